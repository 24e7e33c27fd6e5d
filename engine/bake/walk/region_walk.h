#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bake/bake_context.h"

namespace hazumi {

// Takes the figure on from a frame to a later one, between which nothing begins or ends: the joints
// of the regions that are active, curves, placement and holds. One class a method.
class RegionWalk {
 public:
  virtual ~RegionWalk() = default;

  // No region is active, and what is known of earlier ones is forgotten.
  virtual void Reset() = 0;
  // From `frame` on these are active, one at least; indices of Animation::regions. None was.
  virtual void Begin(const std::vector<int>& regions, int frame) = 0;
  // They are no longer; their reports are written.
  virtual void End() = 0;
  // Placement or masses are not what they were.
  virtual void Interrupt() {}

  // An impulse acts on the figure, which is evaluated at the context's `now`: that changes, but for
  // what the placement follows with. False if no region moves what it acts on.
  virtual bool Push(const PushForce&) { return false; }

  // From the context's `now`, which is at the frame, on to a frame that is returned.
  virtual Result<int> Advance(int frame) = 0;

  // Accelerations with which the figure came to where it is now, and those with which the last
  // Advance set out, if the context wants them.
  virtual MotionAcceleration ArrivedWith() = 0;
  // What constraints did when it came there, by index of the animation's.
  virtual std::vector<ConstraintPush> ConstraintPushesThere() { return {}; }
  // And where regions touch the scene.
  virtual SceneContacts ContactsThere() { return {}; }
  const MotionAcceleration& began_with() const { return began_with_; }
  // And rates, which are not those before where something stops joints dead.
  const VecX& began_with_rates() const { return began_with_rates_; }

  // Work of everything solved so far.
  virtual Work work() const = 0;

  bool has_regions() const { return active() != nullptr; }
  virtual bool moves(JointIndex j) const = 0;
  // Returns whether contacts of the regions place the figure instead of a placement by gravity.
  virtual bool leaves_root_to_contacts() const { return false; }

 protected:
  explicit RegionWalk(BakeContext* context) : context_(*context) {}

  // Null: no region is active.
  virtual const std::vector<int>* active() const = 0;
  // An invalid joint is the root.
  Error CannotGoOnAfter(double frame, JointIndex joint, const std::string& cause) const;
  // "regions[1]", where it is known which: the one that moves the joint, or the only active one.
  // Without regions: "placements".
  std::string PlaceOfRegion(std::optional<JointIndex> joint) const;
  // Something that the placement did.
  void AddEvent(EventKind kind, double frame, std::optional<GroupIndex> joint);

  // Of `motion`, placed, with those of the joints and angles that regions drive, by Coordinate, and
  // of the centre of mass where the regions' forces move it.
  MotionAcceleration Completed(const FigureMotion& motion, const VecX& free,
                               const std::optional<Vec3>& fall = {});

  BakeContext& context_;
  MotionAcceleration began_with_;
  VecX began_with_rates_;  // by JointIndex [rad/s]
};

}  // namespace hazumi
