#include "engine/exchange/gltf/gltf_write.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/exchange/character/from_motion.h"
#include "tests/support/figures.h"
#include "tests/unit/exchange/export_sample.h"
#include "tests/unit/exchange/gltf/gltf_taken_apart.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi::test {
namespace {

Gltf Written(const Character& character, const std::string& extras = "") {
  const auto text = GltfFile(character, {GltfContainer::kText, "test", extras});
  EXPECT_TRUE(text.ok()) << text.error().ToString();
  return TakenApart(text.value());
}

Character HumanCharacter(int num_frames) {
  const Figure figure = Human37();
  auto made = CharacterFromMotion(figure, RandomMotion(figure, num_frames, 1), {});
  return std::move(made).value();
}

TEST(GltfFile, HasTimesFromZeroAndNearQuaternions) {
  const Character character = HumanCharacter(50);
  const Gltf gltf = Written(character);
  const Json* sampler = gltf.Channel(character.bones[0].name, "rotation");
  ASSERT_NE(sampler, nullptr);
  const std::vector<float> times = gltf.Floats((*sampler)["input"]);
  ASSERT_EQ(times.size(), 50u);
  EXPECT_EQ(times.front(), 0.0f);
  EXPECT_FLOAT_EQ(times.back(), 49.0f / 30.0f);
  const std::vector<float> keys = gltf.Floats((*sampler)["output"]);
  for (size_t f = 0; f < 50; ++f) {
    const Eigen::Map<const Eigen::Vector4f> q(&keys[4 * f]);
    const auto& wanted = character.clips[0].tracks[0].rotations[f];
    EXPECT_NEAR(q.norm(), 1.0f, 1e-6f);
    EXPECT_NEAR(std::abs(q.cast<double>().dot(wanted.coeffs())), 1.0, 1e-6);
    const Eigen::Map<const Eigen::Vector4f> last(&keys[f > 0 ? 4 * f - 4 : 0]);
    EXPECT_GE(q.dot(last), 0.0f);
  }
}

// A bone at rest has no channel, one that stands still elsewhere two keys.
TEST(GltfFile, MovesOnlyWhatMoves) {
  Character character;
  character.bones.resize(3);
  Clip clip{"c", 0.1, 4, std::vector<BoneTrack>(3)};
  for (int i = 0; i < 3; ++i) {
    character.bones[static_cast<size_t>(i)].name = std::string(1, static_cast<char>('a' + i));
    character.bones[static_cast<size_t>(i)].parent = i - 1;
  }
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(1.0, Vec3::UnitY()));
  clip.tracks[0].translations = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  clip.tracks[0].rotations.assign(4, Eigen::Quaterniond::Identity());
  clip.tracks[1].rotations.assign(4, turned);
  character.clips = {clip};
  const Gltf gltf = Written(character);
  EXPECT_EQ(gltf.json["animations"][0]["channels"].size(), 2u);
  EXPECT_EQ(gltf.Channel("a", "rotation"), nullptr);
  const Json* still = gltf.Channel("b", "rotation");
  ASSERT_NE(still, nullptr);
  EXPECT_EQ(gltf.Floats((*still)["input"]), (std::vector<float>{0.0f, 0.3f}));
}

TEST(GltfFile, GivesVerticesWeightsThatSumToOne) {
  Character character = SkinnedArm();
  for (auto& weights : character.meshes[0].weights) weights = {0.3f, 0.1f, 0.2f, -0.5f};
  for (auto& binds : character.meshes[0].bind_indices) binds = {0, 1, 0, 1};
  const Gltf gltf = Written(character);
  const Json& attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"];
  const std::vector<float> weights = gltf.Floats(attributes["WEIGHTS_0"]);
  for (size_t i = 0; i < weights.size(); i += 4) {
    EXPECT_FLOAT_EQ(weights[i], 0.5f / 0.6f);  // its two entries of bone 0 are one
    EXPECT_FLOAT_EQ(weights[i + 1], 0.1f / 0.6f);
    EXPECT_EQ(weights[i + 2], 0.0f);
  }
}

TEST(GltfFile, StatesTheBoundsOfPositions) {
  const Gltf gltf = Written(SkinnedArm());
  const Json& attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"];
  const Json& positions = gltf.json["accessors"][attributes["POSITION"].get<size_t>()];
  EXPECT_FLOAT_EQ(positions["max"][1], 2.0f);
  EXPECT_FLOAT_EQ(positions["min"][1], 0.0f);
}

TEST(GltfFile, LeavesNormalsOutThatHaveNoLength) {
  Character character = SkinnedArm();
  character.meshes[0].normals[3].setZero();
  EXPECT_FALSE(
      Written(character).json["meshes"][0]["primitives"][0]["attributes"].contains("NORMAL"));
}

TEST(GltfFile, HangsTheSkeletonOnTheNodesAboveIt) {
  const Character character = HumanCharacter(2);
  const auto text = GltfFile(character, {GltfContainer::kText, "test", "", {}, "Rig/Armature"});
  ASSERT_TRUE(text.ok()) << text.error().ToString();
  const Json document = Json::parse(text.value());
  const Json& top = document["nodes"][document["scenes"][0]["nodes"][0].get<size_t>()];
  EXPECT_EQ(top["name"], "Rig");
  const Json& below = document["nodes"][top["children"][0].get<size_t>()];
  EXPECT_EQ(below["name"], "Armature");
  ASSERT_EQ(below["children"].size(), 1u);
  EXPECT_EQ(document["nodes"][below["children"][0].get<size_t>()]["name"], character.bones[0].name);
  const Character again = ReadSmall("a.gltf", text.value());
  EXPECT_EQ(again.above, "Rig/Armature");
}

TEST(GltfFile, KeepsColorsOfVerticesAndEmission) {
  Json document = SmallGltf();
  Json& primitive = document["meshes"][0]["primitives"][0];
  primitive["attributes"]["COLOR_0"] = primitive["attributes"]["POSITION"];
  primitive["material"] = 0;
  document["materials"] = {
      {{"emissiveFactor", {0.25, 0.5, 1.0}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 3.0}}}}}}};
  const Character read = ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(read.meshes.size(), 1u);
  EXPECT_EQ(read.meshes[0].colors, read.meshes[0].positions);
  ASSERT_EQ(read.materials.size(), 1u);
  EXPECT_EQ(read.materials[0].emission, (std::array<float, 3>{0.75f, 1.5f, 3.0f}));
  const auto text = GltfFile(read, {GltfContainer::kText, "test", ""});
  ASSERT_TRUE(text.ok()) << text.error().ToString();
  const Character again = ReadSmall("b.gltf", text.value());
  EXPECT_EQ(again.meshes[0].colors, read.meshes[0].colors);
  EXPECT_EQ(again.materials[0].emission, read.materials[0].emission);
  EXPECT_EQ(Json::parse(text.value())["extensionsUsed"],
            Json::array({"KHR_materials_emissive_strength"}));
}

TEST(GltfFile, PutsSeveralRootsUnderOne) {
  Character character = SkinnedArm();
  character.bones[1].parent = -1;
  const Gltf gltf = Written(character);
  EXPECT_EQ(gltf.json["nodes"][gltf.json["skins"][0]["skeleton"].get<size_t>()]["children"],
            Json({0, 1}));
}

TEST(GltfFile, CarriesExtras) {
  EXPECT_EQ(Written(SkinnedArm(), R"({"a": [1]})").json["animations"][0]["extras"]["a"][0], 1);
  EXPECT_FALSE(GltfFile(SkinnedArm(), {GltfContainer::kText, "", "[1]"}).ok());
}

TEST(GltfFile, IsABinaryFileOfTwoChunks) {
  const auto file = GltfFile(SkinnedArm(), {});
  ASSERT_TRUE(file.ok());
  const std::string& bytes = file.value();
  uint32_t header[5];
  std::memcpy(header, bytes.data(), sizeof(header));
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(header[1], 2u);
  EXPECT_EQ(header[2], bytes.size());
  EXPECT_EQ(header[3] % 4, 0u);
  const Json json = Json::parse(bytes.substr(20, header[3]));
  EXPECT_FALSE(json["buffers"][0].contains("uri"));
  EXPECT_EQ(bytes.substr(20 + header[3] + 4, 4), std::string("BIN\0", 4));
}

TEST(GltfFile, RefusesWhatGltfCannotHold) {
  Character character = SkinnedArm();
  character.textures[0].encoded = {'G', 'I', 'F', '8'};
  EXPECT_EQ(GltfFile(character, {}).error().place, "textures[0]");
  character = SkinnedArm();
  character.meshes[0].binds[1].bone = 0;
  EXPECT_EQ(GltfFile(character, {}).error().place, "meshes[0]");
  character = SkinnedArm();
  character.meshes[0].positions[0].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(GltfFile(character, {}).ok());
}

}  // namespace
}  // namespace hazumi::test
