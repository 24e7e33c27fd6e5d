#include "engine/project/figure_editor.h"

#include <gtest/gtest.h>

#include "engine/project/project_writer.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

Json TextOf(const Project& project) { return Json::parse(project.figure.embedded_json); }

std::string WhyRefused(const Result<Done>& done) {
  return done.ok() ? "no complaint" : done.error().ToString();
}

TEST(FigureEditor, SetsLimitsInTheTextAndInWhatWasRead) {
  Project project = ParseGood(Changed(SampleProject(), {{"/figure/joints/2/x", "7"}}));
  ASSERT_TRUE(SetHingeLimits("r_shoulder_flexion", -20.0, 90.0, &project.figure).ok());
  Json expected =
      Changed(SampleProject()["figure"],
              {{"/joints/1/hinges/0/limits_deg", "[-20.0, 90.0]"}, {"/joints/2/x", "7"}});
  EXPECT_EQ(TextOf(project), expected);
  EXPECT_NEAR(project.figure.spec.joints[1].hinges[0].upper, 90.0 * 0.017453292519943295, 1e-15);
  EXPECT_EQ(ParseGood(Json::parse(WriteProject(project))), project);
}

TEST(FigureEditor, KeepsTheLimitThatIsNotGiven) {
  Project project = ParseGood(SampleProject());
  ASSERT_TRUE(SetHingeLimits("r_elbow", std::nullopt, 120.0, &project.figure).ok());
  EXPECT_EQ(TextOf(project)["joints"][2]["hinges"][0]["limits_deg"].dump(), "[0,120]");
}

TEST(FigureEditor, AMirroredSideIsEditedByItsOriginal) {
  Project project = ParseGood(SampleProject());
  ASSERT_TRUE(SetHingeLimits("l_elbow", std::nullopt, 120.0, &project.figure).ok());
  ASSERT_TRUE(ChangeLink("l_hand", {1.25, {}}, &project.figure).ok());
  EXPECT_EQ(TextOf(project)["joints"][2]["hinges"][0]["limits_deg"][1], 120.0);
  EXPECT_EQ(TextOf(project)["joints"][3]["links"][0]["mass_kg"], 1.25);
}

TEST(FigureEditor, ARestOutsideTheLimitsIsMovedInside) {
  Project project = ParseGood(SampleProject());
  ASSERT_TRUE(SetHingeLimits("waist", 10.0, 20.0, &project.figure).ok());
  EXPECT_EQ(TextOf(project)["joints"][0]["hinges"][0]["rest_deg"], 10.0);
}

TEST(FigureEditor, AnInertiaGrowsWithTheMassAndADensityGivesWay) {
  Project project = ParseGood(SampleProject());
  ASSERT_TRUE(ChangeLink("pelvis", {20.0, 0.12}, &project.figure).ok());
  ASSERT_TRUE(ChangeLink("chest", {15.0, {}}, &project.figure).ok());
  const Json pelvis = TextOf(project)["root"]["links"][0];
  EXPECT_EQ(pelvis["mass_kg"], 20.0);
  EXPECT_EQ(pelvis["radius_m"], 0.12);
  EXPECT_EQ(pelvis["inertia_kg_m2"].dump(), "[0.1,0.08,0.1,0,0,0]");
  const Json chest = TextOf(project)["joints"][0]["links"][0];
  EXPECT_EQ(chest["mass_kg"], 15.0);
  EXPECT_FALSE(chest.contains("density_kg_m3"));
}

TEST(FigureEditor, RefusesWhatNoFigureCanBeAndLeavesItAsItWas) {
  Project project = ParseGood(SampleProject());
  const Project before = project;
  ProjectFigure* figure = &project.figure;
  EXPECT_EQ(WhyRefused(SetHingeLimits("waist", 70.0, {}, figure)),
            "lower: the lower limit 70 is above the upper one, 60");
  EXPECT_EQ(WhyRefused(SetHingeLimits("nose", 70.0, {}, figure)),
            "joint: the figure has no hinge \"nose\"");
  EXPECT_EQ(WhyRefused(ChangeLink("nose", {1.0, {}}, figure)),
            "link: the figure has no link \"nose\"");
  EXPECT_EQ(WhyRefused(ChangeLink("r_hand", {{}, 0.0}, figure)),
            "joints[3].links[0].radius_m: must be greater than 0, is 0");
  EXPECT_EQ(WhyRefused(EmbedFigure(".", figure)), "figure: is embedded already");
  EXPECT_EQ(project, before);
}

TEST(FigureEditor, AFileIsEmbeddedFirst) {
  const TemporaryFolder folder;
  WriteFile(folder / "doll.json", SampleProject()["figure"].dump());
  ProjectFigure figure;
  figure.file = "doll.json";
  figure.extra = {{"x", "1"}};
  EXPECT_EQ(WhyRefused(SetHingeLimits("waist", 0.0, {}, &figure)),
            "figure: is the file \"doll.json\", which other projects may use; embed it first with "
            "\"figure.embed\"");
  ASSERT_TRUE(EmbedFigure(folder.path(), &figure).ok());
  EXPECT_EQ(figure.file, "");
  EXPECT_EQ(Json::parse(figure.embedded_json), Changed(SampleProject()["figure"], {{"/x", "1"}}));
  EXPECT_TRUE(SetHingeLimits("waist", 0.0, {}, &figure).ok());
  figure.file = "other.json";
  EXPECT_EQ(EmbedFigure(folder.path(), &figure).error().code, ErrorCode::kNoInput);
}

}  // namespace
}  // namespace hazumi::testing
