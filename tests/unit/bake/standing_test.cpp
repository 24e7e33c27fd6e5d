// Figure that stands on springs, sways, and topples after a large enough impulse.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/support.h"
#include "tests/support/animations.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::test {
namespace {

constexpr double kSolesBelow = 0.9024;  // depth of the soles below the pelvis in the zero pose [m]

Animation Standing(int frames, double frequency) {
  Animation animation = LooseHuman(frames, kSolesBelow);
  DynamicsRegion& region = animation.regions[0];
  Drive spring;
  spring.kind = DriveKind::kSpring;
  spring.joints = region.joints;
  spring.frequency = frequency;
  spring.damping_ratio = 1.0;
  spring.feed_forward = true;
  region.drives = {spring};
  return animation;
}

void ApplyImpulseToChest(Animation* animation, int frame, double impulse) {
  OuterForce impulse_force;
  impulse_force.name = "impulse";
  impulse_force.first_frame = frame;
  impulse_force.last_frame = frame + 1;
  impulse_force.action =
      PushForce{{GroupOf(*animation, "chest"), Vec3::Zero()}, Vec3(impulse, 0.0, 0.0)};
  animation->forces.push_back(impulse_force);
}

double FurthestOf(const Motion& motion) {
  double most = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    most = std::max(most, (frame.com - motion.frames[0].com).norm());
  }
  return most;
}

TEST(Standing, HumanOnSpringsOfTwoHertz_StandsForFiveSeconds) {
  const Motion motion = BakeOrFail(Standing(150, 2.0));
  EXPECT_LE(FurthestOf(motion), 0.001);
}

TEST(Standing, ImpulseOfFiveNewtonSeconds_SwaysAFigureThatRecovers) {
  Animation animation = Standing(150, 2.0);
  ApplyImpulseToChest(&animation, 10, 5.0);
  const Motion motion = BakeOrFail(animation);
  EXPECT_GE(FurthestOf(motion), 0.002);
  EXPECT_LE(FurthestOf(motion), 0.02);
  EXPECT_LE((motion.frames.back().com - motion.frames[0].com).norm(), 0.001);
}

TEST(Standing, ImpulseOfSixtyNewtonSeconds_TopplesTheFigure) {
  Animation animation = Standing(90, 2.0);
  ApplyImpulseToChest(&animation, 10, 60.0);
  const Motion motion = BakeOrFail(animation);
  EXPECT_LE(motion.frames.back().com.z(), 0.4);
  EXPECT_GE(motion.frames.back().com.x(), 0.5);
}

// Bounds the evaluations: implicit springs do not limit steps in time-stepping mode.
TEST(Standing, SixFrames_TakeFewEvaluations) {
  EXPECT_LE(BakeOrFail(Standing(6, 2.0)).regions[0].evaluations, 10000);
  EXPECT_LE(BakeOrFail(Standing(60, 5.0)).regions[0].evaluations, 40000);
}

TEST(Standing, TheAccountOfEnergyCloses) {
  Animation animation = Standing(60, 2.0);
  ApplyImpulseToChest(&animation, 10, 5.0);
  BakeOptions options;
  options.energy = true;
  const EnergyBalance energy = BakeOrFail(animation, options).regions[0].energy.value();
  EXPECT_LE(std::abs(energy.residual()), 1e-6);
}

// Positions of a figure at rest whose soles are on the ground.
DynamicsWorkspace AtRest(const Figure& figure) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, {Mat3::Identity(), Vec3(0.0, 0.0, kSolesBelow)}, figure.RestAngles(),
                   &ws);
  return ws;
}

TEST(Support, TwoFeetCarryHalfTheWeightEach) {
  const Animation animation = Standing(6, 2.0);
  const Figure& figure = *animation.figure;
  const DynamicsWorkspace ws = AtRest(figure);
  const std::vector<SupportPoint> points = FindSupport(figure, animation.scene, ws);
  const std::vector<double> shares = CarriedShares(figure, points, ws);
  // Centre of mass 2 mm behind the contact points of the heels, which carry almost all of the
  // weight.
  for (const char* ankle : {"r_ankle_flexion", "l_ankle_flexion", "r_hip_flexion"}) {
    EXPECT_NEAR(shares[figure.FindJoint(ankle)->value()], 0.5, 0.005) << ankle;
  }
  EXPECT_NEAR(shares[figure.FindJoint("r_ankle_flexion")->value()],
              shares[figure.FindJoint("l_ankle_flexion")->value()], 1e-9);
  EXPECT_EQ(shares[figure.FindJoint("waist_flexion")->value()], 0.0);
}

TEST(Support, PointForces_PushAndSupplyForceAndMoment) {
  const Animation animation = Standing(6, 2.0);
  const Figure& figure = *animation.figure;
  const DynamicsWorkspace ws = AtRest(figure);
  const std::vector<SupportPoint> points = FindSupport(figure, animation.scene, ws);
  Vec3 about = Vec3::Zero();  // mean of the points
  for (const SupportPoint& point : points) about += point.Place(ws) / points.size();
  const Wrench needed = {Vec3(20.0, -10.0, 700.0), Vec3(10.0, 5.0, 1.0)};
  const std::vector<Vec3> forces = SupportForces(points, needed, about, ws);
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_GE(forces[i].dot(points[i].normal), 0.0);
    force += forces[i];
    moment += (points[i].Place(ws) - about).cross(forces[i]);
  }
  EXPECT_LE((force - needed.force).norm(), 1e-8);
  EXPECT_LE((moment - needed.moment).norm(), 1e-8);
}

}  // namespace
}  // namespace hazumi::test
