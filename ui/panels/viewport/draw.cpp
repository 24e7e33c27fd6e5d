#include <cstdint>

#include "ui/panels/viewport/acting.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/effort.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/viewport/popups.h"
#include "ui/panels/viewport/scene.h"
#include "ui/panels/viewport/start_speed.h"
#include "ui/panels/viewport/swivel_handle.h"
#include "ui/panels/window/panels.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

// What is shown may be from before an error.
void SayWhatIsWrong(Editor* editor) {
  const Result<const Motion*> motion = editor->session().MotionTo(FrameShown(*editor));
  if (motion.ok() || motion.error().code == ErrorCode::kInterrupted) return;
  editor->Say(motion.error().ToString(), true);
}

// Of the skin: textures that could not be read.
void SayWhatIsNotDrawn(Editor* editor) {
  const std::vector<Warning> warnings = editor->skins.TakeWarnings();
  if (warnings.empty()) return;
  const std::string more =
      warnings.size() == 1 ? "" : " (+" + std::to_string(warnings.size() - 1) + ")";
  editor->Say(warnings[0].place + ": " + warnings[0].message + more, true);
}

// The texture of last time if nothing changed that is seen in it.
Result<unsigned> PictureNow(Editor* editor, const Rect& rect) {
  const render::PictureSize size = {static_cast<int>(rect.w), static_cast<int>(rect.h)};
  ViewportState& state = editor->viewport;
  const PictureKey key = KeyNow(*editor, size);
  if (state.shown && state.shown->key == key) return state.shown->texture;
  Result<ViewportScene> scene = SceneNow(editor, rect);
  SayWhatIsNotDrawn(editor);
  SayWhatIsWrong(editor);
  if (!scene.ok()) scene = ViewportScene();
  Result<unsigned> texture = editor->paint_scene(scene.value().scene, size, state.overlays.shadow);
  if (!texture.ok()) return texture;
  state.shown = ShownPicture{key, texture.value(), std::move(scene.value().ticks)};
  ++state.pictures_drawn;
  return texture;
}

void DrawPicture(Editor* editor, const Rect& rect) {
  const Result<unsigned> picture = PictureNow(editor, rect);
  if (!picture.ok()) {
    ImGui::TextUnformatted(picture.error().ToString().c_str());
    return;
  }
  const auto id = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture.value()));
  ImGui::GetWindowDrawList()->AddImage(id, {rect.x, rect.y}, {rect.right(), rect.bottom()}, {0, 1},
                                       {1, 0});
}

// What lies on the figure. `has_mouse`: nothing else is under the mouse.
void DrawOnFigure(Editor* editor, const View& view, bool has_mouse) {
  const auto figure = PoseNow(&editor->session());
  if (!figure) return;
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  const ViewportState& state = editor->viewport;
  const double scale = editor->settings.scale;
  DrawPathTicks(*editor, view);
  DrawStartSpeeds(editor, view);
  const std::vector<Solid> solids = SolidsOf(&editor->session(), *figure);
  DrawSelectedObject(*editor, view, solids);
  DrawJointMarks(*editor, view, *figure);
  DrawEffort(*editor, view, *figure);
  DrawActing(editor, view, *figure);
  const auto gizmo =
      GizmoOf(view, editor->session(), *figure, state.active_hinge, state.overlays.limits, scale);
  const auto hovered = gizmo && has_mouse ? GizmoAt(view, mouse, *gizmo, scale) : std::nullopt;
  if (gizmo) DrawGizmo(*editor, view, *gizmo, hovered);
  if (const auto handle = SwivelHandleOf(editor->session(), *figure)) {
    DrawSwivelHandle(*editor, view, *handle);
  }
  DrawAimedSpot(*editor, view);
  if (has_mouse && !hovered) {
    DrawHovered(*editor, view, *figure, solids, mouse, ActingAt(editor, view, *figure, mouse));
  }
}

void DrawBox(const std::optional<Rect>& box) {
  if (!box) return;
  const ImVec2 from = {box->x, box->y}, to = {box->right(), box->bottom()};
  Canvas()->AddRectFilled(from, to, ToIm(colors::kWhite, 0.1f));
  Canvas()->AddRect(from, to, ToIm(colors::kWhite, 0.6f));
}

}  // namespace

void DrawViewport(Editor* editor, const Rect& rect) {
  editor->viewport.rect = rect;
  FrameNewDocument(editor);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  BeginPanel("##viewport", rect, editor->theme().window);
  DrawPicture(editor, rect);
  const View view = ViewOf(editor->viewport, editor->session().project(), rect);
  const bool has_mouse = ImGui::IsWindowHovered() && !editor->has_tool() &&
                         rect.Contains(FromIm(ImGui::GetIO().MousePos)) &&
                         !ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  DrawOnFigure(editor, view, has_mouse);
  DrawCameraBorder(*editor, rect);
  DrawCaption(*editor, rect);
  DrawAxisCross(*editor, view);
  DrawToggles(editor, rect);
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::InvisibleButton("##scene", {rect.w, rect.h},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  ActOnViewport(editor, rect);
  DrawBox(editor->viewport.box);
  ImGui::PopStyleVar();
  DrawViewportPopups(editor);
  EndPanel();
}

}  // namespace hazumi::ui
