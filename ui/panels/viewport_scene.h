#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "ui/panels/editor.h"

namespace hazumi::ui {

// The frame that the viewport shows: the nearest to the current one that there is.
int FrameShown(const Editor& editor);
// What a picture of this size would depend on now.
PictureKey KeyNow(const Editor& editor, render::PictureSize size);
// The scene as it is now. Errors: of the bake.
Result<render::Scene> SceneNow(Editor* editor, const Rect& rect);

// Of the paths in a scene made by SceneNow.
std::vector<PathTicks> TicksOf(const render::Scene& scene);

// Frames [first, last] of a motion, counted from 0, with `parts` points for every frame: a smooth
// motion between them, by the angles and rates that it has on both sides. Has what paths need:
// angles, root and CoM.
Motion Refined(const Motion& motion, int first, int last, int parts);

}  // namespace hazumi::ui
