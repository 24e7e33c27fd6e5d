// Which nodes of a scene without a skin are its skeleton.

#include <gtest/gtest.h>

#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "tests/support/data_folder.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi::test {
namespace {

// Hips that move, a spine with a head, two legs; only the left shank moves as well.
std::vector<BareNode> Body(bool has_moving_legs = true) {
  return {{"Hips", -1, {0, 1, 0}, true}, {"Spine", 0, {0, 0.2, 0}},
          {"Head", 1, {0, 0.4, 0}},      {"HeadTop", 2, {0, 0.2, 0}},
          {"LeftUpLeg", 0, {0.1, 0, 0}}, {"LeftLeg", 4, {0, -0.5, 0}, has_moving_legs},
          {"LeftFoot", 5, {0, -0.5, 0}}, {"RightUpLeg", 0, {-0.1, 0, 0}},
          {"RightLeg", 7, {0, -0.5, 0}}, {"RightFoot", 8, {0, -0.5, 0}}};
}
const std::vector<std::string> kBody = {"Hips",       "Spine",    "Head",
                                        "LeftUpLeg",  "LeftLeg",  "LeftFoot",
                                        "RightUpLeg", "RightLeg", "RightFoot"};

std::vector<std::string> BonesOf(const Character& character) {
  std::vector<std::string> names;
  for (const Bone& bone : character.bones) names.push_back(bone.name);
  return names;
}

Character ReadBare(const std::vector<BareNode>& nodes) {
  return ReadSmall("a.gltf", BareGltf(nodes).dump());
}

bool Warns(const Character& character, const std::string& text) {
  return std::any_of(character.warnings.begin(), character.warnings.end(),
                     [&](const Warning& w) { return w.message.find(text) != std::string::npos; });
}

TEST(BoneSelection, WhatKeepsStillIsTheSkeletonToo) {
  EXPECT_EQ(BonesOf(ReadBare(Body())), kBody);
  EXPECT_EQ(BonesOf(ReadBare(Body(false))), kBody);
  const Character character = ReadBare(Body(false));
  ASSERT_TRUE(character.bones[2].end_site.has_value());
  EXPECT_TRUE(character.bones[2].end_site->isApprox(Vec3(0, 0.2, 0), 1e-6));
}

TEST(BoneSelection, ASkeletonOfWhichOneArmMovesIsWhole) {
  std::vector<BareNode> nodes = Body();
  for (BareNode& node : nodes) node.moves = node.name == "LeftLeg";
  EXPECT_EQ(BonesOf(ReadBare(nodes)), kBody);
}

TEST(BoneSelection, ASkeletonWithoutAClipIsReadAtRest) {
  std::vector<BareNode> nodes = Body();
  for (BareNode& node : nodes) node.moves = false;
  const Character character = ReadBare(nodes);
  EXPECT_EQ(BonesOf(character), kBody);
  EXPECT_TRUE(character.clips.empty());
  const Result<Imported> imported = ImportProject(character, {});
  ASSERT_TRUE(imported.ok()) << imported.error().ToString();
  EXPECT_EQ(imported.value().report.num_joints, 8);
}

// Words such as "ik" and "control" make a handle only of what is there twice.
TEST(BoneSelection, NamesOfHandlesRemoveNoBody) {
  for (const char* word : {"IK_", "target_", "Hero_control_"}) {
    std::vector<BareNode> nodes = Body();
    for (BareNode& node : nodes) node.name = word + node.name;
    const Result<Imported> imported = ImportProject(ReadBare(nodes), {});
    ASSERT_TRUE(imported.ok()) << imported.error().ToString();
    EXPECT_EQ(imported.value().report.num_joints, 8) << word;
  }
  std::vector<BareNode> nodes = Body();
  nodes[6].name = "IK_LeftFoot";
  nodes.push_back({"ik_RightFoot", 0, {-0.1, -1, 0}, true});
  const Result<Imported> imported = ImportProject(ReadBare(nodes), {});
  ASSERT_TRUE(imported.ok()) << imported.error().ToString();
  EXPECT_EQ(imported.value().report.num_joints, 8) << "the second right foot is a handle";
}

TEST(BoneSelection, CamerasAndTargetsThatMoveAreNoBones) {
  std::vector<BareNode> nodes = Body();
  nodes.push_back({"Camera01", -1, {3, 3, 3}, true, false, true});
  nodes.push_back({"Camera01.Target", -1, {0, 1, 0}, true});
  const Character character = ReadBare(nodes);
  EXPECT_EQ(BonesOf(character), kBody);
  ASSERT_EQ(character.clips.size(), 1u);
  const std::vector<Vec3>& travel = character.clips[0].tracks[0].translations;
  ASSERT_FALSE(travel.empty());
  EXPECT_NEAR((travel[travel.size() / 2] - travel[0]).norm(), 1.0, 1e-6);
  EXPECT_TRUE(Warns(character, "Camera01.Target"));
}

TEST(BoneSelection, ACameraOnTheSkeletonIsNoBone) {
  std::vector<BareNode> nodes = Body();
  nodes.push_back({"Eyes", 2, {0, 0.1, 0.1}, true, false, true});
  EXPECT_EQ(BonesOf(ReadBare(nodes)), kBody);
}

TEST(BoneSelection, SceneRootsThatMoveAreAPartOfTheFirstBonesMotion) {
  std::vector<BareNode> nodes = {{"Everything", -1, {0, 0, 0}, true}};
  for (BareNode node : Body(false)) {
    ++node.parent;
    nodes.push_back(node);
  }
  const Result<Imported> imported = ImportProject(ReadBare(nodes), {});
  ASSERT_TRUE(imported.ok()) << imported.error().ToString();
  EXPECT_EQ(imported.value().project.figure.spec.root_name, "Hips");
  EXPECT_LE(imported.value().report.position_error_m, 1e-6);
}

TEST(BoneSelection, CubesBesideASkeletonWithoutAMeshAreLeftOut) {
  std::vector<BareNode> nodes = Body();
  nodes.push_back({"Cube", -1, {3, 0, 3}, false, true});
  nodes.push_back({"Cube 1", -1, {3, 0, 0}, true, true});
  const Character character = ReadBare(nodes);
  EXPECT_EQ(BonesOf(character), kBody);
  EXPECT_TRUE(character.meshes.empty());
  EXPECT_TRUE(Warns(character, "left out, because they are no part of the skeleton: Cube, Cube 1"));
}

TEST(BoneSelection, OneMeshInAHandDoesNotDropTheLegs) {
  std::vector<BareNode> nodes = Body();
  nodes[2].has_mesh = true;
  for (BareNode& node : nodes) node.moves = true;
  nodes[3].moves = nodes[6].moves = nodes[9].moves = false;
  const Character character = ReadBare(nodes);
  EXPECT_EQ(BonesOf(character), kBody);
  EXPECT_EQ(character.meshes.size(), 1u);
}

TEST(BoneSelection, PartsThatHangOnNothingAreAllBones) {
  std::vector<BareNode> nodes;
  for (const char* name : {"a", "b", "c"}) nodes.push_back({name, -1, {1, 0, 0}, true, true});
  EXPECT_EQ(ReadBare(nodes).bones.size(), 4u);  // and what holds them together
}

TEST(BoneSelection, OfSeveralCharactersOneIsTakenAndTheOthersAreNamed) {
  HAZUMI_NEED_DATA("reports");
  const auto read = [](const char* file, const char* name = "") {
    ReadOptions options;
    options.character = name;
    const Result<Character> character =
        ReadCharacter(DataPath(std::string("reports/") + file), options);
    EXPECT_TRUE(character.ok()) << character.error().ToString();
    return character.ok() ? character.value() : Character();
  };
  const std::vector<std::string> alone = BonesOf(read("g00_control.gltf"));
  for (const char* file : {"g27_two_characters.gltf", "g13_two_characters_same_names.gltf"}) {
    const Character character = read(file);
    EXPECT_EQ(BonesOf(character), alone) << file;
    EXPECT_EQ(character.meshes.size(), 1u) << file;
    EXPECT_TRUE(Warns(character, "\"Hips\" is taken, one of 2; left out: ")) << file;
  }
  const Character other = read("g27_two_characters.gltf", "B_Hips");
  EXPECT_EQ(other.bones.at(0).name, "B_Hips");
  EXPECT_EQ(other.chosen, "B_Hips");
  EXPECT_EQ(other.others, std::vector<std::string>{"Hips"});
  EXPECT_TRUE(other.warnings.empty());
  EXPECT_EQ(read("g13_two_characters_same_names.gltf", "Hips (2)").bones.size(), alone.size());
  ReadOptions nobody;
  nobody.character = "Nobody";
  const Result<Character> refused =
      ReadCharacter(DataPath("reports/g27_two_characters.gltf"), nobody);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("name one of these: \"Hips\" \"B_Hips\""),
            std::string::npos);
}

class BoneSelectionData : public testing::Test {
 protected:
  void SetUp() override { HAZUMI_NEED_DATA("wild"); }
  static Imported Import(const std::string& file) {
    const Result<Character> character = ReadCharacter(DataPath("wild/" + file));
    EXPECT_TRUE(character.ok()) << character.error().ToString();
    if (!character.ok()) return {};
    Result<Imported> imported = ImportProject(character.value(), {});
    EXPECT_TRUE(imported.ok()) << imported.error().ToString();
    return imported.ok() ? std::move(imported).value() : Imported();
  }
};

double LongestLink(const FigureSpec& figure) {
  double longest = 0.0;
  for (const JointSpec& joint : figure.joints) {
    for (const LinkSpec& link : joint.links)
      longest = std::max(longest, (link.to - link.from).norm());
  }
  return longest;
}

// Along the ground, from the first key of the root to the last [m].
double TravelOf(const Project& project) {
  double squares = 0.0;
  for (const int i : {kRootX, kRootY}) {
    const auto& keys = project.root.curves[static_cast<size_t>(i)].keys;
    squares += std::pow(keys.back().value - keys.front().value, 2);
  }
  return std::sqrt(squares);
}

TEST_F(BoneSelectionData, AWalkFromASceneWithCamerasIsThatOfAPerson) {
  const Imported walk = Import("ozz_pab_walk.fbx");
  EXPECT_EQ(walk.project.figure.spec.root_name, "Hips");
  EXPECT_GT(walk.report.height_m, 1.5);
  EXPECT_LT(walk.report.height_m, 1.95);
  EXPECT_LT(LongestLink(walk.project.figure.spec), 0.6);
  EXPECT_LT(walk.report.position_error_m, 0.01);
  EXPECT_GT(TravelOf(walk.project), 1.4);
  std::printf("walk: %.2f m on the ground\n", TravelOf(walk.project));
}

TEST_F(BoneSelectionData, ARobotsSkeletonIsItAndNotTheCubesBesideIt) {
  const Imported robot = Import("ozz_robot.fbx");
  EXPECT_EQ(robot.project.figure.spec.root_name, "base");
  EXPECT_GE(robot.report.num_joints, 12);
  EXPECT_FALSE(robot.project.skin);
}

TEST_F(BoneSelectionData, ASkeletonOfWhichOnlyTheHipsMoveIsWhole) {
  const Imported skeleton = Import("ozz_pab_skeleton.dae");
  EXPECT_EQ(skeleton.project.figure.spec.root_name, "Hips");
  EXPECT_GE(skeleton.report.num_joints, 50);
  EXPECT_GT(skeleton.report.height_m, 1.5);
  EXPECT_LT(skeleton.report.height_m, 1.95);
}

}  // namespace
}  // namespace hazumi::test
