// Each island takes steps with an error of tolerance / 20, a hundredth of that where contacts,
// constraints or forces from outside push, divided by the sharpness; its control solution with one
// forty times as large, for an estimate of the error [METHOD 8.2]. Friction f per 1/30 s is the
// rate c = -30 ln f [METHOD 2.3].

#include "engine/bake/walk/exact_driver.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/bake/island_curves.h"
#include "engine/bake/walk/contacts_of.h"
#include "engine/bake/walk/loose_balls.h"
#include "engine/bake/walk/outer_forces.h"
#include "engine/bake/walk/spring_of.h"

namespace hazumi {

namespace {

// A step's error is a small part of what is allowed at the end, since errors grow on the way.
constexpr double kStepShare = 0.05;
// What is pushed is so by hundreds of newtons: where it is off, energy is.
constexpr double kPushedShare = 0.01;
// Finer than this a step's error is rounding, and steps would shrink without end [rad].
constexpr double kFinestStep = 1e-15;
constexpr double kControlCoarseness = 40.0;

// Friction is a factor per 1/30 s. [METHOD 2.3]
double FrictionRate(double factor) { return -30.0 * std::log(factor); }

// action(coordinate), in the order of the model's free hinges.
template <typename Action>
void ForEachFreeHinge(const RegionModel& model, Action&& action) {
  for (const ModelNode& node : model.nodes) {
    if (node.role != Role::kFree) continue;
    for (int h = 0; h < node.num_hinges; ++h) action(node.hinges[h].coordinate);
  }
}

}  // namespace

ExactDriver::ExactDriver(const Animation& animation, const Figure& figure, std::vector<int> active,
                         const std::map<int, RegionStart>& starts, double sharpness,
                         std::vector<int> broken, const KnownLogs* known, ThreadPool* pool)
    : animation_(animation),
      figure_(figure),
      active_(std::move(active)),
      sharpness_(sharpness),
      known_(known),
      pool_(pool),
      region_of_(figure.num_joints() + kRootAngles, -1),
      friction_(figure.num_joints() + kRootAngles, 1.0),
      broken_(std::move(broken)),
      estimated_(active_.size()) {
  for (size_t a = 0; a < active_.size(); ++a) {
    const DynamicsRegion& region = animation.regions[active_[a]];
    for (size_t i = 0; i < region.joints.size(); ++i) {
      region_of_[region.joints[i].value()] = static_cast<int>(a);
      friction_[region.joints[i].value()] = region.friction[i];
    }
    for (const hazumi::Drive& drive : region.drives) {
      drives_.resize(region_of_.size(), nullptr);
      springs_.resize(region_of_.size());
      for (const JointIndex j : drive.joints) {
        drives_[j.value()] = &drive;
        if (drive.kind != DriveKind::kSpring) continue;
        springs_[j.value()] =
            SpringOf(drive, j, region, figure, starts.at(active_[a]), animation.rate);
      }
    }
    has_contacts_ |= region.touches_scene || region.touches_self;
    if (!region.root) continue;
    for (int i = 0; i < kRootAngles; ++i) {
      region_of_[figure.num_joints() + i] = static_cast<int>(a);
    }
  }
  ListOwnPairs();
}

// Of which a region that asks for it moves one.
void ExactDriver::ListOwnPairs() {
  const auto touches = [&](int region) { return animation_.regions[region].touches_self; };
  if (std::none_of(active_.begin(), active_.end(), touches)) return;
  const auto asks = [&](int link) {
    const DynamicsRegion* region = Carrying(figure_.links()[link].joint);
    return region && region->touches_self;
  };
  const bool with_touching = animation_.solver.rules().keeps_touching_links_apart;
  for (const LinkPair& pair : PairsApart(figure_, with_touching)) {
    if (asks(pair.a) || asks(pair.b)) own_pairs_.push_back(pair);
  }
}

bool ExactDriver::places_root() const {
  return std::any_of(active_.begin(), active_.end(), [&](int a) {
    return animation_.regions[a].root && animation_.regions[a].touches_scene;
  });
}

// A joint whose friction is 0 is frozen [METHOD 2.4], as is one without room between its limits.
bool ExactDriver::is_frozen(Coordinate c) const {
  if (c >= figure_.num_joints()) return false;
  return friction_[c] == 0.0 || figure_.joints()[c].is_fixed();
}

ModelRequest ExactDriver::RequestFor(const RotationState& state, const RootHold& hold,
                                     const DrivenMotion& driven) const {
  ModelRequest request;
  request.angles = state.q;
  request.coupling = hold.coupling;
  request.pin = hold.pin;
  const int n = figure_.num_joints();
  for (Coordinate c = 0; c < n + kRootAngles; ++c) {
    Role role = driven.angles[c].degree > 0 ? Role::kDriven : Role::kConstant;
    if (is_free(c)) role = is_frozen(c) ? Role::kConstant : Role::kFree;
    request.roles.push_back(role);
  }
  const auto root = request.roles.begin() + n;
  if (std::find(root, request.roles.end(), Role::kDriven) != request.roles.end()) {
    std::fill(root, request.roles.end(), Role::kDriven);
  }
  return request;
}

// That of the nearest joint towards the root that one moves, or the one that moves the root.
const DynamicsRegion* ExactDriver::Carrying(JointIndex j) const {
  while (j.is_valid() && region_of_[j.value()] < 0) j = figure_.joint(j).parent;
  const int region = region_of_[j.is_valid() ? j.value() : figure_.num_joints()];
  return region >= 0 ? &animation_.regions[active_[region]] : nullptr;
}

bool ExactDriver::Touches(JointIndex j) const {
  const DynamicsRegion* region = Carrying(j);
  return region && region->touches_scene;
}

IslandTask ExactDriver::TaskFor(RegionModel model, double t, const std::vector<LooseObject>& loose,
                                IslandConstraints* constraints) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const int k = model.num_free;
  IslandTask task{std::move(model), VecX(k), VecX(k), {}, animation_.gravity};
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
  if (!drives_.empty()) AddDrives(&task);
  AddOuterForces(animation_, figure_, t, task.model, &task.forces);
  const std::vector<int> acting = ActiveConstraints(animation_, t, broken_);
  if (!request_.ties.empty()) {
    *constraints = ConstraintsOf(task.model, animation_, acting);
    task.constraints = constraints->specs;
  }
  if (has_contacts_) {
    const auto touches = [&](JointIndex j) { return Touches(j); };
    AddBalls(animation_.held_objects, loose, figure_, touches, &task.model);
    task.contacts = ContactsOf(task.model, figure_, animation_, touches, own_pairs_, acting);
  }
  return task;
}

void ExactDriver::AddDrives(IslandTask* task) const {
  const int k = task->model.num_free;
  TorqueSpec torques{std::vector<char>(k, 0)};
  SpringSpec springs{std::vector<Spring>(k)};
  bool has_torques = false, has_springs = false;
  int i = 0;
  ForEachFreeHinge(task->model, [&](Coordinate c) {
    const hazumi::Drive* drive = drives_[c];
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

double ExactDriver::StepToleranceFor(const RegionModel& model) const {
  double tolerance = std::numeric_limits<double>::infinity();
  ForEachFreeHinge(model, [&](Coordinate c) {
    const DynamicsRegion& region = animation_.regions[active_[region_of_[c]]];
    tolerance = std::min(tolerance, region.tolerance.value_or(animation_.solver.tolerance));
  });
  const bool is_worked_on =
      has_contacts_ || !animation_.forces.empty() || !animation_.constraints.empty();
  const double share = is_worked_on ? kStepShare * kPushedShare : kStepShare;
  return std::max(kFinestStep, tolerance * share / sharpness_);
}

void ExactDriver::FinishIslands() {
  finished_.evaluations = evaluations();
  finished_.steps = steps();
  finished_.work = work();
  finished_.microseconds = microseconds();
  AppendLogs(&finished_.logs);
}

void ExactDriver::Begin(double t, double end, const RotationState& state,
                        const RotationState& control, const RootHold& hold,
                        const DrivenMotion& driven) {
  FinishIslands();
  for (Estimated& estimated : estimated_) {
    if (!estimated.is_beyond) estimated.within_until = t;
  }
  request_ = RequestFor(state, hold, driven);
  const double middle = 0.5 * (t + end);
  request_.ties = TiesOf(animation_, ActiveConstraints(animation_, middle, broken_));
  for (const LinkPair& pair : own_pairs_) {
    request_.ties.push_back({figure_.links()[pair.a].joint, figure_.links()[pair.b].joint});
  }
  const auto touches = [&](JointIndex j) { return Touches(j); };
  if (!state.loose.empty()) AppendTiesForBalls(figure_, touches, &request_.ties);
  request_.lists_joints = !animation_.forces.empty() || !request_.ties.empty() || has_contacts_;
  std::vector<RegionModel> models = CompileRegionModels(figure_, request_);
  AccountForMass(models);
  islands_.clear();
  islands_.reserve(models.size());
  for (RegionModel& model : models) {
    const double tolerance = StepToleranceFor(model);
    IslandConstraints constraints;
    const auto shared = std::make_shared<const SharedIsland>(
        TaskFor(std::move(model), middle, state.loose, &constraints));
    const auto curves = CurvesOf(shared->task.model, driven);
    Island& island =
        islands_.emplace_back(Island{{shared, tolerance, &moving_bases_},
                                     {shared, tolerance * kControlCoarseness, &moving_bases_},
                                     std::move(constraints)});
    island.solution.Begin(t, end, state, curves, known_);
    const auto is_frozen_before = [&](Coordinate c) {
      return estimated_[region_of_[c]].time_stepping_from < t;
    };
    const std::vector<Coordinate>& hinges = island.solution.hinges();
    island.has_control = std::none_of(hinges.begin(), hinges.end(), is_frozen_before);
    if (island.has_control) island.control.Begin(t, end, control, curves, known_);
  }
  energy_.Restart(islands_.size());
}

// Accounts for objects that changed hands since the last step of the islands, with their energy.
void ExactDriver::AccountForMass(const std::vector<RegionModel>& models) {
  constexpr double kSame = 1e-12;
  double before = 0.0, now = 0.0;
  for (const Island& island : islands_) before += island.solution.model().mass;
  for (const RegionModel& model : models) now += model.mass;
  if (!islands_.empty() && std::abs(now - before) > kSame * now) energy_.JumpBy("handover");
}

std::vector<JointIndex> ExactDriver::WeightlessJoints() const {
  std::vector<JointIndex> joints;
  for (const Island& island : islands_) {
    const RegionModel& model = island.solution.model();
    const std::vector<char> weightless = WeightlessNodes(model);
    for (size_t i = 0; i < weightless.size(); ++i) {
      const Coordinate c = model.nodes[i].num_hinges > 0 ? model.nodes[i].hinges[0].coordinate : 0;
      if (weightless[i] && c < figure_.num_joints()) joints.emplace_back(c);
    }
  }
  return joints;
}

void ExactDriver::Drive(double end, const RotationState& state, const DrivenMotion& driven) {
  const RootHold hold = {request_.coupling, request_.pin};
  const ModelRequest request = RequestFor(state, hold, driven);
  bool same = request.roles == request_.roles;
  for (size_t c = 0; c < request.roles.size() && same; ++c) {
    same = request.roles[c] != Role::kConstant || request.angles[c] == request_.angles[c];
  }
  const double t = time();
  if (!same) {
    RotationState main = state, control = state;
    Sample(t, &main);
    SampleControl(t, &control);
    return Begin(t, end, main, control, hold, driven);
  }
  for (Island& island : islands_) {
    const auto curves = CurvesOf(island.solution.model(), driven);
    island.solution.Drive(t, end, curves);
    if (island.has_control) island.control.Drive(t, end, curves);
  }
}

template <typename Action>
void ExactDriver::ForEachSolution(Action&& action) {
  for (Island& island : islands_) {
    action(island.solution);
    if (island.has_control) action(island.control);
  }
}

bool ExactDriver::Push(const PushForce& push, const RootHold& hold, RotationState* state) {
  DrivenMotion still;
  still.angles.resize(region_of_.size());
  energy_.JumpBy("push");
  return hazumi::Push(push, figure_, RequestFor(*state, hold, still), state);
}

std::optional<ExactDriver::Failure> ExactDriver::Advance(double t, double end) {
  for (Island& island : islands_) {
    island.solution.Advance(t, end);
    if (island.has_control) island.control.Advance(t, end);
    if (island.solution.time_stepping_from() || island.control.time_stepping_from())
      LeaveControl(&island);
  }
  return FirstFailure();
}

std::optional<ExactDriver::Failure> ExactDriver::AdvanceAhead(const std::vector<double>& times,
                                                              double end,
                                                              const std::atomic<bool>* cancel) {
  std::vector<IslandSolution*> unknown;
  const auto shared_times = std::make_shared<const std::vector<double>>(times);
  ForEachSolution([&](IslandSolution& solution) {
    if (!solution.LookAhead(shared_times, end)) unknown.push_back(&solution);
  });
  pool_->Do(static_cast<int>(unknown.size()), [&](int i) { unknown[i]->SolveAhead(cancel); });
  return FirstFailure();
}

double ExactDriver::time() const {
  double time = std::numeric_limits<double>::infinity();
  for (const Island& island : islands_) {
    time = std::min(time, island.solution.time());
    if (island.has_control) time = std::min(time, island.control.time());
  }
  return time;
}

bool ExactDriver::solves_fall() const {
  return std::any_of(islands_.begin(), islands_.end(),
                     [](const Island& island) { return island.solution.solves_fall(); });
}

bool ExactDriver::moves_loose() const {
  return std::any_of(islands_.begin(), islands_.end(),
                     [](const Island& island) { return !island.solution.model().balls.empty(); });
}

void ExactDriver::Sample(double t, RotationState* state, Gaps gaps) {
  for (Island& island : islands_) island.solution.Sample(t, state, gaps);
}

void ExactDriver::SampleControl(double t, RotationState* state) {
  for (Island& island : islands_) {
    (island.has_control ? island.control : island.solution).Sample(t, state);
  }
}

std::optional<Vec3> ExactDriver::Accelerations(double t, VecX* rates, VecX* accelerations) {
  std::optional<Vec3> fall;
  for (Island& island : islands_) {
    const Vec3 of_island = island.solution.Accelerations(t, rates, accelerations);
    if (island.solution.solves_fall()) fall = of_island;
  }
  return fall;
}

void ExactDriver::Account(double t, bool is_cut) {
  energy_.SetCoupling(request_.coupling);
  for (size_t g = 0; g < islands_.size(); ++g) {
    // An island takes its next step only once all have reached the end of the present one.
    IslandSolution& solution = islands_[g].solution;
    if (is_cut || solution.time() <= t) energy_.AddStep(g, t, &solution);
  }
}

}  // namespace hazumi
