#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/panels/commands/keys.h"
#include "ui/panels/window/editor.h"
#include "ui/panels/window/geometry.h"
#include "ui/panels/window/theme.h"

namespace hazumi::ui {

// What the panel that is drawn just now draws on.
inline ImDrawList* Canvas() { return ImGui::GetWindowDrawList(); }
inline ImVec2 ToIm(Point p) { return {p.x, p.y}; }
inline Point FromIm(const ImVec2& p) { return {p.x, p.y}; }
inline ImVec4 ToIm4(const SrgbColor& c) { return {c.r, c.g, c.b, c.a}; }
inline ImU32 ToIm(const SrgbColor& c, float alpha = 1.0f) {
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a * alpha});
}

// A window without a frame that fills a rectangle of the main window. End with EndPanel.
bool BeginPanel(const char* name, const Rect& rect, const SrgbColor& background);
void EndPanel();

// Shows what the last item does, with its key, when the mouse rests on it; with `even_disabled`
// also where it cannot be done. It covers neither the item nor its neighbours (TooltipPlace).
void Tooltip(const std::string& text, const std::string& key = "", bool even_disabled = false);
// The same at once, of what is no item: `item` is where it is.
void TooltipOf(const Rect& item, const std::string& text, const std::string& key = "");

// Keys that were pressed since the last frame, with the modifiers that are held. Letters do not
// repeat: they choose.
std::vector<Chord> PressedKeys(bool with_repeats);

// The colours and measures of ImGui's own widgets.
void ApplyTheme(const Theme& theme, double scale);

// A length at the interface's scale [px].
inline float Px(const Editor& editor, double at_scale_1) {
  return static_cast<float>(at_scale_1 * editor.settings.scale);
}

// Small signs, drawn as shapes so that none depends on a font.
void DrawHatch(ImDrawList* list, const Rect& rect, ImU32 color);  // computed by a region
void DrawDiamond(ImDrawList* list, Point center, float radius, ImU32 color, bool is_filled);
// An eye, open or shut, and a padlock, as wide as high.
void DrawEye(ImDrawList* list, Point center, float radius, ImU32 color, bool is_open);
void DrawLock(ImDrawList* list, Point center, float radius, ImU32 color, bool is_locked);
void DrawDot(ImDrawList* list, Point center, float radius, ImU32 color);
// Points down when open, else to the right.
void DrawTriangle(ImDrawList* list, Point center, float radius, ImU32 color, bool is_open);

}  // namespace hazumi::ui
