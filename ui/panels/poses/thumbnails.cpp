#include "ui/panels/poses/thumbnails.h"

#include <algorithm>
#include <limits>

#include "engine/dynamics/kinematics.h"
#include "engine/spatial/degrees.h"
#include "engine/spatial/euler_angles.h"
#include "render/motion/framing.h"
#include "render/motion/motion_scene.h"

namespace hazumi::ui {

namespace {

// Of all capsules [m].
double LowestPoint(const Figure& figure, const MotionFrame& frame) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Link& link : figure.links()) {
    const BodyScratch& body = ws.body(link.joint);
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      lowest = std::min(lowest, (body.p + body.R * end).z() - link.capsule.radius);
    }
  }
  return lowest;
}

MotionFrame FrameOf(const SavedPose& pose, const Figure& figure) {
  MotionFrame frame;
  frame.q = figure.RestAngles();
  for (const Named<double>& angle : pose.joints) {
    if (const auto hinge = figure.FindJoint(angle.name)) {
      frame.q[hinge->value()] = angle.value * kDegree;
    }
  }
  frame.in_region.assign(static_cast<size_t>(figure.num_joints()), 0);
  const SavedRoot root = pose.root.value_or(SavedRoot());
  frame.X_WR.R = EulerRotation({2, 1, 0}, kDegree * Vec3(0.0, root.angle_y_deg, root.angle_x_deg));
  frame.X_WR.p.z() = root.height_m;
  if (!pose.root && !figure.links().empty()) frame.X_WR.p.z() -= LowestPoint(figure, frame);
  return frame;
}

// From farther away, so that nothing is cut off.
render::Camera SeenWhole(render::Camera camera) {
  camera.eye = camera.target + 1.2 * (camera.eye - camera.target);
  return camera;
}

}  // namespace

render::Scene SceneOf(const SavedPose& pose, const std::shared_ptr<const Figure>& figure) {
  Animation animation;
  animation.figure = figure;
  Motion motion;
  motion.frames = {FrameOf(pose, *figure)};
  const render::Camera camera =
      SeenWhole(render::FrameMotion(animation, motion, "three-quarter", 1.0));
  render::Scene scene = render::MotionScene(animation, motion, motion, camera, {}).At(0);
  scene.ground.visible = true;
  return scene;
}

void Thumbnails::Clear() {
  for (const Kept& kept : kept_) {
    if (kept.texture != 0) pictures_.free(kept.texture);
  }
  kept_.clear();
}

// What cannot be drawn has no texture, and is not tried again.
void Thumbnails::TakeDrawn() {
  const Result<std::vector<Image>>* drawn = task_ ? task_->result() : nullptr;
  if (!drawn) return;
  for (size_t i = 0; i < being_drawn_.size() && !is_of_before_; ++i) {
    const unsigned texture = drawn->ok() ? pictures_.add(drawn->value()[i]) : 0;
    kept_.push_back({being_drawn_[i], texture});
  }
  task_.reset();
  is_of_before_ = false;
}

void Thumbnails::Begin(std::shared_ptr<const Figure> figure, int edge_px) {
  wanted_.clear();
  if (figure != figure_ || edge_px != edge_px_) {
    Clear();
    is_of_before_ = is_busy();
    figure_ = std::move(figure);
    edge_px_ = edge_px;
  }
  TakeDrawn();
}

unsigned Thumbnails::TextureOf(const SavedPose& pose) {
  const auto kept = std::find_if(kept_.begin(), kept_.end(),
                                 [&](const Kept& other) { return other.pose == pose; });
  if (kept != kept_.end()) return kept->texture;
  wanted_.push_back(pose);
  return 0;
}

void Thumbnails::End() {
  if (task_ || wanted_.empty() || !pictures_.draw) return;
  being_drawn_ = wanted_;
  std::vector<render::Scene> scenes;
  for (const SavedPose& pose : wanted_) scenes.push_back(SceneOf(pose, figure_));
  task_ = std::make_unique<BackgroundTask<std::vector<Image>>>(
      [scenes = std::move(scenes), draw = pictures_.draw, edge = edge_px_] {
        return draw(scenes, edge);
      });
}

}  // namespace hazumi::ui
