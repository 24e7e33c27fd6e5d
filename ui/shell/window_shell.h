#pragma once

#include "ui/panels/editor.h"

namespace hazumi::ui {

// Shows an editor in a window until the user leaves it. Draws when something happened, sleeps
// otherwise. Fails (kFailed) where there is no display or no OpenGL 3.3.
Result<Done> RunInWindow(Editor* editor);

}  // namespace hazumi::ui
