#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

Rect Between(Point a, Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

// Names of the joints whose marks are in a rectangle of the window, and of the root; not of hidden
// ones.
std::vector<std::string> JointsIn(const Rect& box, const View& view, const PosedFigure& figure) {
  std::vector<std::string> names;
  const auto is_in = [&](const Vec3& p) {
    const std::optional<Point> at = view.ToWindow(p);
    return at && box.Contains(*at);
  };
  if (!figure.is_root_hidden() && is_in(figure.frame().X_WR.p)) {
    names.push_back(figure.figure().root_name());
  }
  for (int g = 0; g < static_cast<int>(figure.figure().groups().size()); ++g) {
    const GroupIndex joint(g);
    if (figure.IsHidden(joint) || !is_in(figure.CenterOf(joint))) continue;
    names.push_back(figure.figure().group(joint).name);
  }
  return names;
}

// Waits for the button, then goes from where it went down to where it comes up.
class BoxTool : public Tool {
 public:
  std::string hint() const override {
    return std::string(Tr("Box select joints")) + "   " +
           Tr("Shift: add   Ctrl: remove   Esc: cancel");
  }

  bool Update(Editor* editor, const ToolInput& input) override {
    std::optional<Rect>& box = editor->viewport.box;
    if (input.cancel) {
      box.reset();
      return false;
    }
    if (input.is_pressed) from_ = input.mouse;
    if (!from_) return true;
    box = Between(*from_, input.mouse);
    if (input.is_held) return true;
    Select(editor, *box, input.precise ? "add" : input.snap ? "remove" : "replace");
    box.reset();
    return false;
  }

 private:
  static void Select(Editor* editor, const Rect& box, const char* mode) {
    const auto figure = PoseNow(&editor->session());
    if (!figure) return;
    const ViewportState& state = editor->viewport;
    const View view = ViewOf(state, editor->session().project(), state.rect);
    editor->Do("select.joints", {{"joints", JointsIn(box, view, *figure)}, {"mode", mode}});
  }

  std::optional<Point> from_;
};

}  // namespace

Result<Done> TakeBoxTool(Editor* editor) {
  editor->Take(std::make_unique<BoxTool>());
  return Done();
}

}  // namespace hazumi::ui
