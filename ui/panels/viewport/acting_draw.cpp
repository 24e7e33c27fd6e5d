#include <imgui.h>

#include <cmath>

#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/viewport/acting.h"
#include "ui/panels/viewport/contact_marks.h"
#include "ui/panels/viewport/goal_marks.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::ui {

namespace {

// A cross over the middle of a line.
void DrawCross(Point at, float arm, ImU32 color, float width) {
  Canvas()->AddLine({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, color, width);
  Canvas()->AddLine({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, color, width);
}

// A line with a dot at each end, dashed while a gap is open, and with a cross once it is broken.
// Where both ends lie on one another a ring goes around them and the joint.
void Draw(const Editor& editor, const View& view, const ConstraintMark& mark, bool is_chosen) {
  const auto a = view.ToWindow(mark.a), b = view.ToWindow(mark.b);
  if (!a || !b) return;
  const SrgbColor& meant = is_chosen        ? colors::kSelected
                           : mark.is_broken ? colors::kSinking
                           : mark.is_open() ? colors::kChanged
                                            : colors::kHeld;
  const ImU32 color = ToIm(meant), edge = ToIm(colors::kShade, 0.8f);
  const float width = Px(editor, is_chosen ? 3.0 : 2.0), radius = Px(editor, 4.0);
  if (std::hypot(a->x - b->x, a->y - b->y) < radius) {
    Canvas()->AddCircle(ToIm(*a), 2.3f * radius, edge, 24, 2.0f * width);
    Canvas()->AddCircle(ToIm(*a), 2.3f * radius, color, 24, width);
  } else {
    const bool is_dashed = mark.is_open() || mark.is_broken;
    if (is_dashed) DrawDashedLine(*a, *b, color, width);
    if (!is_dashed) Canvas()->AddLine(ToIm(*a), ToIm(*b), color, width);
    for (const Point& end : {*a, *b}) {
      Canvas()->AddCircleFilled(ToIm(end), radius, color, 16);
      Canvas()->AddCircle(ToIm(end), radius, edge, 16);
    }
  }
  if (!mark.is_broken) return;
  DrawCross({0.5f * (a->x + b->x), 0.5f * (a->y + b->y)}, Px(editor, 6.0), color, width);
}

// An arrow, or a dashed line to a ring around where something is pulled to.
void Draw(const Editor& editor, const View& view, const ForceMark& mark) {
  const auto from = view.ToWindow(mark.from), to = view.ToWindow(mark.to);
  if (!from || !to || mark.strength == 0.0) return;
  const ImU32 color = ToIm(colors::kOuterForce);
  const float width = Px(editor, 3.0);
  Point text = *from;
  if (mark.kind == ForceKind::kAttract) {
    DrawDashedLine(*from, *to, color, Px(editor, 2.0));
    Canvas()->AddCircle(ToIm(*to), Px(editor, 8.0), color, 24, Px(editor, 2.0));
    Canvas()->AddCircleFilled(ToIm(*to), Px(editor, 2.5), color, 16);
    text = *to;
  } else {
    DrawArrow(*from, *to, color, width);
  }
  DrawShadedText({text.x + Px(editor, 8.0), text.y - ImGui::GetTextLineHeight() - Px(editor, 4.0)},
                 TextOf(mark).c_str());
}

// None while they are hidden, or nothing is known of the motion.
std::vector<ConstraintMark> MarksNow(Editor* editor, const PosedFigure& figure) {
  edit::Session& session = editor->session();
  const Animation* animation = session.animation();
  if (!editor->viewport.overlays.forces || !animation || animation->constraints.empty()) return {};
  const Result<const Motion*> motion = session.ShownMotionTo(FrameShown(*editor));
  if (!motion.ok()) return {};
  return ConstraintMarks(*animation, *motion.value(), figure);
}

std::vector<ForceMark> ForcesNow(Editor* editor, const PosedFigure& figure) {
  const Animation* animation = editor->session().animation();
  if (!editor->viewport.overlays.forces || !animation) return {};
  return ForceMarks(*animation, figure);
}

}  // namespace

void DrawActing(Editor* editor, const View& view, const PosedFigure& figure) {
  const Project& project = editor->session().project();
  DrawContacts(editor, view, figure);
  for (const ForceMark& mark : ForcesNow(editor, figure)) Draw(*editor, view, mark);
  DrawGoals(editor, view, figure);
  const std::optional<BarRef> chosen = ChosenBar(project, editor->sheet);
  for (const ConstraintMark& mark : MarksNow(editor, figure)) {
    Draw(*editor, view, mark, chosen == BarRef{BarKind::kConstraint, mark.index});
  }
}

std::string ActingAt(Editor* editor, const View& view, const PosedFigure& figure, Point mouse) {
  const std::vector<ConstraintMark> marks = MarksNow(editor, figure);
  const double scale = editor->settings.scale;
  const Project& project = editor->session().project();
  if (const ConstraintMark* mark = ConstraintAt(view, mouse, marks, scale)) {
    return TextOf(*mark, project);
  }
  const std::vector<ForceMark> forces = ForcesNow(editor, figure);
  const ForceMark* force = ForceAt(view, mouse, forces, scale);
  if (force) return project.forces[force->index].name + ": " + TextOf(*force);
  const auto part = GoalPartAt(view, mouse, GoalMarksNow(editor, figure), project, scale);
  if (part) return part->goal + ": " + Tr("drag it, and it is aimed again");
  return ContactAt(editor, view, figure, mouse);
}

bool ChooseConstraintAt(Editor* editor, const View& view, const PosedFigure& figure, Point mouse) {
  const std::vector<ConstraintMark> marks = MarksNow(editor, figure);
  const ConstraintMark* mark = ConstraintAt(view, mouse, marks, editor->settings.scale);
  if (mark) ChooseBar(editor, {BarKind::kConstraint, mark->index});
  return mark != nullptr;
}

}  // namespace hazumi::ui
