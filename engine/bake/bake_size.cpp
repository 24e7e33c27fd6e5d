// What a bake takes of memory, told from what the animation says.

#include "engine/bake/bake_size.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/bake/motion.h"
#include "engine/base/text.h"
#include "engine/timeline/frame_time.h"

namespace hazumi {

namespace {

constexpr double kBlock = 16.0;  // that the heap adds to a block [bytes]

double Gigabytes(double bytes) { return bytes / 1e9; }

// Of the paper's method, in frames that each take whole steps.
double NumSteps(const Animation& animation, double step, double frames) {
  return frames * std::ceil(animation.rate.seconds_per_frame() / step);
}

std::optional<Error> CheckSteps(double steps, const std::string& place) {
  if (steps <= kMostSteps) return std::nullopt;
  return Error{ErrorCode::kSemantics, "", place,
               "its frames would take " + FormatShort(steps) + " steps; at most " +
                   FormatShort(kMostSteps) + " are taken: choose a longer step or fewer frames"};
}

}  // namespace

double NumOutputFrames(const Animation& animation, const FrameRate& rate) {
  const double seconds = animation.rate.SecondsAt(1.0);
  const double first = rate.FrameAt(seconds * animation.first_frame);
  const double last = rate.FrameAt(seconds * animation.last_frame);
  return std::floor(last + kSameFrame) - std::ceil(first - kSameFrame) + 1.0;
}

// A frame has five vectors of all joints, what is held, and which joints are in a region.
double MotionBytes(const Animation& animation, const FrameRate& rate) {
  const double n = animation.figure->num_joints();
  const double objects = static_cast<double>(animation.held_objects.size());
  const double held = static_cast<double>(animation.constraints.size());
  const double frame = sizeof(MotionFrame) + 5.0 * (n * sizeof(double) + kBlock) + n + kBlock +
                       (objects > 0.0 ? objects * sizeof(ObjectPose) + kBlock : 0.0) +
                       (held > 0.0 ? held * (sizeof(double) + sizeof(Wrench)) + 2 * kBlock : 0.0);
  return frame * std::max(0.0, NumOutputFrames(animation, rate));
}

// For each frame its time, and angle and rate of each free hinge: of the solution and of its
// control solution.
double LogBytes(const Animation& animation) {
  double bytes = 0.0;
  for (const DynamicsRegion& region : animation.regions) {
    if (region.method != Method::kExact) continue;
    const double hinges = static_cast<double>(region.joints.size()) + (region.root ? 3.0 : 0.0);
    const double frames = static_cast<double>(region.last_frame) - region.first_frame;
    bytes += frames * 2.0 * (1.0 + 2.0 * hinges) * sizeof(double);
  }
  return bytes;
}

std::optional<Error> CheckSteps(const Animation& animation) {
  const double frames = static_cast<double>(animation.last_frame) - animation.first_frame;
  if (animation.solver.method == Method::kPaper) {
    const double steps = NumSteps(animation, animation.solver.step, frames);
    if (auto error = CheckSteps(steps, "solver.step_s")) return error;
  }
  for (size_t r = 0; r < animation.regions.size(); ++r) {
    const DynamicsRegion& region = animation.regions[r];
    if (region.moves_nothing() || region.method != Method::kPaper) continue;
    const double steps = NumSteps(animation, region.step.value_or(animation.solver.step),
                                  static_cast<double>(region.last_frame) - region.first_frame);
    if (auto error = CheckSteps(steps, "regions[" + std::to_string(r) + "].step_s")) return error;
  }
  return std::nullopt;
}

std::optional<Error> CheckBytes(double bytes, const Animation& animation, const FrameRate& rate) {
  if (bytes <= kMostMotionBytes) return std::nullopt;
  return Error{ErrorCode::kSemantics, "", "frames",
               std::to_string(std::lround(NumOutputFrames(animation, rate))) + " frames of " +
                   std::to_string(animation.figure->num_joints()) + " joints would need " +
                   FormatShort(Gigabytes(bytes)) + " GB of memory; at most " +
                   FormatShort(Gigabytes(kMostMotionBytes)) +
                   " GB are taken: animate fewer frames, or ask for fewer a second"};
}

}  // namespace hazumi
