#include "render/gl/sky_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hazumi::render {
namespace {

constexpr int kColumns = 8;
constexpr int kRows = 24;
constexpr double kSineOfZenithColor = 0.75;  // elevation where the zenith's colour is reached

struct SkyPoint {
  double x, y;  // normalised device coordinates
  Vec3 direction;
};

SkyVertex VertexAt(const SkyPoint& p, const Sky& sky) {
  const double t = std::clamp(p.direction.normalized().z() / kSineOfZenithColor, 0.0, 1.0);
  const auto mix = static_cast<float>(t * t * (3.0 - 2.0 * t));
  return {static_cast<float>(p.x),
          static_cast<float>(p.y),
          {std::lerp(sky.horizon.r, sky.zenith.r, mix), std::lerp(sky.horizon.g, sky.zenith.g, mix),
           std::lerp(sky.horizon.b, sky.zenith.b, mix)}};
}

// Leaves out what is all below the horizon: the picture is cleared to that colour.
void AppendQuad(const std::array<SkyPoint, 4>& corners, const Sky& sky,
                std::vector<SkyVertex>& mesh) {
  const bool visible = std::any_of(corners.begin(), corners.end(),
                                   [](const SkyPoint& p) { return p.direction.z() > 0.0; });
  if (!visible) return;
  for (const int i : {0, 1, 2, 0, 2, 3}) mesh.push_back(VertexAt(corners[i], sky));
}

}  // namespace

std::vector<SkyVertex> BuildSky(const Scene& scene, PictureSize size) {
  const Mat3 R_WE = ViewMatrix(scene.camera).topLeftCorner<3, 3>().transpose();
  const Mat4 projection = ProjectionMatrix(scene.camera, double(size.width) / size.height);
  const auto at = [&](int column, int row) {
    const double x = 2.0 * column / kColumns - 1.0, y = 2.0 * row / kRows - 1.0;
    const Vec3 direction_E(x / projection(0, 0), y / projection(1, 1), -1.0);
    return SkyPoint{x, y, R_WE * direction_E};
  };
  std::vector<SkyVertex> mesh;
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kColumns; ++i) {
      AppendQuad({at(i, row), at(i + 1, row), at(i + 1, row + 1), at(i, row + 1)}, scene.sky, mesh);
    }
  }
  return mesh;
}

}  // namespace hazumi::render
