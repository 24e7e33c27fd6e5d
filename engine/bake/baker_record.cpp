// What is kept of a bake.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/bake/baker.h"
#include "engine/bake/limits.h"

namespace hazumi {

namespace {

constexpr double kSameFrame = 1e-9;  // instants this near are one [frames]

}  // namespace

const char* NameOf(EventKind kind) {
  switch (kind) {
    case EventKind::kTakeOff:
      return "take_off";
    case EventKind::kApex:
      return "apex";
    case EventKind::kLanding:
      return "landing";
    case EventKind::kPinChange:
      return "pin_change";
    case EventKind::kStop:
      return "stop";
    case EventKind::kRelease:
      return "release";
  }
  return "";
}

void SortByTime(std::vector<MotionEvent>* events) {
  std::stable_sort(events->begin(), events->end(),
                   [](const MotionEvent& a, const MotionEvent& b) { return a.time < b.time; });
}

void DropRepeated(std::vector<Warning>* warnings) {
  std::set<std::pair<std::string, std::string>> said;
  std::erase_if(*warnings, [&](const Warning& warning) {
    return !said.emplace(warning.place, warning.message).second;
  });
}

void Baker::Record(int output_frame, const FigureMotion& motion, const MotionLimit& before,
                   std::optional<GroupIndex> pinned) {
  if (!keep_frames_) return;
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  MotionFrame& frame = motion_->frames[output_frame - first_output_];
  frame.frame = output_frame;
  frame.q = motion.q;
  frame.X_WR = motion.X_WR;
  frame.before = before;
  frame.after = LimitOf(motion);
  frame.com = CenterOfMass(figure_, ws_);
  frame.pinned = pinned;
  frame.objects.clear();
  for (const ObjectFlight& object : objects_) {
    frame.objects.push_back(object.At(ws_, Seconds(motion.frame)));
  }
  frame.in_region = free_;
}

double Baker::OutputFramesPerFrame() const {
  return static_cast<double>(animation_.rate.den) * motion_->rate.num /
         (static_cast<double>(animation_.rate.num) * motion_->rate.den);
}

// The end of a step that coincides with an output frame: the same bits at any output rate.
void Baker::RecordIfOutput() {
  const double output = now_.frame * OutputFramesPerFrame();
  if (std::abs(output - std::round(output)) > kSameFrame) return;
  Record(static_cast<int>(std::round(output)), now_, before_, pinned());
}

// Output frames after `from` up to and including `to`, but for `end`.
std::vector<int> Baker::OutputFrames(double from, double to, double end) const {
  const double per_frame = OutputFramesPerFrame();
  const int first = static_cast<int>(std::floor(from * per_frame + kSameFrame)) + 1;
  std::vector<int> frames;
  for (int output = first; output <= to * per_frame + kSameFrame; ++output) {
    if (output / per_frame > end - kSameFrame) break;
    frames.push_back(output);
  }
  return frames;
}

Baker::Failure Baker::RecordUpTo(double from, double to, double end) {
  if (!keep_frames_ && !exact_ && holds_.empty()) return std::nullopt;  // nothing can go wrong
  for (const int output : OutputFrames(from, to, end)) {
    if (is_cancelled()) return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
    const double frame = output / OutputFramesPerFrame();
    FigureMotion motion;
    if (auto error = PoseAt(frame, Side::kAfter, &motion)) return error;
    if (exact_) exact_->Estimate(Seconds(frame));
    Record(output, motion, LimitOf(motion), pinned());
  }
  return std::nullopt;
}

// Output frames that fall strictly between the two ends of a step.
void Baker::RecordBetween(const FigureMotion& from, const FigureMotion& to) {
  const double per_frame = OutputFramesPerFrame();
  const int first = static_cast<int>(std::floor(from.frame * per_frame + kSameFrame)) + 1;
  const int last = static_cast<int>(std::ceil(to.frame * per_frame - kSameFrame)) - 1;
  for (int output = first; output <= last; ++output) {
    FigureMotion between = to;
    between.frame = output / per_frame;
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

void Baker::AddEvent(EventKind kind, double frame, const std::string& joint) {
  const double seconds = Seconds(frame);
  const double output = motion_->rate.FrameAt(seconds);
  const double rounded = kind == EventKind::kApex ? std::round(output) : std::ceil(output - 1e-9);
  stretch_->events.push_back({kind, seconds, static_cast<int>(rounded), joint});
}

// Or goes on with the event that it chatters on with.
void Baker::AddStop(JointIndex j, double time, double last_time, long count) {
  auto& last = last_stop_[j.value()];
  if (last && time - stretch_->events[*last].last_time < kChatterGap) {
    MotionEvent& event = stretch_->events[*last];
    event.count += count;
    event.last_time = last_time;
    return;
  }
  last = stretch_->events.size();
  AddEvent(EventKind::kStop, animation_.rate.FrameAt(time), figure_.joint(j).name);
  if (count == 1) return;
  stretch_->events.back().count = count;
  stretch_->events.back().last_time = last_time;
}

void Baker::AddPinEvent(int frame) {
  if (const auto pin = pinned()) AddEvent(EventKind::kPinChange, frame, figure_.group(*pin).name);
}

void Baker::AddWarning(const std::string& place, const std::string& message) {
  stretch_->warnings.push_back({place, message});
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
