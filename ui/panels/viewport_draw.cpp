#include <algorithm>
#include <cmath>

#include "render/motion/motion_scene.h"
#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

namespace {

// Orbit with the middle button, pan with Shift, zoom with Ctrl or the wheel.
void MoveCamera(Editor* editor, const Rect& rect) {
  const ImGuiIO& io = ImGui::GetIO();
  OrbitCamera& camera = editor->viewport.camera;
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0f) {
    camera.distance = std::clamp(camera.distance * std::pow(0.9, io.MouseWheel), 0.2, 100.0);
  }
  if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Middle)) return;
  const ImVec2 by = io.MouseDelta;
  editor->viewport.through_project_camera = false;
  if (io.KeyShift) {
    const render::Mat4 view = render::ViewMatrix(CameraOf(camera));
    const double metres = camera.distance * 0.63 / rect.h;
    camera.target +=
        metres * (-by.x * view.block<1, 3>(0, 0) + by.y * view.block<1, 3>(1, 0)).transpose();
  } else if (io.KeyCtrl) {
    camera.distance = std::clamp(camera.distance * std::exp(0.005 * by.y), 0.2, 100.0);
  } else {
    camera.azimuth -= 0.008 * by.x;
    camera.elevation = std::clamp(camera.elevation + 0.008 * by.y, -1.5707, 1.5707);
  }
}

render::Scene SceneNow(Editor* editor) {
  edit::Session& session = editor->session();
  const int first = editor->first_frame(), last = editor->last_frame();
  const int frame = std::clamp(static_cast<int>(std::lround(session.frame())), first, last);
  const Result<const Motion*> motion = session.WholeMotion();
  if (!motion.ok()) {
    editor->Say(motion.error().ToString(), true);
    return {};
  }
  const ViewportOverlays& wanted = editor->viewport.overlays;
  render::Overlays overlays;
  overlays.ghost_every = wanted.ghosts ? wanted.ghost_every : 0;
  overlays.paths = wanted.paths;
  overlays.contact_marks = wanted.marks;
  overlays.region_tint = wanted.tint;
  render::MotionScene scene(*session.animation(), *motion.value(), *motion.value(),
                            CameraOf(editor->viewport.camera), overlays);
  return scene.At(frame - first);
}

}  // namespace

void DrawViewport(Editor* editor, const Rect& rect) {
  editor->viewport.rect = rect;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  BeginPanel("##viewport", rect, editor->theme().window);
  const Result<unsigned> picture =
      editor->paint_scene(SceneNow(editor), {static_cast<int>(rect.w), static_cast<int>(rect.h)},
                          editor->viewport.overlays.shadow);
  if (picture.ok()) {
    const auto id = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture.value()));
    ImGui::GetWindowDrawList()->AddImage(id, {rect.x, rect.y}, {rect.right(), rect.bottom()},
                                         {0, 1}, {1, 0});
  } else {
    ImGui::TextUnformatted(picture.error().ToString().c_str());
  }
  ImGui::InvisibleButton("##scene", {rect.w, rect.h},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  MoveCamera(editor, rect);
  EndPanel();
  ImGui::PopStyleVar();
}

}  // namespace hazumi::ui
