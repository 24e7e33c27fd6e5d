// The strength of joints against what its sources say at single angles and rates.

#include "engine/figure/strength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/figure/figure_builder.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

// Rows of [Anderson, Madigan, Nussbaum 2007], table 3, men of 18 to 25 years: C1 ... C6.
constexpr double kMuscles[][6] = {
    {0.161, 0.958, 0.932, 1.578, 3.190, 0.242}, {0.113, 0.738, -0.214, 2.095, 4.267, 0.218},
    {0.163, 1.258, 1.133, 1.517, 3.952, 0.095}, {0.087, 0.869, 0.522, 2.008, 5.233, 0.304},
    {0.095, 1.391, 0.408, 0.987, 3.558, 0.295}, {0.033, 1.510, -0.187, 0.699, 1.940, 0.828}};
constexpr double kBody = 70.0 * 9.81 * 1.70;  // m g h [N m]

StrengthCurve Cosine(const double (&c)[6]) {
  StrengthCurve curve;
  curve.form = StrengthCurve::Form::kCosine;
  curve.torque = kBody * c[0];
  curve.width = 1.0 / c[1];
  curve.best_angle = c[2];
  curve.rate_75 = c[3];
  curve.rate_50 = c[4];
  curve.lengthening = c[5];
  return curve;
}

StrengthCurve Bell() {
  StrengthCurve curve;
  curve.form = StrengthCurve::Form::kBell;
  curve.torque = 65.9;
  curve.best_angle = 0.33;
  curve.width = 1.2;
  curve.fastest = 18.1;
  return curve;
}

// Changes sign where the least strength begins.
TEST(Strength, IsAboveTheLeastOrAtIt) {
  int at_least = 0;
  for (const StrengthCurve& curve : {Cosine(kMuscles[0]), Bell()}) {
    for (double angle = -3.0; angle <= 3.0; angle += 0.1) {
      for (double rate = -20.0; rate <= 20.0; rate += 0.5) {
        const bool is_at_least = StrengthAt(curve, angle, rate).is_at_least;
        EXPECT_EQ(ShareAboveLeast(curve, angle, rate) < 0.0, is_at_least) << angle << ", " << rate;
        at_least += is_at_least;
      }
    }
  }
  EXPECT_GT(at_least, 1000);
}

TEST(Strength, OfMeasuredMusclesIsThreeQuartersAndAHalfAtTheirTwoRates) {
  for (const auto& row : kMuscles) {
    const StrengthCurve curve = Cosine(row);
    EXPECT_DOUBLE_EQ(StrengthOfRate(curve, 0.0), 1.0);
    EXPECT_NEAR(StrengthOfRate(curve, row[3]), 0.75, 1e-12);
    EXPECT_NEAR(StrengthOfRate(curve, row[4]), 0.5, 1e-12);
    EXPECT_NEAR(StrengthAt(curve, row[2], row[4]).torque, 0.5 * kBody * row[0], 1e-9);
  }
}

TEST(Strength, OfMeasuredMusclesFollowsTheCosineOfTheAngle) {
  const StrengthCurve knee = Cosine(kMuscles[2]);
  for (const double q : {0.0, 0.5, 1.133, 2.0}) {
    EXPECT_NEAR(StrengthAt(knee, q, 0.0).torque, kBody * 0.163 * std::cos(1.258 * (q - 1.133)),
                1e-9);
  }
}

TEST(Strength, GrowsWhereMusclesLengthen) {
  const StrengthCurve hip = Cosine(kMuscles[0]);
  EXPECT_NEAR(StrengthOfRate(hip, -1.578), 0.75 * (1.0 + 0.242 * 1.578), 1e-12);
  EXPECT_GT(StrengthOfRate(Bell(), -3.0), 1.2);
  EXPECT_LT(StrengthOfRate(Bell(), -1000.0), 1.4);
}

TEST(Strength, IsNeverLessThanATwentiethAndSaysWhere) {
  for (const auto& row : kMuscles) {
    if (row[4] < 3.0 * row[3]) {  // else a part is left at any rate
      const Strength fast = StrengthAt(Cosine(row), row[2], 1e3);
      EXPECT_TRUE(fast.is_at_least);
      EXPECT_DOUBLE_EQ(fast.torque, 0.05 * kBody * row[0]);
    }
    const Strength far = StrengthAt(Cosine(row), row[2] + 4.0, 0.0);
    EXPECT_TRUE(far.is_at_least);
    EXPECT_FALSE(StrengthAt(Cosine(row), row[2], 0.0).is_at_least);
  }
  EXPECT_TRUE(StrengthAt(Bell(), 0.33, 18.1).is_at_least);
}

TEST(Strength, OfABellIsThatOfANormalDistributionAndOfHillsHyperbola) {
  const StrengthCurve elbow = Bell();
  EXPECT_DOUBLE_EQ(StrengthAt(elbow, 0.33, 0.0).torque, 65.9);
  EXPECT_NEAR(StrengthAt(elbow, 0.33 + 1.2, 0.0).torque, 65.9 * std::exp(-0.5), 1e-9);
  EXPECT_NEAR(StrengthOfRate(elbow, 0.5 * 18.1), 1.0 / 6.0, 1e-12);
  // Value and slope go on at rest.
  EXPECT_NEAR(StrengthOfRate(elbow, 1e-6), StrengthOfRate(elbow, -1e-6), 1e-6);
  const double before = (1.0 - StrengthOfRate(elbow, -1e-5)) / 1e-5;
  const double after = (StrengthOfRate(elbow, 1e-5) - 1.0) / 1e-5;
  EXPECT_NEAR(before, after, 1e-4);
}

TEST(Strength, ShortensTheMusclesOfOneSideWhereItLengthensThoseOfTheOther) {
  const JointStrength knee = {Cosine(kMuscles[3]), Cosine(kMuscles[2])};
  const StrengthLimits limits = knee.At(0.7, 2.0);
  EXPECT_DOUBLE_EQ(limits.positive.torque, StrengthAt(knee.positive, 0.7, 2.0).torque);
  EXPECT_DOUBLE_EQ(limits.negative.torque, StrengthAt(knee.negative, 0.7, -2.0).torque);
}

TEST(Strength, OfAConstantIsItself) {
  StrengthCurve curve;
  curve.torque = 12.0;
  EXPECT_EQ(StrengthAt(curve, 7.0, -50.0).torque, 12.0);
}

TEST(Strength, IsThatOfTheMirroredTwinToo) {
  FigureSpec spec = Arm7Spec();
  for (JointSpec& joint : spec.joints) {
    if (joint.name != "r_elbow") continue;
    joint.hinges[0].strength = JointStrength{Bell(), Cosine(kMuscles[2])};
  }
  spec.mirror = MirrorSpec{"r_", "l_"};
  const Figure figure = Build(spec);
  const Joint& left = figure.joint(figure.group(*figure.FindGroup("l_elbow")).first);
  const Joint& right = figure.joint(figure.group(*figure.FindGroup("r_elbow")).first);
  ASSERT_TRUE(right.strength.has_value());
  EXPECT_EQ(left.strength, right.strength);
  EXPECT_FALSE(figure.joint(figure.group(*figure.FindGroup("l_wrist")).first).strength);
}

}  // namespace
}  // namespace hazumi::test
