#include "render/mesh/ground_occlusion.h"

#include <algorithm>
#include <cmath>

namespace hazumi::render {
namespace {

using Vec3f = Eigen::Vector3f;
constexpr int kSize = GroundOcclusion::kSize;
constexpr float kLeastCover = 0.008f;  // solids that never cover more are left out

struct Blocker {
  Vec3f a, ab;  // [m], z above the ground
  float radius_a, radius_slope, ab_per_length2;
};

Blocker MakeBlocker(const Vec3& a, const Vec3& b, double radius_a, double radius_b,
                    double ground_height) {
  const Vec3f from = (a - Vec3(0, 0, ground_height)).cast<float>();
  const Vec3f along = (b - a).cast<float>();
  return {from, along, float(radius_a), float(radius_b - radius_a),
          1.0f / std::max(along.squaredNorm(), 1e-12f)};
}

// The capsule along the longest axis of a box or ellipsoid.
Blocker LongestAxis(const Pose& X, const Vec3& half, double ground_height) {
  int k = 0;
  half.maxCoeff(&k);
  const double radius = std::sqrt(half[(k + 1) % 3] * half[(k + 2) % 3]);
  const Vec3 arm = X.R.col(k) * std::max(half[k] - radius, 0.0);
  return MakeBlocker(X.p - arm, X.p + arm, radius, radius, ground_height);
}

// What a bone moves covers about as much as the capsule along its box.
void AddSkin(const SkinnedFigure& figure, double ground_height, std::vector<Blocker>* all) {
  for (size_t i = 0; i < figure.model->bulk.size(); ++i) {
    const Extent& box = figure.model->bulk[i];
    if (box.is_empty()) continue;
    const Pose& X_WB = figure.X_WB[i];
    all->push_back(LongestAxis({X_WB.R, X_WB * box.center()}, box.half_size(), ground_height));
  }
}

bool Matters(const Blocker& b) {
  const float lowest = std::min(b.a.z(), b.a.z() + b.ab.z());
  const float radius = std::max(b.radius_a, b.radius_a + b.radius_slope);
  return radius * radius > kLeastCover * lowest * std::max(lowest, 0.0f);
}

std::vector<Blocker> Blockers(const Scene& scene) {
  const double height = scene.ground.height;
  std::vector<Blocker> all;
  for (const TaperedCapsule& c : scene.capsules) {
    if (c.color.a >= 1.0f) all.push_back(MakeBlocker(c.a, c.b, c.radius_a, c.radius_b, height));
  }
  for (const Ellipsoid& e : scene.ellipsoids) {
    if (e.color.a >= 1.0f) all.push_back(LongestAxis(e.X_WE, e.half_axes, height));
  }
  for (const BoxShape& b : scene.boxes) {
    if (b.color.a >= 1.0f) all.push_back(LongestAxis(b.X_WB, b.half_size, height));
  }
  for (const SkinnedFigure& skin : scene.skins) {
    if (skin.alpha >= 1.0f) AddSkin(skin, height, &all);
  }
  std::erase_if(all, [](const Blocker& b) { return !Matters(b); });
  return all;
}

float Cover(const Blocker& b, float x, float y) {
  const Vec3f from_a(x - b.a.x(), y - b.a.y(), -b.a.z());
  const float t = std::clamp(from_a.dot(b.ab) * b.ab_per_length2, 0.0f, 1.0f);
  const Vec3f away = from_a - t * b.ab;
  const float radius = b.radius_a + t * b.radius_slope;
  const float d2 = std::max(away.squaredNorm(), radius * radius);
  const float height = std::max(-away.z(), 0.0f);
  return std::min(radius * radius * height / (d2 * std::sqrt(d2)), 1.0f);
}

// 1 in the middle of the rectangle, falling to 0 at its edge, where the plain ground goes on.
float Window(int row, int column) {
  const int to_edge = std::min({row, column, kSize - 1 - row, kSize - 1 - column});
  return std::min(to_edge / (0.16f * kSize), 1.0f);
}

}  // namespace

GroundOcclusion OccludeGround(const Scene& scene, const GroundRect& rect) {
  const std::vector<Blocker> blockers = Blockers(scene);
  const Eigen::Vector2f low = rect.min.cast<float>();
  const Eigen::Vector2f step = (rect.max - rect.min).cast<float>() / kSize;
  GroundOcclusion result{rect, std::vector<std::uint8_t>(kSize * kSize)};
  for (int row = 0; row < kSize; ++row) {
    for (int i = 0; i < kSize; ++i) {
      const float x = low.x() + (i + 0.5f) * step.x(), y = low.y() + (row + 0.5f) * step.y();
      float open = 1.0f;
      for (const Blocker& b : blockers) open *= 1.0f - Cover(b, x, y);
      open = std::lerp(1.0f, open, Window(row, i));
      result.openness[row * kSize + i] = static_cast<std::uint8_t>(open * 255.0f + 0.5f);
    }
  }
  return result;
}

}  // namespace hazumi::render
