#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/bake/bake.h"
#include "engine/bake/curve_set.h"
#include "engine/bake/exact_driver.h"
#include "engine/bake/object_flight.h"
#include "engine/bake/region_driver.h"
#include "engine/placement/continuous_gravity.h"
#include "engine/placement/gravity_placement.h"
#include "engine/placement/hold_solver.h"

namespace hazumi {

// Walks through an animation from its first frame to its last. Between two frames the same regions,
// holds and placement are active; they change at frames only. What is to be done by the paper's
// method takes equal steps within each frame; the rest goes in continuous time from one change to
// the next.
class Baker {
 public:
  // `sharpness`, by region: how much finer than usual the steps of an exact region are to be.
  Baker(const Animation& animation, const BakeOptions& options, std::vector<double> sharpness);
  Result<Motion> Run();

 private:
  struct ActiveHold {
    const IkHold* hold;
    HoldSolver solver;
    HoldTarget target;
  };
  using Failure = std::optional<Error>;

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
  bool HasRegionFrom(int frame, JointIndex j) const;
  void BeginRoot(int frame);
  void EndRoot(int frame);
  void StartFreeJoint(JointIndex j, int frame, bool handed_over);
  void ResumeAfterRegion(int frame, size_t region);
  double Overshoot(int frame, JointIndex j);
  void LimitTangent(int frame, JointIndex j);
  void WarnIfNoKeyAfter(int frame, JointIndex j, const char* list, size_t index);
  void WarnOfVelocityJump(int frame);
  std::string PlacementPlace(int frame) const;

  bool ChangesAt(int frame) const;
  bool IsExact(int frame) const;

  // In continuous time from a frame to the next at which something changes (baker_exact.cpp).
  Result<int> AdvanceExact(int frame);
  Failure AdvancePiece(double from, double to, double end);
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
  void RecordUpTo(double from, double to, double end);
  void FinishExact(int frame);
  RotationState StateAt(double frame);
  void TurnRoot(double frame, Side side, FigureMotion* motion);
  void TakeReports();

  // Between frames (baker.cpp).
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

  // What is kept (baker_record.cpp).
  void RecordIfOutput();
  void RecordBetween(const FigureMotion& from, const FigureMotion& to);
  void SetBetween(const FigureMotion& from, const FigureMotion& to, FigureMotion* between);
  void Record(int output_frame, const FigureMotion& motion, const MotionLimit& before,
              std::optional<GroupIndex> pinned);
  double OutputFramesPerFrame() const;
  void AddEvent(EventKind kind, double frame, const std::string& joint);
  void AddPinEvent(int frame);
  void AddWarning(const std::string& place, const std::string& message);
  std::optional<GroupIndex> pinned() const;
  RootHold root_hold() const;
  double Seconds(double frames) const { return animation_.rate.SecondsAt(frames); }

  const Animation& animation_;
  const std::atomic<bool>* cancel_;
  bool energy_;
  Figure figure_;  // with what it holds at present
  DynamicsWorkspace ws_;
  CurveSet curves_;
  std::vector<double> key_frames_;

  FigureMotion now_;
  MotionLimit before_;                    // from the left at now_.frame
  std::vector<char> free_;                // by JointIndex: driven by a region
  std::unique_ptr<RegionDriver> driver_;  // of the paper's regions
  std::unique_ptr<ExactDriver> exact_;    // of exact ones; never both
  std::vector<double> sharpness_;         // by region
  DrivenMotion driven_;
  RotationState twin_;  // of exact_'s twins, by Coordinate
  std::vector<char> has_twin_;
  bool root_free_ = false;  // the root's orientation is driven by a region
  RotationState root_;      // its angles then (3)
  bool exact_begun_ = false;
  std::vector<ActiveHold> holds_;
  const PlacementSpan* span_ = nullptr;  // null: keyed
  Vec3 pin_W_ = Vec3::Zero();
  std::optional<GravityPlacement> gravity_;  // the paper's
  std::optional<ContinuousGravity> fall_;    // in continuous time
  std::vector<ObjectFlight> objects_;
  Motion motion_;
};

}  // namespace hazumi
