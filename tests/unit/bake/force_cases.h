#pragma once

// Figures and forces for tests of forces from outside. Metres, kilograms.

#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "engine/bake/incremental_bake.h"
#include "engine/figure/figure_builder.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"

namespace hazumi::test {

inline constexpr double kMass = 1.3, kLength = 0.8, kThickness = 0.05;  // of rods [kg, m]
inline constexpr double kAir = 1.225, kCrossFlow = 1.1;
inline constexpr Interpolation kHold = Interpolation::kHold;

inline LinkSpec Rod(const char* name, const Vec3& from, const Vec3& to) {
  LinkSpec link;
  link.name = name;
  link.from = from;
  link.to = to;
  link.radius = 0.5 * kThickness;
  link.mass = kMass;
  return link;
}

// A capsule along x, half of whose axis is so long, about whose middle the root sits; and a joint
// that does not turn.
inline Figure FreeCapsule(double half, double radius) {
  FigureSpec spec;
  spec.name = "rod";
  spec.root_name = "rod";
  spec.root_links = {Rod("rod", -half * Vec3::UnitX(), half * Vec3::UnitX())};
  spec.root_links[0].radius = radius;
  JointSpec tip;  // gravity needs something to pin where it lands
  tip.name = "tip";
  tip.parent = "rod";
  tip.hinges = {{"", Vec3::UnitY(), 0.0, 0.0, 0.0}};
  spec.joints = {tip};
  return BuildFigure(spec).value();
}

inline Figure FreeRod() { return FreeCapsule(0.5 * kLength, 0.5 * kThickness); }

// A rod along x that turns about z at its end, on a root that stays.
inline Figure TurningRod() {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), Vec3::Zero())};
  spec.root_links[0].radius = 0.1;
  JointSpec joint;
  joint.name = "pivot";
  joint.parent = "base";
  joint.hinges = {{"", Vec3::UnitZ(), -1e3, 1e3, 0.0}};
  joint.links = {Rod("rod", Vec3::Zero(), kLength * Vec3::UnitX())};
  spec.joints = {joint};
  return BuildFigure(spec).value();
}

inline Animation Exact(Figure figure, double gravity) {
  Animation animation = Still(std::move(figure));
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9 * kDegree;
  animation.gravity = gravity;
  return animation;
}

// The root's orientation swings too.
inline void FreeAll(Animation* animation, const std::vector<const char*>& joints = {},
                    int first = 0) {
  DynamicsRegion& region = AddRegion(animation, "free", first, 30, joints);
  region.method = Method::kExact;
  region.root = true;
}

// In flight from the first frame on.
inline Animation Flying(Figure figure, double gravity) {
  Animation animation = Exact(std::move(figure), gravity);
  AddGravity(&animation, 0, 30);
  FreeAll(&animation);
  return animation;
}

inline void AddForce(Animation* animation, int first, int last,
                     std::variant<WindForce, AttractForce, PushForce> action) {
  animation->forces.push_back({"force", std::move(action), first, last});
}

inline void SetRoot(Animation* animation, RootCurve curve, double value, double rate) {
  animation->root_keys[curve] = {{0, value, rate, kHold}};
}

// Baked on after edits: the same bits as baked anew.
inline void ExpectBakedAsAnew(IncrementalBake* bake, const Animation& animation) {
  ASSERT_FALSE(bake->Finish());
  const Motion whole = BakeOrFail(animation);
  for (size_t i = 0; i < whole.frames.size(); ++i) {
    ASSERT_TRUE(IsSame(bake->motion().frames[i], whole.frames[i])) << "frame " << i;
  }
}

}  // namespace hazumi::test
