// Characters that other programs have made; see the README of the shared data.

#include <gtest/gtest.h>

#include "engine/exchange/read_character.h"
#include "tests/support/data_folder.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

struct Expected {
  const char* file;
  size_t bones, clips, meshes, textures;
  UpAxis up;
  double metres_per_unit;
  double height;  // of all meshes at rest, in the file's unit
};

class CharacterFiles : public testing::TestWithParam<Expected> {};

// Where a vertex is while all bones are at rest, at these poses.
Vec3 Skinned(const std::vector<Pose>& rests, const SkinMesh& mesh, size_t vertex) {
  Eigen::Vector4d v;
  v << mesh.positions[vertex].cast<double>(), 1.0;
  Vec3 sum = Vec3::Zero();
  for (size_t k = 0; k < 4; ++k) {
    const SkinMesh::Bind& bind = mesh.binds[mesh.bind_indices[vertex][k]];
    const Pose& X_WB = rests[static_cast<size_t>(bind.bone)];
    sum += mesh.weights[vertex][k] * (X_WB * Vec3((bind.inverse_bind * v).head<3>()));
  }
  return sum;
}

double Height(const Character& c) {
  const int up = c.up == UpAxis::kZ ? 2 : 1;
  double low = 1e9, high = -1e9;
  std::vector<Pose> rests;
  for (size_t i = 0; i < c.bones.size(); ++i) rests.push_back(test::WorldRest(c, i));
  for (const SkinMesh& mesh : c.meshes)
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const double height = Skinned(rests, mesh, v)[up];
      low = std::min(low, height);
      high = std::max(high, height);
    }
  return high - low;
}

TEST_P(CharacterFiles, HasItsBonesClipsAndSize) {
  const Expected& expected = GetParam();
  const std::string name = std::string("characters/") + expected.file;
  HAZUMI_NEED_DATA(name);
  const Result<Character> result = ReadCharacter(test::DataPath(name));
  ASSERT_TRUE(result.ok()) << result.error().ToString();
  const Character& c = result.value();
  EXPECT_EQ(c.bones.size(), expected.bones);
  EXPECT_EQ(c.clips.size(), expected.clips);
  EXPECT_EQ(c.meshes.size(), expected.meshes);
  EXPECT_EQ(c.textures.size(), expected.textures);
  EXPECT_EQ(c.up, expected.up);
  ASSERT_TRUE(c.metres_per_unit.has_value());
  EXPECT_NEAR(*c.metres_per_unit, expected.metres_per_unit, 1e-8);
  EXPECT_NEAR(Height(c), expected.height, 0.02 * expected.height);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, CharacterFiles,
    testing::Values(Expected{"ozz_pab_arnaud.fbx", 53, 0, 1, 0, UpAxis::kY, 0.01, 183.1},
                    Expected{"kaykit_Knight.glb", 22, 76, 15, 1, UpAxis::kY, 1.0, 2.47},
                    Expected{"khronos_cesium_man.gltf", 19, 1, 1, 1, UpAxis::kY, 1.0, 1.507},
                    Expected{"khronos_rigged_simple.gltf", 2, 1, 1, 0, UpAxis::kY, 1.0, 9.15},
                    Expected{"assimp_simple_skin.gltf", 2, 1, 1, 0, UpAxis::kY, 1.0, 2.0}),
    [](const testing::TestParamInfo<Expected>& test) {
      const std::string file = test.param.file;
      return file.substr(0, file.find('.'));
    });

TEST(CharacterFile, TheKnightThrowsAtThirtyFramesASecond) {
  HAZUMI_NEED_DATA("characters/kaykit_Knight.glb");
  const Result<Character> result = ReadCharacter(test::DataPath("characters/kaykit_Knight.glb"));
  ASSERT_TRUE(result.ok()) << result.error().ToString();
  for (const Clip& clip : result.value().clips) {
    EXPECT_NEAR(clip.seconds_per_frame, 1.0 / 30.0, 1e-12) << clip.name;
    if (clip.name == "Throw") {
      EXPECT_GT(clip.num_frames, 20);
    }
  }
  // Controls carry no mesh: they are left out, and said to be.
  ASSERT_FALSE(result.value().warnings.empty());
  EXPECT_NE(result.value().warnings[0].message.find("kneeIK.l"), std::string::npos);
}

}  // namespace
}  // namespace hazumi
