// The strength of hinges in a figure's file.

#include <gtest/gtest.h>

#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

Result<FigureSpec> WithStrength(const std::string& strength) {
  const Json figure =
      Changed(SampleProject()["figure"], {{"/joints/2/hinges/0/strength", strength}});
  return ParseFigure(figure.dump(), "figure.json");
}

constexpr char kCurves[] = R"({
  "positive": {"curve": "cosine", "torque_n_m": 101.5, "best_angle_deg": 30, "width_deg": 60,
               "rate_75_deg_s": 90, "rate_50_deg_s": 200, "lengthening_s": 0.25},
  "negative": {"curve": "bell", "torque_n_m": 45, "best_angle_deg": 95, "width_deg": 75,
               "fastest_deg_s": 1000}})";

TEST(FigureStrength, IsATorqueOrACurveForEachSide) {
  const Result<FigureSpec> figure = WithStrength(R"({"positive_n_m": 65, "negative_n_m": 45})");
  ASSERT_TRUE(figure.ok()) << figure.error().ToString();
  const auto& elbow = figure.value().joints[2].hinges[0].strength;
  ASSERT_TRUE(elbow.has_value());
  EXPECT_EQ(elbow->At(1.0, 3.0).positive.torque, 65.0);
  EXPECT_EQ(elbow->At(1.0, 3.0).negative.torque, 45.0);
  const Result<FigureSpec> curved = WithStrength(kCurves);
  ASSERT_TRUE(curved.ok()) << curved.error().ToString();
  const JointStrength& strength = *curved.value().joints[2].hinges[0].strength;
  EXPECT_NEAR(strength.At(30 * kDegree, 200 * kDegree).positive.torque, 50.75, 1e-9);
  EXPECT_NEAR(strength.At(95 * kDegree, 0.0).negative.torque, 45.0, 1e-9);
}

TEST(FigureStrength, GoesThroughAFile) {
  const FigureSpec figure = WithStrength(kCurves).value();
  const Result<FigureSpec> again = ParseFigure(FigureText(figure), "again.json");
  ASSERT_TRUE(again.ok()) << again.error().ToString();
  EXPECT_EQ(FigureText(again.value()), FigureText(figure));
  const JointStrength &a = *figure.joints[2].hinges[0].strength,
                      &b = *again.value().joints[2].hinges[0].strength;
  EXPECT_NEAR(a.At(0.3, 2.0).positive.torque, b.At(0.3, 2.0).positive.torque, 1e-9);
  EXPECT_NEAR(a.At(0.3, 2.0).negative.torque, b.At(0.3, 2.0).negative.torque, 1e-9);
}

TEST(FigureStrength, SaysWhatIsWrong) {
  const auto complaint = [](const std::string& strength) {
    const Result<FigureSpec> figure = WithStrength(strength);
    return figure.ok() ? "none" : figure.error().ToString();
  };
  EXPECT_NE(complaint(R"({"positive_n_m": 65})").find("needs exactly one of \"negative_n_m\""),
            std::string::npos);
  EXPECT_NE(complaint(R"({"positive_n_m": 0, "negative_n_m": 1})").find("greater than 0"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"negative_n_m": 1, "positive": {"curve": "cosine", "torque_n_m": 1,
      "best_angle_deg": 0, "width_deg": 60, "rate_75_deg_s": 90, "rate_50_deg_s": 80}})")
                .find("rate_50_deg_s"),
            std::string::npos);
}

// The shipped human: the shares of [Anderson, Madigan, Nussbaum 2007] of m g h, and 0.65 of a
// gymnast's torques.
TEST(FigureStrength, OfTheShippedHumanIsThatOfItsSources) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/figures/human.json";
  const Figure human = BuildFigure(LoadFigure(path).value()).value();
  const auto limits = [&](const char* hinge, double angle, double rate) {
    const Joint& joint = human.joint(*human.FindJoint(hinge));
    EXPECT_TRUE(joint.strength.has_value()) << hinge;
    return joint.strength->At(angle, rate);
  };
  const double body = 70.0 * 9.81 * 1.70;
  EXPECT_NEAR(limits("r_knee", 1.133, 0.0).negative.torque, 0.163 * body, 1e-3);
  EXPECT_NEAR(limits("r_knee", 1.133, -1.517).negative.torque, 0.75 * 0.163 * body, 1e-3);
  EXPECT_NEAR(limits("l_knee", 1.133, -3.952).negative.torque, 0.5 * 0.163 * body, 1e-3);
  EXPECT_NEAR(limits("l_hip_flexion", -0.214, 4.267).positive.torque, 0.5 * 0.113 * body, 1e-3);
  EXPECT_NEAR(limits("r_ankle_flexion", 0.408, 0.0).negative.torque, 0.095 * body, 1e-3);
  EXPECT_NEAR(limits("r_elbow_flexion", 0.33, 0.0).positive.torque, 0.65 * 101.384, 1e-3);
  EXPECT_FALSE(human.joint(*human.FindJoint("r_toe")).strength.has_value());
}

}  // namespace
}  // namespace hazumi::testing
