#pragma once

#include <memory>
#include <string>

#include "ui/panels/window/editor.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::ui {

// An editor that a script drives: `--run`. Only pictures need a context to draw with.
class ScriptedEditor {
 public:
  explicit ScriptedEditor(render::PictureSize size) : size_(size) {}
  Editor& editor() { return editor_; }

  // Beside what the editor knows: "capture" draws it, "wait" lets time pass. Errors: of
  // Editor::Invoke, OffscreenShell.
  Result<Done> Do(const std::string& id, const edit::Json& parameters);

 private:
  render::PictureSize size_;
  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

}  // namespace hazumi::ui
