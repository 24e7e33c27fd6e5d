// A flight that forces from outside push off its parabola.

#include "engine/placement/continuous_gravity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/stick_figures.h"

namespace hazumi::test {
namespace {

constexpr double kG = 9.81, kDrag = 3.0;  // [m/s^2], [1/s]

// Of one that is slowed down by kDrag from t = 0 on.
PointMotion FallAt(double t, const PointMotion& start) {
  const Vec3 u = -kG / kDrag * Vec3::UnitZ();
  const double left = std::exp(-kDrag * t);
  return {start.p + u * t + (start.v - u) * (1.0 - left) / kDrag, u + (start.v - u) * left};
}

class ContinuousGravityTest : public ::testing::Test {
 protected:
  ContinuousGravityTest() {
    motion_.q = motion_.qd = motion_.qdd = VecX::Zero(figure_.num_joints());
    motion_.X_WR.p = Vec3(0.0, 0.0, 1.55);  // a metre above the floor
    motion_.root.v = Vec3(0.5, 0.0, 2.0);
    gravity_.Start(0.0, motion_, &ws_);
    start_ = {gravity_.state().com, gravity_.state().com_v};
  }

  Vec3 ComAt(const FigureMotion& motion) {
    ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
    return CenterOfMass(figure_, ws_);
  }
  std::optional<GravityEvent> FirstEvent(double t0, double t1) {
    const auto pose = [&](double t, FigureMotion* motion) {
      *motion = motion_;
      motion->fall = FallAt(t, start_);
    };
    return gravity_.FirstEvent(t0, t1, pose, &ws_);
  }

  Figure figure_ = Pogo();
  std::vector<SceneObject> floor_ = {{"floor", Plane{}, ""}};
  PlacementSpan span_{PlacementKind::kGravity, 0, 100, {}, {}};
  ContinuousGravity gravity_{figure_, floor_, span_, kG};
  DynamicsWorkspace ws_{figure_};
  FigureMotion motion_;
  PointMotion start_;
};

TEST_F(ContinuousGravityTest, PlacesAFigureWhereItsFallIs) {
  motion_.fall = PointMotion{Vec3(1.0, 2.0, 3.0), Vec3(4.0, 5.0, 6.0)};
  gravity_.Place(0.4, &ws_, &motion_);
  EXPECT_LE((ComAt(motion_) - motion_.fall->p).norm(), 1e-14);
  ComputeVelocities(figure_, motion_.root.w, motion_.root.v, motion_.qd, &ws_);
  EXPECT_LE((CenterOfMassVelocity(figure_, ws_) - motion_.fall->v).norm(), 1e-14);
}

TEST_F(ContinuousGravityTest, FindsApexAndLandingOfAPushedFall) {
  const double apex = std::log(1.0 + 2.0 * kDrag / kG) / kDrag;
  const auto first = FirstEvent(0.0, 0.5);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, GravityEvent::Kind::kApex);
  EXPECT_NEAR(first->time, apex, 1e-9);
  const auto second = FirstEvent(first->time, 3.0);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->kind, GravityEvent::Kind::kLanding);
  EXPECT_NEAR(FallAt(second->time, start_).p.z() - start_.p.z(), -1.0, 1e-8);
}

TEST_F(ContinuousGravityTest, GoesOnFreelyOnceNothingPushes) {
  motion_.fall = FallAt(0.2, start_);
  gravity_.Place(0.2, &ws_, &motion_);
  const PointMotion left = *motion_.fall;
  motion_.fall.reset();
  gravity_.RenewFlight(0.2, motion_, &ws_);
  gravity_.Place(0.3, &ws_, &motion_);
  const Vec3 expected = left.p + 0.1 * left.v - 0.5 * kG * 0.01 * Vec3::UnitZ();
  EXPECT_LE((ComAt(motion_) - expected).norm(), 1e-13);
}

}  // namespace
}  // namespace hazumi::test
