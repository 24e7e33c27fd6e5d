// Flights that forces from outside push off their parabola, and their landings.

#include "engine/placement/continuous_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "tests/support/stick_figures.h"

namespace hazumi::test {
namespace {

constexpr double kGravity = 9.81, kDrag = 3.0;  // [m/s^2], [1/s]

// Of one that is slowed down by kDrag from t = 0 on.
PointMotion FallAt(double t, const PointMotion& start) {
  const Vec3 u = -kGravity / kDrag * Vec3::UnitZ();
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
  ContinuousGravity gravity_{figure_, floor_, span_, kGravity};
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
  const double apex = std::log(1.0 + 2.0 * kDrag / kGravity) / kDrag;
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
  const Vec3 expected = left.p + 0.1 * left.v - 0.5 * kGravity * 0.01 * Vec3::UnitZ();
  EXPECT_LE((ComAt(motion_) - expected).norm(), 1e-13);
}

// A figure that has taken off, its lowest point at a given height [m] over the floor.
class HopTest : public ::testing::Test {
 protected:
  // Time of the landing, searched for from cut to cut [s].
  static double LandingOf(const std::function<double(double)>& height,
                          const std::vector<double>& cuts, int version) {
    const Figure figure = Pogo();
    const std::vector<SceneObject> floor = {{"floor", Plane{}, ""}};
    const PlacementSpan span{PlacementKind::kGravity, 0, 100, {}, {}};
    ContinuousGravity gravity(figure, floor, span, kGravity, SolverRules(version));
    DynamicsWorkspace ws(figure);
    FigureMotion motion;
    motion.q = motion.qd = motion.qdd = VecX::Zero(figure.num_joints());
    motion.X_WR.p = Vec3(0.0, 0.0, kTouches + height(0.0));
    gravity.Start(0.0, motion, &ws);
    gravity.Happen({GravityEvent::Kind::kTakeOff, 0.0}, motion, &ws);
    const Vec3 com = gravity.state().com;
    const auto pose = [&](double s, FigureMotion* at) {
      const double rate = (height(s + 1e-6) - height(s - 1e-6)) / 2e-6;
      *at = motion;
      at->fall = PointMotion{com + (height(s) - height(0.0)) * Vec3::UnitZ(), rate * Vec3::UnitZ()};
    };
    double from = 0.0;
    for (const double to : cuts) {
      while (const auto event = gravity.FirstEvent(from, to, pose, &ws)) {
        if (event->is_change()) return event->time;
        from = event->time;
      }
      from = to;
    }
    ADD_FAILURE() << "does not land";
    return NAN;
  }
  static constexpr double kTouches = 0.55;  // height of the root [m]
};

// The figure comes back at 1 um/s: a depth of 1e-9 m takes a millisecond.
TEST_F(HopTest, LandsOnTimeAtLittleSpeed) {
  const auto height = [](double t) { return 1e-6 * t * (1.0 - t); };
  EXPECT_NEAR(LandingOf(height, {2.0}, 2), 1.0, 1e-6);
  EXPECT_NEAR(LandingOf(height, {2.0}, 1), 1.001, 1e-4);
}

// The figure takes off 20 mm deep, comes up to 10 mm and goes down again: it lands at 20 mm,
// wherever the search is cut.
TEST_F(HopTest, LandsAsDeepAsItTookOff) {
  const auto height = [](double t) { return -0.02 + 0.04 * t * (1.0 - t); };
  const double whole = LandingOf(height, {2.0}, 2);
  EXPECT_NEAR(whole, 1.0, 1e-9);
  EXPECT_NEAR(LandingOf(height, {0.3, 0.45, 0.77, 2.0}, 2), whole, 1e-12);
  EXPECT_LT(LandingOf(height, {2.0}, 1), 0.6);
}

// A figure that has been outside lands at the surface.
TEST_F(HopTest, LandsAtTheSurfaceOnceOutside) {
  const auto height = [](double t) { return -0.02 + 0.4 * t * (1.0 - t); };
  EXPECT_NEAR(LandingOf(height, {2.0}, 2), 0.5 + std::sqrt(0.2), 1e-9);
}

}  // namespace
}  // namespace hazumi::test
