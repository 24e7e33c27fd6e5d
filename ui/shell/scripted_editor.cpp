#include "ui/shell/scripted_editor.h"

#include <utility>
#include <vector>

#include "engine/base/text.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::ui {

Result<Done> ScriptedEditor::Do(const std::string& id, const edit::Json& parameters) {
  using edit::ParameterInfo;
  if (id != "capture" && id != "wait") return editor_.Invoke(id, parameters);
  const std::vector<ParameterInfo> infos = {
      id == "wait" ? ParameterInfo{"seconds", edit::ParameterKind::kNumber, true, "how long"}
                   : ParameterInfo{"path", edit::ParameterKind::kText, true, "a .png file"}};
  const auto checked = edit::Parameters::Check(infos, parameters);
  if (!checked.ok()) return checked.error();
  if (id == "capture" && !LowerCase(checked.value().text("path")).ends_with(".png")) {
    return Refusal("path", "capture writes pictures; name a .png file");
  }
  if (!shell_) {
    auto made = OffscreenShell::Create(&editor_, size_);
    if (!made.ok()) return made.error();
    shell_ = std::move(made).value();
  }
  if (id == "capture") return shell_->Capture(checked.value().text("path"));
  shell_->Frame(checked.value().number("seconds"));
  return Done();
}

}  // namespace hazumi::ui
