// What the command line and the motion's JSON say of regions, of both methods.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/cli/report_text.h"
#include "engine/exchange/motion_text.h"
#include "engine/spatial/degrees.h"
#include "tests/support/figures.h"

namespace hazumi {
namespace {

using Json = nlohmann::ordered_json;

RegionReport ExactReport() {
  RegionReport report;
  report.name = "arms";
  report.method = Method::kExact;
  report.tolerance = 0.01 * kDegree;
  report.steps = 12;
  report.evaluations = 340;
  report.solves = 344;
  report.microseconds = 1234.5;
  report.free_joints = 14;
  report.all_joints = 37;
  report.islands = {7, 7};
  report.bodies = 6;
  report.error_estimate = 0.004 * kDegree;
  return report;
}

RegionReport PaperReport() {
  RegionReport report;
  report.name = "arms";
  report.method = Method::kPaper;
  report.step = 0.01;
  report.steps = 34;
  report.evaluations = 1;
  report.free_joints = 1;
  report.all_joints = 1;
  return report;
}

// Starts with 3 J, loses 0.5 J to friction and 0.25 J to limits; 0.5 J cannot be explained.
EnergyBalance SomeEnergy() {
  EnergyBalance energy;
  energy.kinetic_start = 1.0;
  energy.kinetic_end = 2.0;
  energy.potential_start = 2.0;
  energy.potential_end = 1.0;
  energy.laws = {{"friction", -0.5}};
  energy.limits = -0.25;
  energy.keyed = 0.25;
  return energy;
}

// A motion with no frames of this region.
Json BakedJson(const RegionReport& report, const MotionJsonOptions& options = {}) {
  Animation animation;
  animation.figure = std::make_shared<const Figure>(test::Pendulum(1.0, 0.02, 0.5));
  animation.solver = {report.method, 1.0 / 30.0, 0.01 * kDegree, 1};
  Motion motion;
  motion.regions.push_back(report);
  return Json::parse(MotionToJson(animation, motion, options));
}

std::vector<std::string> FieldsOf(const Json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

TEST(ReportText, SaysWhatWasModelled) {
  RegionReport report = ExactReport();
  EXPECT_EQ(ModelText(report, false), "14 of 37 joints, 2 groups of 7, 6 bodies");
  EXPECT_EQ(ModelText(report, true), "14 of 37 joints and the root, 2 groups of 7, 6 bodies");
  report.islands = {1, 7, 3, 3};
  report.bodies = 1;
  EXPECT_EQ(ModelText(report, false),
            "14 of 37 joints, 1 group of 7 and 2 of 3 and 1 of 1, 1 body");
  EXPECT_EQ(ModelText(PaperReport(), false), "1 of 1 joint");
}

TEST(ReportText, SaysWhatItTookAndHowWellItWent) {
  EXPECT_EQ(
      LinesOf(ExactReport(), false),
      (std::vector<std::string>{"14 of 37 joints, 2 groups of 7, 6 bodies",
                                "12 steps, 340 evaluations, error estimate 0.004 deg, 1235 us, "
                                "3.63 us an evaluation"}));
  EXPECT_EQ(LinesOf(PaperReport(), false),
            (std::vector<std::string>{"1 of 1 joint",
                                      "34 steps, 1 evaluation, 0 us, 0 us an evaluation"}));
}

TEST(ReportText, AccountsForTheEnergy) {
  RegionReport report = ExactReport();
  report.energy = SomeEnergy();
  const std::vector<std::string> lines = LinesOf(report, false);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[2],
            "energy: kinetic 1 to 2 J, potential 2 to 1 J, friction -0.5 J, limits -0.25 J, "
            "impacts of contacts 0 J, keys and "
            "placement 0.25 J, unexplained 0.5 J");
}

TEST(ReportText, NamesTheNumberThatTheMethodHeeds) {
  EXPECT_EQ(FinenessText(Method::kPaper, 0.01, 1.0), "paper at 0.01 s");
  EXPECT_EQ(FinenessText(Method::kExact, 0.01, 6e-5 * kDegree), "exact to 6e-05 deg");
}

TEST(MotionJson, OfMethodExactTellsToleranceModelAndError) {
  const Json json = BakedJson(ExactReport());
  EXPECT_EQ(json["solver"].dump(), R"({"method":"exact","tolerance_deg":0.01,"version":1})");
  const Json& region = json["regions"][0];
  EXPECT_EQ(FieldsOf(region),
            (std::vector<std::string>{"name", "method", "tolerance_deg", "steps", "evaluations",
                                      "solves", "free_joints", "all_joints", "groups", "bodies",
                                      "error_estimate_deg"}));
  EXPECT_EQ(region["tolerance_deg"], 0.01);
  EXPECT_EQ(region["groups"], Json::parse("[7, 7]"));
  EXPECT_EQ(region["bodies"], 6);
  EXPECT_NEAR(region["error_estimate_deg"].get<double>(), 0.004, 1e-15);
}

TEST(MotionJson, OfMethodPaperTellsItsStep) {
  const Json json = BakedJson(PaperReport(), {.timings = true});
  EXPECT_EQ(json["solver"].dump(),
            R"({"method":"paper","step_s":0.03333333333333333,"version":1})");
  EXPECT_EQ(FieldsOf(json["regions"][0]),
            (std::vector<std::string>{"name", "method", "step_s", "steps", "evaluations", "solves",
                                      "microseconds", "free_joints", "all_joints"}));
}

TEST(MotionJson, AccountsForTheEnergy) {
  RegionReport report = ExactReport();
  report.energy = SomeEnergy();
  const Json json = BakedJson(report);
  const Json& energy = json["regions"][0]["energy_j"];
  EXPECT_EQ(
      FieldsOf(energy),
      (std::vector<std::string>{"kinetic_start", "kinetic_end", "potential_start", "potential_end",
                                "friction", "stops", "impacts", "keyed", "residual"}));
  EXPECT_EQ(energy["kinetic_end"], 2.0);
  EXPECT_EQ(energy["residual"], 0.5);
}

// By a place of the scene, another link, or a ball.
TEST(MotionJson, NamesWhatPushesALink) {
  Animation animation;
  animation.figure = std::make_shared<const Figure>(test::Pendulum(1.0, 0.02, 0.5));
  animation.scene.emplace_back().name = "floor";
  animation.held_objects.emplace_back().name = "ball";
  animation.regions.emplace_back().touches_scene = true;
  Motion motion;
  motion.regions.push_back(ExactReport());
  MotionFrame& frame = motion.frames.emplace_back();
  frame.q = VecX::Zero(animation.figure->num_joints());
  frame.in_region.assign(animation.figure->num_joints(), false);
  ContactPush push;
  push.link = push.object = 0;
  frame.contacts.pushes = {push, push, push};
  frame.contacts.pushes[1].object = frame.contacts.pushes[2].object = -1;
  frame.contacts.pushes[1].by_link = 0;
  frame.contacts.pushes[2].by_ball = 0;
  const Json json = Json::parse(MotionToJson(animation, motion));
  const Json& contacts = json["frames"][0]["contacts"];
  ASSERT_EQ(contacts.size(), 3u);
  EXPECT_EQ(contacts[0]["object"], "floor");
  EXPECT_EQ(contacts[1]["by_link"], contacts[1]["link"]);
  EXPECT_EQ(contacts[2]["by_held_object"], "ball");
  EXPECT_TRUE(contacts[2]["object"].is_null());
}

TEST(MotionJson, StaysJsonWhateverTheEstimate) {
  RegionReport report = ExactReport();
  report.error_estimate = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(BakedJson(report)["regions"][0]["error_estimate_deg"].is_null());
}

TEST(StatedDegrees, AreThoseThatWereStated) {
  for (const double degrees : {0.0, 1e-10, 7e-9, 3e-4, 0.01, 0.3, 1.5, 5.0}) {
    EXPECT_EQ(StatedDegrees(degrees * kDegree), degrees);
  }
}

}  // namespace
}  // namespace hazumi
