#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/panels/viewport/effort.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/marks.h"

namespace hazumi::ui {

namespace {

// A diamond: pulling it moves a limb, or the root.
void DrawHandle(Point at, float size, ImU32 fill, ImU32 line) {
  const ImVec2 p[] = {
      {at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size}, {at.x - size, at.y}};
  Canvas()->AddConvexPolyFilled(p, 4, fill);
  Canvas()->AddPolyline(p, 4, line, ImDrawFlags_Closed, 1.0f);
}

}  // namespace

void DrawJointMarks(const Editor& editor, const View& view, const PosedFigure& figure) {
  const std::optional<Point> root = view.ToWindow(figure.frame().X_WR.p);
  if (root && !figure.is_root_hidden()) {
    const bool is_selected = editor.session().is_root_selected();
    DrawHandle(*root, Px(editor, is_selected ? 8.0 : 7.0),
               is_selected ? ToIm(colors::kSelected) : ToIm(colors::kWhite, 0.75f),
               ToIm(colors::kShade, 0.8f));
  }
  const std::vector<GroupIndex> selected = SelectedJoints(editor.session());
  const std::vector<GroupIndex> handles = HandleJoints(figure.figure());
  for (int g = 0; g < static_cast<int>(figure.figure().groups().size()); ++g) {
    const GroupIndex joint(g);
    if (figure.IsHidden(joint)) continue;
    const std::optional<Point> at = view.ToWindow(figure.CenterOf(joint));
    if (!at) continue;
    const bool is_selected = std::find(selected.begin(), selected.end(), joint) != selected.end();
    const bool is_handle = std::find(handles.begin(), handles.end(), joint) != handles.end();
    const ImU32 fill = is_selected ? ToIm(colors::kSelected) : ToIm(colors::kWhite, 0.75f);
    const ImU32 line = ToIm(colors::kShade, 0.8f);
    if (is_handle) {
      DrawHandle(*at, Px(editor, is_selected ? 6.5 : 5.5), fill, line);
      continue;
    }
    const float radius = Px(editor, is_selected ? 4.0 : 2.5);
    Canvas()->AddCircleFilled(ToIm(*at), radius, fill, 16);
    Canvas()->AddCircle(ToIm(*at), radius, line, 16);
  }
}

void DrawHovered(const Editor& editor, const View& view, const PosedFigure& figure,
                 const std::vector<Solid>& solids, Point mouse, const std::string& more) {
  const ViewportHit hit = HitTest(view, mouse, figure, solids, editor.settings.scale);
  const Solid* solid = FindSolid(hit.object, solids);
  std::string name = solid ? solid->name : "";
  if (hit.joint) {
    name = figure.figure().group(*hit.joint).name;
    const std::string effort = EffortOfJoint(editor, *hit.joint);
    if (!effort.empty()) name += "\n" + effort;
  }
  if (hit.is_root) name = figure.figure().root_name();
  if (!name.empty() && !more.empty()) name += "\n";
  name += more;
  if (name.empty()) return;
  if (hit.joint) {
    const std::optional<Point> at = view.ToWindow(figure.CenterOf(*hit.joint));
    if (at)
      Canvas()->AddCircle(ToIm(*at), Px(editor, 8.0), ToIm(colors::kWhite), 24, Px(editor, 1.5));
  }
  DrawLabel(editor, view.rect(), mouse, name, ToIm(colors::kWhite));
}

void DrawAimedSpot(const Editor& editor, const View& view) {
  const std::optional<AimedSpot>& aimed = editor.viewport.aimed;
  const auto at = aimed ? view.ToWindow(aimed->at) : std::nullopt;
  if (!at) return;
  const ImU32 color = ToIm(aimed->is_trouble ? colors::kSinking : colors::kSelected);
  const float arm = Px(editor, 9.0), width = Px(editor, 2.0);
  const auto from = aimed->from ? view.ToWindow(*aimed->from) : std::nullopt;
  if (from) DrawDashedLine(*from, *at, color, width);
  Canvas()->AddLine({at->x - arm, at->y}, {at->x + arm, at->y}, color, width);
  Canvas()->AddLine({at->x, at->y - arm}, {at->x, at->y + arm}, color, width);
  Canvas()->AddCircle(ToIm(*at), 0.6f * arm, color, 24, width);
  if (!aimed->text.empty()) DrawLabel(editor, view.rect(), *at, aimed->text, color);
}

static void DrawOutline(const Editor& editor, const View& view, const Box& box) {
  const auto corner = [&](int i) {
    const Vec3 sign(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
    return view.ToWindow(box.X_WB * Vec3(sign.cwiseProduct(box.half_size)));
  };
  for (int i = 0; i < 8; ++i) {
    for (int bit = 1; bit < 8; bit *= 2) {
      const auto a = corner(i), b = corner(i | bit);
      if ((i & bit) || !a || !b) continue;
      Canvas()->AddLine(ToIm(*a), ToIm(*b), ToIm(colors::kSelected), Px(editor, 1.5));
    }
  }
}

// The circle across the view; a little wider than the ball, so that it is seen around a small one.
static void DrawOutline(const Editor& editor, const View& view, const Ball& ball) {
  const Vec3& back = view.back();
  const Vec3 right = ball.radius * back.unitOrthogonal(), up = back.cross(right);
  constexpr int kCorners = 48;
  std::vector<ImVec2> circle;
  const std::optional<Point> center = view.ToWindow(ball.center);
  for (int i = 0; i < kCorners && center; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    const auto at = view.ToWindow(ball.center + std::cos(angle) * right + std::sin(angle) * up);
    if (!at) return;
    const float dx = at->x - center->x, dy = at->y - center->y;
    const float wider = 1.0f + Px(editor, 2.0) / std::max(1.0f, std::hypot(dx, dy));
    circle.push_back({center->x + wider * dx, center->y + wider * dy});
  }
  Canvas()->AddPolyline(circle.data(), static_cast<int>(circle.size()), ToIm(colors::kSelected),
                        ImDrawFlags_Closed, Px(editor, 1.8));
}

void DrawSelectedObject(const Editor& editor, const View& view, const std::vector<Solid>& solids) {
  const Solid* solid = FindSolid(editor.viewport.selected_object, solids);
  if (!solid) return;
  std::visit([&](const auto& shape) { DrawOutline(editor, view, shape); }, solid->shape);
}

void DrawPathTicks(const Editor& editor, const View& view) {
  if (!editor.viewport.overlays.paths || !editor.viewport.shown) return;
  const float half = Px(editor, 1.5);
  for (const PathTicks& ticks : editor.viewport.shown->ticks) {
    for (const Vec3& p : ticks.points) {
      const std::optional<Point> at = view.ToWindow(p);
      if (!at) continue;
      Canvas()->AddRectFilled({at->x - half, at->y - half}, {at->x + half, at->y + half},
                              ToIm(ticks.color));
    }
  }
}

}  // namespace hazumi::ui
