#include <imgui.h>

#include <cmath>

#include "ui/panels/viewport/acting.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/goal_marks.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/popups.h"
#include "ui/panels/viewport/swivel_handle.h"
#include "ui/panels/viewport/tools/tools.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

constexpr float kDragPx = 4.0f;  // a press that moves farther is no click

// Orbit with the middle button, pan with Shift, zoom with Ctrl or the wheel.
void MoveCamera(Editor* editor, const Rect& rect) {
  const ImGuiIO& io = ImGui::GetIO();
  OrbitCamera& camera = editor->viewport.camera;
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0f) {
    editor->viewport.through_project_camera = false;
    Zoom(std::pow(0.9, io.MouseWheel), &camera);
  }
  if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Middle)) return;
  const Point by = FromIm(io.MouseDelta);
  if (by.x == 0.0f && by.y == 0.0f) return;
  editor->viewport.through_project_camera = false;
  if (io.KeyShift) {
    Pan(by, rect.h, &camera);
  } else if (io.KeyCtrl) {
    Zoom(std::exp(0.005 * by.y), &camera);
  } else {
    Orbit(by, &camera);
  }
}

bool IsSelected(const edit::Session& session, GroupIndex joint) {
  for (const GroupIndex selected : SelectedJoints(session)) {
    if (selected == joint) return true;
  }
  return false;
}

bool IsSelected(const edit::Session& session, const ViewportHit& hit) {
  return hit.is_root ? session.is_root_selected() : hit.joint && IsSelected(session, *hit.joint);
}

void Click(Editor* editor, const ViewportHit& hit, bool toggles) {
  edit::Session& session = editor->session();
  Json names = Json::array();
  if (hit.joint) names.push_back(session.figure().group(*hit.joint).name);
  if (hit.is_root) names.push_back(session.figure().root_name());
  const char* mode = !toggles ? "replace" : IsSelected(session, hit) ? "remove" : "add";
  editor->Do("select.joints", {{"joints", names}, {"mode", mode}});
  if (!toggles || hit.object.is_valid()) SelectObject(editor, hit.object);
  editor->Say("");
}

std::string HandleUnder(const ViewportHit& hit, const Figure& figure) {
  if (!hit.is_marker) return "";
  if (hit.is_root) return figure.root_name();
  for (const GroupIndex handle : HandleJoints(figure)) {
    if (handle == *hit.joint) return figure.group(handle).name;
  }
  return "";
}

std::optional<GizmoHit> GizmoUnder(const Editor& editor, const View& view,
                                   const PosedFigure& figure, Point at) {
  const ViewportState& state = editor.viewport;
  const double scale = editor.settings.scale;
  const auto gizmo =
      GizmoOf(view, editor.session(), figure, state.active_hinge, state.overlays.limits, scale);
  return gizmo ? GizmoAt(view, at, *gizmo, scale) : std::nullopt;
}

std::optional<SwivelHandle> SwivelHandleUnder(const Editor& editor, const View& view,
                                              const PosedFigure& figure, Point at) {
  const auto handle = SwivelHandleOf(editor.session(), figure);
  const std::optional<Point> mark = handle ? view.ToWindow(handle->at) : std::nullopt;
  const double reach = kMarkerReach * editor.settings.scale;
  const bool is_under = mark && std::hypot(mark->x - at.x, mark->y - at.y) < reach;
  return is_under ? handle : std::nullopt;
}

// The left button went down. What becomes of it, a click or a drag, shows later.
void Press(Editor* editor, const View& view, const PosedFigure& figure) {
  const Point at = FromIm(ImGui::GetIO().MousePos);
  const ViewportHit hit =
      HitTest(view, at, figure, SolidsOf(&editor->session(), figure), editor->settings.scale);
  const bool on_swivel = SwivelHandleUnder(*editor, view, figure, at).has_value();
  const std::string handle = HandleUnder(hit, figure.figure());
  const bool on_other = !handle.empty() && !IsSelected(editor->session(), hit);
  const bool on_gizmo =
      !on_swivel && !on_other && GizmoUnder(*editor, view, figure, at).has_value();
  const auto goal = GoalPartAt(view, at, GoalMarksNow(editor, figure), editor->session().project(),
                               editor->settings.scale);
  editor->viewport.press = ViewportPress{at, handle, on_gizmo, on_swivel, hit.object, goal};
}

// The button is down: a ring or a limit that is pulled turns its hinge, a handle drags its limb,
// and an object that was selected before is moved.
void Pull(Editor* editor, const View& view, const PosedFigure& figure) {
  const ViewportPress press = *editor->viewport.press;
  const Point at = FromIm(ImGui::GetIO().MousePos);
  if (std::hypot(at.x - press.at.x, at.y - press.at.y) < kDragPx) return;
  editor->viewport.press.reset();
  if (press.on_gizmo) {
    const auto part = GizmoUnder(*editor, view, figure, press.at);
    if (!part) return;
    if (part->part != GizmoPart::kRing) return TakeLimitTool(editor, *part);
    if (editor->session().is_root_selected()) return TakeRootRingTool(editor, *part, {press.at});
    return TakeRingTool(editor, *part, {press.at});
  }
  if (press.object.is_valid() && press.object == editor->viewport.selected_object) {
    (void)TakeMoveObjectTool(editor, HeldFrom{press.at});
  }
  if (press.on_swivel) {
    const auto handle = SwivelHandleUnder(*editor, view, figure, press.at);
    if (handle) return TakeSwivelTool(editor, *handle, {press.at});
  }
  if (press.goal && press.handle.empty()) return TakeGoalTool(editor, *press.goal, {press.at});
  if (press.handle.empty()) return;
  editor->Do("select.joints", {{"joints", Json::array({press.handle})}});
  if (press.handle == figure.figure().root_name()) return TakeRootMoveTool(editor, {{press.at}});
  TakeReachTool(editor, press.handle, {press.at});
}

}  // namespace

void ActOnViewport(Editor* editor, const Rect& rect) {
  ViewportState& state = editor->viewport;
  MoveCamera(editor, rect);
  const bool is_busy = editor->has_tool() || state.had_tool;
  state.had_tool = editor->has_tool();
  if (is_busy) return state.press.reset();
  const auto figure = PoseNow(&editor->session());
  if (!figure) return;
  const View view = ViewOf(state, editor->session().project(), rect);
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    Press(editor, view, *figure);
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    OpenViewportPopup(editor,
                      HitTest(view, FromIm(ImGui::GetIO().MousePos), *figure,
                              SolidsOf(&editor->session(), *figure), editor->settings.scale));
  }
  if (!state.press) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return Pull(editor, view, *figure);
  const Point at = state.press->at;
  const ViewportHit hit =
      HitTest(view, at, *figure, SolidsOf(&editor->session(), *figure), editor->settings.scale);
  state.press.reset();
  if (!hit.is_marker && ChooseConstraintAt(editor, view, *figure, at)) return;
  Click(editor, hit, ImGui::GetIO().KeyShift);
}

}  // namespace hazumi::ui
