#pragma once

#include <atomic>
#include <string>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi::edit {

// Whether a project could be read from `path` and animated there if it were saved: what
// `hazumi --check` would say of the file. Errors: those of ParseProject, CompileAnimation and Bake.
Result<Done> CheckSaved(const Project& project, const std::string& path,
                        const std::atomic<bool>* cancel = nullptr);

}  // namespace hazumi::edit
