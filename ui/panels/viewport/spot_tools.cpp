// What is done onto the spot under the mouse, seen while it is chosen: a jump (J) and a throw (T).
// A height may be typed meanwhile.

#include <cmath>

#include "ui/edit/operators/held/throws.h"
#include "ui/panels/text/filled.h"
#include "ui/panels/viewport/drag_tool.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/object_actions.h"
#include "ui/panels/viewport/tools.h"

namespace hazumi::ui {

namespace {

class SpotTool : public DragTool {
 public:
  // An operator that takes the spot's coordinates in `axes` and, if one is typed, a height. One
  // that takes long is run where the mouse rests.
  SpotTool(Editor* editor, const char* id, std::string axes, const char* what, bool takes_long)
      : DragTool(editor, id, false),
        id_(id),
        axes_(std::move(axes)),
        what_(what),
        takes_long_(takes_long) {}

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
  // What came of it.
  virtual std::string Told(Editor*) const { return ""; }
  // What cannot be is not confirmed: another spot can be pointed at.
  bool IsConfirmed(const ToolInput& input) const override {
    return input.confirm && trouble_.empty();
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;
  void RunThere(Editor* editor);

  const char* id_;
  std::string axes_;
  const char* what_;
  bool takes_long_;
  TypedNumber typed_;
  std::optional<Json> wanted_;  // what it was asked for last
  bool is_due_ = false;         // it has not been done yet
  std::string told_, trouble_;  // what came of it; why it cannot be
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
  const bool rests = wanted_ == wanted;
  if (!rests) {
    wanted_ = wanted;
    is_due_ = true;
  }
  if (is_due_ && (rests || input.confirm || !takes_long_)) RunThere(editor);
  const std::string shown = trouble_.empty() ? told_ : trouble_;
  editor->viewport.aimed =
      AimedSpot{*spot, is_due_ ? Tr("Computing the throw") : shown, !is_due_ && !trouble_.empty()};
  if (!IsConfirmed(input)) return true;
  if (editor->last_frame() > editor->sheet.last) editor->Do("sheet.frame_all");
  if (!told_.empty()) editor->Say(told_);
  return true;
}

void SpotTool::RunThere(Editor* editor) {
  is_due_ = false;
  TakeBack(editor);
  const Result<Done> done = Try(editor, id_, *wanted_);
  trouble_ = done.ok() ? "" : done.error().message;
  told_ = done.ok() ? Told(editor) : "";
}

class ThrowTool : public SpotTool {
 public:
  ThrowTool(Editor* editor, const ProjectHeldObject& object, bool is_made)
      : SpotTool(editor, is_made ? "held.throw_onto" : "throw.add", "xyz",
                 is_made ? "Throw onto the spot under the mouse"
                         : "Make a throw onto the spot under the mouse",
                 /*takes_long=*/true),
        object_(object.name),
        id_(object.identity.id) {}

 private:
  Json Fixed() const override { return {{"object", object_}}; }

  // When it is let go and comes down, and how fast it leaves.
  std::string Told(Editor* editor) const override {
    const Result<const Motion*> motion = editor->session().WholeMotion();
    const int object = IndexOf(id_, editor->session().project().held_objects);
    if (!motion.ok() || object < 0) return "";
    const ProjectHeldObject& thrown = editor->session().project().held_objects[object];
    const std::vector<ProjectKey>& keys = thrown.position.curves[0].keys;
    if (keys.empty()) return "";
    const int down = static_cast<int>(keys.back().frame);
    const auto& frames = motion.value()->frames;
    size_t i = static_cast<size_t>(down - editor->first_frame());
    if (i >= frames.size()) return "";
    while (i > 0 && !frames[i - 1].objects[object].is_held()) --i;
    if (i == 0 || i + 1 >= frames.size()) return "";
    const Vec3 way = frames[i + 1].objects[object].X_WO.p - frames[i].objects[object].X_WO.p;
    return Filled(Tr("Lets go in frame %d at %.1f m/s; it comes down in frame %d."),
                  frames[i].frame, way.norm() / motion.value()->rate.SecondsAt(1), down);
  }

  std::string object_;
  ItemId id_;
};

}  // namespace

Result<Done> TakeJumpTool(Editor* editor) {
  editor->Take(std::make_unique<SpotTool>(editor, "jump.add", "xy",
                                          "Jump onto the spot under the mouse", false));
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
  const int object = static_cast<int>(thrown - all.data());
  const bool is_made = edit::HasThrow(object, &editor->session());
  editor->Take(std::make_unique<ThrowTool>(editor, *thrown, is_made));
  return Done();
}

}  // namespace hazumi::ui
