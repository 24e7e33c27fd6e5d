#include <imgui.h>

#include "ui/panels/viewport/goal_marks.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::ui {

namespace {

// A ring around the place, and a line to it from the point that is to be there; of an arc its top
// as a small diamond.
void Draw(const Editor& editor, const View& view, const GoalMark& mark) {
  const auto point = view.ToWindow(mark.point), place = view.ToWindow(mark.place);
  const ImU32 color = ToIm(colors::kGoal), edge = ToIm(colors::kShade, 0.8f);
  const float width = Px(editor, 2.0), radius = Px(editor, 7.0);
  if (const auto top = mark.top ? view.ToWindow(*mark.top) : std::nullopt) {
    const float r = Px(editor, 6.0);
    const auto diamond = [&](float arm, ImU32 of) {
      Canvas()->AddQuadFilled({top->x, top->y - arm}, {top->x + arm, top->y},
                              {top->x, top->y + arm}, {top->x - arm, top->y}, of);
    };
    diamond(1.4f * r, edge);
    diamond(r, color);
  }
  if (!point || !place) return;
  const Project& project = editor.session().project();
  const bool is_thrown = project.goals[static_cast<size_t>(mark.index)].kind == GoalKind::kObject;
  if (!is_thrown) DrawDashedLine(*point, *place, color, width);
  Canvas()->AddCircle(ToIm(*place), radius, edge, 24, 2.0f * width);
  Canvas()->AddCircle(ToIm(*place), radius, color, 24, width);
  Canvas()->AddCircleFilled(ToIm(*place), Px(editor, 2.5), color, 16);
  DrawShadedText({place->x + 1.5f * radius, place->y - ImGui::GetTextLineHeight()},
                 TextOf(mark, project).c_str());
}

}  // namespace

void DrawGoals(Editor* editor, const View& view, const PosedFigure& figure) {
  for (const GoalMark& mark : GoalMarksNow(editor, figure)) Draw(*editor, view, mark);
}

}  // namespace hazumi::ui
