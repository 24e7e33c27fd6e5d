// What the driver did, for reports: a fifth of the distance from the control solutions is the
// estimate of the error [METHOD 8.2]; and why it cannot go on.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/bake/walk/exact_driver.h"
#include "engine/bake/walk/loose_balls.h"
#include "engine/bake/walk/walk_work.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

// Its distance is mostly its own error; the solution's is this part of it at most.
constexpr double kEstimateShare = 0.2;

// `constraints`: of the island, as the animation counts them.
std::string CauseOf(const ExactFailure& failure, const Animation& animation,
                    const std::vector<int>& constraints, const Work& work) {
  if (failure.cause == ExactFailure::Cause::kNoHold) {
    const Constraint& held = animation.constraints[constraints[failure.constraint]];
    const char* or_else = held.kind == ConstraintKind::kWeld ? ", or hold by a point" : "";
    return "constraint \"" + held.name +
           "\" has no hold on it there, as along a straight limb, and how the motion goes on is "
           "open; bend the limb, or end the constraint earlier" +
           or_else;
  }
  if (failure.cause == ExactFailure::Cause::kEndsApart) {
    return "constraints cannot all be kept: what they hold stays " + FormatShort(failure.gap) +
           " m or rad apart; take one away, or free more joints";
  }
  if (failure.cause == ExactFailure::Cause::kTooMuchWork) return TooMuch(work);
  return "its motion changes faster than any step can follow; ask for less accuracy, more friction "
         "or lower rates";
}

}  // namespace

// Where contacts come too fast the least difference grows without bound.
void ExactDriver::LeaveControl(Island* island) {
  if (!island->has_control) return;
  island->has_control = false;
  const double t = island->solution.time_stepping_from().value_or(island->solution.time());
  for (const Coordinate c : island->solution.hinges()) {
    double& from = estimated_[region_of_[c]].time_stepping_from;
    from = std::min(from, t);
  }
}

void ExactDriver::NoteBranches(const Island& island, double t) {
  const std::optional<double> from =
      EventTrail::Part(island.solution.trail(), island.control.trail(), t);
  if (!from) return;
  for (const Coordinate c : island.solution.hinges()) {
    double& first = estimated_[region_of_[c]].branches_from;
    first = std::min(first, *from);
  }
}

void ExactDriver::Estimate(double t) {
  const int n = figure_.num_joints() + kRootAngles;
  RotationState state{VecX(n), VecX(n), {}}, control = state;
  Sample(t, &state);
  SampleControl(t, &control);
  std::vector<double> errors(active_.size(), 0.0);
  for (const Island& island : islands_) {
    if (!island.has_control) continue;
    NoteBranches(island, t);
    const VecX distances = island.solution.Distances(state, control);
    const auto& hinges = island.solution.hinges();
    for (size_t i = 0; i < hinges.size(); ++i) {
      double& error = errors[region_of_[hinges[i]]];
      error = std::max({error, island.solution.step_tolerance(), kEstimateShare * distances[i]});
    }
  }
  for (size_t a = 0; a < active_.size(); ++a) {
    const DynamicsRegion& region = animation_.regions[active_[a]];
    Estimated& estimated = estimated_[a];
    estimated.error = std::max(estimated.error, errors[a]);
    estimated.is_beyond |= errors[a] > region.tolerance.value_or(animation_.solver.tolerance);
    if (!estimated.is_beyond) {
      estimated.within = estimated.error;
      estimated.within_until = t;
    }
  }
}

ExactDriver::RegionEstimate ExactDriver::EstimateOf(size_t region) const {
  const Estimated& estimated = estimated_[region];
  if (estimated.is_beyond && std::isfinite(estimated.time_stepping_from)) {
    return {estimated.within, std::min(estimated.within_until, estimated.time_stepping_from),
            estimated.branches_from};
  }
  return {estimated.error, estimated.time_stepping_from, estimated.branches_from};
}

std::vector<ExactDriver::SpentSpring> ExactDriver::SpentSprings(double t) {
  std::vector<SpentSpring> all;
  for (Island& island : islands_) {
    if (drives_.empty()) break;
    for (const SpentDrive& drive : island.solution.SpentDrives(t)) {
      all.push_back({JointIndex(island.solution.hinges()[drive.hinge]), drive});
    }
  }
  return all;
}

std::optional<ExactDriver::Failure> ExactDriver::FirstFailure() const {
  const IslandSolution* first = nullptr;
  const Island* of = nullptr;
  for (const Island& island : islands_) {
    for (const IslandSolution* solution : {&island.solution, &island.control}) {
      if (solution == &island.control && !island.has_control) continue;
      if (!solution->failure() || (first && first->time() <= solution->time())) continue;
      first = solution;
      of = &island;
    }
  }
  if (!first) return std::nullopt;
  const Coordinate c = first->hinges()[first->failure()->hinge];
  const bool is_joint = c < figure_.num_joints();
  return Failure{is_joint ? JointIndex(c) : JointIndex(),
                 CauseOf(*first->failure(), animation_, of->held.indices, first->work()),
                 first->time()};
}

std::vector<int> ExactDriver::constraints() const {
  std::vector<int> all;
  for (const Island& island : islands_) {
    all.insert(all.end(), island.held.indices.begin(), island.held.indices.end());
  }
  return all;
}

std::vector<ConstraintPush> ExactDriver::ConstraintPushes(double t) {
  std::vector<ConstraintPush> all(animation_.constraints.size());
  for (Island& island : islands_) {
    const IslandConstraints& held = island.held;
    if (held.indices.empty()) continue;
    const std::vector<ConstraintPush> of_island = island.solution.ConstraintPushes(t);
    for (size_t i = 0; i < held.indices.size(); ++i) {
      ConstraintPush& push = all[static_cast<size_t>(held.indices[i])];
      push = of_island[i];
      if (held.are_swapped[i]) push.on_a = {-push.on_a.force, -push.on_a.moment};
    }
  }
  return all;
}

std::vector<ConstraintBreak> ExactDriver::TakeBreaks() {
  std::vector<ConstraintBreak> breaks;
  for (Island& island : islands_) {
    for (const ConstraintBreak& of : island.solution.TakeBreaks()) {
      breaks.push_back({island.held.indices[of.constraint], of.time});
      broken_.push_back(breaks.back().constraint);
    }
  }
  return breaks;
}

std::vector<ExactDriver::Hit> ExactDriver::TakeHits() {
  std::vector<Hit> hits;
  for (Island& island : islands_) {
    for (const LimitHit& hit : island.solution.TakeHits()) {
      const Coordinate c = island.solution.hinges()[hit.hinge];
      hits.push_back({hit.time, hit.last_time, hit.count, c});
    }
  }
  return hits;
}

std::vector<TouchDown> ExactDriver::TakeTouches() {
  std::vector<TouchDown> touches;
  for (Island& island : islands_) {
    const std::vector<TouchDown> of_island = island.solution.TakeTouches();
    touches.insert(touches.end(), of_island.begin(), of_island.end());
  }
  return touches;
}

void ExactDriver::ExchangeLoose(const std::vector<LooseObject>& before,
                                const std::vector<LooseObject>& now) {
  const auto energy_of = [&](const std::vector<LooseObject>& balls,
                             const std::vector<LooseObject>& others) {
    return EnergyOfBalls(animation_.held_objects, balls, others, animation_.gravity);
  };
  energy_.Exchange(energy_of(before, now), energy_of(now, before));
}

SceneContacts ExactDriver::ContactsAt(double t) {
  SceneContacts contacts;
  if (!has_contacts_) return contacts;
  for (Island& island : islands_) {
    const std::vector<ContactPush> of_island = island.solution.ContactPushes(t);
    contacts.pushes.insert(contacts.pushes.end(), of_island.begin(), of_island.end());
  }
  for (const Link& link : figure_.links()) contacts.is_known.push_back(Touches(link.joint));
  return contacts;
}

long ExactDriver::evaluations() const {
  long sum = finished_.evaluations;
  for (const Island& island : islands_)
    sum += island.solution.evaluations() + island.control.evaluations();
  return sum;
}

Work ExactDriver::work() const {
  Work sum = finished_.work;
  for (const Island& island : islands_) {
    sum += island.solution.work();
    sum += island.control.work();
  }
  return sum;
}

JointIndex ExactDriver::CostliestJoint() const {
  JointIndex costliest;
  double most = -1.0;
  for (const Island& island : islands_) {
    Work work = island.solution.work();
    work += island.control.work();
    const Coordinate first = island.solution.hinges().front();
    if (work.total() <= most) continue;
    most = work.total();
    costliest = first < figure_.num_joints() ? JointIndex(first) : JointIndex();
  }
  return costliest;
}

long ExactDriver::steps() const {
  long sum = finished_.steps;
  for (const Island& island : islands_) sum += island.solution.steps();
  return sum;
}

double ExactDriver::microseconds() const {
  double sum = finished_.microseconds;
  for (const Island& island : islands_) {
    sum += island.solution.microseconds() + island.control.microseconds();
  }
  return sum;
}

void ExactDriver::MoveLogsTo(IslandLogs* logs) {
  std::move(finished_.logs.begin(), finished_.logs.end(), std::back_inserter(*logs));
  finished_.logs.clear();
  AppendLogs(logs);
}

// Of the islands as they are now, if they keep any.
void ExactDriver::AppendLogs(IslandLogs* logs) const {
  if (!known_) return;
  for (const Island& island : islands_) {
    logs->push_back(island.solution.log());
    if (auto log = island.control.log()) logs->push_back(std::move(log));
  }
}

std::vector<int> ExactDriver::island_sizes() const {
  std::vector<int> sizes;
  for (const Island& island : islands_) sizes.push_back(island.solution.model().num_free);
  return sizes;
}

int ExactDriver::num_bodies() const {
  int sum = 0;
  for (const Island& island : islands_) sum += island.solution.model().num_bodies;
  return sum;
}

}  // namespace hazumi
