#include "ui/panels/viewport/hit_test.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/motion/motion_scene.h"

namespace hazumi::ui {

namespace {

// Nearest points of a ray and a segment a-b: distance along the ray, and where on the segment, in
// [0, 1].
struct Nearest {
  double along, on_segment;
};

Nearest NearestTo(const Ray& ray, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a, w = a - ray.from;
  const double dd = d.squaredNorm(), dr = d.dot(ray.direction);
  const double denominator = dd - dr * dr;
  double s = 0.0;
  if (denominator > 1e-12 * dd) s = (dr * w.dot(ray.direction) - w.dot(d)) / denominator;
  s = std::clamp(s, 0.0, 1.0);
  return {(w + s * d).dot(ray.direction), s};
}

// The sphere that the ray comes nearest to stands for the whole.
std::optional<double> EnterCapsule(const Ray& ray, const Vec3& a, const Vec3& b, double radius_a,
                                   double radius_b) {
  const Nearest nearest = NearestTo(ray, a, b);
  const Vec3 center = a + nearest.on_segment * (b - a);
  const double radius = radius_a + nearest.on_segment * (radius_b - radius_a);
  const double off = (ray.from + nearest.along * ray.direction - center).norm();
  if (off > radius) return std::nullopt;
  const double distance = nearest.along - std::sqrt(radius * radius - off * off);
  return distance > 0.0 ? std::optional(distance) : std::nullopt;
}

std::optional<double> EnterEllipsoid(const Ray& ray, const hazumi::Pose& X_WE, const Vec3& half) {
  const Vec3 from = (X_WE.Inverse() * ray.from).cwiseQuotient(half);
  const Vec3 d = (X_WE.R.transpose() * ray.direction).cwiseQuotient(half);
  const double a = d.squaredNorm(), b = from.dot(d), c = from.squaredNorm() - 1.0;
  const double root = b * b - a * c;
  if (root < 0.0) return std::nullopt;
  const double distance = (-b - std::sqrt(root)) / a;
  return distance > 0.0 ? std::optional(distance) : std::nullopt;
}

constexpr double kRootFirst = 2.0;  // the root's mark counts as so much nearer [px]

// The mark that is nearest; an invalid joint is the root.
std::optional<GroupIndex> MarkerAt(const View& view, Point at, const PosedFigure& figure,
                                   double scale) {
  std::optional<GroupIndex> best;
  double least = kMarkerReach * scale;
  const std::optional<Point> root = view.ToWindow(figure.frame().X_WR.p);
  if (root && !figure.is_root_hidden() && std::hypot(root->x - at.x, root->y - at.y) < least) {
    // From the side the hips lie on it.
    least = std::hypot(root->x - at.x, root->y - at.y) - kRootFirst * scale;
    best = GroupIndex();
  }
  for (int g = 0; g < static_cast<int>(figure.figure().groups().size()); ++g) {
    const std::optional<Point> mark = view.ToWindow(figure.CenterOf(GroupIndex(g)));
    if (!mark || figure.IsHidden(GroupIndex(g))) continue;
    const double distance = std::hypot(mark->x - at.x, mark->y - at.y);
    if (distance >= least) continue;
    least = distance;
    best = GroupIndex(g);
  }
  return best;
}

}  // namespace

std::optional<double> Enter(const Ray& ray, const Look& look, const hazumi::Pose& X_WJ) {
  if (look.shape == Look::Shape::kTaperedCapsule) {
    return EnterCapsule(ray, X_WJ * look.from, X_WJ * look.to, look.radius_from, look.radius_to);
  }
  return EnterEllipsoid(ray, {X_WJ.R, X_WJ * look.center}, look.half_axes);
}

std::optional<double> Enter(const Ray& ray, const Box& box) {
  const Vec3 from = box.X_WB.Inverse() * ray.from, d = box.X_WB.R.transpose() * ray.direction;
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (int i = 0; i < 3; ++i) {
    if (d[i] == 0.0 && std::abs(from[i]) > box.half_size[i]) return std::nullopt;
    if (d[i] == 0.0) continue;
    const double a = (-box.half_size[i] - from[i]) / d[i], b = (box.half_size[i] - from[i]) / d[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave && enter > 0.0 ? std::optional(enter) : std::nullopt;
}

std::optional<double> Enter(const Ray& ray, const Ball& ball) {
  return EnterCapsule(ray, ball.center, ball.center, ball.radius, ball.radius);
}

std::optional<SceneHit> HitScene(const Ray& ray, const std::vector<SceneObject>& scene) {
  double least = std::numeric_limits<double>::infinity();
  size_t nearest = 0;
  for (size_t i = 0; i < scene.size(); ++i) {
    std::optional<double> distance;
    if (const Box* box = std::get_if<Box>(&scene[i].shape)) distance = Enter(ray, *box);
    if (const Plane* plane = std::get_if<Plane>(&scene[i].shape)) {
      const double towards = -plane->normal.dot(ray.direction);
      const double above = plane->normal.dot(ray.from) - plane->offset;
      if (towards > 0.0 && above > 0.0) distance = above / towards;
    }
    if (!distance || *distance >= least) continue;
    least = *distance;
    nearest = i;
  }
  if (!std::isfinite(least)) return std::nullopt;
  return SceneHit{nearest, ray.from + least * ray.direction};
}

std::optional<Vec3> MeetsScene(const Ray& ray, const std::vector<SceneObject>& scene) {
  const std::optional<SceneHit> hit = HitScene(ray, scene);
  return hit ? std::optional(hit->at) : std::nullopt;
}

ViewportHit HitTest(const View& view, Point at, const PosedFigure& figure,
                    const std::vector<Solid>& solids, double scale) {
  ViewportHit hit;
  if (const std::optional<GroupIndex> marker = MarkerAt(view, at, figure, scale)) {
    hit.is_marker = true;
    hit.is_root = !marker->is_valid();
    if (!hit.is_root) hit.joint = *marker;
    return hit;
  }
  const Ray ray = view.Through(at);
  double least = std::numeric_limits<double>::infinity();
  const auto joint_of = [&](const Link& link) { return figure.figure().joint(link.joint).group; };
  for (const Link& link : figure.figure().links()) {
    if (link.joint.is_valid() && figure.IsHidden(joint_of(link))) continue;
    for (const Look& look : render::LooksOf(link)) {
      const std::optional<double> distance = Enter(ray, look, figure.PoseOf(link.joint));
      if (!distance || *distance >= least) continue;
      least = *distance;
      hit.is_root = !link.joint.is_valid();
      hit.joint.reset();
      if (!hit.is_root) hit.joint = joint_of(link);
    }
  }
  for (const Solid& solid : solids) {
    const std::optional<double> distance =
        std::visit([&](const auto& shape) { return Enter(ray, shape); }, solid.shape);
    if (!distance || *distance >= least) continue;
    least = *distance;
    hit = {{}, solid.id, false, false};
  }
  return hit;
}

}  // namespace hazumi::ui
