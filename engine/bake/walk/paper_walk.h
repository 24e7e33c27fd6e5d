#pragma once

#include <memory>
#include <vector>

#include "engine/bake/walk/paper_driver.h"
#include "engine/bake/walk/paper_drives.h"
#include "engine/bake/walk/region_walk.h"

namespace hazumi {

// From frame to frame in the paper's steps.
class PaperWalk : public RegionWalk {
 public:
  explicit PaperWalk(BakeContext* context)
      : RegionWalk(context),
        drives_(context),
        step_rate_(VecX::Zero(context->poses.figure().num_joints() + kRootAngles)) {}

  void Reset() override { End(); }
  void Begin(const std::vector<int>& regions, int frame) override;
  void End() override {
    driver_.reset();
    drives_.SetRegions({});
    step_rate_.setZero();
  }
  Result<int> Advance(int frame) override;
  bool moves(JointIndex j) const override { return driver_ && driver_->is_free(j); }
  Work work() const override { return {.motion = work_}; }
  MotionAcceleration ArrivedWith() override { return Completed(context_.now, step_rate_); }

 private:
  const std::vector<int>* active() const override { return driver_ ? &driver_->active() : nullptr; }

  void ReportStep(int region, int frame);
  std::optional<Error> Step(double frame_from, double frame_to, bool to_boundary);
  std::optional<Error> StepRegions(double seconds, FigureMotion* next);
  std::optional<Error> StepRoot(double frame_from, double seconds, Side side, FigureMotion* next);
  std::optional<Error> FinishLanding();
  void RecordBetween(const FigureMotion& from, const FigureMotion& to);
  void SetBetween(const FigureMotion& from, const FigureMotion& to, FigureMotion* between);

  void TellAccelerations(double seconds, const FigureMotion& next);

  std::unique_ptr<PaperDriver> driver_;  // null: no region is active
  PaperDrives drives_;
  double work_ = 0.0;
  VecX step_rate_;  // of free joints in the last step [rad/s^2], by Coordinate
};

}  // namespace hazumi
