// From frame to frame by the paper's method [Arai 2.4, 3]: ceil(frame time / step) equal steps
// in each, and in each step
//   the free joints   y' <- f (y' + y'' dt), y <- y + y' dt, from M y'' = -b at its start, with
//                     friction f, and limits (PaperStep),
//   the others        at its end, from their curves,
//   the root          at its end, from its placement,
//   holds             solved there.
// A landing stops the root after its step, and the free joints feel the impulse [METHOD 5.7].

#include "engine/bake/walk/paper_walk.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/base/text.h"

namespace hazumi {

void PaperWalk::Begin(const std::vector<int>& regions, int frame) {
  driver_ = std::make_unique<PaperDriver>(context_.animation, context_.poses.figure(), regions);
  drives_.SetRegions(regions);
  for (const int r : regions) ReportStep(r, frame);
}

// Regions that are active together are one system and take the smallest of their steps.
void PaperWalk::ReportStep(int region, int frame) {
  double& step = context_.recorder.report(region).step;
  if (driver_->step() >= step) return;
  context_.recorder.AddWarning("regions[" + std::to_string(region) + "]",
                               "takes the step of another region that is active from frame " +
                                   std::to_string(frame) + " on: " + FormatNumber(driver_->step()) +
                                   " s instead of " + FormatNumber(step) + " s");
  step = driver_->step();
}

// A frame that is a whole number of steps but for rounding gets that number.
Result<int> PaperWalk::Advance(int frame) {
  const double step = driver_ ? driver_->step() : context_.animation.solver.step;
  const double wanted = context_.animation.rate.seconds_per_frame() / step;
  const int steps = std::max(1, static_cast<int>(std::ceil(wanted * (1.0 - 1e-12))));
  for (int i = 0; i < steps; ++i) {
    if (auto error = context_.CheckCancelled()) return *error;
    const double from = frame + static_cast<double>(i) / steps;
    const double to = i + 1 == steps ? frame + 1.0 : frame + (i + 1.0) / steps;
    if (auto error = Step(from, to, i + 1 == steps)) return *error;
    if (i + 1 < steps) context_.RecordNow();
  }
  return frame + 1;
}

std::optional<Error> PaperWalk::Step(double frame_from, double frame_to, bool to_boundary) {
  const double seconds = context_.Seconds(frame_to - frame_from);
  FigureMotion next = context_.now;
  next.frame = frame_to;
  if (auto error = StepRegions(seconds, &next)) return error;
  TellAccelerations(seconds, next);
  const Side side = to_boundary ? Side::kBefore : Side::kAfter;
  context_.poses.SetJoints(frame_to, side, &next);
  context_.poses.TurnRoot(frame_to, side, &next);
  if (auto error = StepRoot(frame_from, seconds, side, &next)) return error;
  RecordBetween(context_.now, next);
  context_.Arrive(std::move(next));
  return FinishLanding();
}

std::optional<Error> PaperWalk::StepRegions(double seconds, FigureMotion* next) {
  if (!driver_) return std::nullopt;
  const FigureMotion& now = context_.now;
  const auto start = std::chrono::steady_clock::now();
  std::vector<JointIndex> limits;
  VecX torques;
  if (!drives_.empty()) torques = drives_.TorquesAt(now);
  const auto failure =
      driver_->Advance(now, context_.poses.placement().hold(), drives_.empty() ? nullptr : &torques,
                       seconds, &context_.poses.workspace(), &next->q, &next->qd, &limits);
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
  if (failure) return CannotGoOnAfter(now.frame, failure->joint, failure->cause);
  work_ += static_cast<double>(driver_->solves_of_last_step()) *
           static_cast<double>(context_.poses.figure().groups().size());
  for (const int r : driver_->active()) {
    RegionReport& report = context_.recorder.report(r);
    ++report.steps;
    ++report.evaluations;
    report.solves += driver_->solves_of_last_step();
    report.microseconds += spent.count() / static_cast<double>(driver_->active().size());
  }
  const double end = context_.Seconds(next->frame);
  for (const JointIndex j : limits) context_.recorder.AddLimit(j, end, end, 1);
  return std::nullopt;
}

// A step changes rates by so much, in its time: what the joints did, friction and limits included.
void PaperWalk::TellAccelerations(double seconds, const FigureMotion& next) {
  if (!context_.wants_start && !context_.options.accelerations) return;
  const FigureMotion& now = context_.now;
  step_rate_.setZero();
  for (int j = 0; j < now.q.size(); ++j) {
    if (moves(JointIndex(j))) step_rate_[j] = (next.qd[j] - now.qd[j]) / seconds;
  }
  const MotionAcceleration at_start = Completed(now, step_rate_);
  if (now.frame == std::floor(now.frame)) {
    began_with_ = at_start;
    began_with_rates_ = now.qd;
  }
  if (!context_.options.accelerations) return;
  if (const auto output = context_.recorder.OutputAt(now.frame)) {
    context_.recorder.SetAcceleration(*output, at_start);
  }
}

std::optional<Error> PaperWalk::StepRoot(double frame_from, double seconds, Side side,
                                         FigureMotion* next) {
  RootPlacement& placement = context_.poses.placement();
  for (const RootEvent& event : placement.Step(context_.now, seconds, side, next)) {
    AddEvent(event.kind, frame_from + context_.animation.rate.FrameAt(event.seconds), event.joint);
  }
  return context_.poses.SolveHolds(side, next);
}

std::optional<Error> PaperWalk::FinishLanding() {
  RootPlacement& placement = context_.poses.placement();
  if (!placement.has_landed()) return std::nullopt;
  FigureMotion& now = context_.now;
  const JointIndex pin = placement.hold().pin;
  if (driver_ && !driver_->ApplyLanding(now, pin, &context_.poses.workspace(), &now.qd)) {
    return Error{ErrorCode::kSemantics, "", PlaceOfRegion(std::nullopt),
                 "cannot go on after the landing at frame " + FormatShort(now.frame) +
                     ": a joint in a region moves no mass"};
  }
  placement.Place(now.frame, Side::kAfter, &now);
  return std::nullopt;
}

// Output frames that fall strictly between the two ends of a step.
void PaperWalk::RecordBetween(const FigureMotion& from, const FigureMotion& to) {
  const RootPlacement& placement = context_.poses.placement();
  const auto [first, last] = context_.recorder.OutputsBetween(from.frame, to.frame);
  for (int output = first; output <= last; ++output) {
    FigureMotion between = to;
    between.frame = output / context_.recorder.outputs_per_frame();
    SetBetween(from, to, &between);
    const auto pinned = placement.has_landed() ? std::nullopt : placement.pin();
    context_.recorder.Record(output, between, LimitOf(between), pinned, &context_.poses);
    if (context_.options.accelerations) {
      context_.recorder.SetAcceleration(output, Completed(between, step_rate_));
    }
  }
}

// Curves, holds and placement are evaluated; free joints move on a straight line from step to step
// as in the paper. So does the root in a step that ends with a landing, and all that is not on a
// curve where a hold is in reach at the ends of the step but not here.
void PaperWalk::SetBetween(const FigureMotion& from, const FigureMotion& to,
                           FigureMotion* between) {
  PoseEvaluator& poses = context_.poses;
  const double u = (between->frame - from.frame) / (to.frame - from.frame);
  const auto between_ends = [&](const auto& a, const auto& b) { return (a + u * (b - a)).eval(); };
  between->q = between_ends(from.q, to.q);
  poses.SetJoints(between->frame, Side::kAfter, between);
  poses.TurnRoot(between->frame, Side::kAfter, between);
  const double seconds_before_end = context_.Seconds(to.frame - between->frame);
  if (poses.placement().PlaceWithinStep(seconds_before_end, between)) {
    if (!poses.SolveHolds(Side::kAfter, between, /*tolerance=*/0.0)) return;
    between->q = between_ends(from.q, to.q);
  }
  between->X_WR.p = between_ends(from.X_WR.p, to.X_WR.p);
  between->root.v = (to.X_WR.p - from.X_WR.p) / context_.Seconds(to.frame - from.frame);
}

}  // namespace hazumi
