#pragma once

#include <memory>
#include <vector>

#include "engine/bake/walk/arrivals.h"
#include "engine/bake/walk/driven_curves.h"
#include "engine/bake/walk/exact_driver.h"
#include "engine/bake/walk/refinements.h"
#include "engine/bake/walk/region_walk.h"

namespace hazumi {

// In continuous time from a frame to the next at which something changes.
class ExactWalk : public RegionWalk {
 public:
  // All of it must outlive the walk. `refinements`: how finely regions are solved; `pool`: the
  // threads that help.
  ExactWalk(BakeContext* context, Refinements* refinements, ThreadPool* pool);

  // Regions are not solved anew where one of these logs tells what they do; null: nothing will be
  // asked again, and no logs are kept.
  void UseLogs(const KnownLogs* known) { known_ = known; }
  // Begins a stretch at this frame. The work of the stretch counts from this frame.
  void BeginStretch(int frame) {
    stretch_start_ = frame;
    work_before_stretch_ = work_before_.total();
  }

  Work work() const override;

  // Moves the logs of what is not solved to its end to the recorder.
  void KeepLogs() {
    if (driver_) driver_->MoveLogsTo(&context_.recorder.logs());
  }

  void Reset() override;
  void Begin(const std::vector<int>& regions, int frame) override;
  void End() override;
  void Interrupt() override { has_begun_ = false; }
  bool Push(const PushForce& push) override;
  Result<int> Advance(int frame) override;
  bool moves(JointIndex j) const override {
    return driver_ && driver_->regions().is_free(j.value());
  }
  bool leaves_root_to_contacts() const override {
    return driver_ && driver_->regions().places_root();
  }
  MotionAcceleration ArrivedWith() override { return AccelerationOf(context_.now); }
  std::vector<ConstraintPush> ConstraintPushesThere() override;
  SceneContacts ContactsThere() override;

 private:
  const std::vector<int>* active() const override {
    return driver_ ? &driver_->regions().indices() : nullptr;
  }

  // The driver: begins or goes on at `frame` with curves that change at `to`.
  void Drive(double frame, double to, const Vec3& pin_velocity);
  void LetLooseFly(double seconds);
  RotationState ControlStart(const RotationState& state);
  RotationState WithControl(RotationState state) const;
  void KeepControl(double frame);
  void WriteReports();

  std::optional<Error> AdvancePiece(double from, double to, double end);
  std::optional<Error> AdvanceUndisturbed(double from, double to, double end);
  std::optional<Error> AdvanceAhead(const std::vector<double>& times, double from, double next,
                                    double to, double end);
  void DropDriver();
  // Work since the driver began, or since the driver before ended.
  Work WorkNow() const;
  // Checks the work after a frame; returns an error above the limit.
  std::optional<Error> CheckWork(double frame);
  std::optional<Error> AdvanceRegions(double t, double last);
  std::optional<Error> Arrive(double frame);
  void AddEvents(double until);
  void AddBreak(const ConstraintBreak& broken);
  std::optional<Error> CheckGaps();
  void WarnOfInside();
  void WarnOfOverlap();
  void WarnOfSpentSprings(int frame);
  void WarnOfWeightless();
  void LookAtArrivals(const FigureMotion& motion);
  void RecordPushes(int output, double t);

  MotionAcceleration AccelerationOf(const FigureMotion& motion);
  void TellStart();

  // What the placement does by itself.
  std::optional<GravityEvent> FirstEvent(double t, double next, double to);
  void Happen(const GravityEvent& event, double to);

  std::optional<Error> PoseAt(double frame, Side side, FigureMotion* motion);
  void PoseWithoutPlace(double frame, double seconds, Side side, Gaps gaps, FigureMotion* motion);
  double FrameOf(double seconds, double from, double to) const;
  std::optional<Error> RecordUpTo(double from, double to, double end);
  bool is_causal() const { return context_.animation.solver.rules().is_causal; }
  std::vector<int> EstimatedFrames(double from, double to, double end) const;
  std::optional<Error> EstimateAt(int frame);

  Refinements& refinements_;
  ThreadPool* pool_;
  const KnownLogs* known_ = nullptr;
  DrivenCurves curves_;
  Work work_before_;  // of previous drivers
  double work_before_stretch_ = 0.0;
  double poses_looked_at_ = 0.0;  // for events of the placement, since the driver began
  int stretch_start_ = 0;
  std::unique_ptr<ExactDriver> driver_;  // null: no region is active
  Arrivals arrivals_;
  bool has_begun_ = false;         // the driver, under the present circumstances
  RotationState control_;          // of the control solutions, by Coordinate
  std::vector<char> has_control_;  // by Coordinate: there was one before
  RotationState sample_;           // scratch
  VecX free_rates_;                // scratch, by Coordinate
};

}  // namespace hazumi
