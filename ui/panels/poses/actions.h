#pragma once

#include "ui/panels/commands/actions.h"
#include "ui/panels/viewport/tools/tools.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What can be done with the poses of the library: saving, applying, renaming, removing. The keys
// that a pose becomes are made by the operator pose.blend, which names their values, so that undo,
// journals and recorded scripts need no library.
std::vector<Action> PoseLibraryActions();

// A pose on the project's figure: curves and values. Of what is selected; of all that the pose has
// and the figure too if nothing is.
struct PoseOnFigure {
  std::vector<std::string> curves;
  std::vector<double> values;             // degrees, of the root's height metres
  std::vector<std::string> unknown = {};  // hinges that the figure does not have
};
Result<PoseOnFigure> OnFigure(const SavedPose& pose, bool is_flipped, edit::Session* session);

// Puts a tool in hand that gives an action or operator its parameter `share`: by the mouse to the
// right or left, or by typed percent. E lets it go beyond 0 and 100 %, where the operator may.
// Held: as long as the mouse button is down; it begins at 0 %.
Result<Done> TakeShareTool(Editor* editor, const std::string& id, Json parameters,
                           std::optional<HeldFrom> held = std::nullopt);

}  // namespace hazumi::ui
