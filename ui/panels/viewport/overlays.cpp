#include "ui/panels/viewport/overlays.h"

#include <algorithm>
#include <string>

#include "ui/edit/parameters.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

const std::vector<OverlaySwitch>& OverlaySwitches() {
  using O = ViewportOverlays;
  static const std::vector<OverlaySwitch> all = {
      {"skin", "Skin", "Skin instead of capsules",
       "The figure's skin, or the capsules that it is computed with", &O::skin},
      {"paths", "Paths", "Motion paths",
       "Paths of hands, feet and the centre of mass, a dot each frame", &O::paths},
      {"ghosts", "Ghosts", "Ghosts", "The figure some frames before (blue) and after (orange)",
       &O::ghosts},
      {"keyed", "Keyed", "Pose of the keys", "Where a region moves joints: the pose of their keys",
       &O::keyed},
      {"marks", "Marks", "Pins and centre of mass", "Where the figure is pinned", &O::marks},
      {"tint", "Regions", "Joints in regions", "Colours what a dynamics region moves", &O::tint},
      {"limits", "Limits", "Joint limits",
       "How far the active hinge turns; pull the ends to change it", &O::limits},
      {"forces", "Forces", "Constraints and forces",
       "What keeps things together (dashed: a gap is open), what acts from outside, and what "
       "pushes where a region touches",
       &O::forces},
      {"effort", "Effort", "Effort colours",
       "What each joint has to give, as a share of its strength: green to red, over 100 % marked",
       &O::effort},
      {"shadow", "Shadow", "Shadow", "The shadow on the ground", &O::shadow}};
  return all;
}

std::vector<int> GhostFrames(const ViewportOverlays& overlays, int now, int last,
                             const std::vector<int>& key_frames) {
  std::vector<int> frames;
  if (!overlays.ghosts) return frames;
  const int from = std::max(now - overlays.ghosts_before, 0);
  const int to = std::min(now + overlays.ghosts_after, last);
  const int every = std::max(overlays.ghost_every, 1);
  for (int frame = from; frame <= to; ++frame) {
    const bool is_wanted = overlays.ghosts_at_keys
                               ? std::binary_search(key_frames.begin(), key_frames.end(), frame)
                               : (frame - now) % every == 0;
    if (is_wanted && frame != now) frames.push_back(frame);
  }
  return frames;
}

Result<Done> SetOverlay(Editor* editor, const edit::Parameters& p) {
  const std::string name = p.text("name");
  std::string known;
  for (const OverlaySwitch& overlay : OverlaySwitches()) {
    bool& is_on = editor->viewport.overlays.*overlay.is_on;
    if (name == overlay.name) {
      is_on = p.yes("on", !is_on);
      return Done();
    }
    known += (known.empty() ? "" : ", ") + std::string(overlay.name);
  }
  return Error{ErrorCode::kSchema, "", "name", "\"" + name + "\" is none of " + known};
}

Result<Done> SetGhosts(Editor* editor, const edit::Parameters& p) {
  for (const char* name : {"every", "before", "after"}) {
    const int frames = p.integer(name, 1);
    if (frames >= kGhostReach.lower && frames <= kGhostReach.upper) continue;
    return Error{ErrorCode::kSchema, "", name, "must be " + edit::Describe(kGhostReach)};
  }
  ViewportOverlays& overlays = editor->viewport.overlays;
  overlays.ghosts = true;
  overlays.ghost_every = p.integer("every", overlays.ghost_every);
  overlays.ghosts_before = p.integer("before", overlays.ghosts_before);
  overlays.ghosts_after = p.integer("after", overlays.ghosts_after);
  overlays.ghosts_at_keys = p.yes("at_keys", overlays.ghosts_at_keys && !p.has("every"));
  return Done();
}

}  // namespace hazumi::ui
