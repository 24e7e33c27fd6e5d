// What is kept of a bake.

#include <cmath>

#include "engine/bake/baker.h"
#include "engine/bake/rates.h"

namespace hazumi {

const char* NameOf(EventKind kind) {
  switch (kind) {
    case EventKind::kTakeOff: return "take_off";
    case EventKind::kApex: return "apex";
    case EventKind::kLanding: return "landing";
    case EventKind::kPinChange: return "pin_change";
    case EventKind::kStop: return "stop";
    case EventKind::kRelease: return "release";
  }
  return "";
}

void Baker::Record(int output_frame, const FigureMotion& motion, const MotionRates& before) {
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  MotionFrame frame;
  frame.frame = output_frame;
  frame.q = motion.q;
  frame.X_WR = motion.X_WR;
  frame.before = before;
  frame.after = RatesOf(motion);
  frame.com = CenterOfMass(figure_, ws_);
  frame.pinned = pinned();
  for (const ObjectFlight& object : objects_) {
    frame.objects.push_back(object.At(ws_, Seconds(motion.frame)));
  }
  frame.in_region = free_;
  motion_.frames.push_back(std::move(frame));
}

// Output frames that fall strictly between two steps. Curves are evaluated there; free joints, and
// a root placed by gravity, move on a straight line from step to step as in the paper.
void Baker::RecordBetween(const FigureMotion& from, const FigureMotion& to) {
  if (motion_.rate == animation_.rate) return;
  const double per_frame =
      motion_.rate.frames_per_second() / animation_.rate.frames_per_second();
  const int first = static_cast<int>(std::floor(from.frame * per_frame + 1e-9)) + 1;
  const int last = static_cast<int>(std::ceil(to.frame * per_frame - 1e-9)) - 1;
  for (int output = first; output <= last; ++output) {
    const double frame = output / per_frame;
    const double u = (frame - from.frame) / (to.frame - from.frame);
    FigureMotion between = to;
    between.q = from.q + u * (to.q - from.q);
    between.X_WR.p = from.X_WR.p + u * (to.X_WR.p - from.X_WR.p);
    const Vec3 p = between.X_WR.p;
    if (gravity_) {
      curves_.SampleJoints(frame, Side::kAfter, free_, &between);
      curves_.SampleRootOrientation(frame, Side::kAfter, &between);
      between.X_WR.p = p;
    } else if (Evaluate(frame, Side::kAfter, &between)) {
      continue;  // a hold out of reach: the step's own end reports it
    }
    between.frame = frame;
    Record(output, between, RatesOf(between));
  }
}

// The output frame that coincides with a frame of the animation.
std::optional<int> Baker::OutputFrameAt(int frame) const {
  const long long numerator =
      static_cast<long long>(frame) * animation_.rate.den * motion_.rate.num;
  const long long denominator = static_cast<long long>(animation_.rate.num) * motion_.rate.den;
  if (numerator % denominator != 0) return std::nullopt;
  return static_cast<int>(numerator / denominator);
}

void Baker::AddEvent(EventKind kind, double frame, const std::string& joint) {
  const double seconds = Seconds(frame);
  const double output = motion_.rate.FrameAt(seconds);
  const double rounded = kind == EventKind::kApex ? std::round(output) : std::ceil(output - 1e-9);
  motion_.events.push_back({kind, seconds, static_cast<int>(rounded), joint});
}

void Baker::AddPinEvent(int frame) {
  if (const auto pin = pinned()) AddEvent(EventKind::kPinChange, frame, figure_.group(*pin).name);
}

void Baker::AddWarning(const std::string& place, const std::string& message) {
  motion_.warnings.push_back({place, message});
}

std::optional<GroupIndex> Baker::pinned() const {
  if (gravity_) return gravity_->pin();
  if (span_ && span_->kind == PlacementKind::kPinned) return span_->pin;
  return std::nullopt;
}

RootHold Baker::root_hold() const {
  if (gravity_ && !gravity_->pin()) return {RootCoupling::kFlight, JointIndex()};
  if (const auto pin = pinned()) return {RootCoupling::kPinned, figure_.group(*pin).first};
  return {RootCoupling::kPrescribed, JointIndex()};
}

}  // namespace hazumi
