// Of the shipped human's skin.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "engine/project/project_figure.h"
#include "render/scene/skin_triangles.h"

namespace hazumi::render {
namespace {

std::shared_ptr<const SkinModel> HumanModel() {
  return MakeSkinModel(MeshesOf(ShippedSkin::kHuman)).value();
}

const SkinModel::Part& LargestPart(const SkinModel& model) {
  return *std::max_element(model.parts.begin(), model.parts.end(),
                           [](const auto& a, const auto& b) {
                             return a.levels[0].num_indices < b.levels[0].num_indices;
                           });
}

std::vector<Vec3> PositionsOf(const SkinModel& model) {
  std::vector<Vec3> positions;
  for (const SkinMesh& mesh : model.skin->meshes) {
    for (const auto& p : mesh.positions) positions.push_back(p.cast<double>());
  }
  return positions;
}

// Edges with a triangle on one side only, by the places of their ends.
size_t OpenEdges(const SkinModel& model, const SkinModel::Level& level) {
  using Place = std::array<double, 3>;
  const std::vector<Vec3> positions = PositionsOf(model);
  std::map<std::pair<Place, Place>, int> edges;
  for (size_t i = 0; i < level.num_indices; ++i) {
    const size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const auto place = [&](size_t k) {
      const Vec3& p = positions[model.indices[level.first_index + k]];
      return Place{p.x(), p.y(), p.z()};
    };
    ++edges[{place(i), place(next)}];
    --edges[{place(next), place(i)}];
  }
  size_t open = 0;
  for (const auto& [edge, count] : edges) open += count != 0;
  return open;
}

double VolumeOf(const SkinModel& model, const SkinModel::Level& level) {
  const std::vector<Vec3> positions = PositionsOf(model);
  double volume = 0.0;
  for (size_t i = 0; i < level.num_indices; i += 3) {
    const auto at = [&](size_t k) { return positions[model.indices[level.first_index + i + k]]; };
    volume += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  return volume;
}

TEST(SkinLevels, HaveFewerTrianglesForALargerError) {
  const auto model = HumanModel();
  const SkinModel::Part& part = LargestPart(*model);
  ASSERT_GE(part.levels.size(), 3u);
  for (size_t i = 1; i < part.levels.size(); ++i) {
    EXPECT_LT(part.levels[i].num_indices, part.levels[i - 1].num_indices);
    EXPECT_GT(part.levels[i].error_m, part.levels[i - 1].error_m);
  }
  EXPECT_LT(part.levels.back().num_indices, part.levels.front().num_indices / 4);
}

TEST(SkinLevels, StayClosedAndKeepTheirVolume) {
  const auto model = HumanModel();
  const SkinModel::Part& part = LargestPart(*model);
  const double volume = VolumeOf(*model, part.levels[0]);
  for (const SkinModel::Level& level : part.levels) {
    EXPECT_EQ(OpenEdges(*model, level), 0u);
    EXPECT_NEAR(VolumeOf(*model, level) / volume, 1.0, 0.02);
  }
}

TEST(SkinLevels, ACloserLookTakesMoreTriangles) {
  const auto model = HumanModel();
  const SkinModel::Part& part = LargestPart(*model);
  EXPECT_EQ(LevelFor(part, 1e9, 0.3).num_indices, part.levels.front().num_indices);
  EXPECT_EQ(LevelFor(part, 1e-9, 0.3).num_indices, part.levels.back().num_indices);
  const SkinModel::Level& middle = part.levels[1];
  EXPECT_EQ(LevelFor(part, 0.29 / middle.error_m, 0.3).num_indices, middle.num_indices);
  EXPECT_EQ(LevelFor(part, 0.31 / middle.error_m, 0.3).num_indices, part.levels[0].num_indices);
}

}  // namespace
}  // namespace hazumi::render
