#include <memory>

#include "engine/bake/bake.h"
#include "engine/spatial/degrees.h"
#include "tests/bench/falls.h"

namespace hazumi::bench {

namespace {

// As a file has it that asks for this tolerance [rad]; one thread.
Result<Motion> BakeOf(const Animation& fall, double tolerance, BakeOptions options) {
  Animation animation = fall;
  animation.solver.tolerance = tolerance;
  options.threads = 1;
  return Bake(animation, options);
}

std::vector<MotionLimit> States(const Animation& fall, double tolerance,
                                const std::vector<int>& frames) {
  std::vector<MotionLimit> states;
  const Result<Motion> motion = BakeOf(fall, tolerance, {});
  if (!motion.ok()) return states;
  for (const int frame : frames) states.push_back(motion.value().frames[frame].before);
  return states;
}

// Depths between the frames too, 480 of them a second.
FallAccount Account(const Animation& fall, double tolerance) {
  BakeOptions options;
  options.energy = true;
  options.output_rate = FrameRate{480, 1};
  const Result<Motion> motion = BakeOf(fall, tolerance, options);
  if (!motion.ok()) return {};
  FallAccount account;
  for (const MotionFrame& frame : motion.value().frames) {
    account.depth = std::max(account.depth, DepthOf(*fall.figure, frame.before));
  }
  const RegionReport& report = motion.value().regions[0];
  if (report.estimated_until) account.time_stepping_from = *report.estimated_until / 30.0;
  if (const auto& energy = report.energy) {
    account.unaccounted = energy->residual();
    account.lost = energy->kinetic_start + energy->potential_start - energy->kinetic_end -
                   energy->potential_end;
  }
  account.finished = true;
  return account;
}

}  // namespace

std::vector<FallMethod> HazumiFalls(const Animation& fall) {
  std::vector<double> tolerances;
  for (const double degrees : {10.0, 3.0, 1.0, 0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-5}) {
    tolerances.push_back(degrees * kDegree);
  }
  return {{"hazumi_exact", "rad", tolerances, 1e-8 * kDegree, 1e-7 * kDegree,
           SolverSettings().tolerance,
           [&fall](double tolerance) { return BakeOf(fall, tolerance, {}).ok(); },
           [&fall](double tolerance, const std::vector<int>& frames) {
             return States(fall, tolerance, frames);
           },
           [&fall](double tolerance) { return Account(fall, tolerance); }}};
}

}  // namespace hazumi::bench
