#pragma once

#include <string>

struct ImFontAtlas;

namespace hazumi::ui {

// Fills the atlas for a size of text [px]: Latin, signs, and those Japanese letters that `texts`
// has. False if there is no font with them on this machine: then ImGui's own stands in, or boxes.
bool BuildFonts(float size_px, const std::string& texts, ImFontAtlas* atlas);

}  // namespace hazumi::ui
