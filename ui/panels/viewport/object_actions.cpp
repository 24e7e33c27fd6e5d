// What is done with a box of the scene or a held object: selected, moved, removed, jumped onto.

#include "ui/panels/viewport/object_actions.h"

#include "ui/panels/viewport/point_move_tool.h"
#include "ui/panels/viewport/solids.h"

namespace hazumi::ui {

namespace {

Error NothingSelected() {
  return {ErrorCode::kSchema, "", "", "nothing is selected: click on a joint, a box or a ball"};
}

const ProjectSceneObject* SelectedSceneObject(const Editor& editor) {
  const Project& project = editor.session().project();
  const int index = hazumi::IndexOf(editor.viewport.selected_object, project.scene.objects);
  return index < 0 ? nullptr : &project.scene.objects[index];
}

// The operators add to where the object is: each time from the beginning.
class ObjectTool : public PointMoveTool {
 public:
  ObjectTool(Editor* editor, const Solid& solid, std::optional<HeldFrom> held)
      : PointMoveTool(editor, solid.name, solid.center(), held),
        id_(solid.is_held_object ? "held.move" : "object.move") {}

 private:
  bool Place(Editor* editor, const Vec3& offset) override {
    TakeBack(editor);
    return Run(editor, id_,
               {{"object", name()}, {"x", offset.x()}, {"y", offset.y()}, {"z", offset.z()}});
  }

  const char* id_;
};

}  // namespace

const ProjectHeldObject* SelectedHeldObject(const Editor& editor) {
  const Project& project = editor.session().project();
  const int index = hazumi::IndexOf(editor.viewport.selected_object, project.held_objects);
  return index < 0 ? nullptr : &project.held_objects[index];
}

void SelectObject(Editor* editor, ItemId object) {
  editor->viewport.selected_object = object;
  if (!object.is_valid()) return;
  editor->side.active = NameOfSelectedObject(*editor);
  editor->side.section = Section::kScene;
}

void SelectAdded(Editor* editor, const std::string& id) {
  const Project& project = editor->session().project();
  const bool is_held = id.starts_with("held.add_");
  if (!is_held && id != "object.add_box") return;
  editor->session().set_selected_joints({});
  SelectObject(editor, is_held ? project.held_objects.back().identity.id
                               : project.scene.objects.back().identity.id);
}

std::string NameOfSelectedObject(const Editor& editor) {
  if (const ProjectHeldObject* held = SelectedHeldObject(editor)) return held->name;
  const ProjectSceneObject* object = SelectedSceneObject(editor);
  return object ? object->name : "";
}

static Result<Done> SelectObjectNamed(Editor* editor, const std::string& name) {
  const Project& project = editor->session().project();
  ItemId found;
  for (const ProjectSceneObject& object : project.scene.objects) {
    if (object.name == name) found = object.identity.id;
  }
  for (const ProjectHeldObject& object : project.held_objects) {
    if (object.name == name) found = object.identity.id;
  }
  if (!found.is_valid()) {
    return Error{ErrorCode::kSchema, "", "object", "there is no object \"" + name + "\""};
  }
  Result<Done> none = editor->session().Run("select.joints", {{"joints", Json::array()}});
  if (none.ok()) SelectObject(editor, found);
  return none;
}

static Result<Done> RemoveSelectedObject(Editor* editor) {
  if (const ProjectHeldObject* held = SelectedHeldObject(*editor)) {
    return editor->Invoke("held.remove", {{"object", held->name}});
  }
  const ProjectSceneObject* object = SelectedSceneObject(*editor);
  if (!object) return NothingSelected();
  return editor->Invoke("object.remove", {{"object", object->name}});
}

// And takes the copy in hand.
static Result<Done> DuplicateSelectedObject(Editor* editor) {
  const ProjectSceneObject* object = SelectedSceneObject(*editor);
  if (!object) {
    return Error{ErrorCode::kSchema, "", "",
                 "click on a box first: another one like it is put into the scene"};
  }
  Result<Done> done = editor->Invoke("object.duplicate", {{"object", object->name}});
  if (!done.ok()) return done;
  SelectObject(editor, editor->session().project().scene.objects.back().identity.id);
  return TakeMoveObjectTool(editor, std::nullopt);
}

Result<Done> TakeMoveObjectTool(Editor* editor, std::optional<HeldFrom> held) {
  const auto figure = PoseNow(&editor->session());
  if (!figure) return NothingSelected();
  const std::vector<Solid> solids = SolidsOf(&editor->session(), *figure);
  const Solid* solid = FindSolid(editor->viewport.selected_object, solids);
  if (!solid) return NothingSelected();
  editor->Take(std::make_unique<ObjectTool>(editor, *solid, held));
  return Done();
}

std::vector<Action> ObjectActions() {
  using enum edit::ParameterKind;
  return {
      {"tool.jump",
       "Jump",
       "From where it stands now onto the spot under the mouse; a jump of the current frame is "
       "aimed there. How high its centre of mass rises may be typed.",
       {},
       [](Editor* editor, const edit::Parameters&) { return TakeJumpTool(editor); }},
      {"tool.throw",
       "Throw",
       "Throws the selected held object onto the spot under the mouse: makes the throw or, where "
       "a dynamics region moves the arm as it lets go, aims it. How high it rises may be typed.",
       {},
       [](Editor* editor, const edit::Parameters&) { return TakeThrowTool(editor); }},
      {"tool.add_box",
       "Draw box",
       "Draws a box on what is under the mouse: its base is dragged out, then its height.",
       {},
       [](Editor* editor, const edit::Parameters&) { return TakeAddBoxTool(editor); }},
      {"select.object",
       "Select object",
       "Selects a box of the scene or a held object.",
       {{"object", kText, true, "its name"}},
       [](Editor* editor, const edit::Parameters& p) {
         return SelectObjectNamed(editor, p.text("object"));
       }},
      {"view.duplicate_object",
       "Duplicate selected object",
       "Puts another box like the selected one into the scene and takes it in hand.",
       {},
       [](Editor* editor, const edit::Parameters&) { return DuplicateSelectedObject(editor); }},
      {"view.remove_object",
       "Remove selected object",
       "Takes the selected box or held object away.",
       {},
       [](Editor* editor, const edit::Parameters&) { return RemoveSelectedObject(editor); }}};
}

}  // namespace hazumi::ui
