#include <filesystem>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/terminal.h"
#include "app/cli/verify.h"
#include "engine/base/version.h"

namespace hazumi {

namespace {

int PrintVerdict(const Verdict& verdict) {
  for (const std::string& remark : verdict.remarks) PrintLine(stderr, "hazumi: %s", remark.c_str());
  PrintLine(stdout, "%s", verdict.sentence.c_str());
  return verdict.is_same ? kExitOk : kExitFailed;
}

}  // namespace

std::string MadeByText() { return "Hazumi " + ProgramVersion(); }

void RemarkOnMaker(const std::string& maker, Verdict* verdict) {
  if (maker == MadeByText()) return;
  verdict->remarks.push_back("made by " + (maker.empty() ? "an older program" : maker) +
                             "; this is " + MadeByText());
}

Result<Options> OptionsToMakeAgain(const std::vector<std::string>& task,
                                   const std::vector<std::string>& given,
                                   const std::string& project) {
  std::vector<std::string> words = task;
  words.insert(words.end(), given.begin(), given.end());
  words.push_back(project);
  Result<Options> options = ParseWords(words);
  if (options.ok()) return options;
  return Error{ErrorCode::kSchema, "", "options",
               "this program cannot make it again: " + options.error().message};
}

int RunVerify(const Options& options) {
  const std::string &project = options.files[0], &made = options.files[1];
  const Result<Verdict> verdict = std::filesystem::is_directory(made)
                                      ? VerifyPictures(project, made, options.open_outside)
                                      : VerifyMotion(project, made);
  if (!verdict.ok()) return Complain(InFile(verdict.error(), made));
  return PrintVerdict(verdict.value());
}

}  // namespace hazumi
