// G and R, its handle and its rings: moves and turns the root.

#include <cmath>

#include "ui/panels/viewport/dial.h"
#include "ui/panels/viewport/tools/drag_tool.h"
#include "ui/panels/viewport/tools/point_move_tool.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

bool IsFeetKey(const Chord& chord) { return chord.key == 'F' && !chord.ctrl && !chord.alt; }

// What F does now.
std::string FeetHint(bool feet_stay) {
  return std::string("   F: ") + Tr(feet_stay ? "let the feet come along" : "let the feet stay");
}

class RootMoveTool : public PointMoveTool {
 public:
  using PointMoveTool::PointMoveTool;

 private:
  // Each time from the beginning: feet that were out of reach come back to where they stood.
  bool Place(Editor* editor, const Vec3& offset) override {
    TakeBack(editor);
    const Vec3 to = from() + offset;
    return Run(editor, "root.move",
               {{"x", to.x()}, {"y", to.y()}, {"z", to.z()}, {"feet_stay", feet_stay_}});
  }
  bool TakeKey(const Chord& chord) override {
    if (!IsFeetKey(chord)) return false;
    feet_stay_ = !feet_stay_;
    return true;
  }
  std::string MoreHint() const override { return FeetHint(feet_stay_); }

  bool feet_stay_ = true;
};

class RootTurnTool : public DragTool {
 public:
  RootTurnTool(Editor* editor, const PosedFigure& figure, const View& view)
      : DragTool(editor, "viewport.turn_root ", false),
        name_(figure.figure().root_name()),
        X_WR_(figure.frame().X_WR),
        to_viewer_(view.ToViewer(X_WR_.p)),
        dial_(view.ToWindow(X_WR_.p).value_or(Point{})) {}
  // By one of its rings.
  RootTurnTool(Editor* editor, const PosedFigure& figure, const View& view, const GizmoHit& ring,
               HeldFrom held)
      : DragTool(editor, "viewport.turn_root ", true),
        name_(figure.figure().root_name()),
        X_WR_(figure.frame().X_WR),
        to_viewer_(view.ToViewer(X_WR_.p)),
        ring_axis_(ring.axis),
        dial_(view, X_WR_.p, Axis(), ring.at) {
    BeginAt(held.mouse);
    dial_.BeginAt(held.mouse);
  }

  std::string hint() const override {
    std::string text = std::string(Tr("Rotate")) + " " + name_;
    text += letter_.shown() + ": " +
            (typed_.is_empty() ? Signed(applied_.by_deg, 1) : typed_.shown()) + "\u00b0";
    return text + FeetHint(wanted_feet_stay_) + KeysHint(Tr("axis, twice: its own"));
  }

 private:
  // What the operator was asked for last.
  struct Turned {
    Vec3 axis = Vec3::Zero();
    double by_deg = 0.0;
    bool feet_stay = false;
    bool operator==(const Turned&) const = default;
  };

  bool Follow(Editor* editor, const ToolInput& input) override;
  Vec3 Axis() const;

  std::string name_;
  hazumi::Pose X_WR_;
  Vec3 to_viewer_;
  std::optional<int> ring_axis_;  // of the root, if a ring was taken
  TypedAxis letter_;
  Dial dial_;
  TypedNumber typed_;
  bool wanted_feet_stay_ = false;
  Turned applied_;
};

Vec3 RootTurnTool::Axis() const {
  if (ring_axis_) return X_WR_.R.col(*ring_axis_);
  if (letter_.is_none()) return to_viewer_;
  return letter_.is_own() ? Vec3(X_WR_.R.col(letter_.index())) : Vec3::Unit(letter_.index());
}

bool RootTurnTool::Follow(Editor* editor, const ToolInput& input) {
  for (const Chord& chord : input.keys) {
    if (typed_.Take(chord)) continue;
    if (IsFeetKey(chord)) wanted_feet_stay_ = !wanted_feet_stay_;
    if (!ring_axis_) letter_.Take(chord);
  }
  if (!dial_.has_begun()) dial_.BeginAt(input.mouse);
  dial_.Move(MouseMoved(input));
  // The mouse turns what is seen, a number is about the axis.
  const Vec3 axis = Axis();
  const bool turns_away = !dial_.is_tangential() && axis.dot(to_viewer_) < 0.0;
  const double by_mouse = input.snap ? dial_.snapped_degrees() : dial_.degrees();
  double by = turns_away ? -by_mouse : by_mouse;
  if (!typed_.is_empty()) by = typed_.value();
  const Turned turned = {axis, by, wanted_feet_stay_};
  if (turned == applied_) return true;
  applied_ = turned;
  TakeBack(editor);
  if (by == 0.0) return true;
  return Run(editor, "root.turn",
             {{"x", axis.x()},
              {"y", axis.y()},
              {"z", axis.z()},
              {"by", by},
              {"feet_stay", wanted_feet_stay_}});
}

}  // namespace

void TakeRootMoveTool(Editor* editor, std::optional<HeldFrom> held) {
  const auto figure = PoseNow(&editor->session());
  if (!figure) return;
  editor->Take(std::make_unique<RootMoveTool>(editor, figure->figure().root_name(),
                                              figure->frame().X_WR.p, held));
}

void TakeRootTurnTool(Editor* editor) {
  const auto figure = PoseNow(&editor->session());
  if (!figure) return;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  editor->Take(std::make_unique<RootTurnTool>(editor, *figure, view));
}

void TakeRootRingTool(Editor* editor, const GizmoHit& ring, HeldFrom held) {
  const auto figure = PoseNow(&editor->session());
  if (!figure) return;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  editor->Take(std::make_unique<RootTurnTool>(editor, *figure, view, ring, held));
}

}  // namespace hazumi::ui
