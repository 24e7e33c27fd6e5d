#pragma once

#include <optional>

#include "engine/base/result.h"

namespace hazumi {

// Error (kSemantics) if a key on each of `frames` frames in `seconds`, for each of `curves` curves,
// is far more than a project holds. All three may be estimates.
std::optional<Error> WhyTooManyKeys(double curves, double frames, double seconds);

}  // namespace hazumi
