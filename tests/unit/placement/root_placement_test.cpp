#include <gtest/gtest.h>

#include <cmath>

#include "engine/placement/contact.h"
#include "engine/placement/figure_motion.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

// The human with every joint and the root's orientation swinging.
FigureMotion SwingingAt(const Figure& figure, double t) {
  FigureMotion motion;
  const int n = figure.num_joints();
  motion.q = motion.qd = motion.qdd = VecX::Zero(n);
  for (int j = 0; j < n; ++j) {
    const double k = 2.0 + 0.1 * j;
    motion.q[j] = 0.5 * std::sin(k * t + j);
    motion.qd[j] = 0.5 * k * std::cos(k * t + j);
    motion.qdd[j] = -0.5 * k * k * std::sin(k * t + j);
  }
  RootAngles angles;
  for (int i = 0; i < 3; ++i) {
    const double k = 1.0 + i;
    angles.angle[i] = 0.4 * std::sin(k * t + i);
    angles.rate[i] = 0.4 * k * std::cos(k * t + i);
    angles.acceleration[i] = -0.4 * k * k * std::sin(k * t + i);
  }
  SetRootOrientation(angles, &motion);
  return motion;
}

class RootPlacement : public ::testing::Test {
 protected:
  FigureMotion PinnedAt(double t) {
    FigureMotion motion = SwingingAt(figure_, t);
    PinRoot(figure_, toe_, kPin, &ws_, &motion);
    return motion;
  }
  FigureMotion FallingAt(double t) {
    FigureMotion motion = SwingingAt(figure_, t);
    PlaceCenterOfMass(figure_, kCom + kComV * t, kComV, &ws_, &motion);
    return motion;
  }
  const Vec3 kPin{0.3, -0.2, 0.05}, kCom{0.1, 0.2, 1.0}, kComV{1.0, -0.5, 2.0};
  const Figure figure_ = test::Human();
  const JointIndex toe_ = *figure_.FindJoint("l_toe");
  DynamicsWorkspace ws_{figure_};
};

// Richardson's extrapolation of central differences.
template <typename F>
Vec3 Rate(const F& f, double t) {
  const auto central = [&](double h) -> Vec3 { return (f(t + h) - f(t - h)) / (2.0 * h); };
  return (4.0 * central(5e-4) - central(1e-3)) / 3.0;
}

TEST_F(RootPlacement, OrientationHasTheRatesOfItsAngles) {
  for (const double t : {0.1, 0.7, 1.9}) {
    const FigureMotion now = SwingingAt(figure_, t);
    for (int column = 0; column < 3; ++column) {
      const auto axis = [&](double s) -> Vec3 { return SwingingAt(figure_, s).X_WR.R.col(column); };
      EXPECT_LE((Rate(axis, t) - now.root.w.cross(axis(t))).norm(), 1e-9);
    }
    const auto w = [&](double s) -> Vec3 { return SwingingAt(figure_, s).root.w; };
    EXPECT_LE((Rate(w, t) - now.root.alpha).norm(), 1e-9);
  }
}

TEST_F(RootPlacement, PinStaysInPlaceAndAtRest) {
  for (const double t : {0.1, 0.7, 1.9}) {
    const FigureMotion now = PinnedAt(t);
    ComputePositions(figure_, now.X_WR, now.q, &ws_);
    ComputeMotion(figure_, now.root, now.qd, now.qdd, &ws_);
    EXPECT_LE((ws_.body(toe_).p - kPin).norm(), 1e-14);
    EXPECT_LE(ws_.body(toe_).v.norm(), 1e-13);
    EXPECT_LE(ws_.body(toe_).a.norm(), 1e-12);
  }
}

TEST_F(RootPlacement, PinnedRootsRatesAreTheDerivativesOfItsPosition) {
  const auto p = [&](double s) -> Vec3 { return PinnedAt(s).X_WR.p; };
  const auto v = [&](double s) -> Vec3 { return PinnedAt(s).root.v; };
  for (const double t : {0.1, 0.7, 1.9}) {
    EXPECT_LE((Rate(p, t) - PinnedAt(t).root.v).norm(), 1e-9);
    EXPECT_LE((Rate(v, t) - PinnedAt(t).root.a).norm(), 1e-8);
  }
}

TEST_F(RootPlacement, PutsTheCenterOfMassWhereItIsTold) {
  for (const double t : {0.1, 0.7, 1.9}) {
    const FigureMotion now = FallingAt(t);
    ComputePositions(figure_, now.X_WR, now.q, &ws_);
    ComputeVelocities(figure_, now.root.w, now.root.v, now.qd, &ws_);
    EXPECT_LE((CenterOfMass(figure_, ws_) - (kCom + kComV * t)).norm(), 1e-14);
    EXPECT_LE((CenterOfMassVelocity(figure_, ws_) - kComV).norm(), 1e-13);
    const auto p = [&](double s) -> Vec3 { return FallingAt(s).X_WR.p; };
    EXPECT_LE((Rate(p, t) - now.root.v).norm(), 1e-9);
  }
}

TEST_F(RootPlacement, NearestGroupIsTheOneWhoseOriginIsNearest) {
  ComputePositions(figure_, Pose(), VecX::Zero(figure_.num_joints()), &ws_);
  for (const char* name : {"r_wrist", "l_toe", "neck"}) {
    const GroupIndex group = *figure_.FindGroup(name);
    const Vec3 beside = ws_.body(figure_.group(group).first).p + Vec3(0.01, 0.01, 0.0);
    EXPECT_EQ(NearestGroup(figure_, ws_, beside), group);
  }
}

}  // namespace
}  // namespace hazumi
