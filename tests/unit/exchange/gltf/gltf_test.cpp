// What a file of glTF says, and what is said of one that is not as it should be.

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "engine/base/base64.h"
#include "engine/exchange/read_character.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

TEST(Gltf, IsInMetresWithYUp) {
  const Character c = test::ReadSmall("a.gltf", test::SmallGltf().dump());
  EXPECT_EQ(c.up, UpAxis::kY);
  EXPECT_EQ(c.metres_per_unit, 1.0);
  ASSERT_EQ(c.bones.size(), 2u);
  EXPECT_EQ(c.bones[0].name, "lower");
  EXPECT_EQ(c.bones[1].parent, 0);
  EXPECT_TRUE(c.bones[1].rest.p.isApprox(Vec3(0, 1, 0)));
  EXPECT_TRUE(c.warnings.empty()) << c.warnings[0].message;
}

// From the first key, at 0.5 s, to the last: 30 frames a second.
TEST(Gltf, ClipsRunFromTheFirstKeyToTheLast_AndTheTimeBeforeIsStated) {
  const Character c = test::ReadSmall("a.gltf", test::SmallGltfWithTimes({0.5f, 1.0f}).dump());
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_NE(c.warnings[0].message.find("first key is at 0.5 s"), std::string::npos);
  ASSERT_EQ(c.clips.size(), 1u);
  EXPECT_EQ(c.clips[0].name, "turn");
  EXPECT_EQ(c.clips[0].num_frames, 16);
  EXPECT_NEAR(test::UpperTurnAt(c, 0), 0.0, 1e-4);
  EXPECT_NEAR(test::UpperTurnAt(c, 5), 30.0, 1e-4);
  EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, 1e-4);
  EXPECT_TRUE(c.clips[0].tracks[0].rotations.empty());
}

TEST(Gltf, TheFrameRateIsThatOfTheKeys) {
  for (const double rate :
       {24.0, 25.0, 30.0, 50.0, 60.0, 72.0, 75.0, 90.0, 100.0, 120.0, 144.0, 29.97}) {
    std::vector<float> times;
    for (int i = 0; i < 100; ++i) times.push_back(static_cast<float>(i / rate));
    const Character c = test::ReadSmall("a.gltf", test::SmallGltfWithTimes(times).dump());
    ASSERT_EQ(c.clips.size(), 1u);
    EXPECT_NEAR(1.0 / c.clips[0].seconds_per_frame, rate, 1e-4 * rate);
    EXPECT_EQ(c.clips[0].num_frames, 100) << rate;
    EXPECT_TRUE(c.warnings.empty()) << rate;
  }
}

TEST(Gltf, KeysOfNoUsualRateAreSaidToBeResampled) {
  const Character c =
      test::ReadSmall("a.gltf", test::SmallGltfWithTimes({0.0f, 0.0137f, 0.411f, 1.0f}).dump());
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_EQ(c.warnings[0].place, "clip turn");
  EXPECT_NE(c.warnings[0].message.find("30 times a second"), std::string::npos);
  EXPECT_EQ(c.clips.at(0).num_frames, 31);
  EXPECT_NEAR(test::UpperTurnAt(c, 30), 90.0, 1e-4);
}

// Such as Blender writes: the armature in centimetres, half turned, above bones in metres.
TEST(Gltf, WhatLiesAboveTheBonesIsAPartOfTheFirst) {
  Json document = test::SmallGltf();
  document["nodes"].push_back({{"name", "Armature"},
                               {"scale", {0.01, 0.01, 0.01}},
                               {"rotation", {0, 0, 1, 0}},
                               {"translation", {5, 0, 0}},
                               {"children", {1}}});
  document["scenes"][0]["nodes"] = {0, 3};
  document["nodes"][1]["translation"] = {0, 100, 0};
  const Character c = test::ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(c.bones.size(), 2u);
  EXPECT_TRUE(c.bones[0].rest.p.isApprox(Vec3(5, -1, 0), 1e-6)) << c.bones[0].rest.p.transpose();
  EXPECT_TRUE(c.bones[0].rest.R.isApprox(Vec3(-1, -1, 1).asDiagonal().toDenseMatrix(), 1e-6));
  EXPECT_TRUE(c.bones[0].rest_scale.isApprox(Vec3::Constant(0.01), 1e-6));
  EXPECT_TRUE(c.bones[1].rest.p.isApprox(Vec3(0, 1, 0), 1e-6));
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_NE(c.warnings[0].message.find("scaled at rest: lower"), std::string::npos);
}

TEST(Gltf, StepsStayUntilTheNextKey) {
  Json document = test::SmallGltf();
  document["animations"][0]["samplers"][0]["interpolation"] = "STEP";
  const Character c = test::ReadSmall("a.gltf", document.dump());
  EXPECT_NEAR(test::UpperTurnAt(c, 14), 0.0, 1e-4);
  EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, 1e-4);
}

TEST(Gltf, WeightsOfOneOrTwoBytesAreRead) {
  for (const size_t bytes : {size_t{1}, size_t{2}}) {
    const Character c = test::ReadSmall("a.gltf", test::SmallGltfWithIntegerWeights(bytes).dump());
    ASSERT_EQ(c.meshes.size(), 1u);
    const SkinMesh& mesh = c.meshes[0];
    ASSERT_EQ(mesh.positions.size(), 4u);
    for (size_t v = 0; v < 4; ++v) {
      double lower = 0.0;
      for (size_t k = 0; k < 4; ++k)
        if (mesh.binds[mesh.bind_indices[v][k]].bone == 0) lower += mesh.weights[v][k];
      EXPECT_NEAR(lower, mesh.positions[v].y() < 1.0f ? 1.0 : 0.2, 1e-5) << bytes << " " << v;
    }
  }
}

TEST(Gltf, TheFirstSceneIsTheDefault) {
  Json document = test::SmallGltf();
  document.erase("scene");
  EXPECT_EQ(test::ReadSmall("a.gltf", document.dump()).bones.size(), 2u);
}

TEST(Gltf, SkinsWithoutMatricesAreBoundAtTheOrigin) {
  Json document = test::SmallGltf();
  document["skins"][0].erase("inverseBindMatrices");
  const Character c = test::ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(c.meshes.size(), 1u);
  ASSERT_EQ(c.meshes[0].binds.size(), 2u);
  for (const SkinMesh::Bind& bind : c.meshes[0].binds)
    EXPECT_TRUE(bind.inverse_bind.isIdentity(1e-6)) << bind.inverse_bind;
}

TEST(Gltf, SkinsWithInvalidMatrices_AreRefused) {
  for (const Json& change : {Json{{"type", "SCALAR"}}, Json{{"type", nullptr}},
                             Json{{"componentType", 5123}}, Json{{"count", 1}}}) {
    Json document = test::SmallGltf();
    const size_t binds = document["skins"][0]["inverseBindMatrices"];
    document["accessors"][binds].update(change);
    const Error error = test::ErrorOfSmall("a.gltf", document.dump());
    EXPECT_EQ(error.place, "skins[0]") << change;
    EXPECT_NE(error.message.find("inverse bind matrices"), std::string::npos) << change;
  }
}

TEST(Gltf, OtherVersionsAreNamed) {
  Json document = test::SmallGltf();
  document["asset"]["version"] = "1.0";
  const Error error = test::ErrorOfSmall("a.gltf", document.dump());
  EXPECT_EQ(error.place, "asset.version");
  EXPECT_NE(error.message.find("glTF 2.0"), std::string::npos);
}

TEST(Gltf, NodesOfOneNameAreToldApart) {
  Json document = test::SmallGltf();
  document["nodes"][2]["name"] = "lower";
  const Character c = test::ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(c.bones.size(), 2u);
  EXPECT_EQ(c.bones[0].name, "lower");
  EXPECT_EQ(c.bones[1].name, "lower_1");
  EXPECT_NEAR(test::UpperTurnAt(c, 15), 90.0, 1e-4);
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_NE(c.warnings[0].message.find("lower_1"), std::string::npos);
}

TEST(Gltf, WithoutSkinAndAnimationThereIsNothingToMove) {
  Json document = test::SmallGltf();
  document.erase("skins");
  document.erase("animations");
  document["nodes"][0].erase("skin");
  const Error error = test::ErrorOfSmall("a.gltf", document.dump());
  EXPECT_NE(error.message.find("neither a skin nor an animation"), std::string::npos)
      << error.message;
}

// A folder "inside" with the file, a buffer or picture in it, and one above it.
class GltfFiles : public testing::Test {
 protected:
  GltfFiles() : picture_("\x89PNG\r\n\x1a\n and so on") {
    std::filesystem::create_directories(folder_ / "inside/textures");
    Write("inside/textures/my skin.png", picture_);
    Write("outside.png", picture_);
    document_["materials"] = {
        {{"name", "skin"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    document_["textures"] = {{{"source", 0}}};
    document_["meshes"][0]["primitives"][0]["material"] = 0;
  }
  void Write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  Result<Character> Read() {
    Write("inside/a.gltf", document_.dump());
    return ReadCharacter(folder_ / "inside/a.gltf");
  }
  Result<Character> ReadWithPicture(const std::string& uri) {
    document_["images"] = {{{"uri", uri}}};
    return Read();
  }

  test::TemporaryFolder folder_;
  std::string picture_;
  Json document_ = test::SmallGltf();
};

TEST_F(GltfFiles, PicturesBesideTheFileAreTaken) {
  for (const char* uri : {"textures/my%20skin.png", "textures/my skin.png"}) {
    const Result<Character> c = ReadWithPicture(uri);
    ASSERT_TRUE(c.ok()) << c.error().ToString();
    ASSERT_EQ(c.value().textures.size(), 1u) << uri;
    EXPECT_EQ(
        std::string(c.value().textures[0].encoded.begin(), c.value().textures[0].encoded.end()),
        picture_);
    EXPECT_EQ(c.value().materials[0].texture, 0);
  }
}

TEST_F(GltfFiles, PicturesElsewhereAreLeftOutWithAWarning) {
  std::filesystem::create_symlink(folder_ / "outside.png", folder_ / "inside/link.png");
  for (const std::string uri : {"../outside.png", "textures/../../outside.png", "link.png",
                                "%2e%2e/outside.png", "missing.png"}) {
    const Result<Character> c = ReadWithPicture(uri);
    ASSERT_TRUE(c.ok()) << c.error().ToString();
    EXPECT_TRUE(c.value().textures.empty()) << uri;
    EXPECT_EQ(c.value().materials.at(0).texture, -1);
    ASSERT_EQ(c.value().warnings.size(), 1u) << uri;
    EXPECT_EQ(c.value().warnings[0].place, "material skin");
    EXPECT_NE(c.value().warnings[0].message.find("beside the file"), std::string::npos);
  }
}

TEST_F(GltfFiles, BuffersElsewhereAreAnErrorThatNamesThem) {
  const std::string uri = document_["buffers"][0]["uri"];
  const std::string bytes = *FromBase64(uri.substr(uri.find(',') + 1));
  Write("inside/data.bin", bytes);
  Write("outside.bin", bytes);
  document_["buffers"][0]["uri"] = "data.bin";
  EXPECT_TRUE(ReadWithPicture("textures/my%20skin.png").ok());
  document_["buffers"][0]["uri"] = "../outside.bin";
  const Result<Character> refused = Read();
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("../outside.bin"), std::string::npos)
      << refused.error().ToString();
}

}  // namespace
}  // namespace hazumi
