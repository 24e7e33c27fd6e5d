#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "engine/bake/bake.h"
#include "engine/bake/change_schedule.h"
#include "engine/bake/handover/region_start.h"
#include "engine/bake/pose/limits.h"
#include "engine/bake/pose/pose_evaluator.h"
#include "engine/bake/recorder.h"

namespace hazumi {

// What the parts of a bake share: where it is, what says how the figure is, what changes when, and
// what is written down.
struct BakeContext {
  // The animation and the motion must outlive it.
  BakeContext(const Animation& of, const BakeOptions& with, Motion* motion)
      : animation(of),
        options(with),
        schedule(of),
        recorder(of, with, motion),
        poses(of, &recorder) {}
  BakeContext(const BakeContext&) = delete;  // its parts know each other
  BakeContext& operator=(const BakeContext&) = delete;

  double Seconds(double frames) const { return animation.rate.SecondsAt(frames); }
  std::string NameOf(GroupIndex group) const { return poses.figure().group(group).name; }

  // An error if someone wants it to end.
  std::optional<Error> CheckCancelled() const {
    if (!options.cancel || !options.cancel->load(std::memory_order_relaxed)) return std::nullopt;
    return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
  }

  void Arrive(FigureMotion motion) {
    now = std::move(motion);
    before = LimitOf(now);
  }
  void Record(int output, const FigureMotion& motion, const MotionLimit& left) {
    recorder.Record(output, motion, left, poses.placement().pin(), &poses);
  }
  // Now, if there is an output frame: the same bits at any output rate.
  void RecordNow() {
    if (const auto output = recorder.OutputAt(now.frame)) Record(*output, now, before);
  }

  const Animation& animation;
  const BakeOptions options;
  ChangeSchedule schedule;
  Recorder recorder;
  PoseEvaluator poses;
  std::map<int, RegionStart> starts;  // of the regions that have begun, by index
  FigureMotion now;
  MotionLimit before;  // left-sided limit at now.frame
  // Warning with the frame where the bake ended early, because of BakeOptions::most_work.
  std::optional<Warning> ended_early;
  bool wants_start = false;  // requests the accelerations at the start of a walk
};

}  // namespace hazumi
