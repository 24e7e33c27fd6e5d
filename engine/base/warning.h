#pragma once

#include <string>

namespace hazumi {

// Something odd that stops nothing but that the animator should know. `place` is a path such as
// `regions[1].joints[3]`, as in Error.
struct Warning {
  std::string place;
  std::string message;
};

}  // namespace hazumi
