#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct Compiled {
  Animation animation;
  std::vector<Warning> warnings;
};

// Resolves names, converts to SI and radians, and checks what spans several parts of the project.
// Errors have no file: kSchema for a value out of range or an unknown name (a project just read has
// none), kSemantics for parts that contradict each other, kInterrupted where `cancel` is set.
// `figure`: what was built of the project's figure before, if it was: it becomes the animation's.
Result<Compiled> CompileAnimation(const Project& project, const std::atomic<bool>* cancel = nullptr,
                                  std::shared_ptr<const Figure> figure = nullptr);

}  // namespace hazumi
