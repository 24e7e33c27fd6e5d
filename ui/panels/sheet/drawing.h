#pragma once

#include <imgui.h>

#include <optional>

#include "ui/panels/sheet/frame.h"
#include "ui/panels/window/editor.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

// Shapes of the dope sheet and the graph editor, with ImGui's lists.

inline ImVec2 UpperLeft(const Rect& rect) { return {rect.x, rect.y}; }
inline ImVec2 LowerRight(const Rect& rect) { return {rect.right(), rect.bottom()}; }

struct KeyLook {
  std::optional<Interpolation> kind;  // none: several that differ
  KeyType type = KeyType::kKeyframe;
  bool is_selected = false;
};
// A key: diamond cubic, circle linear, triangle quadratic, square hold, hexagon eased; a diamond
// with a hole where several differ. Coloured by its type if it is not selected. `radius` [px].
void DrawKey(ImDrawList* list, Point at, float radius, const KeyLook& look);

// Slanting lines: what is computed by a dynamics region.
void DrawHatch(ImDrawList* list, const Rect& rect, const Rect& clip, ImU32 color, float step);

// A text on the left of a rectangle, in the middle of its height, cut off at its right end.
void DrawLabel(ImDrawList* list, const Rect& rect, const std::string& text, ImU32 color);

// What the sheets share: frames that are not played in shade, lines at frames; then, above what the
// panel draws, the ruler with events, markers and the playhead.
void DrawTimeGrid(ImDrawList* list, const Editor& editor, const SheetFrame& frame);
void DrawRuler(ImDrawList* list, Editor* editor, const SheetFrame& frame);

// The row of the sound: its wave, and its file's name or what is wrong with it.
void DrawSoundRow(ImDrawList* list, Editor* editor, const SheetFrame& frame);

// The button in the corner, on or off.
void DrawCornerToggle(ImDrawList* list, const Editor& editor, const Rect& corner,
                      const std::string& text, bool is_on);

// Wheel and middle button: rows are scrolled, time is moved and zoomed. `content` height [px].
void NavigateTime(Editor* editor, const SheetFrame& frame);
// Clicks on the ruler and the markers; true if there was one.
bool ClickRuler(Editor* editor, const SheetFrame& frame, Point mouse);
// The right button opens what can be done with a marker, or else with keys.
void RightClickSheet(Editor* editor, const SheetFrame& frame, Point mouse);

}  // namespace hazumi::ui
