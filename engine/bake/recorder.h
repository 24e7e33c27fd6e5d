#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/bake/bake.h"
#include "engine/bake/stretch.h"

namespace hazumi {

class HeldObjects;
class PoseEvaluator;

// Writes down what a bake finds: frames and reports into the motion, events and warnings into the
// stretch that is baked.
class Recorder {
 public:
  // Makes room for all frames, and reports of regions that did nothing yet. The animation must
  // outlive it, and so must the motion.
  Recorder(const Animation& animation, const BakeOptions& options, Motion* motion);

  // From here on events and warnings go to this stretch, which has none.
  void BeginStretch(Stretch* stretch);
  // Begins a stretch that is solved again. Frames and events before `first_frame` keep their
  // values. What the first solution found is returned, for Restore.
  struct Found {
    Stretch stretch;
    std::vector<RegionReport> reports;
    std::vector<MotionFrame> frames;  // from `first_frame` on
    size_t num_written = 0;
  };
  Found BeginAgain(Stretch* stretch, int first_frame);
  // Replaces what was found since by what was found before. The logs of both are kept.
  void Restore(Found found);

  bool keeps_frames() const { return keep_frames_; }
  // Output frames a frame of the animation; they are equally spaced, and frame 0 is at frame 0.
  double outputs_per_frame() const;
  // The output frame at a frame of the animation, if there is one.
  std::optional<int> OutputAt(double frame) const;
  // Those after `from` up to and including `to`, but for `end`; frames of the animation.
  std::vector<int> OutputsUpTo(double from, double to, double end) const;
  // Those strictly between two frames: first and last.
  std::pair<int, int> OutputsBetween(double from, double to) const;
  // The figure at `motion`, as the evaluator has it loaded; its workspace is filled.
  void Record(int output, const FigureMotion& motion, const MotionLimit& before,
              std::optional<GroupIndex> pinned, PoseEvaluator* poses);
  // Of a frame that is recorded.
  void SetAcceleration(int output, MotionAcceleration acceleration);
  void SetConstraintPushes(int output, const std::vector<ConstraintPush>& pushes);
  void SetContacts(int output, SceneContacts contacts);

  // Frames of the animation; seconds.
  void AddEvent(EventKind kind, double frame, const std::string& joint);
  void AddLimit(JointIndex j, double time, double last_time, long count);
  void AddTouch(const TouchDown& touch);
  void AddWarning(const std::string& place, const std::string& message) {
    AddWarning({place, message});
  }
  void AddWarning(Warning warning);
  void AddJump(PlacementJump jump, const std::string& message);
  void AddSeam(const Seam& seam) { stretch_->seams.push_back(seam); }
  IslandLogs& logs() { return stretch_->logs; }
  // Removes the frames after the last one that was recorded, where a bake ends early.
  void DropUnwritten();

  RegionReport& report(int region) { return motion_->regions[region]; }
  // As of a region that did nothing yet.
  void ClearReport(int region);

 private:
  void WarnIfStuck(size_t object, double frame, const HeldObjects& objects);
  void WarnIfInsideEachOther(const std::vector<ObjectPose>& places, const FigureMotion& motion,
                             const HeldObjects& objects);
  MotionFrame* FrameToWrite(int output);
  MotionEvent TouchEvent(const TouchDown& touch) const;
  size_t IndexFrom(int frame) const;
  void Keep(MotionEvent event, double end);
  void Lengthen(std::optional<size_t> event, double last_time, long count);
  bool stays(double frame) const { return first_written_ && frame < *first_written_ - kSameFrame; }

  const Animation& animation_;
  bool keep_frames_;
  Motion* motion_;
  Stretch* stretch_ = nullptr;
  std::optional<int> first_written_;  // earlier frames keep their values
  int first_output_ = 0;
  size_t num_written_ = 0;  // number of frames up to the last one recorded of the stretch
  std::vector<std::optional<size_t>> last_limit_;  // by JointIndex: its latest event in the stretch
  // The latest touch-down of a link or ball on something, by their names, likewise.
  std::map<std::pair<std::string, std::string>, size_t> last_touch_;
};

}  // namespace hazumi
