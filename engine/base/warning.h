#pragma once

#include <optional>
#include <string>

namespace hazumi {

// Something odd that stops nothing but that the animator should know. `place` is a path such as
// `regions[1].joints[3]`, as in Error.
struct Warning {
  // A field of a region that would put it right.
  enum class Remedy { kNone, kBlend, kLimitTangents };

  std::string place;
  std::string message;
  std::optional<int> frame = {};  // where it is seen, if at one frame
  Remedy remedy = Remedy::kNone;
};

}  // namespace hazumi
