#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/spatial/degrees.h"
#include "ui/panels/text/number_text.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

constexpr SrgbColor kAxes[] = {colors::kAxisX, colors::kAxisY, colors::kAxisZ};

// The far half is faint.
void DrawRing(const View& view, const GizmoRing& ring, float width, bool is_hovered) {
  constexpr int kSegments = 72;
  const SrgbColor color = is_hovered ? colors::kSelected : kAxes[ring.color_axis];
  for (int i = 0; i < kSegments; ++i) {
    const Vec3 p = ring.At(2.0 * std::numbers::pi * i / kSegments),
               q = ring.At(2.0 * std::numbers::pi * (i + 1) / kSegments);
    const auto a = view.ToWindow(p), b = view.ToWindow(q);
    if (!a || !b) continue;
    const bool is_far = (p - ring.center).dot(view.ToViewer(ring.center)) < -0.02 * ring.radius;
    Canvas()->AddLine(ToIm(*a), ToIm(*b), ToIm(color, is_far ? 0.25f : 0.95f),
                      is_far ? 0.7f * width : width);
  }
}

void DrawEnd(Point at, float radius, const SrgbColor& color, bool is_hovered) {
  Canvas()->AddCircleFilled(ToIm(at), radius, ToIm(is_hovered ? colors::kSelected : colors::kWhite),
                            16);
  Canvas()->AddCircle(ToIm(at), radius, ToIm(color), 16, 1.5f);
}

// The sector that the limb may point to, and where it points.
void DrawArc(const View& view, const LimitArc& arc, const SrgbColor& color,
             const std::optional<GizmoHit>& hovered, float scale) {
  const auto center = view.ToWindow(arc.center);
  if (!center) return;
  const int parts = std::max(2, static_cast<int>((arc.upper - arc.lower) / 0.09));
  // Smooth edges would show between the triangles.
  const ImDrawListFlags flags = Canvas()->Flags;
  std::optional<Point> before;
  for (int i = 0; i <= parts; ++i) {
    const auto at = view.ToWindow(arc.At(arc.lower + (arc.upper - arc.lower) * i / parts));
    if (before && at) {
      Canvas()->Flags = flags & ~ImDrawListFlags_AntiAliasedFill;
      Canvas()->AddTriangleFilled(ToIm(*center), ToIm(*before), ToIm(*at), ToIm(color, 0.16f));
      Canvas()->Flags = flags;
      Canvas()->AddLine(ToIm(*before), ToIm(*at), ToIm(color, 0.9f), 1.5f * scale);
    }
    before = at;
  }
  const auto now = view.ToWindow(arc.At(arc.angle));
  if (now) Canvas()->AddLine(ToIm(*center), ToIm(*now), ToIm(colors::kWhite), 2.0f * scale);
  const auto lower = view.ToWindow(arc.At(arc.lower)), upper = view.ToWindow(arc.At(arc.upper));
  const auto is_under = [&](GizmoPart part) { return hovered && hovered->part == part; };
  if (lower) DrawEnd(*lower, 4.0f * scale, color, is_under(GizmoPart::kLower));
  if (upper) DrawEnd(*upper, 4.0f * scale, color, is_under(GizmoPart::kUpper));
}

// Which hinge it is, its angle and its limits.
void DrawAngle(const Editor& editor, const View& view, const LimitArc& arc) {
  const auto center = view.ToWindow(arc.center);
  if (!center) return;
  const Joint& joint = editor.session().figure().joint(arc.hinge);
  char text[160];
  std::snprintf(text, sizeof text, "%s  %.1f\u00b0  (%.0f\u00b0 \u2013 %.0f\u00b0)",
                joint.name.c_str(), WithoutMinusZero(arc.angle / kDegree, 1),
                WithoutMinusZero(arc.lower / kDegree, 0), WithoutMinusZero(arc.upper / kDegree, 0));
  const ImVec2 size = ImGui::CalcTextSize(text);
  const float s = static_cast<float>(editor.settings.scale);
  const Rect& rect = view.rect();
  const float x = std::min(std::max(center->x - size.x / 2, rect.x + 6 * s),
                           std::max(rect.right() - size.x - 6 * s, rect.x));
  const float y = std::min(center->y + 70.0f * s, rect.bottom() - size.y - 6 * s);
  Canvas()->AddRectFilled({x - 5 * s, y - 2 * s}, {x + size.x + 5 * s, y + size.y + 2 * s},
                          ToIm(colors::kShade, 0.72f), 4 * s);
  Canvas()->AddText({x, y}, ToIm(colors::kWhite), text);
}

}  // namespace

void DrawGizmo(const Editor& editor, const View& view, const Gizmo& gizmo,
               const std::optional<GizmoHit>& hovered) {
  const float scale = static_cast<float>(editor.settings.scale);
  for (const GizmoRing& ring : gizmo.rings) {
    if (gizmo.arc && gizmo.arc->hinge == ring.hinge) {
      DrawArc(view, *gizmo.arc, kAxes[ring.color_axis], hovered, scale);
    }
  }
  for (const GizmoRing& ring : gizmo.rings) {
    const bool is_hovered = hovered && hovered->part == GizmoPart::kRing &&
                            hovered->hinge == ring.hinge && hovered->axis == ring.color_axis;
    DrawRing(view, ring, 2.2f * scale, is_hovered);
  }
  if (gizmo.arc) DrawAngle(editor, view, *gizmo.arc);
}

}  // namespace hazumi::ui
