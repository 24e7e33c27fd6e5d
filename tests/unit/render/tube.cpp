#include "tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/image/png.h"

namespace hazumi::render {
namespace {

constexpr double kRadius = 0.25;
constexpr int kTexels = 64;

Texture Picture() {
  Image image(kTexels, kTexels);
  for (int row = 0; row < kTexels; ++row) {
    for (int i = 0; i < kTexels; ++i) {
      const bool is_right = i >= kTexels / 2, is_upper = row < kTexels / 2;
      std::uint8_t* texel = &image.rgba[4 * (size_t(row) * kTexels + i)];
      texel[0] = is_right || is_upper ? 255 : 0;
      texel[1] = is_right || !is_upper ? 255 : 0;
      texel[3] = 255;
    }
  }
  return {"halves", EncodePng(image, {}).value()};
}

void AddVertex(double length, double u, double z, SkinMesh* mesh) {
  const double angle = 2.0 * std::numbers::pi * u;
  const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0.0);
  const Eigen::Vector3d p = kRadius * out + Eigen::Vector3d(0, 0, z);
  mesh->positions.push_back(p.cast<float>());
  mesh->normals.push_back(out.cast<float>());
  mesh->texture_coordinates.push_back({float(u), float(1.0 - z / length)});
  const float upper = float(std::clamp((z / length - 0.4) / 0.2, 0.0, 1.0));
  mesh->bind_indices.push_back({0, 1, 0, 0});
  mesh->weights.push_back({1.0f - upper, upper, 0.0f, 0.0f});
}

}  // namespace

std::shared_ptr<const Skin> TubeSkin(double length, int columns, int rows) {
  auto skin = std::make_shared<Skin>();
  skin->bones = {"lower", "upper"};
  skin->textures = {Picture()};
  skin->materials = {{"tube", {1.0f, 1.0f, 1.0f, 1.0f}, 0}};
  SkinMesh mesh;
  mesh.name = "tube";
  mesh.material = 0;
  mesh.binds.resize(2);
  mesh.binds[1].bone = 1;
  mesh.binds[1].inverse_bind(2, 3) = -0.5 * length;
  for (int row = 0; row <= rows; ++row) {
    for (int i = 0; i <= columns; ++i) {
      AddVertex(length, double(i) / columns, length * row / rows, &mesh);
      if (row == rows || i == columns) continue;
      const std::uint32_t a = row * (columns + 1) + i, above = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, above + 1});
      mesh.triangles.push_back({a, above + 1, above});
    }
  }
  skin->meshes = {mesh};
  return skin;
}

SkinnedFigure RestingTube(const std::shared_ptr<const SkinModel>& model, double length) {
  return {model, {Pose(), Pose{Mat3::Identity(), {0.0, 0.0, 0.5 * length}}}, {}, 1.0f};
}

}  // namespace hazumi::render
