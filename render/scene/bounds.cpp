#include "render/scene/bounds.h"

#include <algorithm>

namespace hazumi::render {
namespace {

constexpr double kLongestShadow = 20.0;  // [m]

// A vertex is a mean of points that lie in the boxes of its bones.
void AddSkin(const SkinnedFigure& figure, std::vector<BoundingSphere>* spheres) {
  for (size_t i = 0; i < figure.model->reach.size(); ++i) {
    const Extent& box = figure.model->reach[i];
    if (!box.is_empty()) {
      spheres->push_back({figure.X_WB[i] * box.center(), box.half_size().norm()});
    }
  }
}

}  // namespace

std::vector<BoundingSphere> CasterSpheres(const Scene& scene) {
  std::vector<BoundingSphere> spheres;
  for (const TaperedCapsule& c : scene.capsules) {
    if (c.color.a < 1.0f) continue;
    spheres.push_back({c.a, c.radius_a});
    spheres.push_back({c.b, c.radius_b});
  }
  for (const Ellipsoid& e : scene.ellipsoids) {
    if (e.color.a >= 1.0f) spheres.push_back({e.X_WE.p, e.half_axes.maxCoeff()});
  }
  for (const BoxShape& b : scene.boxes) {
    if (b.color.a >= 1.0f) spheres.push_back({b.X_WB.p, b.half_size.norm()});
  }
  for (const SkinnedFigure& skin : scene.skins) {
    if (skin.alpha >= 1.0f) AddSkin(skin, &spheres);
  }
  return spheres;
}

void GroundRect::Include(const Eigen::Vector2d& center, double radius) {
  min = min.cwiseMin(Eigen::Vector2d(center.array() - radius));
  max = max.cwiseMax(Eigen::Vector2d(center.array() + radius));
}

GroundRect ShadedGround(const std::vector<BoundingSphere>& casters, const Vec3& to_light,
                        double ground_height) {
  const double rise = std::max(to_light.z(), 1e-6);
  const Eigen::Vector2d away = -to_light.head<2>() / rise;
  GroundRect rect;
  for (const BoundingSphere& s : casters) {
    const double height = std::max(s.center.z() - ground_height, 0.0);
    const Eigen::Vector2d reach = away * height;
    const double shorten = std::min(1.0, kLongestShadow / std::max(reach.norm(), 1e-9));
    const double spread = s.radius * std::min(std::hypot(1.0, away.norm()), 5.0);
    rect.Include(s.center.head<2>() + shorten * reach, spread);
    // The soft dark patch below a body is about as wide as the body is high.
    rect.Include(s.center.head<2>(), s.radius + 0.35);
  }
  return rect;
}

}  // namespace hazumi::render
