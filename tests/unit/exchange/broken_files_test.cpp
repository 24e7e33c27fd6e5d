// Broken files and files with random changes. Each must give an error or a valid character.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/exchange/character/character_check.h"
#include "engine/exchange/read_character.h"
#include "tests/support/data_folder.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

namespace fs = std::filesystem;

std::string BytesOf(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

// Error text, or empty.
std::string ReadSoundly(const std::string& path) {
  const Result<Character> result = ReadCharacter(path);
  if (result.ok()) {
    EXPECT_TRUE(CheckCharacter(result.value(), path).ok()) << path;
    return "";
  }
  EXPECT_EQ(result.error().file, path);
  EXPECT_GT(result.error().message.size(), 20u) << path;
  return result.error().message;
}

TEST(BrokenFiles, TheValidatorsModelsEndSoonUnderAnyName) {
  HAZUMI_NEED_DATA("malformed/gltf");
  const test::TemporaryFolder folder;
  for (const fs::path& file : test::DataFiles("malformed/gltf")) {
    const std::string own_name = ReadSoundly(file.string());
    const std::string renamed = folder / "renamed.fbx";
    fs::copy_file(file, renamed, fs::copy_options::overwrite_existing);
    EXPECT_EQ(ReadSoundly(renamed).empty(), own_name.empty()) << file;
  }
}

TEST(BrokenFiles, WhatCrashesAssimpIsNotGivenToIt) {
  HAZUMI_NEED_DATA("malformed/assimp");
  const test::TemporaryFolder folder;
  for (const fs::path& file : test::DataFiles("malformed/assimp"))
    for (const std::string& name : {file.filename().string(), std::string("a.fbx"),
                                    std::string("a.gltf"), std::string("a.dae")}) {
      fs::copy_file(file, folder / name, fs::copy_options::overwrite_existing);
      const std::string error = ReadSoundly(folder / name);
      EXPECT_NE(error.find("Hazumi reads BVH"), std::string::npos) << file << ": " << error;
    }
}

void ReadDamaged(const std::string& name, const std::string& bytes, uint64_t seed, int times) {
  const test::TemporaryFolder folder;
  test::Random random(seed);
  const int size = static_cast<int>(bytes.size());
  for (int i = 0; i < times; ++i) {
    std::string damaged = bytes;
    for (int k = random.Integer(1, 8); k > 0; --k)
      damaged[static_cast<size_t>(random.Integer(64, size - 1))] =
          static_cast<char>(random.Integer(0, 255));
    if (random.Chance(0.2)) damaged.resize(static_cast<size_t>(random.Integer(64, size)));
    std::ofstream(folder / name, std::ios::binary) << damaged;
    ReadSoundly(folder / name);
    ASSERT_EQ(folder.num_entries(), 1u);
  }
}

TEST(BrokenFiles, RandomDamageToFbxAndCollada) {
  ReadDamaged("a.fbx", test::SmallFbx(), 1, 60);
  ReadDamaged("a.dae", test::SmallCollada(), 2, 60);
}

TEST(BrokenFiles, RandomDamageToGltf) { ReadDamaged("a.gltf", test::SmallGltf().dump(), 3, 80); }

TEST(BrokenFiles, RandomDamageToBinaryFiles) {
  const std::string fbx = "characters/ozz_pab_arnaud.fbx", glb = "characters/kaykit_Knight.glb";
  HAZUMI_NEED_DATA(fbx);
  HAZUMI_NEED_DATA(glb);
  ReadDamaged("a.fbx", BytesOf(test::DataPath(fbx)), 4, 15);
  ReadDamaged("a.glb", BytesOf(test::DataPath(glb)), 5, 10);
}

// Indices, counts and numbers that a document may well have, one at a time.
TEST(BrokenFiles, WrongNumbersInGltf) {
  const nlohmann::json sound = test::SmallGltf();
  const test::TemporaryFolder folder;
  const nlohmann::json flat = sound.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (!value.is_number()) continue;
    for (const nlohmann::json& wrong : {nlohmann::json(99), nlohmann::json(4294967295u),
                                        nlohmann::json(-1), nlohmann::json("x")}) {
      nlohmann::json document = sound;
      document[nlohmann::json::json_pointer(path)] = wrong;
      std::ofstream(folder / "a.gltf") << document.dump();
      ReadSoundly(folder / "a.gltf");
    }
  }
}

TEST(BrokenFiles, NodesInACircle) {
  nlohmann::json document = test::SmallGltf();
  document["nodes"][2]["children"] = {1};
  EXPECT_FALSE(test::ErrorOfSmall("a.gltf", document.dump()).message.empty());
}

TEST(BrokenFiles, AMillionNestedNodes) {
  std::string text = "<COLLADA version=\"1.4.1\"><library_visual_scenes><visual_scene id=\"S\">";
  for (int i = 0; i < 1'000'000; ++i) text += "<node id=\"n\">";
  EXPECT_FALSE(test::ErrorOfSmall("a.dae", text).message.empty());
}

}  // namespace
}  // namespace hazumi
