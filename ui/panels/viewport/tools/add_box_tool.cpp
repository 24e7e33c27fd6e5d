// A new box, as other editors draw one: its base is dragged out on what is under the mouse, then
// the mouse gives its height, and a click ends it. Edges can be typed meanwhile, Tab between them;
// typed before anything is dragged they give a box whose base has its middle under the mouse.

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/filled.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/text/number_text.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/tools/drag_tool.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

// Where on the vertical through a point a ray passes nearest [m]; none if it is vertical too.
std::optional<double> HeightOver(const Vec3& point, const Ray& ray) {
  const Vec3 w = ray.from - point;
  const double slope = ray.direction.z(), square = 1.0 - slope * slope;
  if (square < 1e-6) return std::nullopt;
  return (w.z() - slope * ray.direction.dot(w)) / square;
}

constexpr double kClicked = 0.5, kLeast = 0.03, kLeastHeight = 0.01;  // [m]

// With Ctrl, as other things are moved [m].
double Snapped(double metres) { return 0.05 * std::round(metres / 0.05); }

class AddBoxTool : public DragTool {
 public:
  explicit AddBoxTool(Editor* editor)
      : DragTool(editor, "object.add_box ", false),
        name_(FreeObjectName("box", editor->session().project())) {}

  bool aims() const override { return true; }
  std::string hint() const override;

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;
  bool IsConfirmed(const ToolInput& input) const override {
    return is_whole_ || (has_base_ && input.confirm);
  }
  void TakeKeys(const ToolInput& input);
  bool Aim(Editor* editor, const Ray& ray, const ToolInput& input);
  void DragBase(const Ray& ray, bool snap);
  void TakeTyped();
  bool Show(Editor* editor);

  bool is_typed() const {
    return std::any_of(typed_.begin(), typed_.end(), [](const auto& t) { return !t.is_empty(); });
  }

  std::string name_;
  std::array<TypedNumber, 3> typed_;  // edges
  int edge_ = 0;                      // that a number is typed for
  std::optional<Vec3> corner_;        // where the button went down [m]
  bool has_base_ = false, is_whole_ = false;
  Vec3 opposite_ = Vec3::Zero();                      // corner of the base
  Vec3 middle_ = Vec3::Zero(), size_ = Vec3::Zero();  // of the base, and of the box [m]
};

std::string AddBoxTool::hint() const {
  const bool is_sized = corner_ || is_typed();
  const char* what = !is_sized    ? "Drag out the base of a box, or click for one of 50 cm"
                     : !corner_   ? "Click where the middle of its base is to be"
                     : !has_base_ ? "The base of the box"
                                  : "Move up to its height and click";
  std::string text = Tr(what);
  for (int i = 0; i < 3 && is_sized; ++i) {
    text += i ? " x " : "   ";
    text += typed_[i].is_empty() ? Filled("%.2f", size_[i]) : typed_[i].shown();
  }
  if (is_sized) text += " m";
  return text + "   0-9: " + Tr("edges") + "   Tab: " + Tr("the next edge") +
         "   Ctrl: " + Tr("snap") + "   Esc: " + Tr("cancel");
}

void AddBoxTool::TakeKeys(const ToolInput& input) {
  for (const Chord& chord : input.keys) {
    if (chord == Chord{kTab}) edge_ = (edge_ + 1) % 3;
    typed_[edge_].Take(chord);
  }
}

void AddBoxTool::TakeTyped() {
  for (int i = 0; i < 3; ++i) {
    const double edge = std::abs(typed_[i].value());
    if (!typed_[i].is_empty() && edge > 0.0) size_[i] = edge;
  }
}

// Under the mouse the base begins or, with edges typed, has its middle.
bool AddBoxTool::Aim(Editor* editor, const Ray& ray, const ToolInput& input) {
  TakeBack(editor);  // the mouse does not meet the box that is shown
  const Animation* animation = editor->session().animation();
  if (!animation) return false;
  std::optional<Vec3> met = MeetsScene(ray, animation->scene);
  if (!met) return true;
  if (input.snap) met->head<2>() = met->head<2>().unaryExpr(&Snapped);
  editor->viewport.aimed =
      AimedSpot{*met, Filled("x %.2f  y %.2f  z %.2f m", WithoutMinusZero(met->x(), 2),
                             WithoutMinusZero(met->y(), 2), WithoutMinusZero(met->z(), 2))};
  if (is_typed()) {
    middle_ = *met;
    size_.setConstant(kClicked);
    TakeTyped();
    is_whole_ = input.confirm;
    return Show(editor);
  }
  if (!input.is_pressed) return true;
  corner_ = opposite_ = middle_ = *met;
  size_.z() = kLeastHeight;
  return true;
}

void AddBoxTool::DragBase(const Ray& ray, bool snap) {
  const double along = (corner_->z() - ray.from.z()) / ray.direction.z();
  if (!(along > 0.0)) return;  // above the horizon
  opposite_ = ray.from + along * ray.direction;
  if (snap) opposite_.head<2>() = opposite_.head<2>().unaryExpr(&Snapped);
}

bool AddBoxTool::Show(Editor* editor) {
  TakeBack(editor);
  const double z = middle_.z() + 0.5 * size_.z();
  return Run(editor, "object.add_box",
             {{"name", name_},
              {"x", ToCentimetres(middle_.x())},
              {"y", ToCentimetres(middle_.y())},
              {"z", 1e-3 * std::round(1e3 * z)},
              {"size_x", size_.x()},
              {"size_y", size_.y()},
              {"size_z", size_.z()}});
}

bool AddBoxTool::Follow(Editor* editor, const ToolInput& input) {
  TakeKeys(input);
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const Ray ray = view.Through(input.mouse);
  if (!corner_ && (!Aim(editor, ray, input) || !corner_)) return true;
  if (has_base_) {
    const double height = HeightOver(opposite_, ray).value_or(size_.z());
    size_.z() = std::max(kLeastHeight, ToCentimetres(height));
  } else {
    DragBase(ray, input.snap);
    has_base_ = !input.is_held;
    if (has_base_ && !is_typed()) edge_ = 2;
  }
  const Vec3 way = opposite_ - *corner_;
  size_.head<2>() = way.head<2>().cwiseAbs().unaryExpr(&ToCentimetres);
  if (has_base_ && size_.head<2>().maxCoeff() < kLeast && !is_typed()) {
    is_whole_ = true;
    size_.setConstant(kClicked);
    return Show(editor);
  }
  size_.head<2>() = size_.head<2>().cwiseMax(kLeast);
  TakeTyped();
  for (int i = 0; i < 2; ++i) {
    middle_[i] = (*corner_)[i] + std::copysign(0.5 * size_[i], way[i]);
  }
  return Show(editor);
}

}  // namespace

Result<Done> TakeAddBoxTool(Editor* editor) {
  editor->Take(std::make_unique<AddBoxTool>(editor));
  return Done();
}

}  // namespace hazumi::ui
