// Tools that act onto the spot under the mouse and show the result while it is chosen: a jump (J),
// a throw (T), a limb that reaches it. A height may be typed meanwhile.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/filled.h"
#include "engine/base/named.h"
#include "engine/makers/jumps/jumps.h"
#include "engine/makers/throws/throws.h"
#include "engine/project/edits/holders.h"
#include "engine/project/enum_names.h"
#include "engine/spatial/degrees.h"
#include "ui/panels/text/number_text.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/tools/drag_tool.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

// What came of it, and whether the animator should think about it again.
struct Told {
  std::string text;
  bool is_caution = false;
};

class SpotTool : public DragTool {
 public:
  bool aims() const override { return true; }
  std::string hint() const override {
    std::string text = std::string(Tr(texts_.what));
    if (!typed_.is_empty()) {
      text += "   " + std::string(Tr(texts_.height)) + ": " + typed_.shown() + " m";
    }
    if (!trouble_.empty()) return text + KeyHint() + "   ! " + trouble_;
    if (*texts_.height) text += "   0-9: " + std::string(Tr(texts_.height));
    text += KeyHint();
    return text + "   Esc: " + Tr("cancel");
  }

 protected:
  struct Texts {
    const char *what, *height,
        *computing;  // what it does, what a typed height is, while it does it
  };
  // An operator that takes the spot's coordinates in `axes` and, if one is typed, a height. One
  // that takes long is run where the mouse rests.
  SpotTool(Editor* editor, const char* id, std::string axes, Texts texts, bool takes_long)
      : DragTool(editor, id, false),
        id_(id),
        axes_(std::move(axes)),
        texts_(texts),
        takes_long_(takes_long) {}

  virtual Json Fixed() const { return Json::object(); }
  // A key of the tool's own; true: it was one.
  virtual bool TakeKey(const Chord&) { return false; }
  virtual std::string KeyHint() const { return ""; }
  // Where it is done if this is under the mouse.
  virtual Vec3 SpotAt(const Vec3& met, const std::vector<SceneObject>&) const { return met; }
  virtual Told Tell(Editor*) const = 0;
  // What cannot be is not confirmed: another spot can be pointed at.
  bool IsConfirmed(const ToolInput& input) const override {
    return input.confirm && trouble_.empty();
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;
  void RunThere(Editor* editor);
  AimedSpot AimedAt(const Vec3& spot) const;

  const char* id_;
  std::string axes_;
  Texts texts_;
  bool takes_long_;
  TypedNumber typed_;
  std::optional<Json> wanted_;  // what it was asked for last
  bool is_due_ = false;         // it has not been done yet
  Told told_;
  std::string trouble_;  // why it cannot be
  // Something was to be done that has to wait: a spot that cannot be, or another key.
  const char* reminder_ = "";
};

bool SpotTool::Follow(Editor* editor, const ToolInput& input) {
  if (!input.keys.empty()) reminder_ = "";
  for (const Chord& chord : input.keys) {
    const bool is_typed = TakeKey(chord) || (*texts_.height && typed_.Take(chord));
    const bool is_other = !is_typed && chord.ctrl;
    if (is_other) reminder_ = Tr("First click to confirm, or press Esc.");
  }
  const Animation* animation = editor->session().animation();
  if (!animation) return false;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const auto met = MeetsScene(view.Through(input.mouse), animation->scene);
  if (!met) return true;
  const Vec3 spot = SpotAt(*met, animation->scene);
  Json wanted = Fixed();
  for (const char axis : axes_) {
    wanted[std::string(1, axis)] = ToCentimetres(spot[axis - 'x']);
  }
  if (!typed_.is_empty()) wanted["height"] = typed_.value();
  const bool rests = wanted_ == wanted;
  if (!rests) {
    reminder_ = "";
    wanted_ = wanted;
    is_due_ = true;
  }
  if (is_due_ && (rests || input.confirm || !takes_long_)) RunThere(editor);
  if (input.confirm && !trouble_.empty()) {
    reminder_ = Tr("Nothing is done yet: point at another spot, or press Esc.");
  }
  editor->viewport.aimed = AimedAt(spot);
  if (!IsConfirmed(input)) return true;
  if (editor->last_frame() > editor->sheet.last) editor->Do("sheet.frame_all");
  if (!told_.text.empty()) editor->Say(told_.text);
  return true;
}

void SpotTool::RunThere(Editor* editor) {
  is_due_ = false;
  TakeBack(editor);
  const Result<Done> done = Try(editor, id_, *wanted_);
  trouble_ = done.ok() ? "" : done.error().message;
  told_ = done.ok() ? Tell(editor) : Told();
}

AimedSpot SpotTool::AimedAt(const Vec3& spot) const {
  AimedSpot aimed;
  aimed.at = spot;
  aimed.text = Filled("x %.2f  y %.2f  z %.2f m\n", WithoutMinusZero(spot.x(), 2),
                      WithoutMinusZero(spot.y(), 2), WithoutMinusZero(spot.z(), 2));
  if (is_due_) {
    aimed.text += Tr(texts_.computing);
  } else {
    aimed.is_trouble = told_.is_caution || !trouble_.empty();
    aimed.text += trouble_.empty() ? told_.text : trouble_;
  }
  if (*reminder_) aimed.text += std::string("\n") + reminder_;
  return aimed;
}

class JumpTool : public SpotTool {
 public:
  JumpTool(Editor* editor, bool is_there)
      : SpotTool(editor, is_there ? "jump.aim" : "jump.add", "xy",
                 {is_there ? "Aim the jump at the spot under the mouse"
                           : "Jump onto the spot under the mouse",
                  "rise of the centre of mass", "Computing the jump"},
                 /*takes_long=*/false) {}

 private:
  // Feet land on top of what is met on its side.
  Vec3 SpotAt(const Vec3& met, const std::vector<SceneObject>& scene) const override {
    constexpr double kAbove = 1000.0;  // [m]
    const Ray down = {{met.x(), met.y(), kAbove}, -Vec3::UnitZ()};
    return MeetsScene(down, scene).value_or(met);
  }

  Told Tell(Editor* editor) const override {
    constexpr double kFewRise = 0.6;  // [m]
    const Project& project = editor->session().project();
    const auto spans = JumpAt(editor->session().frame(), project.placements);
    const Result<const Motion*> motion = editor->session().WholeMotion();
    if (!spans || !motion.ok()) return {};
    const int take_off = project.placements[spans->before].last_frame;
    const int landing = project.placements[spans->flight].last_frame;
    const auto height = [&](int frame) {
      return motion.value()->frames[static_cast<size_t>(frame - editor->first_frame())].com.z();
    };
    double rise = 0.0;
    for (int f = take_off; f <= landing; ++f) rise = std::max(rise, height(f) - height(take_off));
    Told told;
    told.text = Filled(Tr("Takes off in frame %d, rises %.2f m, lands in frame %d."), take_off,
                       rise, landing);
    told.is_caution = rise > kFewRise;
    if (told.is_caution) told.text += std::string(" ") + Tr("Few people can jump so high.");
    return told;
  }
};

class ThrowTool : public SpotTool {
 public:
  ThrowTool(Editor* editor, const ProjectHeldObject& object, bool is_made)
      : SpotTool(editor, is_made ? "held.throw_onto" : "throw.add", "xyz",
                 {is_made ? "Throw onto the spot under the mouse"
                          : "Make a throw onto the spot under the mouse",
                  "rise above the hand", "Computing the throw"},
                 /*takes_long=*/false),
        object_(object.name),
        id_(object.identity.id) {}

 private:
  Json Fixed() const override {
    Json fixed = {{"object", object_}};
    if (style_) fixed["style"] = NameOf(*style_);
    return fixed;
  }

  // S: the next style.
  bool TakeKey(const Chord& chord) override {
    if (!(chord == Chord{'S'})) return false;
    const auto& styles = EnumNames<ThrowStyle>::kNames;
    const int next = (static_cast<int>(style_.value_or(shown_)) + 1) % std::ssize(styles);
    style_ = styles[next].value;
    return true;
  }
  std::string KeyHint() const override {
    return "   S: " + std::string(Tr(TitleOf(style_.value_or(shown_))));
  }
  static const char* TitleOf(ThrowStyle style) {
    switch (style) {
      case ThrowStyle::kUnderarm:
        return "Underarm";
      case ThrowStyle::kOverarm:
        return "Overarm";
      case ThrowStyle::kPush:
        return "Push";
    }
    return "";
  }

  // When it is let go and comes down, how fast it leaves and how high it rises.
  Told Tell(Editor* editor) const override {
    const Result<const Motion*> motion = editor->session().WholeMotion();
    const int object = IndexOf(id_, editor->session().project().held_objects);
    if (!motion.ok() || object < 0) return {};
    const ProjectHeldObject& thrown = editor->session().project().held_objects[object];
    const std::vector<ProjectKey>& keys = thrown.position.curves[0].keys;
    if (keys.empty()) return {};
    const int down = static_cast<int>(keys.back().frame);
    const auto& frames = motion.value()->frames;
    const auto at = [&](size_t i) -> const Vec3& { return frames[i].objects[object].X_WO.p; };
    const size_t last = static_cast<size_t>(down - editor->first_frame());
    size_t i = last;
    if (i >= frames.size()) return {};
    while (i > 0 && !frames[i - 1].objects[object].is_held()) --i;
    if (i == 0 || i + 1 >= frames.size()) return {};
    const Vec3 way = at(i + 1) - at(i);
    double rise = 0.0;
    for (size_t f = i; f <= last; ++f) rise = std::max(rise, at(f).z() - at(i).z());
    Told told;
    told.text =
        Filled(Tr("Lets go in frame %d at %.1f m/s, rises %.2f m above the hand; it comes down in "
                  "frame %d."),
               frames[i].frame, way.norm() / motion.value()->rate.SecondsAt(1), rise, down);
    for (const ProjectGoal& goal : editor->session().project().goals) {
      const bool is_it = goal.kind == GoalKind::kObject && goal.object == object_;
      if (is_it && goal.frame == frames[i].frame) shown_ = goal.style;
    }
    const auto* muscle = FindNamed(editor->session().outcome().measured, "muscle");
    if (muscle && muscle->value > 1.0) {
      told.is_caution = true;
      told.text +=
          " " + Filled(Tr("It asks for %.0f %% of what muscles can give."), 100.0 * muscle->value);
    }
    Warn(frames[i].X_WR.R * Vec3::UnitX(), way, &told);
    return told;
  }

  static void Warn(const Vec3& ahead, const Vec3& way, Told* told) {
    const double turn = std::remainder(
        std::atan2(way.y(), way.x()) - std::atan2(ahead.y(), ahead.x()), 2.0 * std::numbers::pi);
    if (std::abs(turn) <= makers::kWidestThrow) return;
    told->is_caution = true;
    told->text += " " + Filled(Tr("That is %.0f degrees to the side of where the figure faces: "
                                  "turn the figure to it."),
                               std::abs(turn) / kDegree);
  }

  std::string object_;
  ItemId id_;
  std::optional<ThrowStyle> style_;                   // that was chosen
  mutable ThrowStyle shown_ = ThrowStyle::kUnderarm;  // of the throw that is shown
};

class AimTool : public SpotTool {
 public:
  AimTool(Editor* editor, std::string joint)
      : SpotTool(editor, "goal.reach", "xyz",
                 {"Reach the spot under the mouse in this frame", "", "Computing the reach"},
                 /*takes_long=*/true),
        joint_(std::move(joint)) {}

 private:
  Json Fixed() const override { return {{"joint", joint_}}; }
  Told Tell(Editor* editor) const override {
    const AimAnswer answer = AnswerOf(editor->session());
    return {answer.text, answer.is_caution};
  }

  std::string joint_;
};

bool HasHolder(const ProjectHeldObject& object, const edit::Session& session) {
  const auto holders = HoldersOf(object, session.project().frames);
  return HolderAt(static_cast<int>(session.frame()), holders) != nullptr;
}

}  // namespace

Result<Done> TakeJumpTool(Editor* editor) {
  const edit::Session& session = editor->session();
  const bool is_there = JumpAt(session.frame(), session.project().placements).has_value();
  editor->Take(std::make_unique<JumpTool>(editor, is_there));
  return Done();
}

Result<Done> TakeAimTool(Editor* editor) {
  const std::vector<GroupIndex> joints = SelectedJoints(editor->session());
  if (joints.size() != 1) {
    return Error{ErrorCode::kSchema, "", "", Tr("click on the joint that is to reach it, a wrist")};
  }
  editor->Take(std::make_unique<AimTool>(editor, editor->session().figure().group(joints[0]).name));
  return Done();
}

Result<Done> TakeThrowTool(Editor* editor) {
  const std::vector<ProjectHeldObject>& all = editor->session().project().held_objects;
  const ProjectHeldObject* thrown = SelectedHeldObject(*editor);
  if (!thrown && all.size() == 1) thrown = &all[0];
  if (!thrown) {
    return Error{ErrorCode::kSchema, "", "",
                 all.empty() ? Tr("there is nothing to throw: click a wrist, then Scene > Add ball")
                             : Tr("click on what is to be thrown")};
  }
  const int object = static_cast<int>(thrown - all.data());
  edit::Session& session = editor->session();
  const Animation* animation = session.animation();
  const bool is_made =
      animation && makers::HasThrow(object, session.frame(), *animation, session.project());
  if (!is_made && !HasHolder(*thrown, editor->session())) {
    return Error{ErrorCode::kSchema, "", "",
                 Filled(Tr("no hand has \"%s\" in this frame: click a wrist, then Scene > Pass on "
                           "gives it to that hand"),
                        thrown->name.c_str())};
  }
  editor->Take(std::make_unique<ThrowTool>(editor, *thrown, is_made));
  return Done();
}

}  // namespace hazumi::ui
