#pragma once

#include <vector>

#include "ui/edit/parameters.h"
#include "ui/panels/viewport/state.h"

namespace hazumi::ui {

class Editor;

// What can be switched on and off beside the figure.
struct OverlaySwitch {
  const char* name;  // as in view.overlay
  const char* label;
  const char* in_menu;
  const char* help;
  bool ViewportOverlays::*is_on;
};

// In the order in which they are offered.
const std::vector<OverlaySwitch>& OverlaySwitches();

// Frames, counted from the first one, of which a ghost is seen while `now` is; ascending, without
// `now`. `key_frames`: in order. All lie from 0 to `last`.
std::vector<int> GhostFrames(const ViewportOverlays& overlays, int now, int last,
                             const std::vector<int>& key_frames);

inline constexpr NumberRange kGhostReach = {1.0, 1000.0};  // frames

// The actions view.overlay and view.ghosts.
Result<Done> SetOverlay(Editor* editor, const edit::Parameters& p);
Result<Done> SetGhosts(Editor* editor, const edit::Parameters& p);

}  // namespace hazumi::ui
