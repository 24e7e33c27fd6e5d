// Which nodes of a glTF file are read where it does not say so.

#include <gtest/gtest.h>

#include "engine/exchange/read_character.h"
#include "tests/support/data_folder.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

std::vector<std::string> NamesOf(const Character& character) {
  std::vector<std::string> names;
  for (const Bone& bone : character.bones) names.push_back(bone.name);
  return names;
}

TEST(GltfScene, WithoutAnyAllRootsAreRead) {
  const Json sound = test::SmallGltf();
  const Character expected = test::ReadSmall("a.gltf", sound.dump());
  for (const Json& scenes : {Json(), Json::array()}) {
    Json document = sound;
    document.erase("scene");
    document.erase("scenes");
    if (scenes.is_array()) document["scenes"] = scenes;
    const Character c = test::ReadSmall("a.gltf", document.dump());
    EXPECT_EQ(NamesOf(c), NamesOf(expected));
    EXPECT_EQ(c.clips.size(), 1u);
    EXPECT_EQ(c.meshes.size(), 1u);
    EXPECT_TRUE(c.warnings.empty());
  }
}

TEST(GltfScene, OfSeveralTheFirstIsReadAndThatIsSaid) {
  Json document = test::SmallGltf();
  document.erase("scene");
  document["scenes"][0]["name"] = "stage";
  EXPECT_TRUE(test::ReadSmall("a.gltf", document.dump()).warnings.empty()) << "the only one";
  document["scenes"].push_back({{"nodes", {0}}});
  const Character c = test::ReadSmall("a.gltf", document.dump());
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_EQ(c.warnings[0].place, "scene");
  EXPECT_NE(c.warnings[0].message.find("none of the 2 scenes"), std::string::npos);
  EXPECT_NE(c.warnings[0].message.find("\"stage\""), std::string::npos);
}

// 3.0 and 30e-1 are as good as 3 to JSON.
TEST(GltfScene, IndicesMayBeWrittenWithAPoint) {
  Json document = test::SmallGltf();
  const Character expected = test::ReadSmall("a.gltf", document.dump());
  const Json flat = document.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (value.is_number_integer())
      document[Json::json_pointer(path)] = static_cast<double>(value.get<int64_t>());
  }
  ASSERT_NE(document.dump().find("\"componentType\":5126.0"), std::string::npos);
  const Character c = test::ReadSmall("a.gltf", document.dump());
  EXPECT_EQ(NamesOf(c), NamesOf(expected));
  EXPECT_EQ(c.clips.at(0).num_frames, expected.clips.at(0).num_frames);
  EXPECT_EQ(c.meshes.at(0).triangles, expected.meshes.at(0).triangles);
}

TEST(GltfScene, AFileWithoutNodesSaysSo) {
  const Error none = test::ErrorOfSmall("a.gltf", R"({"asset": {"version": "2.0"}})");
  EXPECT_EQ(none.code, ErrorCode::kSemantics);
  EXPECT_EQ(none.place, "nodes");
  EXPECT_NE(none.message.find("there are none"), std::string::npos) << none.message;
  const Error circle = test::ErrorOfSmall(
      "a.gltf",
      R"({"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {"children": [0]}]})");
  EXPECT_NE(circle.message.find("each is a child"), std::string::npos) << circle.message;
}

// Valid files: a node, and nodes with meshes of nothing, none of which moves.
TEST(GltfScene, KhronossFilesWithoutOneAreRefusedForWhatTheyLack) {
  HAZUMI_NEED_DATA("wild");
  for (const char* name : {"khronos_no_scene_1.gltf", "khronos_no_scene_2.gltf"}) {
    const Result<Character> result = ReadCharacter(test::DataPath(std::string("wild/") + name));
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().message,
              "has neither a skin nor an animation, so that there is nothing to move; export the "
              "character with its armature")
        << name;
  }
}

}  // namespace
}  // namespace hazumi
