#pragma once

#include <optional>

#include "engine/bake/motion.h"
#include "engine/dynamics/kinematics.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// The body that a held object adds to its holder, in the frame of the holder's last hinge.
RigidInertia InertiaOf(const HeldObject& object);

// A held object while it is held and after: on a parabola, turning at a constant rate.
class ObjectFlight {
 public:
  ObjectFlight(const Figure& figure, const HeldObject& object, double gravity);

  // Lets go now; the workspace holds the figure's positions and velocities.
  void Release(const DynamicsWorkspace& ws, double seconds);
  bool is_held() const { return !flight_; }
  // While held the workspace must hold the figure's positions at that time.
  ObjectPose At(const DynamicsWorkspace& ws, double seconds) const;
  bool operator==(const ObjectFlight&) const = default;

 private:
  struct Flight {
    double start = 0.0;  // [s]
    Pose X_WO;
    Vec3 v = Vec3::Zero(), w = Vec3::Zero();
    bool operator==(const Flight&) const = default;
  };
  JointIndex holder_;
  Vec3 offset_;
  double gravity_;
  std::optional<Flight> flight_;
};

}  // namespace hazumi
