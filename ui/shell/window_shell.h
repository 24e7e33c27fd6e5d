#pragma once

#include <functional>
#include <string>

#include "ui/panels/editor.h"

namespace hazumi::ui {

struct WindowOptions {
  std::string state_folder;  // where journals are kept; empty: nowhere
  // Told for each event how long it took until the picture was finished [s]; may be empty.
  std::function<void(double seconds)> trace;
};

// Shows an editor in a window until the user leaves it. Draws when something happened, sleeps
// otherwise. Fails (kFailed) where there is no display or no OpenGL 3.3.
Result<Done> RunInWindow(Editor* editor, const WindowOptions& options);

}  // namespace hazumi::ui
