#pragma once

#include "ui/edit/parameters.h"
#include "ui/panels/window/editor.h"

// What places the figure or holds a joint from the current frame on: until something else begins
// that does, or to the end. For the list in actions.cpp. The new span is the chosen one.
namespace hazumi::ui::span {

using edit::Parameters;

// By the selected joint; refused if there is none.
Result<Done> Pin(Editor* editor, const Parameters&);
Result<Done> Hold(Editor* editor, const Parameters&);
Result<Done> Gravity(Editor* editor, const Parameters&);

}  // namespace hazumi::ui::span
