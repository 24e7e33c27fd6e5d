#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/bake/bake.h"
#include "engine/bake/change_schedule.h"
#include "engine/bake/curve_set.h"
#include "engine/bake/exact_driver.h"
#include "engine/bake/known_holds.h"
#include "engine/bake/recorder.h"
#include "engine/bake/region_driver.h"
#include "engine/bake/stretch.h"

namespace hazumi {

// Walks through an animation, stretch by stretch. Between two frames the same regions, holds and
// placement are active; they change at frames only. What is to be done by the paper's method takes
// equal steps within each frame; the rest goes in continuous time from one change to the next.
class Baker {
 public:
  // The motion that it fills: its frames and the reports of its regions. The threads that help.
  Baker(const Animation& animation, const BakeOptions& options, Motion* motion, ThreadPool* pool);

  // The animation's first frame.
  Result<Checkpoint> Begin();
  // Bakes from stretch->start up to the next checkpoint, which is returned unless the animation
  // ends before. Regions are not solved anew where one of the logs in `known` tells what they do;
  // null: nothing will be asked again, and no logs are kept.
  Result<std::optional<Checkpoint>> BakeStretch(const KnownLogs* known, Stretch* stretch);

  // A curve of the animation is about to change its keys, or has changed them.
  void RemoveKeys(const Keys& keys) { schedule_.RemoveKeys(keys); }
  void AddKeys(const Keys& keys) { schedule_.AddKeys(keys); }
  // Regions of the animation have changed, but not their number.
  void RegionsChanged();

 private:
  struct ActiveHold {
    const IkHold* hold;
    HoldSolver solver;
    HoldTarget target;
    bool is_warned_of = false;  // in this stretch
  };
  using Failure = std::optional<Error>;

  // Stretches (baker.cpp).
  Checkpoint Save(int frame);
  void Restore(const Checkpoint& checkpoint);
  void LoadFigure();
  Result<int> AdvanceToCheckpoint(int frame);
  bool Sharpen();

  // At a frame: what ends, what begins (baker_boundary.cpp).
  Failure CrossFrame(int frame);
  bool Ends(int last_frame, int frame) const;
  bool EndRegions(int frame);
  bool EndHolds(int frame);
  bool EndPlacement(int frame);
  bool ReleaseObjects(int frame);
  bool BeginRegions(int frame);
  bool BeginHolds(int frame);
  bool BeginPlacement(int frame, bool was_keyed);
  void TakeKeyedVelocity(int frame);
  void RebuildDriver(int frame);
  void ReportStep(int region, int frame);
  void BeginRoot(int frame);
  void StartFreeJoint(JointIndex j, int frame, bool handed_over);
  void WarnIfNoKeyAfter(int frame, JointIndex j, const char* list, size_t index);
  void WarnOfVelocityJump(int frame);
  void WarnOfDistance(int frame);

  // After a region (baker_resume.cpp).
  void ResumeAfterRegion(int frame, size_t region);
  void ResumeJoint(int frame, JointIndex j, double rate, const DynamicsRegion& region);
  void ResumeCurve(int frame, double angle, double rate, const DynamicsRegion& region,
                   const Joint* joint, CurveTrack* curve);
  double Overshoot(int frame, JointIndex j);
  void LimitTangent(int frame, JointIndex j, size_t region);
  void EndRoot(int frame, const DynamicsRegion& region);

  bool IsExact(int frame) const;

  // In continuous time from a frame to the next at which something changes (baker_exact.cpp).
  Result<int> AdvanceExact(int frame);
  Failure AdvancePiece(double from, double to, double end);
  Failure AdvanceUndisturbed(double from, double to, double end);
  Failure AdvanceAhead(const std::vector<double>& times, double from, double next, double to,
                       double end);
  void AddHits(double until);
  double DriveCurves(double from, int end);
  Failure FitHolds(double from, double to);
  bool DependsOnRegions(const RootHold& hold) const;
  Failure PoseAt(double frame, Side side, FigureMotion* motion);
  void PoseWithoutPlace(double frame, double seconds, Side side, FigureMotion* motion);
  double FrameOf(double seconds, double from, double to) const;
  Failure AdvanceRegions(double t, double last);
  std::optional<GravityEvent> FirstGravityEvent(double t, double next, double to);
  Failure BeginExact(double frame, double to, const Vec3& v_pin);
  Failure Happen(const GravityEvent& event, double to);
  Failure FinishExact(int frame);
  void KeepControl(double frame);
  RotationState StateAt(double frame);
  void TurnRoot(double frame, Side side, FigureMotion* motion);
  void TakeReports();

  // Between frames (baker_frames.cpp).
  Failure AdvanceFrame(int frame);
  Failure Step(double frame_from, double frame_to, bool to_boundary);
  Failure StepRegions(double seconds, FigureMotion* next);
  Failure StepPlacement(double frame_from, double seconds, Side side, FigureMotion* next);
  Failure FinishLanding();
  bool is_cancelled() const { return cancel_ && cancel_->load(std::memory_order_relaxed); }
  Error CannotGoOnAfter(double frame, JointIndex joint, const std::string& cause) const;
  std::string RegionPlace(std::optional<JointIndex> joint) const;
  Failure Evaluate(double frame, Side side, FigureMotion* motion);
  void PlaceRoot(double frame, Side side, FigureMotion* motion);
  Failure SolveHolds(double frame, Side side, FigureMotion* motion);
  Failure SolveHold(ActiveHold* active, double frame, Side side, const PoseOf<Jet>& X_WR,
                    std::vector<Jet>* q);
  Error OutOfReach(size_t hold, double frame, double distance) const;
  void WarnOfReach(ActiveHold* active);

  // What is kept (baker_record.cpp).
  void RecordIfOutput();
  Failure RecordUpTo(double from, double to, double end);
  void RecordBetween(const FigureMotion& from, const FigureMotion& to);
  void SetBetween(const FigureMotion& from, const FigureMotion& to, FigureMotion* between);
  void Record(int output_frame, const FigureMotion& motion, const MotionLimit& before,
              std::optional<GroupIndex> pinned);
  void AddPinEvent(int frame);
  std::optional<GroupIndex> pinned() const;
  RootHold root_hold() const;
  double Seconds(double frames) const { return animation_.rate.SecondsAt(frames); }

  const Animation& animation_;
  const std::atomic<bool>* cancel_;
  bool energy_, refine_;
  ThreadPool* pool_;
  Figure figure_;  // with what it holds at present
  DynamicsWorkspace ws_;
  CurveSet curves_;
  ChangeSchedule schedule_;

  FigureMotion now_;
  MotionLimit before_;                    // from the left at now_.frame
  std::vector<char> free_;                // by JointIndex: driven by a region
  std::unique_ptr<RegionDriver> driver_;  // of the paper's regions
  std::unique_ptr<ExactDriver> exact_;    // of exact ones; never both
  struct Refinement {
    double sharpness = 1.0;  // how much finer than usual the steps are
    double last_estimate = std::numeric_limits<double>::infinity();  // with the one before [rad]
  };
  std::vector<Refinement> refinements_;  // by region
  std::vector<int> begun_;               // regions in this stretch
  std::set<int> active_regions_;         // begun and not ended
  DrivenMotion driven_;
  RotationState control_;  // of exact_'s control solutions, by Coordinate
  std::vector<char> has_control_;
  bool root_free_ = false;  // the root's orientation is driven by a region
  RotationState root_;      // its angles then (3)
  bool exact_begun_ = false;
  std::vector<ActiveHold> holds_;
  KnownHolds known_holds_;
  bool is_between_ = false;  // two ends of a step: what is not in reach there needs no hold
  const PlacementSpan* span_ = nullptr;  // null: keyed
  Vec3 pin_W_ = Vec3::Zero();
  std::optional<GravityPlacement> gravity_;  // the paper's
  std::optional<ContinuousGravity> fall_;    // in continuous time
  std::vector<ObjectFlight> objects_;
  Recorder recorder_;
  const KnownLogs* known_ = nullptr;
};

}  // namespace hazumi
