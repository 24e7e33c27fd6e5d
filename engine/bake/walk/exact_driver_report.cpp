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
#include "engine/region/exact/exact_step.h"

namespace hazumi {

namespace {

// Its distance is mostly its own error; the solution's is this part of it at most.
constexpr double kEstimateShare = 1.0 / ExactStep::kControlError;

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
  estimates_.NoteTimeStepping(
      island->solution.hinges(),
      island->solution.time_stepping_from().value_or(island->solution.time()));
}

VecX ExactDriver::Estimate(double t) {
  const int n = regions_.num_coordinates();
  RotationState state{VecX::Zero(n), VecX::Zero(n), {}}, control = state;
  Sample(t, &state);
  SampleControl(t, &control);
  std::vector<double> errors(regions_.size(), 0.0);
  for (const Island& island : islands_) {
    if (!island.has_control) continue;
    const auto& hinges = island.solution.hinges();
    if (const auto from = EventTrail::Part(island.solution.trail(), island.control.trail(), t)) {
      estimates_.NoteBranches(hinges, *from);
    }
    const VecX distances = island.solution.Distances(state, control);
    for (size_t i = 0; i < hinges.size(); ++i) {
      double& error = errors[regions_.PlaceOf(hinges[i])];
      error = std::max({error, island.solution.step_tolerance(), kEstimateShare * distances[i]});
    }
  }
  estimates_.Add(t, errors);
  return std::move(state.q);
}

std::vector<double> ExactDriver::Distances(const VecX& angles, const VecX& others) const {
  const RotationState here{angles, {}, {}}, there{others, {}, {}};
  std::vector<double> distances(regions_.size(), 0.0);
  for (const Island& island : islands_) {
    const VecX of_hinges = island.solution.Distances(here, there);
    for (Eigen::Index i = 0; i < of_hinges.size(); ++i) {
      double& distance = distances[regions_.PlaceOf(island.solution.hinges()[i])];
      distance = std::max(distance, of_hinges[i]);
    }
  }
  return distances;
}

std::vector<ExactDriver::SpentSpring> ExactDriver::SpentSprings(double t) {
  std::vector<SpentSpring> all;
  if (!regions_.has_drives()) return all;
  for (Island& island : islands_) {
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
  const bool is_joint = c < regions_.figure().num_joints();
  return Failure{is_joint ? JointIndex(c) : JointIndex(),
                 CauseOf(*first->failure(), regions_.animation(), of->held.indices, first->work()),
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
  std::vector<ConstraintPush> all(regions_.animation().constraints.size());
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

ExactDriver::Events ExactDriver::TakeEvents() {
  Events events;
  for (Island& island : islands_) {
    const IslandEvents of_island = island.solution.TakeEvents();
    for (const LimitHit& hit : of_island.hits) {
      const Coordinate c = island.solution.hinges()[hit.hinge];
      events.hits.push_back({hit.time, hit.last_time, hit.count, c});
    }
    events.touches.insert(events.touches.end(), of_island.touches.begin(), of_island.touches.end());
    for (const ConstraintBreak& of : of_island.breaks) {
      events.breaks.push_back({island.held.indices[of.constraint], of.time});
      broken_.push_back(events.breaks.back().constraint);
    }
  }
  return events;
}

void ExactDriver::ExchangeLoose(const std::vector<LooseObject>& before,
                                const std::vector<LooseObject>& now) {
  const Animation& animation = regions_.animation();
  const auto energy_of = [&](const std::vector<LooseObject>& balls,
                             const std::vector<LooseObject>& others) {
    return EnergyOfBalls(animation.held_objects, balls, others, animation.gravity);
  };
  energy_.Exchange(energy_of(before, now), energy_of(now, before));
}

SceneContacts ExactDriver::ContactsAt(double t) {
  SceneContacts contacts;
  if (!regions_.has_contacts()) return contacts;
  for (Island& island : islands_) {
    const std::vector<ContactPush> of_island = island.solution.ContactPushes(t);
    contacts.pushes.insert(contacts.pushes.end(), of_island.begin(), of_island.end());
  }
  for (const Link& link : regions_.figure().links()) {
    contacts.is_known.push_back(regions_.Touches(link.joint));
  }
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
    costliest = first < regions_.figure().num_joints() ? JointIndex(first) : JointIndex();
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
