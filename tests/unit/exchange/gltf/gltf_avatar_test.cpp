// What a glTF file says beside nodes, meshes and clips: roles of an avatar's bones, and what is not
// read.

#include <gtest/gtest.h>

#include "engine/exchange/read_character.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

TEST(GltfAvatar, BonesOfBothVersionsHaveTheirRoles) {
  Json old = test::SmallGltf(), now = old;
  size_t lower = 0, upper = 0;
  for (size_t i = 0; i < old["nodes"].size(); ++i) {
    if (old["nodes"][i].value("name", "") == "lower") lower = i;
    if (old["nodes"][i].value("name", "") == "upper") upper = i;
  }
  old["extensions"]["VRM"]["humanoid"]["humanBones"] = {
      {{"bone", "leftUpperArm"}, {"node", lower}}, {{"bone", "leftLowerArm"}, {"node", upper}}};
  now["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"] = {{"leftUpperArm", {{"node", lower}}},
                                                             {"leftLowerArm", {{"node", upper}}}};
  for (const Json& document : {old, now}) {
    const Character c = test::ReadSmall("a.vrm", document.dump());
    ASSERT_EQ(c.bones.size(), 2u);
    EXPECT_EQ(c.bones[0].place, (BodyPlace{BodyRole::kUpperArm, BodySide::kLeft}));
    EXPECT_EQ(c.bones[1].place, (BodyPlace{BodyRole::kForearm, BodySide::kLeft}));
    ASSERT_EQ(c.warnings.size(), 1u);
    EXPECT_NE(c.warnings[0].message.find("springs"), std::string::npos);
  }
}

TEST(GltfAvatar, BrokenRolesAreNone) {
  for (const Json& bones :
       {Json(3), Json::array({3}), Json::array({{{"bone", "jaw"}, {"node", 0}}}),
        Json::array({{{"bone", "leftFoot"}, {"node", 900}}}),
        Json::array({{{"bone", "left"}, {"node", 0}}})}) {
    Json document = test::SmallGltf();
    document["extensions"]["VRM"]["humanoid"]["humanBones"] = bones;
    for (const Bone& bone : test::ReadSmall("a.vrm", document.dump()).bones)
      EXPECT_FALSE(bone.place) << bones.dump();
  }
}

TEST(GltfAvatar, WhatIsNotReadIsSaid) {
  Json document = test::SmallGltf();
  document["materials"] = {{{"normalTexture", {{"index", 0}}}, {"emissiveFactor", {0, 0.5, 0}}}};
  const Character c = test::ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_EQ(c.warnings[0].message,
            "not read: normal maps; all of it stays where motion is put back into the "
            "file (--onto)");
}

}  // namespace
}  // namespace hazumi
