#pragma once

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Each fills the panel of properties with a section. To be called inside its window.
void DrawPoseSection(Editor* editor);
void DrawPosesSection(Editor* editor);
void DrawRegionSection(Editor* editor);
void DrawSceneSection(Editor* editor);
void DrawProjectSection(Editor* editor);
void DrawProblemsSection(Editor* editor);
void DrawSweepSection(Editor* editor);
void DrawFlights(Editor* editor);  // of the project

}  // namespace hazumi::ui
