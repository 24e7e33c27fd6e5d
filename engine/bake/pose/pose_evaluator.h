#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/bake/pose/active_holds.h"
#include "engine/bake/pose/curve_set.h"
#include "engine/bake/pose/held_objects.h"
#include "engine/bake/pose/root_placement.h"
#include "engine/bake/rotation_state.h"

namespace hazumi {

// An object that is let go of, or goes over to a holder.
struct ObjectChange {
  size_t object = 0;
  int holder = -1;  // -1: it is let go of
};

// The whole figure at an instant: joints and orientation from their curves, but for what regions
// drive; then the root's place; then the joints that holds move. What acts at the time it is told
// as it changes.
class PoseEvaluator {
 public:
  // Both must outlive it. Nothing acts, and the figure holds nothing.
  PoseEvaluator(const Animation& animation, Recorder* recorder);

  // Goes on with curves from these pieces, and with these objects held or let go of. No region
  // drives anything.
  void Resume(const std::vector<CurveTrack::Piece>& pieces,
              const std::vector<ObjectState>& objects);
  // Curves as the animation's keys and regions are now.
  void ResetCurves();
  // From here on the placement is that of a span of the animation; null: of none.
  RootPlacement& StartPlacement(const PlacementSpan* span);
  // Objects change hands in a figure that is at `motion` and got there with `before`. Returns how
  // far each jumps [m].
  std::vector<double> HandOver(const std::vector<ObjectChange>& changes, const FigureMotion& motion,
                               const MotionLimit& before);
  // Releases an object that a holder has let go of on the frame of `motion`, with its velocity in
  // that motion.
  void ReleaseWith(const FigureMotion& motion, size_t object, int holder);
  // A region drives the joint from here on, or no longer.
  void SetFree(JointIndex j, bool is_free) { free_[j.value()] = is_free; }
  // A region drives the root's orientation from here on, starting there (accelerations are not
  // read); or no longer.
  void FreeRoot(const RootAngles& angles);
  void BindRoot() { free_root_.reset(); }
  // Where a region drives it, it has got to the root's part of `state`.
  void TurnFreeRoot(const RotationState& state);

  // Sets all of `motion` at a frame but the angles of free joints, which are there. An error where
  // a hold is out of reach.
  std::optional<Error> Evaluate(double frame, Side side, FigureMotion* motion);
  // In parts, one after the other.
  void SetJoints(double frame, Side side, FigureMotion* motion) {
    motion->frame = frame;
    curves_.SampleJoints(frame, side, free_, motion);
  }
  void TurnRoot(double frame, Side side, FigureMotion* motion);
  std::optional<Error> SolveHolds(Side side, FigureMotion* motion,
                                  double tolerance = ActiveHolds::kReachTolerance);

  // All rotations of a figure that is at `motion`, limits from the right.
  RotationState StateAt(const FigureMotion& motion);
  // Whether the root's place depends on joints that regions drive.
  bool IsPlacedByRegions() const;

  const Figure& figure() const { return figure_; }  // with what it holds
  DynamicsWorkspace& workspace() { return ws_; }
  CurveSet& curves() { return curves_; }
  RootPlacement& placement() { return *placement_; }
  const RootPlacement& placement() const { return *placement_; }
  const PlacementSpan* span() const { return span_; }
  ActiveHolds& holds() { return holds_; }
  HeldObjects& objects() { return objects_; }
  const std::vector<char>& free() const { return free_; }  // by JointIndex
  // The root's angles z, y, x, if a region drives them.
  const std::optional<RotationState>& free_root() const { return free_root_; }

 private:
  void LoadFigure() { figure_ = objects_.LoadedFigure(); }
  PointMotion AnchorAt(const FigureMotion& motion);

  const Animation& animation_;
  Figure figure_;
  DynamicsWorkspace ws_;
  CurveSet curves_;
  HeldObjects objects_;
  const PlacementSpan* span_ = nullptr;
  std::unique_ptr<RootPlacement> placement_;
  std::vector<char> free_;
  std::optional<RotationState> free_root_;
  ActiveHolds holds_;
};

}  // namespace hazumi
