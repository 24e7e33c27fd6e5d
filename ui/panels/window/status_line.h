#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Of a motion that goes on being computed, or was stopped; else empty.
std::string BakingText(const Editor& editor);
// What the right of the status bar says: file, frame, memory of the undo history, version; the most
// important first.
std::vector<std::string> StatusParts(const Editor& editor);
// As much of a tool's hint as has room: its parts are three spaces apart, the first one stays.
std::string FittingHint(const std::string& hint, float room,
                        const std::function<float(const std::string&)>& width_of);
// "12 kB", "3.4 MB".
std::string MemoryText(size_t bytes);

}  // namespace hazumi::ui
