#pragma once

// Figures that are held, for tests of constraints. Metres, kilograms.

#include <cmath>

#include "engine/bake/walk/held_together.h"
#include "engine/dynamics/kinematics.h"
#include "tests/support/figures.h"
#include "tests/support/momentum.h"
#include "tests/unit/bake/force_cases.h"

namespace hazumi::test {

inline ConstraintEnd OnRoot(const Vec3& offset) {
  ConstraintEnd end;
  end.offset = offset;
  return end;
}
inline ConstraintEnd InWorld(const Vec3& place) {
  ConstraintEnd end;
  end.is_in_world = true;
  end.offset = place;
  return end;
}
inline ConstraintEnd OnJoint(const Animation& animation, const char* joint) {
  ConstraintEnd end;
  end.joint = GroupOf(animation, joint);
  return end;
}

inline Constraint& AddPoint(Animation* animation, const ConstraintEnd& a, const ConstraintEnd& b,
                            int first, int last) {
  Constraint constraint;
  constraint.name = "held";
  constraint.a = a;
  constraint.b = b;
  constraint.first_frame = first;
  constraint.last_frame = last;
  return animation->constraints.emplace_back(constraint);
}

// A rod along x that turns about an axis at its end, on a root that stays.
inline Figure RodAbout(const Vec3& axis) {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), Vec3::Zero())};
  JointSpec joint;
  joint.name = "pivot";
  joint.parent = "base";
  joint.hinges = {{"", axis, -1e3, 1e3, 0.0}};
  joint.links = {Rod("rod", Vec3::Zero(), kLength * Vec3::UnitX())};
  spec.joints = {joint};
  return BuildFigure(spec).value();
}

// Across its axis [kg m^2].
inline double InertiaAboutEnd() {
  const Figure rod = RodAbout(Vec3::UnitY());
  return rod.body(JointIndex(0)).I_com(1, 1) + kMass * kLength * kLength / 4.0;
}
// With what part of its weight a rod that is let go level presses on its end: 1/4 of a thin one.
inline double RodInertiaShare() {
  return 1.0 - kMass * kLength * kLength / (4.0 * InertiaAboutEnd());
}
// With what force its end is held where the sine of its angle below level is `sine` [N].
inline double ForceOfFallingRod(double sine) {
  const double half = 0.5 * kLength, I = InertiaAboutEnd();
  const double square = 2.0 * kMass * kG * half * sine / I;  // of its rate
  const double along = kMass * (kG * sine + half * square);
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double across = kMass * (kG * cosine - half * kMass * kG * half * cosine / I);
  return std::hypot(along, across);
}

inline double GapAt(const Animation& animation, const Constraint& constraint,
                    const MotionFrame& frame) {
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
  return GapOf(constraint, *animation.figure, frame.X_WR, ws).distance;
}

// Kinetic and potential energy, from the first frame to the last one [J].
inline double EnergyGained(const Animation& animation, const Motion& motion) {
  const auto energy = [&](const MotionLimit& at) {
    const Momentum momentum = MomentumOf(*animation.figure, at);
    return momentum.kinetic + momentum.potential(animation.gravity);
  };
  return energy(motion.frames.back().before) - energy(motion.frames.front().after);
}

// Three rods one beyond the other, about y, that turn by 0.6 to either side of straight.
inline Animation Chain() {
  FigureSpec spec;
  spec.name = "chain";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), 0.1 * Vec3::UnitZ())};
  const char* const names[] = {"one", "two", "three"};
  for (int i = 0; i < 3; ++i) {
    JointSpec joint;
    joint.name = names[i];
    joint.parent = i == 0 ? "base" : names[i - 1];
    if (i > 0) joint.offset = 0.4 * Vec3::UnitX();
    joint.hinges = {{"", Vec3::UnitY(), -0.6, 0.6, 0.0}};
    joint.links = {Rod(names[i], Vec3::Zero(), 0.4 * Vec3::UnitX())};
    spec.joints.push_back(joint);
  }
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  AddRegion(&animation, "chain", 0, 30, {"one"}).method = Method::kExact;
  return animation;
}

// Both arms of a pinned human loose, their wrists held where they are.
inline Animation HandsOnBar() {
  Animation animation = Exact(Human37(), kG);
  AddPin(&animation, 0, 300, "r_ankle");
  for (const char* side : {"l", "r"}) {
    const std::string s = side;
    KeysOf(&animation, (s + "_shoulder_y").c_str()) = {{0, -1.3, {}}};
    KeysOf(&animation, (s + "_elbow_y").c_str()) = {{0, -0.9, {}}};
    KeysOf(&animation, (s + "_shoulder_x").c_str()) = {{0, s == "l" ? 0.3 : -0.3, {}}};
  }
  AddRegion(&animation, "arms", 0, 30, {"l_shoulder", "r_shoulder"}).method = Method::kExact;
  Animation bare = animation;
  bare.last_frame = 1;
  const Motion still = BakeOrFail(bare);
  for (const char* joint : {"l_wrist", "r_wrist"}) {
    AddPoint(&animation, OnJoint(animation, joint),
             InWorld(OriginOf(animation, still.frames[0], joint)), 0, 30);
  }
  return animation;
}

}  // namespace hazumi::test
