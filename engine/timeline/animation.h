#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/timeline/constraint.h"
#include "engine/timeline/dynamics_region.h"
#include "engine/timeline/frame_time.h"
#include "engine/timeline/keyframe.h"
#include "engine/timeline/outer_force.h"
#include "engine/timeline/placement_span.h"
#include "engine/timeline/scene_object.h"
#include "engine/timeline/solver_rules.h"

namespace hazumi {

// The solver a file asks for; stated in every file, so that later defaults change no motion.
struct SolverSettings {
  Method method = Method::kPaper;
  double step = 1.0 / 30.0;     // kPaper [s]
  double tolerance = 1.745e-4;  // kExact: greatest error of an angle in a region [rad]
  int version = kSolverVersion;
  SolverRules rules() const { return SolverRules(version); }
  bool operator==(const SolverSettings&) const = default;
};

// Numbers of the root's curves: position [m], then the hinge angles of R = Rz Ry Rx [rad].
enum RootCurve { kRootX, kRootY, kRootZ, kRootAngleZ, kRootAngleY, kRootAngleX, kNumRootCurves };

// Everything that determines the motion, with names resolved and in SI units. Made from a project
// by CompileAnimation, which guarantees what the fields' comments say.
struct Animation {
  std::shared_ptr<const Figure> figure;
  FrameRate rate;
  int first_frame = 0;
  int last_frame = 0;  // inclusive
  SolverSettings solver;
  double gravity = 9.81;  // [m/s^2], along -z of the world

  std::array<Keys, kNumRootCurves> root_keys;
  std::vector<Keys> joint_keys;  // by JointIndex; empty: the rest angle

  std::vector<DynamicsRegion> regions;
  std::vector<PlacementSpan> placements;  // ascending, disjoint
  std::vector<IkHold> holds;
  std::vector<HeldObject> held_objects;
  std::vector<SceneObject> scene;
  std::vector<OuterForce> forces;
  std::vector<Constraint> constraints;
};

// Whether a hinge starts in a region with the speed that another region, which ends there, leaves
// it with.
inline bool IsTakenOver(const DynamicsRegion& region, JointIndex hinge,
                        const Animation& animation) {
  return std::any_of(animation.regions.begin(), animation.regions.end(),
                     [&](const DynamicsRegion& other) {
                       return other.last_frame == region.first_frame &&
                              std::binary_search(other.joints.begin(), other.joints.end(), hinge);
                     });
}

}  // namespace hazumi
