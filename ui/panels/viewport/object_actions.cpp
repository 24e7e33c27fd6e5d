// What is done with a box of the scene or a held object: selected, moved, removed, jumped onto.

#include "ui/edit/operators/edits.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/solids.h"
#include "ui/panels/viewport/tools/point_move_tool.h"

namespace hazumi::ui {

namespace {

Error NothingSelected() {
  return {ErrorCode::kSchema, "", "", "nothing is selected: click on a joint, a box or a ball"};
}

std::optional<Solid> SelectedSolid(Editor* editor) {
  const auto figure = PoseNow(&editor->session());
  if (!figure) return std::nullopt;
  const std::vector<Solid> solids = SolidsOf(&editor->session(), *figure);
  const Solid* solid = FindSolid(editor->viewport.selected_object, solids);
  return solid ? std::optional(*solid) : std::nullopt;
}

const ProjectSceneObject* SelectedSceneObject(const Editor& editor) {
  const Project& project = editor.session().project();
  const int index = hazumi::IndexOf(editor.viewport.selected_object, project.scene.objects);
  return index < 0 ? nullptr : &project.scene.objects[index];
}

// The operators add to where the object is: each time from the beginning.
class ObjectTool : public PointMoveTool {
 public:
  ObjectTool(Editor* editor, const Solid& solid, const char* id, std::optional<HeldFrom> held)
      : PointMoveTool(editor, solid.name, solid.center(), held),
        id_(id),
        is_in_scene_(!solid.is_held_object) {}

 protected:
  bool Place(Editor* editor, const Vec3& offset) override {
    TakeBack(editor);
    return Run(editor, id_,
               {{"object", name()}, {"x", offset.x()}, {"y", offset.y()}, {"z", offset.z()}});
  }
  // What stands in the scene stays as high as it is, unless it is seen from the side.
  Vec3 PlaneOf(const View& view) const override {
    constexpr double kFromTheSide = 0.1;
    const bool is_from_above = std::abs(view.back().z()) > kFromTheSide;
    return is_in_scene_ && is_from_above ? Vec3(Vec3::UnitZ()) : view.back();
  }

  const char* id_;
  bool is_in_scene_;
};

// Nothing is copied until the mouse moves, so that no copy is ever left where the box is.
class CopyTool : public ObjectTool {
 public:
  CopyTool(Editor* editor, const Solid& solid)
      : ObjectTool(editor, solid, "object.duplicate", std::nullopt),
        copy_(FreeObjectName(solid.name, editor->session().project())) {}

 private:
  std::string moved() const override { return copy_; }
  bool Place(Editor* editor, const Vec3& offset) override {
    return is_made_ = ObjectTool::Place(editor, offset);
  }
  bool Follow(Editor* editor, const ToolInput& input) override {
    if (!ObjectTool::Follow(editor, input)) return false;
    if (is_made_ && IsConfirmed(input)) {
      SelectObject(editor, editor->session().project().scene.objects.back().identity.id);
    }
    return true;
  }

  std::string copy_;  // its name
  bool is_made_ = false;
};

const char* MoveOperatorOf(const Solid& solid) {
  return solid.is_held_object ? "held.move" : "object.move";
}

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

static Result<Done> DuplicateSelectedObject(Editor* editor) {
  const std::optional<Solid> solid = SelectedSolid(editor);
  if (!solid || solid->is_held_object) {
    return Error{ErrorCode::kSchema, "", "",
                 "click on a box first: another one like it is put into the scene"};
  }
  editor->Take(std::make_unique<CopyTool>(editor, *solid));
  return Done();
}

Result<Done> TakeMoveObjectTool(Editor* editor, std::optional<HeldFrom> held) {
  const std::optional<Solid> solid = SelectedSolid(editor);
  if (!solid) return NothingSelected();
  editor->Take(std::make_unique<ObjectTool>(editor, *solid, MoveOperatorOf(*solid), held));
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
       "a dynamics region moves the arm as it lets go, aims it. S changes the style; how high it "
       "rises may be typed.",
       {},
       [](Editor* editor, const edit::Parameters&) { return TakeThrowTool(editor); }},
      {"tool.aim",
       "Reach what is clicked",
       "The tip of the selected joint's limb reaches the spot under the mouse in the current "
       "frame, by its inertia and as little muscle as possible.",
       {},
       [](Editor* editor, const edit::Parameters&) { return TakeAimTool(editor); }},
      {"tool.hold_on",
       "Hold on to what is clicked",
       "The selected joint takes hold of what is clicked, an object, the ground or another joint, "
       "from the current frame on.",
       {},
       [](Editor* editor, const edit::Parameters&) { return TakeHoldOnTool(editor); }},
      {"tool.add_box",
       "Draw box",
       "Draws a box on what is under the mouse: its base is dragged out, then its height.",
       {},
       [](Editor* editor, const edit::Parameters&) { return TakeAddBoxTool(editor); }},
      {"view.add_menu",
       "Add menu",
       "Opens what can be put into the scene or a hand.",
       {},
       [](Editor* editor, const edit::Parameters&) -> Result<Done> {
         editor->viewport.popup = ViewportPopup::kAdd;
         return Done();
       }},
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
