#include <gtest/gtest.h>

#include <algorithm>

#include "engine/bake/bake.h"
#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"
#include "engine/exchange/bvh/bvh_file.h"
#include "engine/exchange/import/import_project.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/unit/exchange/made_characters.h"

namespace hazumi::test {
namespace {

// How far joints of the baked motion are from where the file has them at most [m].
double PositionError(const Character& character, const Project& project) {
  const Figure figure = BuildFigure(project.figure.spec).value();
  const Motion motion = BakeWell(project);
  const Planned planned = PlanOf(character);
  DynamicsWorkspace ws(figure);
  double most = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    ComputePositions(figure, frame.X_WR, frame.q, &ws);
    const auto there =
        FilePositions(character, planned.skeleton, &character.clips[0], planned.world, frame.frame);
    for (size_t k = 1; k < there.size(); ++k) {
      const JointGroup& group = figure.group(*figure.FindGroup(planned.plan.joints[k].name));
      most = std::max(most, (ws.body(group.first).p - there[k]).norm());
    }
  }
  return most;
}

TEST(Import, BakesToWhatTheFileHas) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Character character = RandomCharacter(&random);
    const Imported imported = ImportWell(character);
    EXPECT_LE(imported.report.position_error_m, 1e-9);
    EXPECT_LE(PositionError(character, imported.project), 1e-8);
  }
}

TEST(Import, SaysHowFarReducedKeysAreOff) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Character character = RandomCharacter(&random, 8, 80);
    ImportOptions options;
    options.reduce_deg = 2.0;
    const Imported imported = ImportWell(character, options);
    const Imported whole = ImportWell(character);
    EXPECT_LT(imported.report.num_keys, whole.report.num_keys / 2);
    EXPECT_GT(imported.report.position_error_m, 1e-5);
    EXPECT_NEAR(PositionError(character, imported.project), imported.report.position_error_m, 1e-8);
  }
}

TEST(Import, IsTheSameAfterSavingAndReading) {
  Random random(7);
  Character character = RandomCharacter(&random);
  AddSkin(&random, &character);
  const Project project = ImportWell(character).project;
  ASSERT_TRUE(project.skin);
  const std::string text = WriteProject(project);
  const Result<Project> read = ParseProject(text, "again.kfa");
  ASSERT_TRUE(read.ok()) << read.error().ToString();
  EXPECT_TRUE(read.value() == project);
  EXPECT_EQ(WriteProject(read.value()), text);
  EXPECT_TRUE(read.value().read.warnings.empty());
  EXPECT_EQ(WriteProject(ImportWell(character).project), text);  // every time
}

TEST(Import, WeighsWhatItIsToldTo) {
  Random random(3);
  ImportOptions options;
  options.mass_kg = 63.5;
  const Imported imported = ImportWell(RandomCharacter(&random), options);
  const Figure figure = BuildFigure(imported.project.figure.spec).value();
  EXPECT_NEAR(figure.total_mass(), 63.5, 1e-9);
  for (const JointSpec& joint : imported.project.figure.spec.joints) {
    for (const LinkSpec& link : joint.links) EXPECT_GT(*link.mass, 0.0) << link.name;
  }
}

TEST(Import, IsAsTallAsItIsToldTo) {
  Random random(4);
  ImportOptions options;
  options.height_m = 1.8;
  EXPECT_NEAR(ImportWell(RandomCharacter(&random), options).report.height_m, 1.8, 1e-12);
}

TEST(Import, LimitsHoldTheClipAndRest) {
  Random random(5);
  const Project project = ImportWell(RandomCharacter(&random)).project;
  const Result<Compiled> compiled = CompileAnimation(project);
  ASSERT_TRUE(compiled.ok());
  EXPECT_TRUE(compiled.value().warnings.empty());  // no key is outside
  for (const JointSpec& joint : project.figure.spec.joints) {
    for (const HingeSpec& hinge : joint.hinges) {
      EXPECT_LT(hinge.lower, -0.2);
      EXPECT_GT(hinge.upper, 0.2);
    }
  }
}

// The lowest point of any capsule, by frame [m].
std::vector<double> LowestPoints(const Project& project) {
  const Figure figure = BuildFigure(project.figure.spec).value();
  DynamicsWorkspace ws(figure);
  std::vector<double> lowest;
  for (const MotionFrame& frame : BakeWell(project).frames) {
    ComputePositions(figure, frame.X_WR, frame.q, &ws);
    lowest.push_back(1e9);
    for (const Link& link : figure.links()) {
      const Pose X_WB =
          link.joint.is_valid() ? Pose{ws.body(link.joint).R, ws.body(link.joint).p} : frame.X_WR;
      for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
        lowest.back() = std::min(lowest.back(), (X_WB * end).z() - link.capsule.radius);
      }
    }
  }
  return lowest;
}

TEST(Import, PutsTheGroundUnderTheFeet) {
  Random random(6);
  Character character = RandomCharacter(&random, 12, 100);
  for (Vec3& p : character.clips[0].tracks[1].translations) p += Vec3::Constant(500.0);
  const Imported imported = ImportWell(character);
  const auto& plane = std::get<ProjectPlane>(imported.project.scene.objects.at(0).shape);
  std::vector<double> lowest = LowestPoints(imported.project);
  std::sort(lowest.begin(), lowest.end());
  EXPECT_NEAR(plane.offset_m, lowest[5], 1e-8);  // one frame in twenty is a stray one
  const auto& facts = imported.report.facts;
  EXPECT_TRUE(std::any_of(facts.begin(), facts.end(), [](const std::string& fact) {
    return fact.starts_with("the ground is put at z = ");
  }));
}

TEST(Import, SaysThatAClipBeginsFarAway) {
  Character character = Hand();
  character.clips[0].tracks[0].translations.assign(31, Vec3(300, 400, 0));
  const std::vector<Warning> warnings = ImportWell(character).report.warnings;
  ASSERT_FALSE(warnings.empty());
  EXPECT_TRUE(warnings[0].message.starts_with("is 500 m from the origin")) << warnings[0].message;
}

// Y is up: the file's x is the world's y, its y z.
TEST(Import, JointsOfOneAndTwoHingesKeepThem) {
  const Result<Character> read = ReadBvh(
      "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation "
      "Xrotation Yrotation\nJOINT Knee\n{\nOFFSET 0 -1 0\nCHANNELS 1 Xrotation\nJOINT Foot\n{\n"
      "OFFSET 0 -1 0\nCHANNELS 2 Yrotation Xrotation\nEnd Site\n{\nOFFSET 0 0 1\n}\n}\n}\n}\n"
      "MOTION\nFrames: 2\nFrame Time: 0.1\n0 2 0 0 0 0 10 20 30\n0 2 0 0 0 0 11 21 31\n",
      "legs.bvh");
  ASSERT_TRUE(read.ok()) << read.error().ToString();
  ImportOptions options;
  options.metres_per_unit = 1.0;
  const Imported imported = ImportWell(read.value(), options);
  std::string names;
  for (const auto& joint : imported.project.joints) {
    names += joint.name + " " + FormatShort(joint.value.keys.at(1).value) + ", ";
  }
  EXPECT_EQ(names, "Knee_y 11, Foot_z 21, Foot_y 31, ");
  EXPECT_LE(imported.report.position_error_m, 1e-12);
  BakeWell(imported.project);
}

TEST(Import, OfACharacterWithoutAClipStandsAtRest) {
  Random random(8);
  Character character = RandomCharacter(&random);
  character.clips.clear();
  const Imported imported = ImportWell(character);
  EXPECT_EQ(BakeWell(imported.project).frames.size(), 61u);
  EXPECT_TRUE(imported.project.joints.empty());
}

TEST(Import, TakesClipsOfOneFrameAndOfNone) {
  Random random(9);
  Character character = RandomCharacter(&random, 5, 1);
  EXPECT_EQ(BakeWell(ImportWell(character).project).frames.size(), 2u);
  Clip& clip = character.clips[0];
  clip.num_frames = 0;
  for (BoneTrack& track : clip.tracks) track = {};
  EXPECT_EQ(ImportWell(character).report.num_keys, 6);
}

TEST(Import, FrameRatesAreWhatPeopleCallThem) {
  Random random(10);
  Character character = RandomCharacter(&random, 4, 3);
  const auto rate = [&](double seconds) {
    character.clips[0].seconds_per_frame = seconds;
    const ProjectRate fps = ImportWell(character).project.fps;
    return std::pair(fps.num, fps.den);
  };
  EXPECT_EQ(rate(0.0333333), std::pair(30, 1));
  EXPECT_EQ(rate(0.033367), std::pair(30000, 1001));
  EXPECT_EQ(rate(0.0083333), std::pair(120, 1));
  EXPECT_EQ(rate(0.041667), std::pair(24, 1));
  EXPECT_EQ(rate(0.0417083), std::pair(24000, 1001));
  EXPECT_EQ(rate(0.08), std::pair(12500, 1000));
}

TEST(Import, ClipsAreAskedForByName) {
  Random random(11);
  const Character character = RandomCharacter(&random);
  ImportOptions options;
  options.clip = "jump";
  const Result<Imported> imported = ImportProject(character, options);
  ASSERT_FALSE(imported.ok());
  EXPECT_EQ(imported.error().ToString(), "clip: there is no \"jump\"; there are \"clip\"");
}

TEST(Import, BonesBelowABoneThatOnlyMovesThemBegin) {
  Character character = Hand();
  character.bones[0].name = "root";
  character.bones[1].name = "pelvis";
  const Imported imported = ImportWell(character);
  EXPECT_EQ(imported.project.figure.spec.root_name, "pelvis");
  for (const Warning& warning : imported.report.warnings) EXPECT_EQ(warning.place, "unit");
}

std::string RefusalOf(const Character& character, const ImportOptions& options = {}) {
  const Result<Imported> imported = ImportProject(character, options);
  EXPECT_FALSE(imported.ok());
  return imported.ok() ? "" : imported.error().ToString();
}

TEST(Import, WhatIsEmptyOrADwarfIsRefused) {
  Character character = Hand();
  character.metres_per_unit = 1e-11;
  EXPECT_NE(RefusalOf(character).find("say how tall it is (--height)"), std::string::npos);
  ImportOptions options;
  options.height_m = 0.4;
  ImportWell(character, options);
  for (Bone& bone : character.bones) bone.rest.p.setZero();
  EXPECT_NE(RefusalOf(character, options).find("all its bones lie in one place"),
            std::string::npos);
  character = Hand();
  character.bones.resize(1);
  character.clips[0].tracks.resize(1);
  EXPECT_NE(RefusalOf(character).find("without joints or a mesh"), std::string::npos);
}

// "ik_foot_l" beside the pelvis, as engines have it, is no second foot.
TEST(Import, HelpersOfARigAreNoBones) {
  Character character = Hand();
  Bone helper;
  helper.name = "ik_hand_l";
  helper.parent = 0;
  helper.rest.p = Vec3(0, 0, -1);
  character.bones.push_back(helper);
  character.clips[0].tracks.emplace_back();
  const Imported imported = ImportWell(character);
  EXPECT_EQ(imported.report.num_joints, ImportWell(Hand()).report.num_joints);
}

TEST(Import, TwoSkeletonsAreRefused) {
  Character character = Hand();
  character.bones[1].parent = -1;
  const Result<Imported> imported = ImportProject(character, {});
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().ToString().find("no common root"), std::string::npos);
}

}  // namespace
}  // namespace hazumi::test
