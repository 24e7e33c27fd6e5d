#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "render/motion/motion_scene.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// The frame that the viewport shows: the nearest to the current one that there is.
int FrameShown(const Editor& editor);
// What a picture of this size would depend on now.
PictureKey KeyNow(const Editor& editor, render::PictureSize size);
// How the figure is drawn.
render::FigureLook LookOf(const ViewportOverlays& overlays);
// The scene as it is now, and where its paths are at each frame.
struct ViewportScene {
  render::Scene scene;
  std::vector<PathTicks> ticks;
};
// Errors: of the bake.
Result<ViewportScene> SceneNow(Editor* editor, const Rect& rect);

// A motion with more instants than frames, for paths. Has what these need: angles, root and CoM.
struct RefinedMotion {
  Motion motion;
  std::vector<size_t> at_frames;  // which of them are frames of the original
};
// Frames [first, last], counted from 0, and between two of them as many instants as it takes for no
// joint and not the root to turn by more than a few degrees: a smooth motion, by the angles and
// rates that there are on both sides.
RefinedMotion Refined(const Motion& motion, int first, int last);

}  // namespace hazumi::ui
