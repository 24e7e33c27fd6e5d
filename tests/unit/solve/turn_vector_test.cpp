#include "engine/solve/turn_vector.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hazumi::solve {
namespace {

const Vec3 kDirection = Vec3(0.48, -0.6, 0.64);

TEST(TurnVector, GivesBackWhatARotationWasMadeOf) {
  for (const double angle : {0.0, 1e-12, 1e-6, 9e-4, 1.1e-3, 0.02, 1.0, 3.0, 3.14159}) {
    const Vec3 r = angle * kDirection;
    EXPECT_LT((TurnVector(RotationBy(r)) - r).norm(), 1e-11 * std::max(1.0, angle)) << angle;
    const Mat3 R = RotationBy(r);
    EXPECT_LT((R * R.transpose() - Mat3::Identity()).norm(), 1e-14) << angle;
  }
}

// Richardson's difference of fourth order.
TEST(TurnVector, ChangesAsItsDerivativeSays) {
  for (const double angle : {0.0, 1e-5, 9e-3, 1.1e-2, 0.7, 2.5}) {
    const Vec3 r = angle * kDirection;
    const Mat3 R = RotationBy(r), V = TurnVectorChange(r);
    for (int i = 0; i < 3; ++i) {
      const auto behind = [&](double h) { return TurnVector(R * RotationBy(h * Vec3::Unit(i))); };
      const auto before = [&](double h) { return TurnVector(RotationBy(h * Vec3::Unit(i)) * R); };
      const auto slope = [](const auto& f) {
        constexpr double h = 1e-3;
        return Vec3((8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h));
      };
      EXPECT_LT((slope(behind) - V.col(i)).norm(), 1e-9) << angle;
      EXPECT_LT((slope(before) - V.transpose().col(i)).norm(), 1e-9) << angle;
    }
  }
}

}  // namespace
}  // namespace hazumi::solve
