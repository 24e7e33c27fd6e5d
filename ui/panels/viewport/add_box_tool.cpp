// A new box, as other editors draw one: its base is dragged out on what is under the mouse, then
// the mouse gives its height, and a click ends it.

#include <cmath>

#include "ui/edit/operators/edits.h"
#include "ui/panels/viewport/drag_tool.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/object_actions.h"
#include "ui/panels/viewport/tools.h"

namespace hazumi::ui {

namespace {

// Where on the vertical through a point a ray passes nearest [m]; none if it is vertical too.
std::optional<double> HeightOver(const Vec3& point, const Ray& ray) {
  const Vec3 w = ray.from - point;
  const double slope = ray.direction.z(), square = 1.0 - slope * slope;
  if (square < 1e-6) return std::nullopt;
  return (w.z() - slope * ray.direction.dot(w)) / square;
}

class AddBoxTool : public DragTool {
 public:
  explicit AddBoxTool(Editor* editor)
      : DragTool(editor, "object.add_box ", false),
        name_(edit::FreeName(std::string("box"), editor->session().project().scene.objects)) {}

  bool aims() const override { return true; }
  std::string hint() const override {
    const char* what = !corner_     ? "Drag out the base of a box, or click for one of 50 cm"
                       : !has_base_ ? "The base of the box"
                                    : "Move up to its height and click";
    std::string text = Tr(what);
    if (corner_) {
      char size[60];
      std::snprintf(size, sizeof size, "   %.2f x %.2f x %.2f m", size_.x(), size_.y(), size_.z());
      text += size;
    }
    return text + "   Esc: " + Tr("cancel");
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;
  bool IsConfirmed(const ToolInput& input) const override {
    return is_whole_ || (has_base_ && input.confirm);
  }
  void DragBase(const Ray& ray);
  bool Show(Editor* editor);

  std::string name_;
  std::optional<Vec3> corner_;  // where the button went down [m]
  bool has_base_ = false, is_whole_ = false;
  Vec3 opposite_ = Vec3::Zero();                      // corner of the base
  Vec3 middle_ = Vec3::Zero(), size_ = Vec3::Zero();  // of the base, and of the box [m]
};

void AddBoxTool::DragBase(const Ray& ray) {
  const double along = (corner_->z() - ray.from.z()) / ray.direction.z();
  if (!(along > 0.0)) return;  // above the horizon
  opposite_ = ray.from + along * ray.direction;
  middle_ = 0.5 * (opposite_ + *corner_);
  size_.head<2>() = (opposite_ - *corner_).head<2>().cwiseAbs().unaryExpr(&ToCentimetres);
}

bool AddBoxTool::Show(Editor* editor) {
  TakeBack(editor);
  const double z = corner_->z() + 0.5 * size_.z();
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
  constexpr double kClicked = 0.5, kLeast = 0.03, kLeastHeight = 0.01;  // [m]
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const Ray ray = view.Through(input.mouse);
  if (!corner_) {
    const Animation* animation = editor->session().animation();
    if (!animation) return false;
    if (input.is_pressed) corner_ = MeetsScene(ray, animation->scene);
    if (!corner_) return true;
    opposite_ = *corner_;
    size_.z() = kLeastHeight;
  }
  if (has_base_) {
    const double height = HeightOver(opposite_, ray).value_or(size_.z());
    size_.z() = std::max(kLeastHeight, ToCentimetres(height));
    return Show(editor);
  }
  DragBase(ray);
  has_base_ = !input.is_held;
  if (has_base_ && size_.head<2>().maxCoeff() < kLeast) {
    is_whole_ = true;
    size_.setConstant(kClicked);
    middle_ = *corner_;
  }
  size_.head<2>() = size_.head<2>().cwiseMax(kLeast);
  return Show(editor);
}

}  // namespace

Result<Done> TakeAddBoxTool(Editor* editor) {
  editor->Take(std::make_unique<AddBoxTool>(editor));
  return Done();
}

}  // namespace hazumi::ui
