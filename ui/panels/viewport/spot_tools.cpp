// What is done onto the spot under the mouse, seen while it is chosen: a jump (J) and a throw (T).
// A height may be typed meanwhile.

#include <cmath>

#include "ui/panels/viewport/drag_tool.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/object_actions.h"
#include "ui/panels/viewport/tools.h"

namespace hazumi::ui {

namespace {

class SpotTool : public DragTool {
 public:
  // An operator that takes the spot's coordinates in `axes` and, if one is typed, a height.
  SpotTool(Editor* editor, const char* id, std::string axes, const char* what)
      : DragTool(editor, id, false), id_(id), axes_(std::move(axes)), what_(what) {}

  std::string hint() const override {
    std::string text = std::string(Tr(what_));
    if (!typed_.is_empty()) {
      text += "   " + std::string(Tr("height")) + " " + typed_.shown() + " m";
    }
    if (!trouble_.empty()) return text + "   ! " + trouble_;
    return text + "   0-9: " + Tr("height") + "   Esc: " + Tr("cancel");
  }

 protected:
  virtual Json Fixed() const { return Json::object(); }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;

  const char* id_;
  std::string axes_;
  const char* what_;
  TypedNumber typed_;
  std::optional<Json> wanted_;  // what it was asked for last
  std::string trouble_;         // why that cannot be
};

bool SpotTool::Follow(Editor* editor, const ToolInput& input) {
  for (const Chord& chord : input.keys) (void)typed_.Take(chord);
  const Animation* animation = editor->session().animation();
  if (!animation) return false;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const auto spot = MeetsScene(view.Through(input.mouse), animation->scene);
  if (!spot) return true;
  Json wanted = Fixed();
  for (const char axis : axes_) {
    wanted[std::string(1, axis)] = ToCentimetres((*spot)[axis - 'x']);
  }
  if (!typed_.is_empty()) wanted["height"] = typed_.value();
  if (wanted_ == wanted) return true;
  wanted_ = wanted;
  TakeBack(editor);
  trouble_ = Run(editor, id_, wanted) ? "" : editor->message.text;
  return true;
}

class ThrowTool : public SpotTool {
 public:
  ThrowTool(Editor* editor, std::string object)
      : SpotTool(editor, "held.throw_onto", "xyz", "Throw onto the spot under the mouse"),
        object_(std::move(object)) {}

 private:
  Json Fixed() const override { return {{"object", object_}}; }

  std::string object_;
};

}  // namespace

Result<Done> TakeJumpTool(Editor* editor) {
  editor->Take(
      std::make_unique<SpotTool>(editor, "jump.add", "xy", "Jump onto the spot under the mouse"));
  return Done();
}

Result<Done> TakeThrowTool(Editor* editor) {
  const std::vector<ProjectHeldObject>& all = editor->session().project().held_objects;
  const ProjectHeldObject* thrown = SelectedHeldObject(*editor);
  if (!thrown && all.size() == 1) thrown = &all[0];
  if (!thrown) {
    return Error{ErrorCode::kSchema, "", "",
                 all.empty() ? "there is nothing to throw: put a ball into a hand first"
                             : "click on what is to be thrown"};
  }
  editor->Take(std::make_unique<ThrowTool>(editor, thrown->name));
  return Done();
}

}  // namespace hazumi::ui
