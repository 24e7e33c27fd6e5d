#pragma once

#include <memory>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "engine/base/members.h"
#include "engine/region/exact/exact_reports.h"
#include "engine/region/exact/impact_log.h"
#include "engine/region/forces/force_spec.h"
#include "engine/region/region_dynamics.h"

namespace hazumi {

// An island of joints that feel each other, and what acts on them.
struct IslandTask {
  RegionModel model;
  VecX lower, upper;  // limits, by free hinge [rad]
  std::vector<ForceSpec> forces;
  double gravity = 0.0;  // along -z [m/s^2]
  std::vector<ConstraintSpec> constraints = {};
  ContactSpec contacts = {};
  // Whether anything holds it from outside, so that it matters where it is in the world.
  bool is_placed() const {
    return ActsFromOutside(forces) || !constraints.empty() || !contacts.empty();
  }
};
inline auto MembersOf(const IslandTask& task) {
  const auto& [model, lower, upper, forces, gravity, constraints, contacts] = task;
  return std::tie(model, lower, upper, forces, gravity, constraints, contacts);
}

// Progress of an island: the time reached, events, and the failure that ends it, if any.
struct IslandProgress {
  double time = 0.0, step_start = 0.0;  // end and start of its last step [s]
  std::optional<ExactFailure> failure;
  double microseconds = 0.0;                      // that it took
  std::optional<double> time_stepping_from = {};  // as ExactSolver [s]
  IslandEvents events = {};
};

// Fewer times than asked for where it could not go on.
struct IslandSamples {
  // Angles, then rates, by free hinge; of several times one after the other.
  std::vector<double> hinges;
  // One for each time, if any of it is solved along.
  std::vector<OuterMotion> outer;
};

// The motion up to a time, at once.
struct IslandCourse {
  IslandProgress progress;
  IslandSamples samples;
};

// Requests to an island, one after the other. Its answers, each of the type Result, depend on
// nothing else. Times [s].
//
// Begins at t in this state, moved by curves that are smooth up to `end` and numbered as CurvesOf
// does it.
struct BeginIsland {
  using Result = std::monostate;
  double t = 0.0, end = 0.0;
  double step_tolerance = 0.0;      // error of one step [rad]
  double solution_tolerance = 0.0;  // as ExactStep::SetTolerance [rad]
  HingeState state;                 // its anchor is zero unless laws act from outside
  std::shared_ptr<const DrivenMotion> curves;
  std::shared_ptr<const IslandTask> task;
};
inline auto MembersOf(const BeginIsland& request) {
  const auto& [t, end, step_tolerance, solution_tolerance, state, curves, task] = request;
  return std::tie(t, end, step_tolerance, solution_tolerance, state, curves, task);
}

// Goes on from t, where it is, with other curves.
struct DriveIsland {
  using Result = std::monostate;
  double t = 0.0, end = 0.0;
  std::shared_ptr<const DrivenMotion> curves;
};
inline auto MembersOf(const DriveIsland& request) {
  const auto& [t, end, curves] = request;
  return std::tie(t, end, curves);
}

// Takes steps until it is beyond t, at most to `end`.
struct AdvanceIsland {
  using Result = IslandProgress;
  double t = 0.0, end = 0.0;
};
inline auto MembersOf(const AdvanceIsland& request) {
  const auto& [t, end] = request;
  return std::tie(t, end);
}

// Takes all steps to `end`, and samples the motion at `times`, which rise.
struct SolveIsland {
  using Result = IslandCourse;
  double end = 0.0;
  std::shared_ptr<const std::vector<double>> times;
};
inline auto MembersOf(const SolveIsland& request) {
  const auto& [end, times] = request;
  return std::tie(end, times);
}

// Angles and rates at t, which lies in the step that it is in.
struct SampleIsland {
  using Result = IslandSamples;
  double t = 0.0;
  Gaps gaps = Gaps::kClosed;
};
inline auto MembersOf(const SampleIsland& request) {
  const auto& [t, gaps] = request;
  return std::tie(t, gaps);
}

// Energy and powers there.
struct MeasureIsland {
  using Result = EnergyFlow;
  double t = 0.0;
};
inline auto MembersOf(const MeasureIsland& request) {
  const auto& [t] = request;
  return std::tie(t);
}

// Accelerations at t, which lies in the step that it is in; at the step's end those with which the
// next one begins.
struct AccelerateIsland {
  using Result = InstantReport;
  double t = 0.0;
};
inline auto MembersOf(const AccelerateIsland& request) {
  const auto& [t] = request;
  return std::tie(t);
}

using IslandRequest = std::variant<BeginIsland, DriveIsland, AdvanceIsland, SolveIsland,
                                   SampleIsland, MeasureIsland, AccelerateIsland>;

using IslandResult = std::variant<std::monostate, IslandProgress, IslandCourse, IslandSamples,
                                  EnergyFlow, InstantReport>;

struct IslandCall {
  IslandRequest request;
  IslandResult result;
  // Totals up to this call, from the beginning.
  long evaluations = 0, steps = 0;
  Work work = {};
};
// All that an island was asked, from the beginning on.
using IslandLog = std::vector<IslandCall>;
using IslandLogs = std::vector<std::shared_ptr<const IslandLog>>;

}  // namespace hazumi
