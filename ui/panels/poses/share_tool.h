#pragma once

#include "ui/panels/viewport/tools/tools.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Puts a tool in hand that gives an action or operator its parameter `share`: by the mouse to the
// right or left, or by typed percent. E lets it go beyond 0 and 100 %, where the operator may.
// Held: as long as the mouse button is down; it begins at 0 %.
Result<Done> TakeShareTool(Editor* editor, const std::string& id, Json parameters,
                           std::optional<HeldFrom> held = std::nullopt);

}  // namespace hazumi::ui
