#pragma once

#include "ui/panels/commands/actions.h"

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

}  // namespace hazumi::ui
