#include "ui/panels/viewport/actions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ui/edit/operators/edits.h"
#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/viewport/solids.h"

namespace hazumi::ui {

namespace {

void Extend(const PosedFigure& figure, Eigen::AlignedBox3d* bounds) {
  for (const Link& link : figure.figure().links()) {
    const hazumi::Pose X_WJ = figure.PoseOf(link.joint);
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      const Vec3 p = X_WJ * end;
      bounds->extend(p - Vec3::Constant(link.capsule.radius));
      bounds->extend(p + Vec3::Constant(link.capsule.radius));
    }
  }
}

void Extend(const Box& box, Eigen::AlignedBox3d* bounds) {
  const Vec3 reach = Vec3::Constant(box.half_size.norm());
  bounds->extend(box.X_WB.p - reach);
  bounds->extend(box.X_WB.p + reach);
}

void Extend(const Ball& ball, Eigen::AlignedBox3d* bounds) {
  bounds->extend(ball.center - Vec3::Constant(ball.radius));
  bounds->extend(ball.center + Vec3::Constant(ball.radius));
}

Result<Done> LookAt(Editor* editor, const Eigen::AlignedBox3d& bounds, double least_radius) {
  ViewportState& state = editor->viewport;
  state.through_project_camera = false;
  const double aspect = state.rect.h > 0.0f ? state.rect.w / state.rect.h : 1.0;
  FrameSphere(bounds.center(), std::max(0.5 * bounds.diagonal().norm(), least_radius), aspect,
              &state.camera);
  return Done();
}

Error CannotBeAnimated() {
  return {ErrorCode::kSemantics, "", "", "the project cannot be animated as it is"};
}

}  // namespace

Result<Done> FrameSelected(Editor* editor) {
  edit::Session& session = editor->session();
  const auto figure = PoseNow(&session);
  if (!figure) return CannotBeAnimated();
  Eigen::AlignedBox3d bounds;
  for (const GroupIndex joint : SelectedJoints(session)) bounds.extend(figure->CenterOf(joint));
  if (session.is_root_selected()) bounds.extend(figure->frame().X_WR.p);
  const std::vector<Solid> solids = SolidsOf(&session, *figure);
  if (const Solid* solid = FindSolid(editor->viewport.selected_object, solids)) {
    std::visit([&](const auto& shape) { Extend(shape, &bounds); }, solid->shape);
  }
  if (bounds.isEmpty()) Extend(*figure, &bounds);
  constexpr double kLeast = 0.3;  // [m]: a joint with what is around it
  return LookAt(editor, bounds, kLeast);
}

Result<Done> FrameAll(Editor* editor) {
  edit::Session& session = editor->session();
  const Result<const Motion*> motion = session.WholeMotion();
  if (!motion.ok()) return motion.error();
  Eigen::AlignedBox3d bounds;
  for (const MotionFrame& frame : motion.value()->frames) {
    Extend(PosedFigure(session.figure(), frame), &bounds);
  }
  for (const SceneObject& object : session.animation()->scene) {
    if (const Box* box = std::get_if<Box>(&object.shape)) Extend(*box, &bounds);
  }
  return LookAt(editor, bounds, 0.3);
}

void FrameNewDocument(Editor* editor) {
  long& framed = editor->viewport.framed_document;
  if (framed == editor->session().document_number()) return;
  framed = editor->session().document_number();
  editor->DropTool();
  const bool is_new = editor->session().document().path().empty();
  if (is_new || !FrameAll(editor).ok()) editor->viewport.camera = OrbitCamera();
  editor->Do("sheet.frame_all");
}

Result<Done> LookThroughCamera(Editor* editor) {
  bool& through = editor->viewport.through_project_camera;
  if (!through && !editor->session().project().camera) {
    return Error{ErrorCode::kSchema, "", "view.camera",
                 "the project has no camera; give it one with View > Set camera to the view"};
  }
  through = !through;
  return Done();
}

// Pictures show all that the viewport shows, and more above and below where that is wider. Their
// frame is seen as through the camera, until the view is moved.
Result<Done> SetCameraToView(Editor* editor) {
  render::Camera view = CameraOf(editor->viewport.camera);
  const Rect& rect = editor->viewport.rect;
  const double wider = rect.h > 0.0f ? rect.w / rect.h / kPictureAspect : 1.0;
  if (wider > 1.0) {
    const double half = wider * std::tan(0.5 * kDegree * view.vertical_fov_deg);
    view.vertical_fov_deg = WithoutRoundOff(2.0 * std::atan(half) / kDegree);
  }
  Result<Done> set = editor->session().Run("camera.set", {{"eye_x", view.eye.x()},
                                                          {"eye_y", view.eye.y()},
                                                          {"eye_z", view.eye.z()},
                                                          {"target_x", view.target.x()},
                                                          {"target_y", view.target.y()},
                                                          {"target_z", view.target.z()},
                                                          {"fov", view.vertical_fov_deg}});
  if (!set.ok()) return set;
  editor->viewport.through_project_camera = true;
  editor->Say(Tr("The camera looks from here: pictures show what is in the frame."));
  return set;
}

}  // namespace hazumi::ui
