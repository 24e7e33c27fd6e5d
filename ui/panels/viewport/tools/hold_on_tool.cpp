// What the selected joint is to hold on to is pointed at, and clicked: a box, a held object, the
// ground, another joint.

#include <cmath>

#include "engine/base/filled.h"
#include "engine/project/checks/constraint_checks.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

constexpr int kArriveFrames = 5;  // as long as "constraint.hold_on" gives a hand

// Something to hold on to.
struct Target {
  std::string name;
  bool is_joint = false;
  Vec3 at = Vec3::Zero();  // where it is held, world [m]
};

class HoldOnTool : public Tool {
 public:
  HoldOnTool(Editor* editor, GroupIndex joint)
      : joint_(joint), name_(editor->session().figure().group(joint).name) {
    editor->playback.Stop();
    editor->Do("edit.end_drag");
    editor->Say("");
  }

  bool aims() const override { return true; }
  std::string hint() const override {
    const std::string text = Filled(Tr("Click what %s is to hold on to"), name_.c_str());
    return text + "   Esc: " + Tr("cancel");
  }

  bool Update(Editor* editor, const ToolInput& input) override {
    const auto figure = PoseNow(&editor->session());
    if (input.cancel || !figure) return false;
    const std::optional<Target> target = TargetAt(editor, *figure, input.mouse);
    if (!target) return true;
    if (input.confirm && HoldOn(editor, *target)) return false;
    const bool is_refused = refused_ == target->name;
    editor->viewport.aimed = AimedSpot{target->at, is_refused ? trouble_ : target->name, is_refused,
                                       figure->CenterOf(joint_)};
    return true;
  }

 private:
  std::optional<Target> TargetAt(Editor* editor, const PosedFigure& figure, Point mouse) const {
    const ViewportState& state = editor->viewport;
    if (!state.rect.Contains(mouse)) return std::nullopt;
    const View view = ViewOf(state, editor->session().project(), state.rect);
    const std::vector<Solid> solids = SolidsOf(&editor->session(), figure);
    const ViewportHit hit = HitTest(view, mouse, figure, solids, editor->settings.scale);
    if (hit.joint == joint_) return std::nullopt;
    if (hit.joint) {
      const std::string& name = figure.figure().group(*hit.joint).name;
      return Target{name, true, figure.CenterOf(*hit.joint)};
    }
    if (hit.is_root) {
      const std::string& name = figure.figure().root_name();
      return Target{name, true, figure.frame().X_WR.p};
    }
    const Ray ray = view.Through(mouse);
    if (const Solid* solid = FindSolid(hit.object, solids)) {
      const auto along =
          std::visit([&](const auto& shape) { return Enter(ray, shape); }, solid->shape);
      return Target{solid->name, false, ray.from + along.value_or(0.0) * ray.direction};
    }
    const Animation* animation = editor->session().animation();
    const auto met = animation ? HitScene(ray, animation->scene) : std::nullopt;
    if (!met) return std::nullopt;
    return Target{animation->scene[met->object].name, false, met->at};
  }

  Result<Done> Hold(Editor* editor, const Target& target) const {
    if (target.is_joint) {
      return editor->Invoke("constraint.add", {{"kind", "point"},
                                               {"a_joint", name_},
                                               {"b_joint", target.name},
                                               {"arrive", kArriveFrames}});
    }
    const auto whole = [](double metres) { return std::round(1000.0 * metres) / 1000.0; };
    return editor->Invoke("constraint.hold_on", {{"joint", name_},
                                                 {"object", target.name},
                                                 {"x", whole(target.at.x())},
                                                 {"y", whole(target.at.y())},
                                                 {"z", whole(target.at.z())}});
  }

  // False: it is refused, and something else can be clicked.
  bool HoldOn(Editor* editor, const Target& target) {
    const Result<Done> done = Hold(editor, target);
    if (!done.ok()) {
      refused_ = target.name;
      trouble_ = done.error().message;
      return false;
    }
    const Project& project = editor->session().project();
    const int last = static_cast<int>(project.constraints.size()) - 1;
    ChooseBar(editor, {BarKind::kConstraint, last});
    const Animation* animation = editor->session().animation();
    const bool is_felt = animation && IsFelt(animation->constraints[last], *animation);
    editor->Say(
        Filled(Tr(is_felt ? "%s holds on to %s." : kNotFelt), name_.c_str(), target.name.c_str()));
    return true;
  }

  static constexpr const char* kNotFelt =
      "%s holds on to %s once a dynamics region moves one of them: mark one in these frames.";

  GroupIndex joint_;
  std::string name_;
  std::string refused_, trouble_;  // what was refused last, and why
};

}  // namespace

Result<Done> TakeHoldOnTool(Editor* editor) {
  const std::vector<GroupIndex> joints = SelectedJoints(editor->session());
  if (joints.size() != 1) {
    return Error{ErrorCode::kSchema, "", "", Tr("click on the joint that is to hold on, a wrist")};
  }
  editor->Take(std::make_unique<HoldOnTool>(editor, joints[0]));
  return Done();
}

}  // namespace hazumi::ui
