#include "engine/figure/hinge_row.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

HingeRow RandomRow(Random* random, int size) {
  HingeRow row;
  for (int i = 0; i < size; ++i) row.push_back({random->Rotation().col(0)});
  return row;
}

std::vector<double> RandomAngles(Random* random, size_t size) {
  std::vector<double> angles(size);
  for (double& angle : angles) angle = random->Uniform(-3.0, 3.0);
  return angles;
}

TEST(HingeRow, ThreeHingesAtRightAnglesTurnToAnything) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Mat3 axes = random.Rotation();
    const double hand = i % 2 == 0 ? 1.0 : -1.0;
    const HingeRow row = {{axes.col(0)}, {hand * axes.col(1)}, {axes.col(2)}};
    std::vector<double> angles = RandomAngles(&random, 3);
    const Mat3 R = random.Rotation();
    EXPECT_LE(TurnTo(R, row, &angles), 1e-7);
    EXPECT_LE((RotationOf(row, angles) - R).norm(), 1e-12);
  }
}

TEST(HingeRow, AnglesThatAreRightStay) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const HingeRow row = RandomRow(&random, random.Integer(1, 3));
    const std::vector<double> angles = RandomAngles(&random, row.size());
    std::vector<double> found = angles;
    EXPECT_LE(TurnTo(RotationOf(row, angles), row, &found), 1e-7);
    for (size_t k = 0; k < row.size(); ++k) EXPECT_NEAR(found[k], angles[k], 1e-6);
  }
}

TEST(HingeRow, TwoHingesAtRightAnglesFindWhatTheyCanDo) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Mat3 axes = random.Rotation();
    const HingeRow row = {{axes.col(0)}, {axes.col(1)}};
    std::vector<double> angles = RandomAngles(&random, 2);
    EXPECT_LE(TurnTo(RotationOf(row, RandomAngles(&random, 2)), row, &angles), 1e-7);
  }
}

// A fine grid of angles has none that is nearer.
TEST(HingeRow, TooFewHingesComeAsNearAsTheyCan) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const HingeRow row = RandomRow(&random, 2);
    const Mat3 R = random.Rotation();
    std::vector<double> angles = RandomAngles(&random, 2);
    const double left = TurnTo(R, row, &angles);
    double least = 10.0;
    for (double a = -std::numbers::pi; a < std::numbers::pi; a += 0.05) {
      for (double b = -std::numbers::pi; b < std::numbers::pi; b += 0.05) {
        const Mat3 rest = RotationOf(row, {a, b}).transpose() * R;
        least = std::min(least, Eigen::AngleAxisd(rest).angle());
      }
    }
    EXPECT_LE(left, least + 1e-6) << i;
    EXPECT_NEAR(Eigen::AngleAxisd(Mat3(RotationOf(row, angles).transpose() * R)).angle(), left,
                1e-6);
  }
}

TEST(HingeRow, FixedHingesStayAndTheOthersMakeTheBestOfIt) {
  const HingeRow row = {{Vec3::UnitZ()}, {Vec3::UnitX(), true}, {Vec3::UnitY()}};
  std::vector<double> angles = {0.0, 0.3, 0.0};
  EXPECT_LE(TurnTo(RotationOf(row, {0.7, 0.3, -0.4}), row, &angles), 1e-7);
  EXPECT_NEAR(angles[0], 0.7, 1e-7);
  EXPECT_EQ(angles[1], 0.3);
  EXPECT_NEAR(angles[2], -0.4, 1e-7);
}

TEST(HingeRow, WholeTurnsAreKept) {
  const HingeRow row = {{Vec3::UnitY()}};
  std::vector<double> angles = {12.0};
  EXPECT_LE(TurnTo(RotationOf(row, {0.1}), row, &angles), 1e-7);
  EXPECT_NEAR(angles[0], 0.1 + 4.0 * std::numbers::pi, 1e-9);
}

}  // namespace
}  // namespace hazumi::test
