#include <algorithm>
#include <cstdlib>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal.h"
#include "engine/project/text_file.h"
#include "ui/edit/script.h"
#include "ui/edit/state_folder.h"
#include "ui/panels/actions.h"
#include "ui/shell/scripted_editor.h"
#include "ui/shell/window_shell.h"

namespace hazumi {

namespace {

Result<Done> Open(const Options& options, ui::Editor* editor) {
  if (options.files.empty()) return Done();
  return editor->Invoke("file.open", {{"path", options.files[0]}});
}

// How long events took until their picture was finished.
class Trace {
 public:
  void Add(double seconds) { milliseconds_.push_back(1e3 * seconds); }
  void Print(const ui::Playback& playback) {
    PrintLine(stdout, "playback %d frames shown, %d dropped, at most %.0f ms late",
              playback.frames(), playback.dropped(), 1e3 * playback.latest());
    if (milliseconds_.empty()) return;
    std::sort(milliseconds_.begin(), milliseconds_.end());
    PrintLine(stdout, "events %zu, event to picture: median %.1f ms, 99 of 100 within %.1f ms",
              milliseconds_.size(), At(0.5), At(0.99));
  }

 private:
  double At(double share) const {
    return milliseconds_[static_cast<size_t>(share * (milliseconds_.size() - 1))];
  }
  std::vector<double> milliseconds_;
};

}  // namespace

// A signal ends it at once, as a crash does: its journal is there when it is started again.
int RunWindow(const Options& options) {
  LeaveInterruptsAlone();
  ui::Editor editor;
  const Result<Done> opened = Open(options, &editor);
  if (!opened.ok()) return Complain(opened.error());
  ui::WindowOptions window;
  const Result<std::string> state =
      edit::StateFolder([](const char* name) { return std::getenv(name); });
  if (state.ok()) window.state_folder = state.value();
  if (!state.ok()) editor.Say(state.error().ToString(), true);
  Trace trace;
  if (options.trace) window.trace = [&](double seconds) { trace.Add(seconds); };
  const Result<Done> done = ui::RunInWindow(&editor, window);
  if (options.trace) trace.Print(editor.playback);
  return done.ok() ? kExitOk : Complain(done.error());
}

int RunEdits(const Options& options) {
  const Result<std::string> text = ReadTextFile(options.script);
  if (!text.ok()) return Complain(text.error());
  const PictureSize size = options.size.value_or(PictureSize{1280, 800});
  ui::ScriptedEditor scripted({size.width, size.height});
  scripted.editor().session().set_saves_checked(true);
  const Result<Done> opened = Open(options, &scripted.editor());
  if (!opened.ok()) return Complain(opened.error());
  const Result<Done> done =
      edit::RunScript(text.value(), options.script,
                      [&](const std::string& id, const edit::Json& p) -> Result<Done> {
                        if (Interrupted()) return InterruptedError();
                        return scripted.Do(id, p);
                      });
  if (!done.ok()) return Complain(done.error());
  if (!scripted.editor().session().document().is_saved()) {
    PrintLine(stderr, "hazumi: %s: the project is changed but not saved; end with \"file.save\"",
              options.script.c_str());
  }
  return kExitOk;
}

namespace {

void PrintParameters(const std::vector<edit::ParameterInfo>& infos) {
  for (const edit::ParameterInfo& info : infos) {
    const std::string offered = edit::Describe(info.offer.thing);
    PrintLine(stdout, "    %s%s: %s, %s%s", info.name, info.is_required ? "" : " (optional)",
              edit::Describe(info.kind), info.help,
              offered.empty() ? "" : (" (" + offered + ")").c_str());
  }
}

}  // namespace

// One a paragraph: id and sentence, then its parameters; of the session, then of the editor.
int RunOperators() {
  for (const edit::Operator& op : edit::AllOperators()) {
    PrintLine(stdout, "%s: %s", op.id, op.help);
    PrintParameters(op.parameters);
  }
  for (const ui::Action& action : ui::AllActions()) {
    PrintLine(stdout, "%s: %s", action.id, action.help);
    PrintParameters(action.parameters);
  }
  return kExitOk;
}

}  // namespace hazumi
