#include "render/mesh/mark_mesh.h"

#include <cmath>
#include <numbers>

namespace hazumi::render {
namespace {

constexpr int kCircleSteps = 48;
constexpr SrgbColor kDarkQuarter = FromHex(0x22262b);

// Points of a circle from `from` to `to` [quarter turns] in the plane of the unit vectors u, v.
std::vector<Vec3> Arc(const Vec3& center, const Vec3& u, const Vec3& v, double from, double to) {
  const int steps = std::max(2, static_cast<int>(kCircleSteps * (to - from) / 4.0));
  std::vector<Vec3> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::lerp(from, to, double(i) / steps) * std::numbers::pi / 2.0;
    points.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
  }
  return points;
}

// Draws world lines and areas into one mesh.
class Pen {
 public:
  Pen(const Projector& projector, FlatMesh& mesh) : projector_(projector), mesh_(mesh) {}

  void Line(const std::vector<Vec3>& points, const Stroke& stroke) {
    for (const auto& piece : projector_.ProjectLine(points)) {
      AppendStroke(piece, stroke, projector_.size(), mesh_);
    }
  }

  // A convex area; left out when a part of it is behind the viewer.
  void Area(const std::vector<Vec3>& corners, const SrgbColor& color) {
    const auto pieces = projector_.ProjectLine(corners);
    if (pieces.size() != 1 || pieces[0].size() != corners.size()) return;
    AppendFill(pieces[0], color, projector_.size(), mesh_);
  }

 private:
  const Projector& projector_;
  FlatMesh& mesh_;
};

void DrawPolyline(const Polyline& line, Pen& pen) {
  for (const auto& dash : SplitIntoDashes(line.points, line.dash_m)) {
    pen.Line(dash, {line.width_px, line.color});
  }
}

void DrawCross(const Marker& m, Pen& pen) {
  const double r = m.radius_m * std::numbers::sqrt2 / 2.0;
  for (const Vec3& arm : {Vec3(r, r, 0.0), Vec3(r, -r, 0.0)}) {
    pen.Line({m.center - arm, m.center + arm}, {m.width_px, m.color});
  }
}

void DrawFlatMarker(const Marker& m, Pen& pen) {
  if (m.shape == MarkerShape::kCross) return DrawCross(m, pen);
  const Vec3 u(m.radius_m, 0.0, 0.0), v(0.0, m.radius_m, 0.0);
  const auto circle = Arc(m.center, u, v, 0.0, 4.0);
  if (m.shape == MarkerShape::kRing) return pen.Line(circle, {m.width_px, m.color});
  pen.Area(circle, m.color);
}

// Quarters in turn light and dark, with a dark rim.
void DrawCenterOfMass(const Marker& m, const Mat4& view, Pen& pen) {
  const Vec3 u = m.radius_m * view.block<1, 3>(0, 0).transpose();
  const Vec3 v = m.radius_m * view.block<1, 3>(1, 0).transpose();
  for (int quarter = 0; quarter < 4; ++quarter) {
    std::vector<Vec3> corners = Arc(m.center, u, v, quarter, quarter + 1);
    corners.insert(corners.begin(), m.center);
    pen.Area(corners, quarter % 2 == 0 ? m.color : kDarkQuarter);
  }
  pen.Line(Arc(m.center, u, v, 0.0, 4.0), {m.width_px, kDarkQuarter});
}

}  // namespace

MarkMeshes BuildMarks(const Scene& scene, const Projector& projector) {
  MarkMeshes meshes;
  Pen below(projector, meshes.hidden_by_solids), above(projector, meshes.on_top);
  const Mat4 view = ViewMatrix(scene.camera);
  for (const Marker& m : scene.markers) {
    if (m.shape == MarkerShape::kCenterOfMass) {
      DrawCenterOfMass(m, view, above);
    } else {
      DrawFlatMarker(m, m.on_top ? above : below);
    }
  }
  for (const Polyline& line : scene.polylines) DrawPolyline(line, line.on_top ? above : below);
  return meshes;
}

}  // namespace hazumi::render
