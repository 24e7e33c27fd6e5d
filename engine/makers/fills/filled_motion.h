#pragma once

// Internal. The motion of the joints of one fill.
//
// Every joint first takes the spline of least relative acceleration through its keys. Trunk and
// root stay with that. Then each limb, a row of joints that carries no other limb, takes the motion
// of least effort in the world, on the body as it moves then (solve/fill_solver.h).

#include <array>
#include <atomic>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/makers/fills/filled_place.h"
#include "engine/makers/fills/joint_angles.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Joint and what was found for it.
struct FilledAngles {
  FilledJoint joint;
  std::optional<JointAngles> angles;  // none: it is not filled
};
struct FilledMotion {
  std::vector<FilledAngles> joints;
  std::vector<std::string> unfilled;  // curves with keys of joints that have too few of them
  std::array<FilledPlace, 3> places;  // of the root, by axis
  // Largest distance of a joint from its place in the animation [m], and where.
  double farthest = 0.0;
  std::string farthest_joint;
  int farthest_frame = 0;
};

// `animation`: without keys of this fill and those after it. Errors: of Bake; kSchema for keys
// between frames; kInterrupted.
Result<FilledMotion> FillMotion(const ProjectFill& fill, const Animation& animation,
                                const std::atomic<bool>* cancel);

}  // namespace hazumi::makers
