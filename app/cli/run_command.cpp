#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/terminal.h"
#include "engine/project/text_file.h"
#include "ui/edit/script.h"

namespace hazumi {

int RunEdits(const Options& options) {
  const Result<std::string> text = ReadTextFile(options.script);
  if (!text.ok()) return Complain(text.error());
  edit::Session session;
  if (!options.files.empty()) {
    const Result<Done> opened = session.Run("file.open", {{"path", options.files[0]}});
    if (!opened.ok()) return Complain(opened.error());
  }
  const Result<Done> done = edit::RunScript(text.value(), options.script, &session);
  if (!done.ok()) return Complain(done.error());
  if (!session.document().is_saved()) {
    PrintLine(stderr, "hazumi: %s: the project is changed but not saved; end with \"file.save\"",
              options.script.c_str());
  }
  return kExitOk;
}

// One operator a paragraph: id and sentence, then its parameters.
int RunOperators() {
  for (const edit::Operator& op : edit::AllOperators()) {
    PrintLine(stdout, "%s: %s", op.id, op.help);
    for (const edit::ParameterInfo& info : op.parameters) {
      PrintLine(stdout, "    %s%s: %s, %s", info.name, info.is_required ? "" : " (optional)",
                edit::Describe(info.kind), info.help);
    }
  }
  return kExitOk;
}

}  // namespace hazumi
