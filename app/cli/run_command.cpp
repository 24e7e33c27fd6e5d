#include <cstdio>
#include <cstdlib>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/completion.h"
#include "app/cli/exit_codes.h"
#include "app/cli/help_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal.h"
#include "engine/project/json/text_file.h"
#include "engine/project/project_reader.h"
#include "ui/edit/recovery/recovery.h"
#include "ui/edit/script.h"
#include "ui/panels/commands/actions.h"
#include "ui/shell/scripted_editor.h"
#include "ui/shell/settings_file.h"
#include "ui/shell/window_shell.h"

namespace hazumi {

namespace {

Result<Done> Open(const Options& options, ui::Editor* editor) {
  if (options.files.empty()) return Done();
  return editor->Invoke("file.open", {{"path", options.files[0]}});
}

void PrintTrace(const ui::WindowTrace& trace) {
  PrintLine(stdout,
            "playback %d frames shown, %d passed over, %d late by more than a frame's time, "
            "the latest by %.0f ms",
            trace.frames(), trace.passed_over(), trace.late_frames(), 1e3 * trace.latest());
  PrintLine(stdout, "events %d, of which %d changed the project", trace.events(), trace.changes());
  if (trace.typed() > 0) {
    PrintLine(stdout, "typing: %d events to picture: median %.1f ms, 99 of 100 within %.1f ms",
              trace.typed(), 1e3 * trace.TypingTimeOf(0.5), 1e3 * trace.TypingTimeOf(0.99));
  }
  if (trace.changes() == 0) return;
  PrintLine(stdout,
            "change to picture: median %.1f ms, 99 of 100 within %.1f ms; in %d the motion "
            "was still the one before",
            1e3 * trace.TimeOf(0.5), 1e3 * trace.TimeOf(0.99), trace.behind());
}

// A line of JSON: the operator, the addresses of what it made, and what it measured.
void PrintOutcome(const std::string& id, const edit::Outcome& outcome) {
  edit::Json json = {{"op", id}, {"made", outcome.made}, {"measured", edit::Json::object()}};
  for (const Named<double>& each : outcome.measured) json["measured"][each.name] = each.value;
  std::printf("%s\n", json.dump(-1, ' ', false, edit::Json::error_handler_t::replace).c_str());
}

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
  ui::WindowTrace trace;
  if (options.trace) window.trace = &trace;
  const Result<Done> done = ui::RunInWindow(&editor, window);
  if (options.trace) PrintTrace(trace);
  return done.ok() ? kExitOk : Complain(done.error());
}

int RunEdits(const Options& options) {
  const Result<std::string> text = ReadTextFile(options.script);
  if (!text.ok()) return Complain(text.error());
  KeepInput(options.script, InputKind::kScript);
  const PictureSize size = options.size.value_or(PictureSize{1280, 800});
  ui::ScriptedEditor scripted({size.width, size.height});
  scripted.editor().session().set_saves_checked(true);
  scripted.editor().session().media() = edit::MediaAccess(options.open_outside);
  scripted.editor().poses.library.set_path(ui::PosesPath());
  const Result<Done> opened = Open(options, &scripted.editor());
  if (!opened.ok()) return Complain(opened.error());
  const Result<Done> done =
      edit::RunScript(text.value(), options.script,
                      [&](const std::string& id, const edit::Json& p) -> Result<Done> {
                        if (Interrupted()) return InterruptedError();
                        scripted.editor().session().ForgetOutcome();
                        Result<Done> step = scripted.Do(id, p);
                        if (step.ok() && options.json) {
                          PrintOutcome(id, scripted.editor().session().outcome());
                        }
                        return step;
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
    std::string what = edit::Describe(info.kind);
    const std::string named = Describe(info.offer.thing), range = edit::Describe(info.range);
    if (info.unit[0] != '\0') what += std::string(" in ") + info.unit;
    if (!range.empty()) what += " " + range;
    if (!named.empty()) what += ", " + named;
    PrintLine(stdout, "    %s%s: %s: %s", info.name, info.is_required ? "" : " (optional)",
              what.c_str(), info.help);
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

int RunSchema() {
  std::fputs(ProjectSchema().c_str(), stdout);
  return kExitOk;
}

int RunManual() {
  std::fputs(ManPage().c_str(), stdout);
  return kExitOk;
}

int RunCompletion(const Options& options) {
  std::fputs(CompletionFor(options.shell).c_str(), stdout);
  return kExitOk;
}

}  // namespace hazumi
