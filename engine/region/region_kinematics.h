#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/region/forces/force_law.h"
#include "engine/region/moving_base.h"
#include "engine/region/outer_motion.h"
#include "engine/spatial/checks.h"

namespace hazumi {

// Kinds of what acts on an island, which decide which nodes have to be placed, and where.
struct IslandNeeds {
  bool forces = false;  // laws add forces to nodes
  bool rows = false;    // constraints or contacts, which may hang on several moving bases
  bool world = false;   // somebody asks where nodes are in the world
};

// The first stage of the equations of motion: places the nodes of an island at one instant, and
// finds what their own inertia and gravity ask of their joints. World axes; points relative to the
// root's origin.
class RegionKinematics {
 public:
  // `model` must outlive this object. `gravity`: along -z [m/s^2].
  RegionKinematics(const RegionModel* model, double gravity, const IslandNeeds& needs);

  // Sets the curves of driven joints from `start` on. `layout` is any layout of the model.
  void SetCurves(const DrivenMotion* driven, double start, const RegionLayout& layout);
  // A moving base replaces the chain that moves the island, nodes [0, first_moved).
  bool needs_moving_base() const { return first_moved_ > 0 && !is_base_still_ && !needs_.world; }
  int first_moved() const { return first_moved_; }
  std::shared_ptr<const MovingBase> FitMovingBase(double start, double end,
                                                  const RegionLayout& layout);
  void UseMovingBase(std::shared_ptr<const MovingBase> base) { moving_base_ = std::move(base); }
  // Time up to which the curves are polynomials, for a motion that is requested up to `end` [s].
  double SmoothUntil(double end) const { return std::max(end, driven_->holds_until); }

  // Places the nodes for positions and velocities of the layout. `outer`: the figure's place, and
  // balls.
  RegionState Place(double t, const RegionLayout& layout, const double* positions,
                    const double* velocities, const OuterMotion& outer);
  // The same with the chain in place of the moving base.
  RegionState PlaceWithChain(double t, const RegionLayout& layout, const double* positions,
                             const double* velocities);
  // The state of the latest placement, which was with these arguments.
  RegionState Placed(double t, const RegionLayout& layout, const double* positions,
                     const double* velocities) const {
    HAZUMI_ASSERT(t == placed_at_.t && &layout == placed_at_.layout &&
                  positions == placed_at_.positions);
    return {t, *model_, layout, *driven_, nodes_, positions, velocities, places_};
  }
  // Adds accelerations x of the layout's directions to the motion of the nodes.
  void Accelerate(const RegionLayout& layout, const double* x) {
    nodes_.Accelerate(layout, x, first_moved_);
  }
  // Sets what the inertia of the nodes asks for, all of them being accelerated by `base` as well
  // [m/s^2], and forgets all other forces.
  void AskForInertia(double t, const small::V3& base, const OuterMotion& outer);

  // Acceleration of the root less gravity's, which all points have in addition to their motion
  // about the root. In flight zero: the figure falls freely.
  small::V3 BaseAcceleration(double t) const;
  // Velocity of the root. Sets those of the nodes' origins relative to the root.
  small::V3 RootVelocity(double t, std::vector<small::V3>* velocities) const;

  NodeKinematics& nodes() { return nodes_; }
  const NodeKinematics& nodes() const { return nodes_; }
  const DrivenMotion& driven() const { return *driven_; }

 private:
  bool IsBaseStill() const;
  void PlaceStillBase(double t, const RegionLayout& layout);
  MovingBase::Frame BaseAt(double t, const RegionLayout& layout);
  void MoveBase(double t, const RegionLayout& layout);
  small::V3 RootPosition(double t, const OuterMotion& outer) const;
  void PlaceInWorld(double t, const OuterMotion& outer);
  void PlaceBalls(const small::V3& p_root, const OuterMotion& outer);

  const RegionModel* model_;
  double gravity_;
  IslandNeeds needs_;
  NodeKinematics nodes_;
  const DrivenMotion* driven_ = nullptr;
  int first_moved_ = 0;
  std::shared_ptr<const MovingBase> moving_base_;
  bool is_base_still_ = false, is_base_placed_ = false;
  struct {
    double t = 0.0;
    const RegionLayout* layout = nullptr;
    const double* positions = nullptr;
  } placed_at_;
  std::vector<NodePlace> places_;      // empty unless the world is needed
  std::vector<small::V3> velocities_;  // of the nodes' origins, relative to the root
};

}  // namespace hazumi
