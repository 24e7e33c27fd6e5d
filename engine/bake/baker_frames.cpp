// From frame to frame in the paper's steps, and the whole figure at one instant.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/bake/baker.h"
#include "engine/bake/limits.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

constexpr double kReachTolerance = 1e-4;  // of holds that keys just do not reach [m]

Error CannotGoOn(std::string place, std::string message) {
  return {ErrorCode::kSemantics, "", std::move(place), std::move(message)};
}

}  // namespace

// ceil(frame time / step) equal steps; a frame that is a whole number of steps but for rounding
// gets that number.
Baker::Failure Baker::AdvanceFrame(int frame) {
  const double step = driver_ ? driver_->step() : animation_.solver.step;
  const double wanted = animation_.rate.seconds_per_frame() / step;
  const int steps = std::max(1, static_cast<int>(std::ceil(wanted * (1.0 - 1e-12))));
  for (int i = 0; i < steps; ++i) {
    if (is_cancelled()) return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
    const double from = frame + static_cast<double>(i) / steps;
    const double to = i + 1 == steps ? frame + 1.0 : frame + (i + 1.0) / steps;
    if (auto error = Step(from, to, i + 1 == steps)) return error;
    if (i + 1 < steps) RecordIfOutput();
  }
  return std::nullopt;
}

Baker::Failure Baker::Step(double frame_from, double frame_to, bool to_boundary) {
  const double seconds = Seconds(frame_to - frame_from);
  FigureMotion next = now_;
  next.frame = frame_to;
  if (auto error = StepRegions(seconds, &next)) return error;
  const Side side = to_boundary ? Side::kBefore : Side::kAfter;
  curves_.SampleJoints(frame_to, side, free_, &next);
  curves_.SampleRootOrientation(frame_to, side, &next);
  if (auto error = StepPlacement(frame_from, seconds, side, &next)) return error;
  RecordBetween(now_, next);
  now_ = std::move(next);
  before_ = LimitOf(now_);
  return FinishLanding();
}

Baker::Failure Baker::StepRegions(double seconds, FigureMotion* next) {
  if (!driver_) return std::nullopt;
  const auto start = std::chrono::steady_clock::now();
  std::vector<JointIndex> stops;
  const auto failure =
      driver_->Advance(now_, root_hold(), seconds, &ws_, &next->q, &next->qd, &stops);
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
  if (failure) {
    return CannotGoOnAfter(now_.frame, failure->joint, failure->cause);
  }
  for (const int r : driver_->active()) {
    RegionReport& report = recorder_.report(r);
    ++report.steps;
    ++report.evaluations;
    report.solves += driver_->solves_of_last_step();
    report.microseconds += spent.count() / static_cast<double>(driver_->active().size());
  }
  for (const JointIndex j : stops) {
    recorder_.AddStop(j, Seconds(next->frame), Seconds(next->frame), 1);
  }
  return std::nullopt;
}

Baker::Failure Baker::StepPlacement(double frame_from, double seconds, Side side,
                                    FigureMotion* next) {
  if (!gravity_) {
    PlaceRoot(next->frame, side, next);
    return SolveHolds(next->frame, side, next);
  }
  const std::optional<GroupIndex> pin_before = gravity_->pin();
  gravity_->Advance(now_, seconds, &ws_, next);
  for (const GravityPlacement::Event& event : gravity_->events()) {
    const double frame = frame_from + animation_.rate.FrameAt(event.seconds_into_step);
    using Kind = GravityPlacement::EventKind;
    if (event.kind == Kind::kTakeOff) {
      recorder_.AddEvent(EventKind::kTakeOff, frame, figure_.group(*pin_before).name);
    }
    if (event.kind == Kind::kApex) recorder_.AddEvent(EventKind::kApex, frame, "");
    if (event.kind == Kind::kLanding) {
      recorder_.AddEvent(EventKind::kLanding, frame, figure_.group(*gravity_->pin()).name);
    }
  }
  return std::nullopt;
}

// An invalid joint is the root.
Error Baker::CannotGoOnAfter(double frame, JointIndex joint, const std::string& cause) const {
  const std::string who = joint.is_valid() ? "joint \"" + figure_.joint(joint).name + "\""
                                           : "root \"" + figure_.root_name() + "\"";
  return CannotGoOn(RegionPlace(joint.is_valid() ? std::optional(joint) : std::nullopt),
                    "cannot go on after frame " + FormatShort(frame) + ": " + who + ": " + cause);
}

// "regions[1]", where it is known which: the one that moves the joint, or the only active one.
std::string Baker::RegionPlace(std::optional<JointIndex> joint) const {
  std::vector<int> candidates = driver_ ? driver_->active() : exact_->active();
  std::erase_if(candidates, [&](int r) {
    const auto& joints = animation_.regions[r].joints;
    return joint && !std::binary_search(joints.begin(), joints.end(), *joint);
  });
  if (candidates.size() != 1) return "regions";
  return "regions[" + std::to_string(candidates[0]) + "]";
}

// A landing stops the root's fall; the free joints feel the impulse. [METHOD 5.7]
Baker::Failure Baker::FinishLanding() {
  if (!gravity_ || !gravity_->has_landed()) return std::nullopt;
  const JointIndex pin = figure_.group(*gravity_->pin()).first;
  if (driver_ && !driver_->ApplyLanding(now_, pin, &ws_, &now_.qd)) {
    return CannotGoOn(RegionPlace(std::nullopt), "cannot go on after the landing at frame " +
                                                     FormatShort(now_.frame) +
                                                     ": a joint in a region moves no mass");
  }
  gravity_->Place(&ws_, &now_);
  return std::nullopt;
}

Baker::Failure Baker::Evaluate(double frame, Side side, FigureMotion* motion) {
  motion->frame = frame;
  curves_.SampleJoints(frame, side, free_, motion);
  TurnRoot(frame, side, motion);
  PlaceRoot(frame, side, motion);
  return SolveHolds(frame, side, motion);
}

void Baker::PlaceRoot(double frame, Side side, FigureMotion* motion) {
  if (fall_) {
    fall_->Place(Seconds(frame), &ws_, motion);
  } else if (gravity_) {
    gravity_->Place(&ws_, motion);
  } else if (span_ && span_->kind == PlacementKind::kPinned) {
    PinRoot(figure_, figure_.group(*span_->pin).first, pin_W_, &ws_, motion);
  } else {
    curves_.SampleRootPosition(frame, side, motion);
  }
}

Baker::Failure Baker::SolveHolds(double frame, Side side, FigureMotion* motion) {
  if (holds_.empty()) return std::nullopt;
  const PoseOf<Jet> X_WR = RootJet(curves_.RootAnglesAt(frame, side), *motion);
  std::vector<Jet> q(figure_.num_joints());
  for (int j = 0; j < figure_.num_joints(); ++j) {
    q[j] = Jet(motion->q[j], motion->qd[j], motion->qdd[j]);
  }
  for (ActiveHold& active : holds_) {
    if (auto error = SolveHold(&active, frame, side, X_WR, &q)) return error;
    for (const JointIndex j : active.solver.joints()) {
      motion->q[j.value()] = q[j.value()].v;
      motion->qd[j.value()] = q[j.value()].d;
      motion->qdd[j.value()] = q[j.value()].dd;
    }
  }
  return std::nullopt;
}

// Sets the joints that a hold moves, unless it is known already how.
Baker::Failure Baker::SolveHold(ActiveHold* active, double frame, Side side,
                                const PoseOf<Jet>& X_WR, std::vector<Jet>* q) {
  const size_t index = active->hold - animation_.holds.data();
  const KnownHolds::Place place = {index, frame, side == Side::kBefore};
  HoldRequest request = {X_WR, active->target, active->solver.ChainOf(*q),
                         is_between_ ? 0.0 : kReachTolerance};
  const HoldResult* result = known_holds_.Find(place, request);
  if (!result) {
    const HoldSolution solution = active->solver.Solve(X_WR, active->target, q, request.tolerance);
    if (!solution.reached) return OutOfReach(index, frame, solution.distance);
    HoldResult found = {solution.distance, {}};
    for (const JointIndex j : active->solver.joints()) found.joints.push_back((*q)[j.value()]);
    result = known_holds_.Keep(place, std::move(request), std::move(found));
  }
  if (result->distance > 0.0) WarnOfReach(active);
  auto jet = result->joints.begin();
  for (const JointIndex j : active->solver.joints()) (*q)[j.value()] = *jet++;
  return std::nullopt;
}

Error Baker::OutOfReach(size_t hold, double frame, double distance) const {
  const IkHold& held = animation_.holds[hold];
  return CannotGoOn(
      "holds[" + std::to_string(hold) + "]",
      "\"" + figure_.group(held.joint).name + "\" is out of reach at frame " + FormatShort(frame) +
          ": " + FormatShort(distance) + " m short; move the root nearer" +
          (held.reach == HoldReach::kLimb ? ", give the hold the reach \"body\", or shorten it"
                                          : " or shorten the hold"));
}

void Baker::WarnOfReach(ActiveHold* active) {
  if (std::exchange(active->is_warned_of, true)) return;
  recorder_.AddWarning(
      "holds[" + std::to_string(active->hold - animation_.holds.data()) + "]",
      "\"" + figure_.group(active->hold->joint).name +
          "\" is out of reach at times, by 0.1 mm at most: there it is held so much beside "
          "its place; move the root nearer");
}

}  // namespace hazumi
