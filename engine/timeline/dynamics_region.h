#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/figure/indices.h"

namespace hazumi {

enum class Method {
  kPaper,  // the passive step of Arai 2.4
};
constexpr const char* NameOf(Method method) {
  switch (method) {
    case Method::kPaper:
      return "paper";
  }
  return "";
}

// Frames x joints in which the joints swing by their own inertia (Arai 2.5).
// Half open: the region drives its joints from `first_frame` up to and including the moment of
// `last_frame`, where another region may take over.
struct DynamicsRegion {
  std::string name;
  int first_frame = 0;
  int last_frame = 0;
  std::vector<JointIndex> joints;  // ascending, no duplicates
  std::vector<double> friction;    // one for each of `joints`: factor in [0, 1] per 1/30 s
  Method method = Method::kPaper;
  std::optional<double> step;  // [s]; not given: the animation's
};

}  // namespace hazumi
