// Triangles are taken away where the surface changes least, by meshoptimizer (edge collapse by
// quadric error), each level from all triangles, as far as an error that doubles from level to
// level.

#include <meshoptimizer.h>

#include <algorithm>

#include "render/scene/skin_triangles.h"

namespace hazumi::render {
namespace {

constexpr size_t kFewTriangles = 2000;  // are drawn as they are
constexpr int kCoarserLevels = 4;
constexpr float kLeastError = 1.0f / 4000.0f;  // of the mesh's extent
constexpr double kWorthIt = 0.8;               // of the triangles of the level before, at most

void AddLevel(const std::vector<std::uint32_t>& indices, double error_m, SkinModel::Part* part,
              SkinModel* model) {
  part->levels.push_back({model->indices.size(), indices.size(), error_m});
  for (const std::uint32_t i : indices) {
    model->indices.push_back(static_cast<std::uint32_t>(model->num_vertices) + i);
  }
}

}  // namespace

void AddLevels(const SkinMesh& mesh, const std::vector<std::uint32_t>& indices,
               SkinModel::Part* part, SkinModel* model) {
  AddLevel(indices, 0.0, part, model);
  if (indices.size() <= 3 * kFewTriangles) return;
  const float* positions = mesh.positions.front().data();
  const size_t stride = sizeof(mesh.positions.front()), count = mesh.positions.size();
  const float extent = meshopt_simplifyScale(positions, count, stride);
  for (int k = 0; k < kCoarserLevels; ++k) {
    std::vector<std::uint32_t> fewer(indices.size());
    float error = 0.0f;
    const auto allowed = static_cast<float>(1 << k) * kLeastError;
    fewer.resize(meshopt_simplify(fewer.data(), indices.data(), indices.size(), positions, count,
                                  stride, 0, allowed, meshopt_SimplifyLockBorder, &error));
    const auto before = static_cast<double>(part->levels.back().num_indices);
    if (fewer.empty() || static_cast<double>(fewer.size()) > kWorthIt * before) continue;
    AddLevel(fewer, static_cast<double>(error * extent), part, model);
  }
}

const SkinModel::Level& LevelFor(const SkinModel::Part& part, double pixels_per_m, double pixels) {
  const auto found = std::find_if(
      part.levels.rbegin(), part.levels.rend(),
      [&](const SkinModel::Level& level) { return level.error_m * pixels_per_m <= pixels; });
  return found != part.levels.rend() ? *found : part.levels.front();
}

}  // namespace hazumi::render
