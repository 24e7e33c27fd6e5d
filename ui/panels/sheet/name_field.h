#pragma once

#include <optional>
#include <string>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A field for a name in a small window, which has the keyboard when that opens; Enter closes it.
// Gives the name once another one was typed.
std::optional<std::string> NameField(Editor* editor, const std::string& name);

}  // namespace hazumi::ui
