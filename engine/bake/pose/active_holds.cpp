// Holds one after the other, each from the pose that those before it left (HoldSolver): the same
// request, bit for bit, has the same answer and is not solved again (KnownHolds).

#include "engine/bake/pose/active_holds.h"

#include <utility>

#include "engine/bake/pose/limits.h"
#include "engine/bake/recorder.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

std::string PlaceOfHold(size_t index) { return "holds[" + std::to_string(index) + "]"; }

}  // namespace

void ActiveHolds::Resume(const std::vector<Begun>& begun) {
  holds_.clear();
  for (const auto& [index, target] : begun) {
    holds_.push_back({index, HoldSolver(figure_, animation_.holds[index]), target});
  }
}

std::vector<ActiveHolds::Begun> ActiveHolds::begun() const {
  std::vector<Begun> begun;
  for (const Hold& hold : holds_) begun.push_back({hold.index, hold.target});
  return begun;
}

void ActiveHolds::Begin(size_t index, const DynamicsWorkspace& ws) {
  const IkHold& hold = animation_.holds[index];
  const JointIndex held = figure_.group(hold.joint).first;
  const HoldTarget target{ws.body(held).p, ws.body(figure_.joint(held).parent).R};
  holds_.push_back({index, HoldSolver(figure_, hold), target});
}

void ActiveHolds::EndAt(int frame) {
  std::erase_if(holds_,
                [&](const Hold& hold) { return animation_.holds[hold.index].last_frame == frame; });
}

std::vector<ActiveHolds::Moved> ActiveHolds::moved() const {
  std::vector<Moved> moved;
  for (const Hold& hold : holds_) {
    moved.push_back({hold.index, animation_.holds[hold.index].last_frame, hold.solver.joints()});
  }
  return moved;
}

std::optional<Error> ActiveHolds::Solve(const RootAngles& root, Side side, double tolerance,
                                        FigureMotion* motion) {
  const PoseOf<Jet> X_WR = RootJet(root, *motion);
  std::vector<Jet> q(figure_.num_joints());
  for (int j = 0; j < figure_.num_joints(); ++j) {
    q[j] = Jet(motion->q[j], motion->qd[j], motion->qdd[j]);
  }
  for (Hold& hold : holds_) {
    const Place place = {hold.index, motion->frame, side == Side::kBefore};
    if (auto error = SolveHold(place, tolerance, X_WR, &hold, &q)) return error;
    for (const JointIndex j : hold.solver.joints()) {
      motion->q[j.value()] = q[j.value()].v;
      motion->qd[j.value()] = q[j.value()].d;
      motion->qdd[j.value()] = q[j.value()].dd;
    }
  }
  return std::nullopt;
}

// Sets the joints that a hold moves, unless it is known already how.
std::optional<Error> ActiveHolds::SolveHold(const Place& place, double tolerance,
                                            const PoseOf<Jet>& X_WR, Hold* hold,
                                            std::vector<Jet>* q) {
  HoldRequest request = {X_WR, hold->target, hold->solver.ChainOf(*q), tolerance};
  const HoldResult* result = known_.Find(place, request);
  if (!result) {
    const HoldSolution solution = hold->solver.Solve(X_WR, hold->target, q, tolerance);
    if (!solution.reached)
      return OutOfReach(hold->index, std::get<double>(place), solution.distance);
    HoldResult found = {solution.distance, {}};
    for (const JointIndex j : hold->solver.joints()) found.joints.push_back((*q)[j.value()]);
    result = known_.Keep(place, std::move(request), std::move(found));
  }
  if (result->distance > 0.0) WarnOfReach(hold);
  auto jet = result->joints.begin();
  for (const JointIndex j : hold->solver.joints()) (*q)[j.value()] = *jet++;
  return std::nullopt;
}

Error ActiveHolds::OutOfReach(size_t index, double frame, double distance) const {
  const IkHold& held = animation_.holds[index];
  return {ErrorCode::kSemantics, "", PlaceOfHold(index),
          "\"" + figure_.group(held.joint).name + "\" is out of reach at frame " +
              FormatShort(frame) + ": " + FormatShort(distance) + " m short; move the root nearer" +
              (held.reach == HoldReach::kLimb ? ", give the hold the reach \"body\", or shorten it"
                                              : " or shorten the hold")};
}

void ActiveHolds::WarnOfReach(Hold* hold) {
  if (std::exchange(hold->is_warned_of, true)) return;
  recorder_->AddWarning(PlaceOfHold(hold->index),
                        "\"" + figure_.group(animation_.holds[hold->index].joint).name +
                            "\" is out of reach at times, by 0.1 mm at most: there it is held so "
                            "much beside its place; move the root nearer");
}

}  // namespace hazumi
