#include "engine/makers/fills/fill_effort.h"

#include <cmath>

#include "engine/analysis/effort.h"
#include "engine/bake/bake.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/compile.h"

namespace hazumi::makers {

Result<double> TorqueIn(const ProjectFill& fill, const Project& project) {
  const Result<Compiled> compiled = CompileAnimation(project);
  if (!compiled.ok()) return compiled.error();
  const Animation& animation = compiled.value().animation;
  BakeOptions options;
  options.accelerations = true;
  const Result<Motion> motion = Bake(animation, options);
  if (!motion.ok()) return motion.error();
  const Effort effort = EffortOf(animation, motion.value());
  const std::vector<bool> hinges = JointsOf(fill.joints, *animation.figure);
  double sum = 0.0;
  long count = 0;
  for (size_t t = 0; t < effort.frames.size(); ++t) {
    const int frame = motion.value().frames[t].frame;
    // Free ends are left out: the rate of the curve jumps there within a frame.
    if (frame < fill.first_frame + 2 || frame > fill.last_frame - 2) continue;
    for (size_t j = 0; j < hinges.size(); ++j) {
      if (!hinges[j]) continue;
      const double tau = effort.frames[t].tau[static_cast<Eigen::Index>(j)];
      sum += tau * tau;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

}  // namespace hazumi::makers
