// A step of an island may have an error of tolerance / 20, and a hundredth of that where contacts,
// constraints or forces from outside push. Friction f per 1/30 s is the rate c = -30 ln f
// [METHOD 2.3].

#include "engine/bake/walk/active_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/bake/walk/contacts_of.h"
#include "engine/bake/walk/drive_curves.h"
#include "engine/bake/walk/loose_balls.h"
#include "engine/bake/walk/outer_forces.h"

namespace hazumi {

namespace {

// A step's error is a small part of what is allowed at the end, since errors grow on the way.
constexpr double kStepShare = 0.05;
// Pushes are of hundreds of newtons: an error of a position is a large error of energy.
constexpr double kPushedShare = 0.01;

// Calls action(coordinate), in the order of the model's free hinges.
template <typename Action>
void ForEachFreeHinge(const RegionModel& model, Action&& action) {
  for (const ModelNode& node : model.nodes) {
    if (node.role != Role::kFree) continue;
    for (int h = 0; h < node.num_hinges; ++h) action(node.hinges[h].coordinate);
  }
}

}  // namespace

ActiveRegions::ActiveRegions(const Animation& animation, const Figure& figure,
                             std::vector<int> indices, const std::map<int, RegionStart>& starts)
    : animation_(animation),
      figure_(figure),
      indices_(std::move(indices)),
      place_of_(figure.num_joints() + kRootAngles, -1),
      friction_(figure.num_joints() + kRootAngles, 1.0) {
  for (size_t a = 0; a < size(); ++a) {
    const DynamicsRegion& of = region(a);
    for (size_t i = 0; i < of.joints.size(); ++i) {
      place_of_[of.joints[i].value()] = static_cast<int>(a);
      friction_[of.joints[i].value()] = of.friction[i];
    }
    for (const Drive& drive : of.drives) {
      drives_.resize(place_of_.size(), nullptr);
      springs_.resize(place_of_.size());
      for (const JointIndex j : drive.joints) {
        drives_[j.value()] = &drive;
        if (drive.kind != DriveKind::kSpring) continue;
        springs_[j.value()] =
            SpringOf(drive, j, of, figure, starts.at(indices_[a]), animation.rate);
        springs_[j.value()].lists_strength_kinks = animation.solver.rules().lists_strength_kinks;
      }
    }
    has_contacts_ |= of.touches_scene || of.touches_self;
    if (!of.root) continue;
    for (int i = 0; i < kRootAngles; ++i) place_of_[figure.num_joints() + i] = static_cast<int>(a);
  }
  ListOwnPairs();
}

void ActiveRegions::ListOwnPairs() {
  const auto touches = [&](int index) { return animation_.regions[index].touches_self; };
  if (std::none_of(indices_.begin(), indices_.end(), touches)) return;
  const auto asks = [&](int link) {
    const DynamicsRegion* of = Carrying(figure_.links()[link].joint);
    return of && of->touches_self;
  };
  const bool with_touching = animation_.solver.rules().keeps_touching_links_apart;
  for (const LinkPair& pair : PairsApart(figure_, with_touching)) {
    if (asks(pair.a) || asks(pair.b)) own_pairs_.push_back(pair);
  }
}

double ActiveRegions::ToleranceOf(size_t place) const {
  return region(place).tolerance.value_or(animation_.solver.tolerance);
}

bool ActiveRegions::places_root() const {
  return std::any_of(indices_.begin(), indices_.end(), [&](int a) {
    return animation_.regions[a].root && animation_.regions[a].touches_scene;
  });
}

// A joint whose friction is 0 is frozen [METHOD 2.4], as is one without room between its limits.
bool ActiveRegions::is_frozen(Coordinate c) const {
  if (c >= figure_.num_joints()) return false;
  return friction_[c] == 0.0 || figure_.joints()[c].is_fixed();
}

// Returns the region that moves the links of a joint: that of the nearest free joint towards the
// root, or the one that moves the root. Null: none.
const DynamicsRegion* ActiveRegions::Carrying(JointIndex j) const {
  while (j.is_valid() && !is_free(j.value())) j = figure_.joint(j).parent;
  const int place = place_of_[j.is_valid() ? j.value() : figure_.num_joints()];
  return place >= 0 ? &region(static_cast<size_t>(place)) : nullptr;
}

bool ActiveRegions::Touches(JointIndex j) const {
  const DynamicsRegion* of = Carrying(j);
  return of && of->touches_scene;
}

ModelRequest ActiveRegions::RequestFor(const RotationState& state, const RootHold& hold,
                                       const DrivenMotion& driven) const {
  ModelRequest request;
  request.angles = state.q;
  request.coupling = hold.coupling;
  request.pin = hold.pin;
  for (Coordinate c = 0; c < num_coordinates(); ++c) {
    Role role = driven.angles[c].degree > 0 ? Role::kDriven : Role::kConstant;
    if (is_free(c)) role = is_frozen(c) ? Role::kConstant : Role::kFree;
    request.roles.push_back(role);
  }
  const auto root = request.roles.begin() + figure_.num_joints();
  if (std::find(root, request.roles.end(), Role::kDriven) != request.roles.end()) {
    std::fill(root, request.roles.end(), Role::kDriven);
  }
  return request;
}

ModelRequest ActiveRegions::RequestWithTies(const RotationState& state, const RootHold& hold,
                                            const DrivenMotion& driven,
                                            const std::vector<int>& acting) const {
  ModelRequest request = RequestFor(state, hold, driven);
  request.ties = TiesOf(animation_, acting);
  for (const LinkPair& pair : own_pairs_) {
    request.ties.push_back({figure_.links()[pair.a].joint, figure_.links()[pair.b].joint});
  }
  const auto touches = [&](JointIndex j) { return Touches(j); };
  if (!state.loose.empty()) AppendTiesForBalls(figure_, touches, &request.ties);
  request.lists_joints = !animation_.forces.empty() || !request.ties.empty() || has_contacts_;
  return request;
}

ActiveRegions::Island ActiveRegions::IslandFor(RegionModel model, const Circumstances& at) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const int k = model.num_free;
  Island island{{std::move(model), VecX(k), VecX(k), {}, animation_.gravity}, {}};
  IslandTask& task = island.task;
  VecX rates(k);
  int i = 0;
  ForEachFreeHinge(task.model, [&](Coordinate c) {
    const bool is_joint = c < figure_.num_joints();
    rates[i] = FrictionRate(friction_[c]);
    task.lower[i] = is_joint ? figure_.joints()[c].lower : -kInfinity;
    task.upper[i] = is_joint ? figure_.joints()[c].upper : kInfinity;
    ++i;
  });
  if (!rates.isZero(0.0)) task.forces.emplace_back(RetentionSpec{std::move(rates)});
  if (has_drives()) AddDrives(&task);
  AddOuterForces(animation_, figure_, at.t, task.model, &task.forces);
  if (at.has_ties) {
    island.held = ConstraintsOf(task.model, animation_, at.acting);
    task.constraints = island.held.specs;
  }
  // Limits go by them as well, whatever touches.
  task.contacts.rules = animation_.solver.rules();
  if (has_contacts_) {
    const auto touches = [&](JointIndex j) { return Touches(j); };
    AddBalls(animation_.held_objects, at.loose, figure_, touches, &task.model);
    task.contacts = ContactsOf(task.model, figure_, animation_, touches, own_pairs_, at.acting);
  }
  return island;
}

void ActiveRegions::AddDrives(IslandTask* task) const {
  const int k = task->model.num_free;
  TorqueSpec torques{std::vector<char>(k, 0)};
  SpringSpec springs{std::vector<Spring>(k)};
  bool has_torques = false, has_springs = false;
  int i = 0;
  ForEachFreeHinge(task->model, [&](Coordinate c) {
    const Drive* drive = drives_[c];
    const bool is_torque = drive && drive->kind == DriveKind::kTorque;
    torques.is_driven[i] = is_torque;
    if (drive && !is_torque) springs.springs[i] = springs_[c];
    has_torques |= is_torque;
    has_springs |= drive && !is_torque;
    ++i;
  });
  if (has_torques) task->forces.emplace_back(std::move(torques));
  if (has_springs) task->forces.emplace_back(std::move(springs));
}

double ActiveRegions::StepToleranceFor(const RegionModel& model) const {
  double tolerance = std::numeric_limits<double>::infinity();
  ForEachFreeHinge(model,
                   [&](Coordinate c) { tolerance = std::min(tolerance, ToleranceOf(PlaceOf(c))); });
  const bool is_worked_on =
      has_contacts_ || !animation_.forces.empty() || !animation_.constraints.empty();
  return tolerance * (is_worked_on ? kStepShare * kPushedShare : kStepShare);
}

}  // namespace hazumi
