// What the graph editor shows.

#include "ui/panels/commands/actions.h"

namespace hazumi::ui {

namespace {

using edit::Parameters;

Result<Done> Normalize(Editor* editor, const Parameters&) {
  editor->sheet.normalize = !editor->sheet.normalize;
  editor->sheet.fits_values = true;
  return Done();
}

Result<Done> ShowTorque(Editor* editor, const Parameters&) {
  editor->sheet.torque = !editor->sheet.torque;
  if (editor->sheet.torque) editor->sheet.kind = SheetKind::kGraph;
  return Done();
}

}  // namespace

std::vector<Action> GraphActions() {
  return {{"sheet.normalize",
           "Normalize",
           "Draws each curve as high as the graph, or to scale.",
           {},
           Normalize},
          {"sheet.torque",
           "Torque",
           "Shows the torque that the motion needs below the curves, beside what muscles can give.",
           {},
           ShowTorque}};
}

}  // namespace hazumi::ui
