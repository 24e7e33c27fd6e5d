#include "ui/panels/viewport/gizmo.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace hazumi::ui {

namespace {

constexpr double kRingPx = 62.0, kArcPx = 44.0, kReachPx = 6.0, kEndReachPx = 8.0;
constexpr int kPoints = 72;  // of a ring

Vec3 SquareTo(const Vec3& axis, const Vec3& direction) {
  const Vec3 square = direction - direction.dot(axis) * axis;
  return square.norm() > 0.1 ? Vec3(square.normalized()) : axis.unitOrthogonal();
}

int NearestAxis(const Vec3& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return axis;
}

double DistancePx(const View& view, const Vec3& p, Point at) {
  const std::optional<Point> on_screen = view.ToWindow(p);
  return on_screen ? std::hypot(on_screen->x - at.x, on_screen->y - at.y) : 1e9;
}

LimitArc ArcOf(const View& view, const PosedFigure& figure, GroupIndex joint, JointIndex hinge,
               double scale) {
  const Joint& limits = figure.figure().joint(hinge);
  LimitArc arc;
  arc.hinge = hinge;
  arc.center = figure.CenterOf(joint);
  arc.axis = figure.AxisOf(hinge);
  arc.limb = SquareTo(arc.axis, figure.LimbOf(joint));
  arc.radius = kArcPx * scale * view.MetresPerPixel(arc.center);
  arc.angle = figure.angle(hinge);
  arc.lower = limits.lower;
  arc.upper = limits.upper;
  return arc;
}

Gizmo GizmoOfRoot(const View& view, const PosedFigure& figure, double scale) {
  const hazumi::Pose& X_WR = figure.frame().X_WR;
  const double radius = kRingPx * scale * view.MetresPerPixel(X_WR.p);
  Gizmo gizmo;
  for (int i = 0; i < 3; ++i) gizmo.rings.push_back({{}, X_WR.p, X_WR.R.col(i), radius, i});
  return gizmo;
}

std::optional<Gizmo> GizmoOfJoints(const View& view, const edit::Session& session,
                                   const PosedFigure& figure, double scale) {
  const std::vector<GroupIndex> joints = TurnableJoints(session);
  if (joints.empty()) return std::nullopt;
  const Vec3 middle = figure.MiddleOf(joints);
  const double radius = kRingPx * scale * view.MetresPerPixel(middle);
  Gizmo gizmo;
  for (int i = 0; i < 3; ++i) gizmo.rings.push_back({{}, middle, Vec3::Unit(i), radius, i});
  return gizmo;
}

}  // namespace

Vec3 GizmoRing::At(double t) const {
  const Vec3 u = axis.unitOrthogonal();
  return center + radius * (std::cos(t) * u + std::sin(t) * axis.cross(u));
}

Vec3 LimitArc::At(double at_angle) const {
  const double by = at_angle - angle;
  return center + radius * (std::cos(by) * limb + std::sin(by) * axis.cross(limb));
}

std::optional<Gizmo> GizmoOf(const View& view, const edit::Session& session,
                             const PosedFigure& figure, const std::string& active, bool with_limits,
                             double scale) {
  if (session.is_root_selected()) return GizmoOfRoot(view, figure, scale);
  const std::vector<GroupIndex> joints = SelectedJoints(session);
  if (joints.size() != 1) return GizmoOfJoints(view, session, figure, scale);
  const std::vector<JointIndex> hinges = TurnableHinges(session, joints[0]);
  if (hinges.empty()) return std::nullopt;
  Gizmo gizmo;
  const Vec3 center = figure.CenterOf(joints[0]);
  const double radius = kRingPx * scale * view.MetresPerPixel(center);
  JointIndex shown = hinges[0];
  for (const JointIndex hinge : hinges) {
    const Joint& joint = figure.figure().joint(hinge);
    const int color = NearestAxis(joint.X_PJ.R * joint.axis);
    gizmo.rings.push_back({hinge, center, figure.AxisOf(hinge), radius, color});
    if (joint.name == active) shown = hinge;
  }
  if (with_limits) gizmo.arc = ArcOf(view, figure, joints[0], shown, scale);
  return gizmo;
}

std::optional<GizmoHit> GizmoAt(const View& view, Point at, const Gizmo& gizmo, double scale) {
  if (gizmo.arc) {
    const LimitArc& arc = *gizmo.arc;
    const double lower = DistancePx(view, arc.At(arc.lower), at);
    const double upper = DistancePx(view, arc.At(arc.upper), at);
    if (std::min(lower, upper) < kEndReachPx * scale) {
      const GizmoPart part = lower < upper ? GizmoPart::kLower : GizmoPart::kUpper;
      return GizmoHit{part, arc.hinge, Vec3::Zero()};
    }
  }
  std::optional<GizmoHit> hit;
  double least = kReachPx * scale;
  for (const GizmoRing& ring : gizmo.rings) {
    for (int i = 0; i < kPoints; ++i) {
      const Vec3 p = ring.At(2.0 * std::numbers::pi * i / kPoints);
      const bool is_far = (p - ring.center).dot(view.ToViewer(ring.center)) < -0.2 * ring.radius;
      const double distance = DistancePx(view, p, at) + (is_far ? 0.5 * kReachPx * scale : 0.0);
      if (distance >= least) continue;
      least = distance;
      hit = GizmoHit{GizmoPart::kRing, ring.hinge, p, ring.color_axis};
    }
  }
  return hit;
}

std::optional<double> AngleAt(const View& view, Point at, const LimitArc& arc, double near) {
  if (std::abs(view.ToViewer(arc.center).dot(arc.axis)) < 0.08) return std::nullopt;
  const std::optional<Vec3> p = view.OnPlane(at, arc.center, arc.axis);
  if (!p) return std::nullopt;
  const Vec3 r = *p - arc.center;
  const double by = std::atan2(r.dot(arc.axis.cross(arc.limb)), r.dot(arc.limb));
  return near + std::remainder(arc.angle + by - near, 2.0 * std::numbers::pi);
}

}  // namespace hazumi::ui
