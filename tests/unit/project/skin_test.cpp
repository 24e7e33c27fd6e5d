// Skins and figures in a project file.

#include <gtest/gtest.h>

#include "engine/base/base64.h"
#include "engine/project/figure_file.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/support/random.h"
#include "tests/unit/project/skin_sample.h"

namespace hazumi::testing {
namespace {

TEST(Base64, IsThatOfTheStandard) {  // [RFC 4648, 10]
  const std::pair<const char*, const char*> kCases[] = {{"", ""},
                                                        {"f", "Zg=="},
                                                        {"fo", "Zm8="},
                                                        {"foo", "Zm9v"},
                                                        {"foob", "Zm9vYg=="},
                                                        {"fooba", "Zm9vYmE="},
                                                        {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : kCases) {
    EXPECT_EQ(ToBase64(bytes), text);
    EXPECT_EQ(FromBase64(text), bytes);
  }
  EXPECT_EQ(FromBase64("Zm8"), "fo");
}

TEST(Base64, GivesBackAnyBytes) {
  test::Random random(1);
  for (int length = 0; length < 100; ++length) {
    std::string bytes;
    for (int i = 0; i < length; ++i) bytes += static_cast<char>(random.Integer(0, 255));
    EXPECT_EQ(FromBase64(ToBase64(bytes)), bytes);
  }
}

TEST(Base64, RefusesWhatIsNone) {
  for (const char* text : {"Z", "Zm9vZ", "Zm9*", "Zm 9v", "Zm8===", "=Zm8", "Zh==", "====="}) {
    EXPECT_FALSE(FromBase64(text)) << text;
  }
}

TEST(Skin, IsTheSameAfterSavingAndReading) {
  Project project = ParseGood(SampleProject());
  project.skin.skin = std::make_shared<const Skin>(SampleSkin());
  const std::string text = WriteProject(project);
  const Project again = ParseGood(Json::parse(text));
  ASSERT_TRUE(again.skin);
  EXPECT_TRUE(*again.skin.skin == SampleSkin());
  EXPECT_TRUE(again == project);
  EXPECT_EQ(WriteProject(again), text);
  EXPECT_TRUE(again.read.warnings.empty());
}

TEST(Skin, ABoneMayTakeAShareOfItsJoint) {
  Skin skin = SampleSkin();
  skin.bones[1] = SkinBone("r_ankle", 0.25);
  Project project = ParseGood(SampleProject());
  project.skin = {.skin = std::make_shared<const Skin>(skin)};
  const Json written = Json::parse(WriteProject(project));
  EXPECT_EQ(written["skin"]["bones"],
            Json::parse(R"(["r_knee", {"joint": "r_ankle", "share": 0.25}])"));
  EXPECT_TRUE(*ParseGood(written).skin.skin == skin);
}

TEST(Skin, ThatComesWithTheProgramIsOnlyNamed) {
  Json json = SampleProject();
  json["skin"] = Json::parse(R"({"shipped": "human"})");
  const Project project = ParseGood(json);
  ASSERT_TRUE(project.skin);
  EXPECT_FALSE(project.skin.meshes()->meshes.empty());
  EXPECT_EQ(Json::parse(WriteProject(project))["skin"], json["skin"]);
  EXPECT_FALSE(project == ParseGood(SampleProject()));
}

TEST(Skin, IsLeftOutOfProjectsWithoutOne) {
  EXPECT_FALSE(Json::parse(WriteProject(ParseGood(SampleProject()))).contains("skin"));
}

TEST(Skin, MakesProjectsDiffer) {
  const Project bare = ParseGood(SampleProject());
  const Project skinned = ParseGood(WithSkin({}));
  EXPECT_FALSE(bare == skinned);
  EXPECT_TRUE(skinned == ParseGood(WithSkin({})));
  EXPECT_FALSE(skinned == ParseGood(WithSkin({{"/skin/materials/0/name", "\"cloth\""}})));
}

TEST(FigureText, GivesTheSameFigureBack) {
  test::Random random(2);
  FigureSpec spec = ParseGood(SampleProject()).figure.spec;
  for (JointSpec& joint : spec.joints) joint.orientation = random.Rotation();
  const std::string text = FigureText(spec);
  std::vector<Warning> warnings;
  const Result<FigureSpec> read = ParseFigure(text, "figure.json", &warnings);
  ASSERT_TRUE(read.ok()) << read.error().ToString();
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(read.value().joints.size(), spec.joints.size());
  for (size_t i = 0; i < spec.joints.size(); ++i) {
    const JointSpec &a = spec.joints[i], &b = read.value().joints[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_TRUE(a.orientation.isApprox(b.orientation, 1e-14));
    ASSERT_EQ(a.hinges.size(), b.hinges.size());
    for (size_t h = 0; h < a.hinges.size(); ++h) {
      EXPECT_EQ(a.hinges[h].axis, b.hinges[h].axis);
      EXPECT_NEAR(a.hinges[h].lower, b.hinges[h].lower, 1e-14);
      EXPECT_NEAR(a.hinges[h].upper, b.hinges[h].upper, 1e-14);
    }
    ASSERT_EQ(a.links.size(), b.links.size());
    for (size_t k = 0; k < a.links.size(); ++k) EXPECT_EQ(a.links[k].to, b.links[k].to);
  }
}

// Where y is a right angle, and hardly beside it, two of three angles cannot be told apart.
TEST(FigureText, KeepsOrientationsNearRightAngles) {
  test::Random random(3);
  FigureSpec spec = ParseGood(SampleProject()).figure.spec;
  for (double beside : {0.0, 1e-12, 1e-9, 1e-7, 1e-5}) {
    for (int i = 0; i < 20; ++i) {
      const double half = 0.5 * 3.14159265358979323846 + (i % 2 ? beside : -beside);
      Mat3& R = spec.joints[0].orientation;
      R = Eigen::AngleAxisd(random.Uniform(-3, 3), Vec3::UnitZ()) *
          Eigen::AngleAxisd(half, Vec3::UnitY()) *
          Eigen::AngleAxisd(random.Uniform(-3, 3), Vec3::UnitX());
      const Result<FigureSpec> read = ParseFigure(FigureText(spec), "figure.json", nullptr);
      ASSERT_TRUE(read.ok()) << read.error().ToString();
      EXPECT_LT((read.value().joints[0].orientation - R).norm(), 1e-14);
    }
  }
}

}  // namespace
}  // namespace hazumi::testing
