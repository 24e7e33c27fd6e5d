#include "ui/panels/viewport/contact_marks.h"

#include <imgui.h>

#include <algorithm>

#include "engine/base/filled.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/viewport/nearest_line.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::ui {

namespace {

// An arrow is so long for the weight of the figure, within bounds [m]; two thousandths have none.
constexpr double kOfWeight = 0.8, kShortestArrow = 0.08, kLongestArrow = 1.2, kLeastShare = 2e-3;

// None while they are hidden.
std::vector<ContactMark> ContactsNow(Editor* editor, const PosedFigure& figure) {
  const Animation* animation = editor->session().animation();
  if (!editor->viewport.overlays.forces || !animation) return {};
  return ContactMarks(*animation, figure);
}

}  // namespace

std::vector<ContactMark> ContactMarks(const Animation& animation, const PosedFigure& figure) {
  std::vector<ContactMark> marks;
  const double weight = figure.figure().total_mass() * animation.gravity;
  const auto has = [](int i, size_t count) { return i >= 0 && static_cast<size_t>(i) < count; };
  for (const ContactPush& push : figure.frame().contacts.pushes) {
    // The motion may be from before an edit, with others.
    if (!has(push.link, figure.figure().links().size())) continue;
    if (!has(push.by_link, figure.figure().links().size()) &&
        !has(push.by_ball, animation.held_objects.size()) &&
        !has(push.object, animation.scene.size())) {
      continue;
    }
    const double force = push.force.norm();
    if (weight <= 0.0 || force < kLeastShare * weight) continue;
    const double length = std::clamp(kOfWeight * force / weight, kShortestArrow, kLongestArrow);
    marks.push_back({push, push.p, push.p + length / force * push.force, force});
  }
  return marks;
}

std::string TextOf(const ContactMark& mark, const Animation& animation) {
  const auto& links = animation.figure->links();
  const ContactParts& parts = mark.parts;
  const std::string& by = parts.by_link >= 0   ? links[parts.by_link].name
                          : parts.by_ball >= 0 ? animation.held_objects[parts.by_ball].name
                                               : animation.scene[parts.object].name;
  return links[parts.link].name + ", " + by + ": " + Filled("%.0f N", mark.force);
}

void DrawContacts(Editor* editor, const View& view, const PosedFigure& figure) {
  const ImU32 color = ToIm(colors::kOuterForce);
  for (const ContactMark& mark : ContactsNow(editor, figure)) {
    const auto from = view.ToWindow(mark.from), to = view.ToWindow(mark.to);
    if (!from || !to) continue;
    Canvas()->AddCircleFilled(ToIm(*from), Px(*editor, 3.0), color, 12);
    DrawArrow(*from, *to, color, Px(*editor, 2.0));
  }
}

std::string ContactAt(Editor* editor, const View& view, const PosedFigure& figure, Point mouse) {
  const std::vector<ContactMark> marks = ContactsNow(editor, figure);
  const double scale = editor->settings.scale;
  const ContactMark* mark = NearestLine(view, mouse, marks, scale);
  return mark ? TextOf(*mark, *editor->session().animation()) : "";
}

}  // namespace hazumi::ui
