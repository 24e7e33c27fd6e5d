#pragma once

// What the export dialog says about a file before it is written, in the interface's language.

#include <string>
#include <vector>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// "22 joints, 48 frames, 30 fps, 1.6 s, 310 kB" and what the format has beside that, a line each.
// `summary` is not needed for a video.
std::vector<std::string> ExportFacts(const Editor& editor, const ExportSummary* summary);
// What a user might look for in the file and will not find: "2 regions", "ball".
std::vector<std::string> LeftOut(const Editor& editor, const ExportSummary* summary);

}  // namespace hazumi::ui
