#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/figure/indices.h"
#include "engine/timeline/drive.h"

namespace hazumi {

enum class Method {
  kPaper,  // the passive step of Arai 2.4
  kExact,  // its meaning in continuous time, with the error under control [METHOD 2.1]
};
constexpr const char* NameOf(Method method) {
  switch (method) {
    case Method::kPaper:
      return "paper";
    case Method::kExact:
      return "exact";
  }
  return "";
}

// Rate of a friction factor per 1/30 s [1/s]; infinite for 0, which freezes a joint. [METHOD 2.3]
inline double FrictionRate(double factor) { return -30.0 * std::log(factor); }

// Frames x joints in which the joints swing by their own inertia (Arai 2.5).
// Half open: the region drives its joints from `first_frame` up to and including the moment of
// `last_frame`, where another region may take over.
struct DynamicsRegion {
  std::string name;
  int first_frame = 0;
  int last_frame = 0;
  std::vector<JointIndex> joints;  // ascending, no duplicates
  std::vector<double> friction;    // one for each of `joints`: factor in [0, 1] per 1/30 s
  bool root = false;               // kExact: the root's orientation too
  // kExact: what it moves stays out of what stands in the scene; a root that it moves, and that a
  // placement by gravity leaves to it, is placed by that.
  bool touches_scene = false;
  // kExact: links of which it moves one stay out of each other.
  bool touches_self = false;
  Method method = Method::kPaper;
  std::optional<double> step;       // kPaper [s]; not given: the animation's
  std::optional<double> tolerance;  // kExact [rad]; not given: the animation's
  // The curves after the region start no faster than they can without leaving the joint limits.
  bool limit_tangents = false;
  // The curves after the region run to their first key at least this far behind it and pass over
  // those between.
  int blend_frames = 0;
  std::vector<Drive> drives;  // of its joints; the others are limp
  // Joints that are said to be in it but go on along their keys: none of `joints`, ascending.
  std::vector<JointIndex> keyed;
  // It stays in the list, where it is counted, and moves nothing: `joints` and `drives` are empty,
  // `root` is false.
  bool is_muted = false;
  bool operator==(const DynamicsRegion&) const = default;

  bool moves_nothing() const { return joints.empty() && !root; }
};

}  // namespace hazumi
