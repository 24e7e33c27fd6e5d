// Torques against closed forms and the laws of motion.

#include "engine/analysis/joint_torques.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

constexpr double kMass = 3.0, kRadius = 0.05, kLength = 0.8;

Animation PendulumWith(const Keys& keys) {
  Animation animation = Still(Pendulum(kMass, kRadius, kLength));
  animation.joint_keys[0] = keys;
  return animation;
}

double GravityTorque(double angle) { return kMass * kG * 0.5 * kLength * std::sin(angle); }

TEST(JointTorques, HoldAPendulumBesideItsPivot) {
  const Animation animation = PendulumWith({{0, 1.2, 0.0, kCubic}});
  for (const JointTorques& torques : TorquesOf(animation, BakeOrFail(animation))) {
    EXPECT_NEAR(torques.tau[0], GravityTorque(1.2), 1e-9);
    EXPECT_NEAR(torques.unsupported.force.z(), kMass * kG, 1e-9);
  }
}

TEST(JointTorques, OfKeysAreThoseOfTheirCurveToItsLastFrame) {
  const double a = 0.3, b = 1.4, T = 1.0;
  const Animation animation = PendulumWith({{0, a, 0.0, kCubic}, {30, b, 0.0, kCubic}});
  const std::vector<JointTorques> torques = TorquesOf(animation, BakeOrFail(animation));
  const double inertia =
      kMass * (3.0 * kRadius * kRadius + 4.0 * kLength * kLength) / 12.0;  // about the pivot
  for (int f = 0; f <= 30; ++f) {
    const double s = f / 30.0;
    const double q = a + (b - a) * s * s * (3.0 - 2.0 * s);
    const double qdd = (b - a) * (6.0 - 12.0 * s) / (T * T);
    EXPECT_NEAR(torques[f].tau[0], inertia * qdd + GravityTorque(q), 1e-9) << f;
  }
}

// The largest torque of any hinge of arms that swing freely.
double LargestOfASwing(int frames_per_second) {
  Animation animation = Still(Human37());
  KeysOf(&animation, "r_shoulder_y") = {{0, 0.9, 0.0, kCubic}};
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}, 1.0).method = Method::kExact;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9;
  BakeOptions options;
  options.output_rate = FrameRate{frames_per_second, 1};
  const Motion motion = BakeOrFail(animation, options);
  EXPECT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  const std::vector<JointTorques> torques = TorquesOf(animation, motion);
  double largest = 0.0;
  for (size_t i = 0; i + 1 < motion.frames.size(); ++i) {
    for (int j = 0; j < torques[i].tau.size(); ++j) {
      if (motion.frames[i].in_region[j]) largest = std::max(largest, std::abs(torques[i].tau[j]));
    }
  }
  return largest;
}

TEST(JointTorques, OfAFreeSwingVanishWithTheSquareOfTheFrameTime) {
  const double coarse = LargestOfASwing(60), fine = LargestOfASwing(240);
  EXPECT_GT(coarse, 0.0);
  EXPECT_LT(fine, coarse / 13.0);
  EXPECT_LT(fine, 0.02);
}

TEST(JointTorques, OfAFigureOnOneAnkleCarryItsWeight) {
  Animation animation = Still(Human37());
  KeysOf(&animation, "r_hip_y") = {{0, 0.4, 0.0, kCubic}};
  AddPin(&animation, 0, 30, "r_ankle");
  const Motion motion = BakeOrFail(animation);
  const Figure& figure = *animation.figure;
  const JointTorques torques = TorquesOf(animation, motion)[10];
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, motion.frames[10].X_WR, motion.frames[10].q, &ws);
  const JointGroup& ankle = figure.group(GroupOf(animation, "r_ankle"));
  for (int h = 0; h < ankle.size; ++h) {
    const BodyScratch& at = ws.body(JointIndex(ankle.first.value() + h));
    // All that is not beyond the hinge hangs on it, and is held from the foot.
    Vec3 moment = Vec3::Zero();
    const auto add = [&](const RigidInertia& body, const BodyScratch& where) {
      moment += (where.p + where.R * body.com - at.p).cross(Vec3(0, 0, -kG * body.mass));
    };
    add(figure.root_body(), ws.bodies[0]);
    for (int j = 0; j < figure.num_joints(); ++j) {
      const JointIndex body(j);
      if (body == ankle.first || figure.IsBeyond(body, ankle.first)) continue;
      add(figure.body(body), ws.body(body));
    }
    EXPECT_NEAR(torques.tau[ankle.first.value() + h], at.axis.dot(moment), 1e-9) << h;
  }
  EXPECT_EQ(torques.unsupported.force.norm(), 0.0);
}

// Keys may turn a figure in the air; its centre of mass they cannot move.
TEST(JointTorques, OfAFlightNeedNoForceFromOutside) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/jump.kfa";
  const Animation animation = CompileAnimation(LoadProject(path).value()).value().animation;
  BakeOptions options;
  options.output_rate = FrameRate{240, 1};
  const Motion motion = BakeOrFail(animation, options);
  const std::vector<JointTorques> torques = TorquesOf(animation, motion);
  const double take_off = EventsOf(motion, EventKind::kTakeOff).at(0).time;
  const double landing = EventsOf(motion, EventKind::kLanding).at(0).time;
  int flying = 0;
  for (size_t i = 0; i < motion.frames.size(); ++i) {
    const double t = motion.rate.SecondsAt(motion.frames[i].frame);
    if (t <= take_off || t + 1.0 / 240.0 >= landing) continue;
    ++flying;
    EXPECT_LT(torques[i].unsupported.force.norm(), 0.002 * 70.0 * kG) << t;
  }
  EXPECT_GT(flying, 40);
}

TEST(JointTorques, CarryABallUntilItIsLetGo) {
  Animation animation = Still(Human37());
  KeysOf(&animation, "r_shoulder_y") = {{0, -1.5, 0.0, kCubic}};
  const Motion empty = BakeOrFail(animation);
  const JointTorques without = TorquesOf(animation, empty)[0];
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{0.05};
  ball.mass = 0.5;
  ball.holders = {{GroupOf(animation, "r_wrist"), Vec3::Zero(), Holder::kFromTheStart, 15}};
  animation.held_objects.push_back(ball);
  const Motion motion = BakeOrFail(animation);
  const std::vector<JointTorques> with = TorquesOf(animation, motion);
  const Vec3 arm = OriginOf(animation, motion.frames[0], "r_wrist") -
                   OriginOf(animation, motion.frames[0], "r_shoulder");
  const int flexion = JointOf(animation, "r_shoulder_y").value();
  EXPECT_NEAR(std::abs(with[0].tau[flexion] - without.tau[flexion]), 0.5 * kG * std::abs(arm.x()),
              1e-9);
  EXPECT_NEAR(with[15].tau[flexion], without.tau[flexion], 1e-9);
}

}  // namespace
}  // namespace hazumi::test
