#pragma once

#include <string>

#include "ui/panels/window/editor.h"
#include "ui/shell/window_trace.h"

namespace hazumi::ui {

struct WindowOptions {
  std::string state_folder;      // where journals are kept; empty: nowhere
  WindowTrace* trace = nullptr;  // told of each event and frame; may be null
};

// Shows an editor in a window until the user leaves it. Draws when something happened, sleeps
// otherwise. Fails (kFailed) where there is no display or no OpenGL 3.3.
Result<Done> RunInWindow(Editor* editor, const WindowOptions& options);

}  // namespace hazumi::ui
