#include "render/motion/framing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/dynamics/kinematics.h"

namespace hazumi::render {

namespace {

double RadiusOf(const HeldObject& object) {
  if (const auto* sphere = std::get_if<hazumi::SphereShape>(&object.shape)) return sphere->radius;
  return std::get<hazumi::BoxShape>(object.shape).half_size.norm();
}

// Boxes that are no larger than what moves, and no farther from it than they are large, are part of
// what happens; others are where it happens.
void ExtendByProps(const Animation& animation, Eigen::AlignedBox3d* bounds) {
  const Eigen::AlignedBox3d moved = *bounds;
  for (const SceneObject& object : animation.scene) {
    const auto* box = std::get_if<Box>(&object.shape);
    if (box == nullptr) continue;
    const Vec3 reach = box->X_WB.R.cwiseAbs() * box->half_size;
    const Eigen::AlignedBox3d of_box(box->X_WB.p - reach, box->X_WB.p + reach);
    const double size = of_box.diagonal().norm();
    if (size > moved.diagonal().norm() || moved.exteriorDistance(of_box) > size) continue;
    bounds->extend(of_box);
  }
}

// Of all capsules and all that is held or thrown, at all frames, and of the boxes beside them.
Eigen::AlignedBox3d MotionBounds(const Animation& animation, const Motion& motion) {
  const Figure& figure = *animation.figure;
  DynamicsWorkspace ws(figure);
  Eigen::AlignedBox3d bounds;
  for (const MotionFrame& frame : motion.frames) {
    ComputePositions(figure, frame.X_WR, frame.q, &ws);
    for (const Link& link : figure.links()) {
      const BodyScratch& body = ws.body(link.joint);
      const Vec3 margin = Vec3::Constant(link.capsule.radius);
      for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
        const Vec3 p = body.p + body.R * end;
        bounds.extend(p - margin);
        bounds.extend(p + margin);
      }
    }
    for (size_t i = 0; i < frame.objects.size(); ++i) {
      const Vec3 margin = Vec3::Constant(RadiusOf(animation.held_objects[i]));
      bounds.extend(frame.objects[i].X_WO.p - margin);
      bounds.extend(frame.objects[i].X_WO.p + margin);
    }
  }
  ExtendByProps(animation, &bounds);
  return bounds;
}

// Towards the viewer.
Vec3 DirectionOf(const std::string& side) {
  if (side == "front") return Vec3(1.0, 0.0, 0.12);
  if (side == "back") return Vec3(-1.0, 0.0, 0.12);
  if (side == "left") return Vec3(0.0, 1.0, 0.12);
  if (side == "right") return Vec3(0.0, -1.0, 0.12);
  if (side == "top") return Vec3(0.0, 0.0, 1.0);
  return Vec3(0.55, -1.0, 0.28);
}

}  // namespace

Camera FrameMotion(const Animation& animation, const Motion& motion, const std::string& side,
                   double aspect) {
  const Eigen::AlignedBox3d bounds = MotionBounds(animation, motion);
  Camera camera;
  if (bounds.isEmpty()) return camera;
  const double half_height = camera.vertical_fov_deg * std::numbers::pi / 360.0;
  const double half_width = std::atan(std::tan(half_height) * aspect);
  const double radius = 0.5 * bounds.diagonal().norm() * 0.9;
  const double distance = radius / std::sin(std::min(half_height, half_width));
  camera.target = bounds.center();
  camera.eye = camera.target + DirectionOf(side).normalized() * distance;
  return camera;
}

}  // namespace hazumi::render
