#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/base/result.h"

namespace hazumi::render {

// Writes a file all or nothing: into a temporary file of the same folder, then renamed over `path`.
// On failure nothing is left behind, an older file at `path` stays as it was, and the error
// (kCannotWrite) names the file and the reason.
Result<Done> WriteFileAtomically(const std::filesystem::path& path,
                                 const std::vector<std::uint8_t>& bytes);

}  // namespace hazumi::render
