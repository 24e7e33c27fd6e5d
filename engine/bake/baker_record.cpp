// Frames of the output: at the ends of steps, and between.

#include "engine/bake/baker.h"
#include "engine/bake/limits.h"

namespace hazumi {

void Baker::Record(int output, const FigureMotion& motion, const MotionLimit& before,
                   std::optional<GroupIndex> pinned) {
  recorder_.Record(output, figure_, motion, before, pinned, objects_, free_, &ws_);
}

// The end of a step that coincides with an output frame: the same bits at any output rate.
void Baker::RecordIfOutput() {
  if (const auto output = recorder_.OutputAt(now_.frame)) Record(*output, now_, before_, pinned());
}

Baker::Failure Baker::RecordUpTo(double from, double to, double end) {
  const bool can_fail = exact_ || !holds_.empty();
  if (!recorder_.keeps_frames() && !can_fail) return std::nullopt;
  for (const int output : recorder_.OutputsUpTo(from, to, end)) {
    if (is_cancelled()) return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
    const double frame = output / recorder_.outputs_per_frame();
    FigureMotion motion;
    if (auto error = PoseAt(frame, Side::kAfter, &motion)) return error;
    if (exact_) exact_->Estimate(Seconds(frame));
    Record(output, motion, LimitOf(motion), pinned());
  }
  return std::nullopt;
}

// Output frames that fall strictly between the two ends of a step.
void Baker::RecordBetween(const FigureMotion& from, const FigureMotion& to) {
  const auto [first, last] = recorder_.OutputsBetween(from.frame, to.frame);
  for (int output = first; output <= last; ++output) {
    FigureMotion between = to;
    between.frame = output / recorder_.outputs_per_frame();
    SetBetween(from, to, &between);
    const bool lands = gravity_ && gravity_->has_landed();
    Record(output, between, LimitOf(between), lands ? std::nullopt : pinned());
  }
}

// Curves, holds and placement are evaluated; free joints move on a straight line from step to step
// as in the paper. So does the root in a step that ends with a landing, and all that is not on a
// curve where a hold is in reach at the ends of the step but not here.
void Baker::SetBetween(const FigureMotion& from, const FigureMotion& to, FigureMotion* between) {
  const double u = (between->frame - from.frame) / (to.frame - from.frame);
  between->q = from.q + u * (to.q - from.q);
  if (gravity_) {
    curves_.SampleJoints(between->frame, Side::kAfter, free_, between);
    curves_.SampleRootOrientation(between->frame, Side::kAfter, between);
    const double seconds_before_end = Seconds(to.frame - between->frame);
    if (!gravity_->has_landed()) return gravity_->Place(&ws_, between, seconds_before_end);
  } else {
    is_between_ = true;
    const bool is_reached = !Evaluate(between->frame, Side::kAfter, between);
    is_between_ = false;
    if (is_reached) return;
    between->q = from.q + u * (to.q - from.q);
  }
  between->X_WR.p = from.X_WR.p + u * (to.X_WR.p - from.X_WR.p);
  between->root.v = (to.X_WR.p - from.X_WR.p) / Seconds(to.frame - from.frame);
}

void Baker::AddPinEvent(int frame) {
  const std::optional<GroupIndex> pin = pinned();
  if (pin) recorder_.AddEvent(EventKind::kPinChange, frame, figure_.group(*pin).name);
}

std::optional<GroupIndex> Baker::pinned() const {
  if (gravity_) return gravity_->pin();
  if (fall_) return fall_->pin();
  if (span_ && span_->kind == PlacementKind::kPinned) return span_->pin;
  return std::nullopt;
}

RootHold Baker::root_hold() const {
  if (gravity_ && !gravity_->pin()) return {RootCoupling::kFlight, JointIndex()};
  if (fall_ && !fall_->pin()) return {RootCoupling::kFlight, JointIndex()};
  if (const auto pin = pinned()) return {RootCoupling::kPinned, figure_.group(*pin).first};
  return {RootCoupling::kPrescribed, JointIndex()};
}

}  // namespace hazumi
