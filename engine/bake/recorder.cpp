#include "engine/bake/recorder.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/bake/pose/limits.h"
#include "engine/bake/pose/pose_evaluator.h"
#include "engine/spatial/checks.h"
#include "engine/timeline/frame_time.h"

namespace hazumi {

const char* NameOf(SeamOf border) {
  switch (border) {
    case SeamOf::kRegion:
      return "region";
    case SeamOf::kPlacement:
      return "placement";
    case SeamOf::kHold:
      return "hold";
  }
  return "";
}

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
    case EventKind::kLimit:
      return "stop";
    case EventKind::kRelease:
      return "release";
    case EventKind::kBreak:
      return "break";
    case EventKind::kTouchDown:
      return "touch_down";
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

Recorder::Recorder(const Animation& animation, const BakeOptions& options, Motion* motion)
    : animation_(animation), keep_frames_(options.keep_frames), motion_(motion) {
  motion_->rate = options.output_rate.value_or(animation.rate);
  const double per_frame = outputs_per_frame();
  first_output_ = static_cast<int>(std::ceil(animation_.first_frame * per_frame - kSameFrame));
  const int last = static_cast<int>(std::floor(animation_.last_frame * per_frame + kSameFrame));
  if (keep_frames_) motion_->frames.resize(std::max(0, last - first_output_ + 1));
  motion_->regions.resize(animation_.regions.size());
  for (size_t r = 0; r < animation_.regions.size(); ++r) ClearReport(static_cast<int>(r));
}

void Recorder::BeginStretch(Stretch* stretch) {
  HAZUMI_ASSERT(stretch != nullptr && stretch->start.frame >= animation_.first_frame);
  stretch_ = stretch;
  stretch->events.clear();
  stretch->warnings.clear();
  stretch->placement_jumps.clear();
  stretch->seams.clear();
  stretch->logs.clear();
  last_limit_.assign(animation_.figure->num_joints(), std::nullopt);
  last_touch_.clear();
  first_written_.reset();
  num_written_ = IndexFrom(stretch->start.frame);
}

Recorder::Found Recorder::BeginAgain(Stretch* stretch, int first_frame) {
  IslandLogs logs = std::move(stretch->logs);
  Found found = {*stretch, motion_->regions, {}, num_written_};
  const size_t first = std::min(IndexFrom(first_frame), num_written_);
  if (keep_frames_) {
    found.frames.assign(motion_->frames.begin() + static_cast<std::ptrdiff_t>(first),
                        motion_->frames.begin() + static_cast<std::ptrdiff_t>(num_written_));
  }
  BeginStretch(stretch);
  stretch->logs = std::move(logs);
  const double end = animation_.rate.SecondsAt(first_frame);
  for (const MotionEvent& event : found.stretch.events) {
    if (animation_.rate.FrameAt(event.time) < first_frame - kSameFrame) Keep(event, end);
  }
  first_written_ = first_frame;
  return found;
}

void Recorder::Restore(Found found) {
  found.stretch.logs = std::move(stretch_->logs);
  *stretch_ = std::move(found.stretch);
  motion_->regions = std::move(found.reports);
  std::move(found.frames.begin(), found.frames.end(),
            motion_->frames.begin() +
                static_cast<std::ptrdiff_t>(found.num_written - found.frames.size()));
  num_written_ = found.num_written;
}

// Index of the first output at this frame of the animation or after it.
size_t Recorder::IndexFrom(int frame) const {
  const double output = std::ceil(frame * outputs_per_frame() - kSameFrame);
  return static_cast<size_t>(std::max(0.0, output - first_output_));
}

// Adds an event of the solution before, which lasts until `end` [s] at most. Later impacts that
// chatter on with it are counted to it.
void Recorder::Keep(MotionEvent event, double end) {
  HAZUMI_ASSERT(std::isfinite(event.time) && event.count > 0);
  const size_t index = stretch_->events.size();
  event.last_time = std::min(event.last_time, end);
  stretch_->events.push_back(event);
  if (event.kind == EventKind::kTouchDown) last_touch_[{event.link, event.on}] = index;
  if (event.kind != EventKind::kLimit) return;
  if (const auto joint = animation_.figure->FindJoint(event.joint)) {
    last_limit_[joint->value()] = index;
  }
}

// Returns null for a frame that is not recorded or keeps its value.
MotionFrame* Recorder::FrameToWrite(int output) {
  if (!keep_frames_ || stays(output / outputs_per_frame())) return nullptr;
  num_written_ = std::max(num_written_, static_cast<size_t>(output - first_output_) + 1);
  return &motion_->frames[output - first_output_];
}

void Recorder::DropUnwritten() {
  if (keep_frames_) motion_->frames.resize(num_written_);
}

void Recorder::ClearReport(int region) {
  HAZUMI_ASSERT(0 <= region && region < static_cast<int>(animation_.regions.size()));
  const DynamicsRegion& own = animation_.regions[region];
  RegionReport report;
  report.name = own.name;
  report.method = own.method;
  report.step = own.step.value_or(animation_.solver.step);
  report.tolerance = own.tolerance.value_or(animation_.solver.tolerance);
  report.free_joints = static_cast<int>(own.joints.size());
  report.all_joints = animation_.figure->num_joints();
  motion_->regions[region] = report;
}

double Recorder::outputs_per_frame() const {
  return static_cast<double>(animation_.rate.den) * motion_->rate.num /
         (static_cast<double>(animation_.rate.num) * motion_->rate.den);
}

std::optional<int> Recorder::OutputAt(double frame) const {
  const double output = frame * outputs_per_frame();
  if (std::abs(output - std::round(output)) > kSameFrame) return std::nullopt;
  return static_cast<int>(std::round(output));
}

std::vector<int> Recorder::OutputsUpTo(double from, double to, double end) const {
  HAZUMI_ASSERT(from <= to);
  const double per_frame = outputs_per_frame();
  const int first = static_cast<int>(std::floor(from * per_frame + kSameFrame)) + 1;
  std::vector<int> outputs;
  for (int output = first; output <= to * per_frame + kSameFrame; ++output) {
    if (output / per_frame > end - kSameFrame) break;
    outputs.push_back(output);
  }
  return outputs;
}

std::pair<int, int> Recorder::OutputsBetween(double from, double to) const {
  const double per_frame = outputs_per_frame();
  return {static_cast<int>(std::floor(from * per_frame + kSameFrame)) + 1,
          static_cast<int>(std::ceil(to * per_frame - kSameFrame)) - 1};
}

void Recorder::Record(int output, const FigureMotion& motion, const MotionLimit& before,
                      std::optional<GroupIndex> pinned, PoseEvaluator* poses) {
  MotionFrame* const written = FrameToWrite(output);
  if (!written && animation_.held_objects.empty()) return;
  DynamicsWorkspace& ws = poses->workspace();
  ComputePositions(poses->figure(), motion.X_WR, motion.q, &ws);
  std::vector<ObjectPose> objects;
  for (size_t i = 0; i < animation_.held_objects.size(); ++i) {
    objects.push_back(poses->objects().At(i, motion, ws));
    WarnIfStuck(i, motion.frame, poses->objects());
  }
  WarnIfInsideEachOther(objects, motion, poses->objects());
  if (!written) return;
  MotionFrame& frame = *written;
  frame.frame = output;
  frame.q = motion.q;
  frame.X_WR = motion.X_WR;
  frame.before = before;
  frame.after = LimitOf(motion);
  frame.com = CenterOfMass(poses->figure(), ws);
  frame.pinned = pinned;
  frame.objects = std::move(objects);
  frame.in_region = poses->free();
  frame.acceleration.reset();
  frame.constraint_forces.assign(animation_.constraints.size(), 0.0);
  frame.constraint_pushes.assign(animation_.constraints.size(), {});
  frame.contacts = {};
}

void Recorder::WarnIfStuck(size_t object, double frame, const HeldObjects& objects) {
  const std::optional<double> from = objects.StuckFrom(object);
  if (!from || animation_.rate.SecondsAt(frame) <= *from) return;
  const int stuck = static_cast<int>(std::floor(animation_.rate.FrameAt(*from)));
  AddWarning({"held_objects[" + std::to_string(object) + "].contacts",
              "\"" + animation_.held_objects[object].name + "\" cannot go on beyond frame " +
                  std::to_string(stuck) +
                  " with what it touches, and stays there; move what stands there",
              stuck});
}

// Warns of balls that fly through each other, which only a region with contacts prevents.
void Recorder::WarnIfInsideEachOther(const std::vector<ObjectPose>& places,
                                     const FigureMotion& motion, const HeldObjects& objects) {
  constexpr double kDeep = 1e-4;  // [m]
  const auto radius_of = [&](size_t i) {
    const HeldObject& object = animation_.held_objects[i];
    const auto* sphere = std::get_if<SphereShape>(&object.shape);
    const bool flies = places[i].holder < 0 && objects.states()[i].flight.has_value();
    return flies && object.touches_scene && sphere ? sphere->radius : 0.0;
  };
  if (!motion.loose.empty()) return;  // a region's contacts keep them apart
  for (size_t i = 0; i < places.size(); ++i) {
    for (size_t k = i + 1; k < places.size(); ++k) {
      const double a = radius_of(i), b = radius_of(k);
      if (a == 0.0 || b == 0.0) continue;
      if ((places[i].X_WO.p - places[k].X_WO.p).norm() > a + b - kDeep) continue;
      AddWarning({"held_objects[" + std::to_string(k) + "].contacts",
                  "\"" + animation_.held_objects[i].name + "\" and \"" +
                      animation_.held_objects[k].name +
                      "\" fly through each other: balls collide with each other only while a "
                      "region touches the scene; let one last until they have met",
                  static_cast<int>(std::floor(motion.frame))});
    }
  }
}

void Recorder::SetAcceleration(int output, MotionAcceleration acceleration) {
  if (MotionFrame* frame = FrameToWrite(output)) frame->acceleration = std::move(acceleration);
}

void Recorder::SetConstraintPushes(int output, const std::vector<ConstraintPush>& pushes) {
  MotionFrame* const frame = FrameToWrite(output);
  if (!frame) return;
  frame->constraint_forces.clear();
  frame->constraint_pushes.clear();
  for (const ConstraintPush& push : pushes) {
    frame->constraint_forces.push_back(push.size);
    frame->constraint_pushes.push_back(push.on_a);
  }
}

void Recorder::SetContacts(int output, SceneContacts contacts) {
  if (MotionFrame* frame = FrameToWrite(output)) frame->contacts = std::move(contacts);
}

void Recorder::AddEvent(EventKind kind, double frame, const std::string& joint) {
  if (stays(frame)) return;
  const double seconds = animation_.rate.SecondsAt(frame);
  const double output = motion_->rate.FrameAt(seconds);
  const double rounded = kind == EventKind::kApex ? std::round(output) : std::ceil(output - 1e-9);
  stretch_->events.push_back({kind, seconds, static_cast<int>(rounded), joint});
}

// Impacts that began in the frames that stay, of which `event` is the last one there, may go on
// after them.
void Recorder::Lengthen(std::optional<size_t> event, double last_time, long count) {
  if (!event || stays(animation_.rate.FrameAt(last_time))) return;
  MotionEvent& kept = stretch_->events[*event];
  kept.last_time = std::max(kept.last_time, last_time);
  kept.count = std::max(kept.count, count);
}

// Or goes on with the event that it chatters on with.
void Recorder::AddLimit(JointIndex j, double time, double last_time, long count) {
  HAZUMI_ASSERT(time <= last_time && count > 0);
  auto& last = last_limit_[j.value()];
  if (stays(animation_.rate.FrameAt(time))) return Lengthen(last, last_time, count);
  if (last && time - stretch_->events[*last].last_time < kChatterGap) {
    MotionEvent& event = stretch_->events[*last];
    event.count += count;
    event.last_time = last_time;
    return;
  }
  last = stretch_->events.size();
  AddEvent(EventKind::kLimit, animation_.rate.FrameAt(time), animation_.figure->joint(j).name);
  if (count == 1) return;
  stretch_->events.back().count = count;
  stretch_->events.back().last_time = last_time;
}

// Adds a touch-down, or counts it to the event that it repeats within kChatterGap.
void Recorder::AddTouch(const TouchDown& touch) {
  HAZUMI_ASSERT(touch.time <= touch.last_time && touch.count > 0);
  const double frame = animation_.rate.FrameAt(touch.time);
  MotionEvent event = TouchEvent(touch);
  if (stays(frame)) {
    const auto last = last_touch_.find({event.link, event.on});
    const bool is_known = last != last_touch_.end();
    return Lengthen(is_known ? std::optional(last->second) : std::nullopt, event.last_time,
                    event.count);
  }
  const auto [entry, is_new] = last_touch_.try_emplace({event.link, event.on});
  if (!is_new) {
    MotionEvent& last = stretch_->events[entry->second];
    if (touch.time - last.last_time < kChatterGap) {
      last.count += event.count;
      last.last_time = event.last_time;
      return;
    }
  }
  entry->second = stretch_->events.size();
  AddEvent(EventKind::kTouchDown, frame, event.joint);
  event.time = stretch_->events.back().time;
  event.frame = stretch_->events.back().frame;
  stretch_->events.back() = std::move(event);
}

// Returns an event with the names of the bodies and without the time.
MotionEvent Recorder::TouchEvent(const TouchDown& touch) const {
  const auto ball_name = [&](int ball) { return animation_.held_objects[ball].name; };
  const std::vector<Link>& links = animation_.figure->links();
  MotionEvent event = {EventKind::kTouchDown, 0.0, 0, ""};
  if (touch.parts.link >= 0) {
    const Link& link = links[touch.parts.link];
    event.link = link.name;
    event.joint = link.joint.is_valid() ? animation_.figure->joint(link.joint).name
                                        : animation_.figure->root_name();
  } else if (touch.ball >= 0) {
    event.link = ball_name(touch.ball);
  }
  if (touch.parts.object >= 0) event.on = animation_.scene[touch.parts.object].name;
  if (touch.parts.by_link >= 0) event.on = links[touch.parts.by_link].name;
  if (touch.parts.by_ball >= 0) event.on = ball_name(touch.parts.by_ball);
  event.count = touch.count;
  event.last_time = touch.last_time;
  return event;
}

void Recorder::AddWarning(Warning warning) { stretch_->warnings.push_back(std::move(warning)); }

void Recorder::AddJump(PlacementJump jump, const std::string& message) {
  AddWarning("placements[" + std::to_string(jump.placement) + "]", message);
  stretch_->placement_jumps.push_back(jump);
}

}  // namespace hazumi
