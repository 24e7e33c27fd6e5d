// Each island takes steps with an error of its regions' tolerance for a step
// (ActiveRegions::StepToleranceFor), divided by the sharpness; its control solution with one forty
// times as large, for an estimate of the error [METHOD 8.2].

#include "engine/bake/walk/exact_driver.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/bake/island_curves.h"
#include "engine/bake/walk/outer_forces.h"

namespace hazumi {

namespace {

// Finer than this a step's error is rounding, and steps would shrink without end [rad].
constexpr double kFinestStep = 1e-15;
constexpr double kControlCoarseness = 40.0;

}  // namespace

ExactDriver::ExactDriver(ActiveRegions regions, double sharpness, std::vector<int> broken,
                         const KnownLogs* known, ThreadPool* pool)
    : regions_(std::move(regions)),
      sharpness_(sharpness),
      known_(known),
      pool_(pool),
      broken_(std::move(broken)),
      estimates_(&regions_) {}

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
  estimates_.BeginIslands(t);
  const double middle = 0.5 * (t + end);
  const std::vector<int> acting = ActiveConstraints(regions_.animation(), middle, broken_);
  request_ = regions_.RequestWithTies(state, hold, driven, acting);
  std::vector<RegionModel> models = CompileRegionModels(regions_.figure(), request_);
  AccountForMass(models);
  const bool controls_equal_steps = regions_.animation().solver.rules().controls_equal_steps;
  islands_.clear();
  islands_.reserve(models.size());
  for (RegionModel& model : models) {
    const double tolerance = std::max(kFinestStep, regions_.StepToleranceFor(model) / sharpness_);
    ActiveRegions::Island made =
        regions_.IslandFor(std::move(model), {middle, !request_.ties.empty(), acting, state.loose});
    const auto shared = std::make_shared<const SharedIsland>(std::move(made.task));
    const auto curves = CurvesOf(shared->task.model, driven);
    const IslandSolution::Tolerance of_control = {tolerance * kControlCoarseness,
                                                  controls_equal_steps ? tolerance : 0.0};
    Island& island = islands_.emplace_back(Island{{shared, {tolerance}, &moving_bases_},
                                                  {shared, of_control, &moving_bases_},
                                                  std::move(made.held)});
    island.solution.Begin(t, end, state, curves, known_);
    const auto has_time_stepped = [&](Coordinate c) { return estimates_.HasTimeStepped(c, t); };
    const std::vector<Coordinate>& hinges = island.solution.hinges();
    island.has_control = std::none_of(hinges.begin(), hinges.end(), has_time_stepped);
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
      if (weightless[i] && c < regions_.figure().num_joints()) joints.emplace_back(c);
    }
  }
  return joints;
}

void ExactDriver::Drive(double end, const RotationState& state, const DrivenMotion& driven) {
  const RootHold hold = {request_.coupling, request_.pin};
  const ModelRequest request = regions_.RequestFor(state, hold, driven);
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
  still.angles.resize(regions_.num_coordinates());
  energy_.JumpBy("push");
  return hazumi::Push(push, regions_.figure(), regions_.RequestFor(*state, hold, still), state);
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
