#include "render/motion/object_scene.h"

#include <cstdlib>

namespace hazumi::render {

namespace {

constexpr double kLevel = 1.0 - 1e-9;  // least z of a level plane's normal

bool IsLevel(const Plane& plane) { return plane.normal.z() >= kLevel; }

// A square of this size stands for an endless plane that is not level [m].
constexpr double kSlab = 20.0, kSlabThickness = 0.02;

BoxShape Slab(const Plane& plane, const SrgbColor& color) {
  const Mat3 R = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), plane.normal).matrix();
  const Vec3 center = plane.normal * (plane.offset - kSlabThickness);
  return {{R, center}, {kSlab / 2.0, kSlab / 2.0, kSlabThickness}, 0.0, color};
}

SrgbColor Darker(const SrgbColor& color) {
  constexpr float kFactor = 0.86f;
  return {color.r * kFactor, color.g * kFactor, color.b * kFactor, color.a};
}

}  // namespace

SrgbColor ColorFromText(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return FromHex(0x808080);
  return FromHex(static_cast<std::uint32_t>(std::strtoul(text.c_str() + 1, nullptr, 16)));
}

void AddSceneObject(const SceneObject& object, Scene* scene) {
  const SrgbColor color = ColorFromText(object.color);
  if (const auto* plane = std::get_if<Plane>(&object.shape)) {
    if (!IsLevel(*plane) || scene->ground.visible) {
      scene->boxes.push_back(Slab(*plane, color));
      return;
    }
    scene->ground.visible = true;
    scene->ground.height = plane->offset;
    scene->ground.floor = color;
    scene->ground.pattern = Darker(color);
  } else if (const auto* box = std::get_if<Box>(&object.shape)) {
    scene->boxes.push_back({box->X_WB, box->half_size, 0.01, color});
  } else {
    const Capsule& capsule = std::get<Capsule>(object.shape);
    scene->capsules.push_back({capsule.a, capsule.b, capsule.radius, capsule.radius, color});
  }
}

void AddHeldObject(const HeldObject& object, const Pose& X_WO, float alpha, Scene* scene) {
  SrgbColor color = ColorFromText(object.color);
  color.a = alpha;
  if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
    scene->ellipsoids.push_back(Sphere(X_WO.p, sphere->radius, color));
  } else {
    const auto& box = std::get<hazumi::BoxShape>(object.shape);
    scene->boxes.push_back({X_WO, box.half_size, 0.004, color});
  }
}

std::optional<double> TopBelow(const SceneObject& object, const Vec3& point) {
  if (const auto* plane = std::get_if<Plane>(&object.shape)) {
    if (IsLevel(*plane) && plane->offset <= point.z()) return plane->offset;
    return std::nullopt;
  }
  const auto* box = std::get_if<Box>(&object.shape);
  if (box == nullptr || box->X_WB.R(2, 2) < kLevel) return std::nullopt;
  const Vec3 local = box->X_WB.Inverse() * point;
  const bool above = local.z() >= box->half_size.z() && std::abs(local.x()) <= box->half_size.x() &&
                     std::abs(local.y()) <= box->half_size.y();
  if (!above) return std::nullopt;
  return box->X_WB.p.z() + box->half_size.z();
}

}  // namespace hazumi::render
