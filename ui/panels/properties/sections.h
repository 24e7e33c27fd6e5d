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

// Rows for the drives of a region, a copy of the project's.
void DrawDrives(Editor* editor, const ProjectRegion& region);

// The fields of the chosen span of placement or hold, as rows of the properties: in these, and in
// the small window that a double click on its bar opens.
void DrawSpanFields(Editor* editor);

}  // namespace hazumi::ui
