#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/bake/pose/object_flight.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/figure_motion.h"
#include "engine/timeline/animation.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

// Who has an object as the animation begins, by index of its holders; -1: nobody. Who lets go of it
// on that very frame has it, unless the next one takes it there.
int HolderAtFirst(const HeldObject& object, int first_frame);

// The body that an object adds to its holder, in the frame of the holder's last hinge.
RigidInertia InertiaOf(const HeldObject& object, const Holder& holder);
// The figure with an object that its holder of this index has; as it is if that is -1.
Figure WithObject(const Figure& figure, const HeldObject& object, int holder);

// Who has an object, and how it flew off when it was let go last.
struct ObjectState {
  struct Flight {
    double start = 0.0;  // [s]
    BodyMotion from;
    bool operator==(const Flight&) const = default;
  };
  int holder = -1;  // by index of HeldObject::holders; -1: nobody
  std::optional<Flight> flight;
  bool operator==(const ObjectState&) const = default;
};

// The objects of an animation while it is baked: held, in flight, or where their keys say.
class HeldObjects {
 public:
  // The animation must outlive it. Nobody holds anything.
  explicit HeldObjects(const Animation& animation);

  // With those held that are from the first frame on.
  std::vector<ObjectState> AtFirst() const;
  const std::vector<ObjectState>& states() const { return states_; }
  void Resume(const std::vector<ObjectState>& states) { states_ = states; }
  void ResetCurves();  // as the animation's keys are now

  // Releases an object from the hand of the holder with this index, even if the holder no longer
  // has the object. The workspace holds the positions and velocities of the figure.
  void Release(size_t object, int holder, double seconds, const DynamicsWorkspace& ws);
  void Take(size_t object, int holder) { states_[object].holder = holder; }

  Figure LoadedFigure() const;  // the animation's, with what it holds
  // Those that fly and touch things then, and that no keys take from there: what moves them may be
  // a region's contacts.
  std::vector<LooseObject> LooseAt(double frame);
  // That moves one no longer: it flies on.
  void LetFly(const LooseObject& loose, double seconds);

  // The workspace holds the figure's positions in that motion.
  ObjectPose At(size_t object, const FigureMotion& motion, const DynamicsWorkspace& ws);
  // Where its motion could not be solved further, if it could not: from there on it stays [s].
  std::optional<double> StuckFrom(size_t object) const;

 private:
  BodyMotion InFlight(size_t object, double seconds);
  // The first key that places it after it was let go last.
  Keys::const_iterator KeyAfterFlight(size_t object) const;

  const Animation& animation_;
  std::vector<std::array<CurveTrack, 3>> curves_;  // by object; of x, y, z
  std::vector<ObjectState> states_;
  // By object: what touches the scene on the way of its latest state, as far as it was asked for.
  std::vector<std::optional<ObjectFlight>> flights_;
};

}  // namespace hazumi
