#include "engine/spatial/euler_angles.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr double kRight = std::numbers::pi / 2.0;

const std::vector<std::string>& Orders() {
  static const std::vector<std::string> orders = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};
  return orders;
}

TEST(EulerAngles, GiveTheRotationBack) {
  Random random(1);
  for (const std::string& order : Orders()) {
    const EulerAxes axes = *EulerAxesOf(order);
    for (int i = 0; i < 500; ++i) {
      const Mat3 R = random.Rotation();
      const Vec3 angles = EulerAnglesNear(R, axes, random.Vector3(10.0));
      ASSERT_LT((EulerRotation(axes, angles) - R).norm(), 1e-14) << order;
    }
  }
}

TEST(EulerAngles, GiveTheRotationBackInAndNearGimbalLock) {
  Random random(2);
  for (const std::string& order : Orders()) {
    const EulerAxes axes = *EulerAxesOf(order);
    for (int i = 0; i < 500; ++i) {
      Vec3 angles = random.Vector3(3.0);
      const double off = i % 3 == 0 ? 0.0 : random.LogUniform(1e-16, 1e-2);
      angles[1] = (random.Chance(0.5) ? kRight : -kRight) + off;
      const Mat3 R = EulerRotation(axes, angles);
      const Vec3 found = EulerAnglesNear(R, axes, random.Vector3(3.0));
      ASSERT_LT((EulerRotation(axes, found) - R).norm(), 3e-12) << order << " off " << off;
    }
  }
}

// The angles themselves come back where the ones before were near, over whole turns and through
// the lock.
TEST(EulerAngles, FollowAMotionWithoutAJump) {
  for (const std::string& order : Orders()) {
    const EulerAxes axes = *EulerAxesOf(order);
    Vec3 previous = Vec3::Zero();
    for (int i = 0; i <= 2000; ++i) {
      const double t = i * 0.01;
      const Vec3 angles(0.8 * t, 0.6 * t, -1.1 * t + 0.3 * std::sin(t));
      previous = EulerAnglesNear(EulerRotation(axes, angles), axes, previous);
      ASSERT_LT((previous - angles).norm(), 1e-9) << order << " at " << t;
    }
  }
}

TEST(EulerAngles, OrdersOfFewerAxesAreCompleted) {
  EXPECT_EQ(*EulerAxesOf("ZXY"), (EulerAxes{2, 0, 1}));
  EXPECT_EQ(*EulerAxesOf("Y"), (EulerAxes{1, 0, 2}));
  EXPECT_EQ(*EulerAxesOf(""), (EulerAxes{0, 1, 2}));
  for (const char* wrong : {"ZXZ", "XX", "XYZX", "xyz", "W"}) EXPECT_FALSE(EulerAxesOf(wrong));
}

}  // namespace
}  // namespace hazumi::test
