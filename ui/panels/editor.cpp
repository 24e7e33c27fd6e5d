#include "ui/panels/editor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/panels/actions.h"

namespace hazumi::ui {

Editor::Editor() = default;

Result<Done> Editor::Invoke(const std::string& id, const Json& parameters) {
  Result<Done> done = Done();
  if (const Action* action = FindAction(id)) {
    const auto checked = edit::Parameters::Check(action->parameters, parameters);
    done = checked.ok() ? action->run(this, checked.value()) : checked.error();
  } else {
    done = session_.Run(id, parameters);
  }
  if (!done.ok()) Say(done.error().ToString(), true);
  return done;
}

void Editor::Tick(double now) {
  now_ = now;
  if (playback.is_on()) session_.set_frame(playback.FrameAt(now));
}

double Editor::NextDeadline() const {
  if (!playback.is_on()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, playback.NextFrameTime(now_) - now_);
}

void Editor::Take(std::unique_ptr<Tool> next) {
  ToolInput cancel;
  cancel.cancel = true;
  if (tool_) tool_->Update(this, cancel);
  tool_ = std::move(next);
}

void Editor::UpdateTool(const ToolInput& input) {
  if (!tool_) return;
  std::unique_ptr<Tool> tool = std::move(tool_);
  const bool stays = tool->Update(this, input);
  if (stays && !tool_) tool_ = std::move(tool);
}

}  // namespace hazumi::ui
