// Derivatives of a region's motion against the analytic solution, their convergence, and what is
// refused. The comparison with bakes is tests/property/sensitivity_test.cpp.

#include "engine/bake/sensitivity/region_sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/animations.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

constexpr double kMass = 1.0, kRadius = 0.05, kLength = 1.0;

Figure RodWithLimits(double limit) {
  LinkSpec link;
  link.name = "rod";
  link.to = Vec3(0.0, 0.0, -kLength);
  link.radius = kRadius;
  link.mass = kMass;
  JointSpec joint;
  joint.name = "rod";
  joint.parent = "base";
  joint.hinges = {{"", Vec3::UnitY(), -limit, limit, 0.0}};
  joint.links = {link};
  FigureSpec spec;
  spec.name = "pendulum";
  spec.root_name = "base";
  spec.joints = {joint};
  return Build(spec);
}

// A rod about its end without gravity, from the angle 0.2 with the rate 2.
Animation Rod(double friction, double limit = 3.0) {
  Animation animation = Still(RodWithLimits(limit));
  animation.solver.method = Method::kExact;
  animation.gravity = 0.0;
  KeysOf(&animation, "rod") = {{0, 0.2, 2.0, kCubic}};
  AddRegion(&animation, "swing", 0, 30, {"rod"}, friction).method = Method::kExact;
  return animation;
}

MatX DerivativesOf(const Animation& animation, int frame,
                   const RegionSensitivityOptions& options = {}) {
  const Result<RegionSensitivity> result = DeriveRegion(animation, 0, {frame}, options);
  return result.value().frames[0].D;
}

// q = q0 + v0 (1 - e^-ct) / c,   v = v0 e^-ct.
TEST(RegionSensitivity, OfARodWithFriction_IsTheAnalyticOne) {
  constexpr double kFriction = 0.8;
  const double c = FrictionRate(kFriction), left = std::exp(-c * 0.5);
  const MatX D = DerivativesOf(Rod(kFriction), 15);
  EXPECT_NEAR(D(0, 0), 1.0, 1e-9);
  EXPECT_NEAR(D(1, 0), 0.0, 1e-9);
  EXPECT_NEAR(D(0, 1), (1.0 - left) / c, 1e-9);
  EXPECT_NEAR(D(1, 1), left, 1e-9);
}

// A torque turns the rod back with the acceleration a. It hits its limit L at t1 and leaves it at
// once,
//   L = q0 + v0 t1 - a t1^2 / 2,   q = L - a (t - t1)^2 / 2,   v = -a (t - t1),
// so that dq = a (t - t1) dt1 and dv = a dt1, dt1 = -(dq0 + t1 dv0) / (v0 - a t1).
TEST(RegionSensitivity, OfARodThatHitsItsLimit_IsTheAnalyticOne) {
  constexpr double kInertia = kMass * (3.0 * kRadius * kRadius + 4.0 * kLength * kLength) / 12.0;
  constexpr double kTorque = -1.0, kLimit = 0.5, kStart = 0.2, kRate = 2.0, kTime = 0.5;
  Animation animation = Rod(/*friction=*/1.0, kLimit);
  Drive drive;
  drive.joints = {JointOf(animation, "rod")};
  drive.torque = {{0, kTorque, {}, Interpolation::kHold}};
  animation.regions[0].drives = {drive};
  const double a = -kTorque / kInertia;
  const double rate = std::sqrt(kRate * kRate - 2.0 * a * (kLimit - kStart));  // at the limit
  const double t1 = (kRate - rate) / a;
  const Result<RegionSensitivity> result = DeriveRegion(animation, 0, {15});
  ASSERT_TRUE(result.ok()) << result.error().ToString();
  ASSERT_EQ(result.value().events.size(), 1u);
  EXPECT_NEAR(result.value().events[0].time, t1, 1e-9);
  EXPECT_NEAR(result.value().events[0].rate, rate, 1e-8);
  const MatX& D = result.value().frames[0].D;
  EXPECT_NEAR(D(0, 0), -a * (kTime - t1) / rate, 1e-8);
  EXPECT_NEAR(D(1, 0), -a / rate, 1e-8);
  EXPECT_NEAR(D(0, 1), -a * (kTime - t1) * t1 / rate, 1e-8);
  EXPECT_NEAR(D(1, 1), -a * t1 / rate, 1e-8);
}

// An arm of seven hinges, let go with rates, that meets its limits.
Animation Arm() {
  Animation animation = Still(Arm7());
  animation.solver.method = Method::kExact;
  for (size_t j = 0; j < animation.joint_keys.size(); ++j) {
    animation.joint_keys[j] = {{0, 0.3, 1.0 + static_cast<double>(j), kCubic}};
  }
  AddRegion(&animation, "swing", 0, 20, {"r_shoulder"}, 0.8).method = Method::kExact;
  return animation;
}

TEST(RegionSensitivity, ConvergesWithItsTolerance) {
  const Animation arm = Arm();
  const auto derivatives = [&](double tolerance) {
    RegionSensitivityOptions options;
    options.tolerance = {tolerance, 10.0 * tolerance};
    return DerivativesOf(arm, 20, options);
  };
  const MatX best = derivatives(1e-13);
  const auto error = [&](double tolerance) {
    return (derivatives(tolerance) - best).lpNorm<Eigen::Infinity>() /
           best.lpNorm<Eigen::Infinity>();
  };
  EXPECT_LT(error(1e-6), 1e-3);
  EXPECT_LT(error(1e-8), 1e-5);
  EXPECT_LT(error(1e-10), 1e-7);
  EXPECT_LT(error(1e-10), 0.1 * error(1e-6));
}

// The state at a frame depends on that at an earlier one, and that on the start.
TEST(RegionSensitivity, OfEarlierFrames_DoesNotDependOnLaterOnes) {
  const Animation arm = Arm();
  const Result<RegionSensitivity> both = DeriveRegion(arm, 0, {10, 20});
  ASSERT_TRUE(both.ok());
  const MatX alone = DerivativesOf(arm, 20);
  EXPECT_LT((both.value().frames[1].D - alone).lpNorm<Eigen::Infinity>(),
            1e-7 * alone.lpNorm<Eigen::Infinity>());
  const MatX earlier = DerivativesOf(arm, 10);
  EXPECT_LT((both.value().frames[0].D - earlier).lpNorm<Eigen::Infinity>(),
            1e-7 * earlier.lpNorm<Eigen::Infinity>());
}

std::string RefusalOf(const Animation& animation) {
  const Result<RegionSensitivity> result = DeriveRegion(animation, 0, {15});
  return result.ok() ? "" : result.error().message;
}

TEST(RegionSensitivity, RefusesWhatItDoesNotCover) {
  EXPECT_EQ(RefusalOf(Arm()), "");
  Animation paper = Arm();
  paper.regions[0].method = Method::kPaper;
  EXPECT_NE(RefusalOf(paper).find("paper"), std::string::npos);
  Animation touching = Arm();
  touching.regions[0].touches_scene = true;
  EXPECT_NE(RefusalOf(touching).find("contacts"), std::string::npos);
  Animation falling = Arm();
  AddGravity(&falling, 5, 25);
  EXPECT_NE(RefusalOf(falling).find("gravity"), std::string::npos);
  Animation pushed = Arm();
  pushed.forces.push_back({"blow", PushForce{}, 5, 6});
  EXPECT_NE(RefusalOf(pushed).find("the force blow"), std::string::npos);
  Animation tied = Arm();
  tied.constraints.emplace_back();
  tied.constraints.back().last_frame = 20;
  EXPECT_NE(RefusalOf(tied).find("constraint"), std::string::npos);
  Animation outside = Arm();
  outside.joint_keys[0][0].value = 4.0;  // its limits are at pi
  EXPECT_NE(RefusalOf(outside).find("outside its limits"), std::string::npos);
}

}  // namespace
}  // namespace hazumi::test
