// The scene: what places the figure, objects, gravity and the camera.

#include <algorithm>
#include <cmath>

#include "ui/panels/actions.h"
#include "ui/panels/properties_fields.h"
#include "ui/panels/properties_layout.h"
#include "ui/panels/properties_sections.h"

namespace hazumi::ui {

namespace {

std::string SpanText(int first, int last) {
  return std::to_string(first) + " – " + std::to_string(last);
}

// A line of a list with a button that takes it away; true if that was clicked.
bool DrawEntry(const std::string& text, int index) {
  ImGui::PushID(index);
  const float button = ImGui::GetFrameHeight();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button);
  const bool is_clicked = ImGui::Button("×", {button, 0.0f});
  Tooltip(Tr("Remove"));
  ImGui::PopID();
  return is_clicked;
}

std::string ActiveName(Editor* editor) {
  const edit::Session& session = editor->session();
  const auto active = ActiveJoint(session.figure(), session.selected_joints(), editor->side.active);
  return active ? session.figure().group(*active).name : "";
}

// From the current frame to the end.
void Place(Editor* editor, const char* kind, const std::string& pin) {
  const edit::Session& session = editor->session();
  Json span = {{"kind", kind},
               {"first", static_cast<int>(std::lround(session.frame()))},
               {"last", session.project().frames.last}};
  if (!pin.empty()) span["pin"] = pin;
  editor->Do("placement.set", span);
}

void DrawPlacement(Editor* editor) {
  if (!DrawHeading(Tr("Placement"))) return;
  const std::vector<ProjectPlacement> spans = editor->session().project().placements;
  for (size_t i = 0; i < spans.size(); ++i) {
    const ProjectPlacement& span = spans[i];
    std::string text = SpanText(span.first_frame, span.last_frame) + "  " +
                       Tr(hazumi::NameOf(span.kind)) + "  " + span.pin;
    if (!span.landing_pin.empty()) text += " / " + span.landing_pin;
    if (!DrawEntry(text, static_cast<int>(i))) continue;
    editor->Do("placement.set",
               {{"kind", "keyed"}, {"first", span.first_frame}, {"last", span.last_frame}});
  }
  if (spans.empty()) DrawNote(Tr("The root's keys place the figure."));
  const std::string joint = ActiveName(editor);
  const char* help = HelpOf("placement.set");
  if (DrawButton(Tr("Pin from here"), help, 2)) {
    joint.empty() ? editor->Say(Tr("Select the joint that is to be pinned."), true)
                  : Place(editor, "pinned", joint);
  }
  ImGui::SameLine();
  if (DrawButton(Tr("Gravity from here"), help, 2)) Place(editor, "gravity", "");
}

void DrawHolds(Editor* editor) {
  if (!DrawHeading(Tr("Holds"), false)) return;
  const std::vector<ProjectHold> holds = editor->session().project().holds;
  for (size_t i = 0; i < holds.size(); ++i) {
    const std::string text =
        SpanText(holds[i].first_frame, holds[i].last_frame) + "  " + holds[i].joint;
    if (!DrawEntry(text, static_cast<int>(i))) continue;
    editor->Do("hold.remove", {{"index", static_cast<int>(i)}});
  }
  if (!DrawButton(Tr("Hold from here"), HelpOf("hold.add"))) return;
  const std::string joint = ActiveName(editor);
  if (joint.empty()) return editor->Say(Tr("Select the joint that is to be held."), true);
  editor->Do("hold.add", {{"joint", joint},
                          {"first", static_cast<int>(std::lround(editor->session().frame()))},
                          {"last", editor->session().project().frames.last}});
}

void MoveObject(Editor* editor, const std::string& object, int axis, double by,
                const std::string& drag) {
  const char* axes[] = {"x", "y", "z"};
  editor->Do("object.move", {{"object", object}, {axes[axis], by}, {"drag", drag}});
}

void DrawBox(Editor* editor, const std::string& name, const ProjectBox& box) {
  DrawVector(editor, Tr("Position"), box.center_m, "%.3f m",
             [&](int axis, double value, const std::string& drag) {
               MoveObject(editor, name, axis, value - box.center_m[axis], drag);
             });
  DrawVector(editor, Tr("Size"), box.size_m, "%.3f m",
             [&](int axis, double value, const std::string& drag) {
               const char* sizes[] = {"size_x", "size_y", "size_z"};
               editor->Do("object.set", {{"object", name}, {sizes[axis], value}, {"drag", drag}});
             });
}

// How far from the origin; the operator moves along an axis of the world.
void DrawPlane(Editor* editor, const std::string& name, const ProjectPlane& plane) {
  int axis = 0;
  plane.normal.cwiseAbs().maxCoeff(&axis);
  DrawNumber(editor, {"offset", Tr("Offset"), plane.offset_m, "%.3f m", 0.005},
             [&](double value, const std::string& drag) {
               const double by = (value - plane.offset_m) / plane.normal[axis];
               MoveObject(editor, name, axis, by, drag);
             });
}

void DrawObject(Editor* editor, const ProjectSceneObject& object) {
  ImGui::PushID(object.name.c_str());
  const bool is_open = ImGui::TreeNodeEx(
      object.name.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
  if (is_open) {
    if (const auto* box = std::get_if<ProjectBox>(&object.shape))
      DrawBox(editor, object.name, *box);
    if (const auto* plane = std::get_if<ProjectPlane>(&object.shape)) {
      DrawPlane(editor, object.name, *plane);
    }
    DrawColor(
        editor, "color", Tr("Color"), object.color,
        [&](const std::string& color, const std::string& drag) {
          editor->Do("object.set", {{"object", object.name}, {"color", color}, {"drag", drag}});
        });
    if (DrawButton(Tr("Remove"), HelpOf("object.remove"))) {
      editor->Do("object.remove", {{"object", object.name}});
    }
  }
  ImGui::PopID();
}

std::string FreeName(const char* wanted, const ProjectScene& scene) {
  std::string name = wanted;
  const auto is_taken = [&](const auto& object) { return object.name == name; };
  for (int i = 2; std::any_of(scene.objects.begin(), scene.objects.end(), is_taken); ++i) {
    name = std::string(wanted) + " " + std::to_string(i);
  }
  return name;
}

void DrawObjects(Editor* editor) {
  if (!DrawHeading(Tr("Objects"))) return;
  const ProjectScene scene = editor->session().project().scene;
  for (const ProjectSceneObject& object : scene.objects) DrawObject(editor, object);
  if (DrawButton(LabelOf("object.add_box"), HelpOf("object.add_box"), 2)) {
    editor->Do("object.add_box", {{"name", FreeName("box", scene)}, {"z", 0.5}});
  }
  ImGui::SameLine();
  if (DrawButton(LabelOf("object.add_plane"), HelpOf("object.add_plane"), 2)) {
    editor->Do("object.add_plane", {{"name", FreeName("plane", scene)}});
  }
  DrawNumber(editor, {"gravity", Tr("Gravity"), scene.gravity_m_s2, "%.2f m/s²", 0.02},
             [&](double value, const std::string& drag) {
               editor->Do("scene.gravity", {{"gravity", value}, {"drag", drag}});
             });
}

void DrawHeldObjects(Editor* editor) {
  const std::vector<ProjectHeldObject>& held = editor->session().project().held_objects;
  if (held.empty() || !DrawHeading(Tr("Held objects"), false)) return;
  for (const ProjectHeldObject& object : held) {
    char mass[32];
    std::snprintf(mass, sizeof mass, "%.3g kg", object.mass_kg);
    std::string text = object.joint + ", " + mass;
    if (object.release_frame) {
      text += std::string(", ") + Tr("let go on") + " " + std::to_string(*object.release_frame);
    }
    DrawFact(editor, object.name, text);
  }
}

void SetFromView(Editor* editor) {
  const render::Camera view = CameraOf(editor->viewport.camera);
  editor->Do("camera.set", {{"eye_x", view.eye.x()},
                            {"eye_y", view.eye.y()},
                            {"eye_z", view.eye.z()},
                            {"target_x", view.target.x()},
                            {"target_y", view.target.y()},
                            {"target_z", view.target.z()},
                            {"fov", view.vertical_fov_deg}});
}

void DrawCamera(Editor* editor) {
  if (!DrawHeading(Tr("Camera"), false)) return;
  const std::optional<ProjectCamera> camera = editor->session().project().camera;
  if (camera) {
    const auto submit = [editor](const char* const* names) {
      return [editor, names](int axis, double value, const std::string& drag) {
        editor->Do("camera.set", {{names[axis], value}, {"drag", drag}});
      };
    };
    static constexpr const char* kEye[] = {"eye_x", "eye_y", "eye_z"};
    static constexpr const char* kTarget[] = {"target_x", "target_y", "target_z"};
    DrawVector(editor, Tr("Position"), camera->eye_m, "%.2f m", submit(kEye));
    DrawVector(editor, Tr("Target"), camera->target_m, "%.2f m", submit(kTarget));
    DrawNumber(editor, {"fov", Tr("Field of view"), camera->vertical_fov_deg, "%.1f°", 0.2},
               [&](double value, const std::string& drag) {
                 editor->Do("camera.set", {{"fov", value}, {"drag", drag}});
               });
  } else {
    DrawNote(Tr("The project has no camera of its own: pictures are framed by themselves."));
  }
  if (DrawButton(Tr("Set from view"), HelpOf("camera.set"))) SetFromView(editor);
}

}  // namespace

void DrawSceneSection(Editor* editor) {
  DrawPlacement(editor);
  DrawHolds(editor);
  DrawObjects(editor);
  DrawHeldObjects(editor);
  DrawCamera(editor);
}

}  // namespace hazumi::ui
