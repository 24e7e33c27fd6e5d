// J: a jump onto what is under the mouse, seen while it is chosen.

#include <cmath>
#include <limits>

#include "ui/panels/viewport/drag_tool.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/tools.h"

namespace hazumi::ui {

namespace {

// Where a ray meets the scene first; none if it does not.
std::optional<Vec3> MeetsScene(const Ray& ray, const std::vector<SceneObject>& scene) {
  double least = std::numeric_limits<double>::infinity();
  for (const SceneObject& object : scene) {
    std::optional<double> distance;
    if (const Box* box = std::get_if<Box>(&object.shape)) distance = Enter(ray, *box);
    if (const Plane* plane = std::get_if<Plane>(&object.shape)) {
      const double towards = -plane->normal.dot(ray.direction);
      const double above = plane->normal.dot(ray.from) - plane->offset;
      if (towards > 0.0 && above > 0.0) distance = above / towards;
    }
    if (distance) least = std::min(least, *distance);
  }
  if (!std::isfinite(least)) return std::nullopt;
  return ray.from + least * ray.direction;
}

class JumpTool : public DragTool {
 public:
  explicit JumpTool(Editor* editor) : DragTool(editor, "viewport.jump ", false) {}

  std::string hint() const override {
    std::string text = std::string(Tr("Jump onto the spot under the mouse"));
    if (!typed_.is_empty()) {
      text += "   " + std::string(Tr("height")) + " " + typed_.shown() + " m";
    }
    if (!trouble_.empty()) return text + "   ! " + trouble_;
    return text + "   0-9: " + Tr("height") + "   Esc: " + Tr("cancel");
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;

  TypedNumber typed_;
  std::optional<Json> wanted_;  // what it was asked for last
  std::string trouble_;         // why there is no such jump
};

bool JumpTool::Follow(Editor* editor, const ToolInput& input) {
  for (const Chord& chord : input.keys) (void)typed_.Take(chord);
  const Animation* animation = editor->session().animation();
  if (!animation) return false;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const auto spot = MeetsScene(view.Through(input.mouse), animation->scene);
  if (!spot) return true;
  constexpr double kStep = 0.01;  // [m]
  // Adding 0 leaves no -0.
  const auto rounded = [](double metres) { return kStep * std::round(metres / kStep) + 0.0; };
  Json wanted = {{"x", rounded(spot->x())}, {"y", rounded(spot->y())}};
  if (!typed_.is_empty()) wanted["height"] = typed_.value();
  if (wanted_ == wanted) return true;
  wanted_ = wanted;
  TakeBack(editor);
  trouble_ = Run(editor, "jump.add", wanted) ? "" : editor->message.text;
  return true;
}

}  // namespace

Result<Done> TakeJumpTool(Editor* editor) {
  editor->Take(std::make_unique<JumpTool>(editor));
  return Done();
}

}  // namespace hazumi::ui
