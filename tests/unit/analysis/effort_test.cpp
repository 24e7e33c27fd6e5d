// Effort against closed forms: standing, a squat, a touch-down, a flight.

#include "engine/analysis/effort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/dynamics/kinematics.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "tests/support/figures.h"
#include "tests/support/odd_figures.h"
#include "tests/support/random.h"
#include "tests/unit/analysis/baked_effort.h"

namespace hazumi::test {
namespace {

BakedEffort EffortIn(const Animation& animation, int frames_per_second = 30) {
  return BakeEffort(animation, FrameRate{frames_per_second, 1});
}

TEST(Effort, OfStandingOnTwoFeetIsHalfTheWeightOnEach) {
  const Animation animation = Standing();
  const BakedEffort found = EffortIn(animation);
  const double weight = animation.figure->total_mass() * kG;
  for (const FrameEffort& frame : found.effort.frames) {
    for (const char* side : {"l_", "r_"}) {
      const Vec3 force = LegForce(animation, frame, side);
      EXPECT_NEAR(force.z(), 0.5 * weight, 1e-6);
      EXPECT_NEAR(force.x(), 0.0, 1e-6);
    }
    EXPECT_LT(frame.from_nowhere.force.norm(), 1e-6);
    EXPECT_LT(frame.from_nowhere.moment.norm(), 1e-6);
  }
  EXPECT_FALSE(found.effort.is_filtered);
}

TEST(Effort, IsAShareOfTheStrengthOfItsDirection) {
  Animation animation = Standing();
  for (const char* arm : {"l_shoulder_flexion", "r_shoulder_flexion"}) {
    KeysOf(&animation, arm) = {{0, 1.2, 0.0, kCubic}};
  }
  const BakedEffort found = EffortIn(animation);
  const FrameEffort& frame = found.effort.frames[10];
  const JointIndex ankle = JointOf(animation, "r_ankle_flexion"), toe = JointOf(animation, "r_toe");
  const double tau = frame.tau[ankle.value()];
  const StrengthLimits limits = animation.figure->joint(ankle).strength->At(0.0, 0.0);
  const double strength = tau > 0.0 ? limits.positive.torque : limits.negative.torque;
  EXPECT_GT(std::abs(tau), 1.0);
  EXPECT_NEAR(frame.share[ankle.value()], std::abs(tau) / strength, 1e-12);
  EXPECT_LT(frame.share[toe.value()], 0.0);
}

// A straight elbow is pressed against its stop by what is before it, and pulled off it by what is
// behind.
TEST(Effort, WhatAStopGivesIsNobodysEffort) {
  for (const double lean : {0.2, -0.2}) {
    Animation animation = Standing();
    const JointIndex elbow = JointOf(animation, "r_elbow_flexion");
    const Joint& hinge = animation.figure->joint(elbow);
    KeysOf(&animation, "r_elbow_flexion") = {{0, hinge.lower, 0.0, kCubic}};
    KeysOf(&animation, "r_shoulder_flexion") = {{0, lean, 0.0, kCubic}};
    const BakedEffort found = EffortIn(animation);
    const FrameEffort& frame = found.effort.frames[10];
    const bool is_pressed = frame.tau[elbow.value()] > 0.0;
    EXPECT_GT(std::abs(frame.tau[elbow.value()]), 0.1) << lean;
    EXPECT_EQ(frame.share[elbow.value()] == 0.0, is_pressed) << lean;
    EXPECT_EQ(is_pressed, lean > 0.0);
  }
}

// On the right foot, the pelvis over it, the left leg drawn up from frame 0 to `down` and then as
// the right one.
Animation OnOneFoot(double down) {
  Animation animation = Standing();
  const double b = 0.0945;  // the legs lean by this to the right, soles flat
  const auto leg = [&](const std::string& side, double lean) {
    KeysOf(&animation, (side + "hip_abduction").c_str()) = {{0, -lean, 0.0, kCubic}};
    KeysOf(&animation, (side + "ankle_inversion").c_str()) = {{0, lean, 0.0, kCubic}};
  };
  leg("r_", b);
  leg("l_", -b);
  const auto lift = [&](const char* hinge, double angle) {
    KeysOf(&animation, hinge) = {{0, angle, {}, Interpolation::kQuintic}, {down, 0.0, {}, kCubic}};
  };
  lift("l_hip_flexion", 0.6);
  lift("l_knee", 1.2);
  lift("l_ankle_flexion", 0.3);
  // The ankle stays where it is, at the height of a flat sole.
  const Figure& figure = *animation.figure;
  VecX q = figure.RestAngles();
  q[JointOf(animation, "r_hip_abduction").value()] = -b;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, {Mat3::Identity(), Vec3(0, 0, kHipHeight)}, q, &ws);
  const double leaning = ws.body(JointOf(animation, "r_ankle_flexion")).p.z();
  ComputePositions(figure, {Mat3::Identity(), Vec3(0, 0, kHipHeight)}, figure.RestAngles(), &ws);
  const double straight = ws.body(JointOf(animation, "r_ankle_flexion")).p.z();
  animation.root_keys[kRootZ] = {{0, kHipHeight + straight - leaning, 0.0, kCubic}};
  return animation;
}

TEST(Effort, OfStandingOnOneFootIsTheWeightTimesItsLeverAtTheAnkle) {
  Animation animation = OnOneFoot(1000);
  for (const char* hinge : {"l_hip_flexion", "l_knee", "l_ankle_flexion"}) {
    KeysOf(&animation, hinge).resize(1);  // it is held up
  }
  const BakedEffort found = EffortIn(animation);
  const Figure& figure = *animation.figure;
  const FrameEffort& frame = found.effort.frames[0];
  ASSERT_LT(frame.from_nowhere.force.norm(), 1e-6);
  ASSERT_LT(frame.from_nowhere.moment.norm(), 1e-6);
  EXPECT_NEAR(LegForce(animation, frame, "r_").z(), figure.total_mass() * kG, 1e-6);
  EXPECT_EQ(LegForce(animation, frame, "l_").z(), 0.0);
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, found.motion.frames[0].X_WR, found.motion.frames[0].q, &ws);
  for (const char* name : {"r_ankle_flexion", "r_ankle_inversion"}) {
    const JointIndex ankle = JointOf(animation, name);
    double mass = figure.root_body().mass;
    Vec3 com = mass * (ws.bodies[0].p + ws.bodies[0].R * figure.root_body().com);
    for (int j = 0; j < figure.num_joints(); ++j) {
      if (figure.IsBeyond(JointIndex(j), ankle)) continue;
      const RigidInertia& body = figure.body(JointIndex(j));
      mass += body.mass;
      com += body.mass * (ws.bodies[j + 1].p + ws.bodies[j + 1].R * body.com);
    }
    const Vec3 lever = com / mass - ws.body(ankle).p;
    const double expected = ws.body(ankle).axis.dot(lever.cross(Vec3(0, 0, -mass * kG)));
    EXPECT_NEAR(frame.tau[ankle.value()], expected, 1e-6) << name;
  }
}

TEST(Effort, DoesNotJumpWhereAFootTouchesDown) {
  const Animation animation = OnOneFoot(20);
  for (const int rate : {30, 240}) {
    const BakedEffort found = EffortIn(animation, rate);
    double peak = 0.0, step = 0.0, one_foot = 0.0, both = 0.0;
    const std::vector<FrameEffort>& frames = found.effort.frames;
    for (size_t i = 0; i < frames.size(); ++i) {
      peak = std::max(peak, frames[i].tau.lpNorm<Eigen::Infinity>());
      if (i == 0) continue;
      const double time = found.motion.rate.SecondsAt(found.motion.frames[i].frame);
      if (std::abs(time - 20.0 / 30.0) > 0.1) continue;
      step = std::max(step, (frames[i].tau - frames[i - 1].tau).lpNorm<Eigen::Infinity>());
    }
    one_foot = LegForce(animation, frames.front(), "l_").z();
    both = LegForce(animation, frames.back(), "l_").z();
    EXPECT_EQ(one_foot, 0.0);
    EXPECT_GT(both, 20.0);
    std::printf("  touch-down at %d frames a second: the largest step is %.1f %% of the peak\n",
                rate, 100.0 * step / peak);
    EXPECT_LT(step, 0.1 * peak) << rate;
  }
}

// A planar leg: foot, shank, thigh and trunk, which is the root. Lengths of shank and thigh,
// masses, centres above the lower joint and moments of inertia of shank, thigh, trunk.
constexpr double kL[2] = {0.43, 0.41}, kM[3] = {3.5, 8.0, 40.0}, kD[3] = {0.25, 0.23, 0.3},
                 kI[3] = {0.05, 0.12, 1.6};

Figure PlanarLeg() {
  FigureSpec spec;
  spec.name = "leg";
  spec.root_name = "trunk";
  spec.root_links = {Lump("trunk", kM[2], {0, 0, kD[2]}, kI[2])};
  const auto joint = [&](const char* name, const char* parent, const Vec3& offset, LinkSpec link) {
    JointSpec spec_of;
    spec_of.name = name;
    spec_of.parent = parent;
    spec_of.offset = offset;
    spec_of.hinges = {{"", Vec3::UnitY(), -3.0, 3.0, 0.0}};
    spec_of.links = {std::move(link)};
    spec.joints.push_back(spec_of);
  };
  joint("hip", "trunk", Vec3::Zero(), Lump("thigh", kM[1], {0, 0, kD[1] - kL[1]}, kI[1]));
  joint("knee", "hip", {0, 0, -kL[1]}, Lump("shank", kM[0], {0, 0, kD[0] - kL[0]}, kI[0]));
  LinkSpec foot = Lump("foot", 1.0, {0.05, 0, -0.05}, 0.003);
  foot.from = {-0.1, 0, -0.05};
  foot.to = {0.2, 0, -0.05};
  foot.radius = 0.03;
  joint("ankle", "knee", {0, 0, -kL[0]}, foot);
  return Build(spec);
}

// Torques of the lower on the upper body at ankle, knee and hip, by Lagrange's equations in the
// bodies' angles from upright, with p[i] = f s(t).
Vec3 SquatTorques(const Vec3& angle, const Vec3& rate, const Vec3& acceleration) {
  Vec3 Q = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    double ax = 0.0, az = 0.0;
    const auto reach = [&](int j) { return j < i ? kL[j] : kD[i]; };
    for (int j = 0; j <= i; ++j) {
      const double s = std::sin(angle[j]), c = std::cos(angle[j]), w2 = rate[j] * rate[j];
      ax += reach(j) * (c * acceleration[j] - s * w2);
      az += reach(j) * (-s * acceleration[j] - c * w2);
    }
    for (int k = 0; k <= i; ++k) {
      Q[k] += kM[i] * reach(k) * (ax * std::cos(angle[k]) - (az + kG) * std::sin(angle[k]));
    }
    Q[i] += kI[i] * acceleration[i];
  }
  return {Q[0] + Q[1] + Q[2], Q[1] + Q[2], Q[2]};
}

TEST(Effort, OfASquatIsThatOfLagrangesEquations) {
  Animation animation = Still(PlanarLeg());
  AddFloor(&animation);
  const Vec3 last(0.5, -0.7, 0.6);  // shank, thigh, trunk, from upright
  const auto key = [](double to) { return Keys{{0, 0.0, 0.0, kCubic}, {30, to, 0.0, kCubic}}; };
  animation.root_keys[kRootAngleY] = key(last[2]);
  animation.root_keys[kRootZ] = {{0, 0.08 + kL[0] + kL[1], 0.0, kCubic}};
  animation.joint_keys[0] = key(last[1] - last[2]);
  animation.joint_keys[1] = key(last[0] - last[1]);
  animation.joint_keys[2] = key(-last[0]);
  AddPin(&animation, 0, 30, "ankle");
  const BakedEffort found = EffortIn(animation);
  for (int f = 0; f <= 30; ++f) {
    const double s = f / 30.0;
    const Vec3 torques = SquatTorques(last * (s * s * (3.0 - 2.0 * s)),
                                      last * (6.0 * s * (1.0 - s)), last * (6.0 - 12.0 * s));
    const FrameEffort& frame = found.effort.frames[static_cast<size_t>(f)];
    // A hinge's torque is on the body beyond it, which is the lower one.
    EXPECT_NEAR(frame.tau[2], -torques[0], 1e-6) << "ankle, frame " << f;
    EXPECT_NEAR(frame.tau[1], -torques[1], 1e-6) << "knee, frame " << f;
    EXPECT_NEAR(frame.tau[0], -torques[2], 1e-6) << "hip, frame " << f;
    EXPECT_LT(frame.from_nowhere.force.norm(), 1e-6);
    EXPECT_LT(frame.from_nowhere.moment.norm(), 1e-6);
  }
}

TEST(Effort, OfAFigureThatKeysHoldInTheAirIsToldAsFromNowhere) {
  Animation animation = Standing();
  animation.root_keys[kRootZ] = {{0, 2.0, 0.0, kCubic}};
  const BakedEffort found = EffortIn(animation);
  const FrameEffort& frame = found.effort.frames[3];
  EXPECT_TRUE(frame.contacts.empty());
  EXPECT_NEAR(frame.from_nowhere.force.z(), animation.figure->total_mass() * kG, 1e-9);
  const auto lines = EffortReport(animation, found.motion, found.effort);
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("from nowhere: 687 N");
  }));
}

TEST(Effort, OfAFlightNeedsNoForceFromNowhere) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/jump.kfa";
  const Animation animation = CompileAnimation(LoadProject(path).value()).value().animation;
  const BakedEffort found = EffortIn(animation, 240);
  const double take_off = EventsOf(found.motion, EventKind::kTakeOff).at(0).time;
  const double landing = EventsOf(found.motion, EventKind::kLanding).at(0).time;
  double worst = 0.0;
  int flying = 0;
  for (size_t i = 0; i < found.motion.frames.size(); ++i) {
    const double t = found.motion.rate.SecondsAt(found.motion.frames[i].frame);
    if (t <= take_off || t >= landing) continue;
    ++flying;
    Vec3 force = found.effort.frames[i].from_nowhere.force;
    for (const EffortContact& contact : found.effort.frames[i].contacts) force += contact.force;
    worst = std::max(worst, force.norm());
  }
  EXPECT_GT(flying, 40);
  EXPECT_LT(worst, 1e-6);
}

TEST(Effort, OfAFreeSwingIsNoneInItsJoints) {
  Animation animation = Still(Human37());
  animation.solver.method = Method::kExact;
  KeysOf(&animation, "r_shoulder_y") = {{0, 0.9, 0.0, kCubic}};
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}, 1.0).method = Method::kExact;
  const BakedEffort found = EffortIn(animation);
  ASSERT_TRUE(EventsOf(found.motion, EventKind::kLimit).empty());
  for (size_t i = 0; i + 1 < found.motion.frames.size(); ++i) {
    for (int j = 0; j < found.effort.frames[i].tau.size(); ++j) {
      if (!found.motion.frames[i].in_region[static_cast<size_t>(j)]) continue;
      EXPECT_NEAR(found.effort.frames[i].tau[j], 0.0, 1e-9) << i << " " << j;
    }
  }
}

TEST(Effort, OfACaptureIsThatOfTheFilteredMotion) {
  Animation animation = Standing();
  animation.last_frame = 120;
  Keys& knee = KeysOf(&animation, "l_knee");
  Keys& hip = KeysOf(&animation, "l_hip_flexion");
  Random random(7);
  for (int f = 0; f <= 120; ++f) {
    const double slow = 0.5 - 0.5 * std::cos(f / 30.0 * 6.28 * 0.5);
    knee.push_back({f * 1.0, slow + random.Uniform(-0.003, 0.003), {}, kCubic});
    hip.push_back({f * 1.0, 0.5 * slow + random.Uniform(-0.003, 0.003), {}, kCubic});
  }
  EXPECT_TRUE(IsCapture(animation));
  const BakedEffort found = EffortIn(animation);
  EXPECT_TRUE(found.effort.is_filtered);
  EXPECT_EQ(found.effort.cutoff, 6.0);
  const auto lines = EffortReport(animation, found.motion, found.effort);
  EXPECT_EQ(lines.back(), "a capture: filtered at 6 Hz before it was differentiated");
  EXPECT_FALSE(IsCapture(Standing()));
}

}  // namespace
}  // namespace hazumi::test
