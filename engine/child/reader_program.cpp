#include "engine/child/reader_program.h"

#include <signal.h>
#include <string.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "engine/base/text.h"
#include "engine/child/exit_codes.h"

namespace hazumi {
namespace {

namespace fs = std::filesystem;
constexpr const char* kReaderName = "hazumi-reader";
// As the loader and shells end when a program cannot be run.
constexpr int kCannotRun = 126, kNotFound = 127;

Error Because(ErrorCode code, const std::string& message) { return {code, "", "", message}; }

Error TookTooLong(const ReadLimits& limits) {
  return Because(ErrorCode::kSyntax,
                 "reading it took more than " + FormatShort(limits.seconds) + " s and was stopped");
}

Error TookTooMuch(const ReadLimits& limits) {
  const double megabytes = static_cast<double>(limits.memory) / (1024.0 * 1024.0);
  return Because(ErrorCode::kSyntax, "reading it needed more than " + FormatShort(megabytes) +
                                         " MB of memory and was stopped");
}

Error Crashed(const std::string& how) {
  return Because(ErrorCode::kSyntax, "the reader crashed on it (" + how + ")");
}

Error Signalled(int signal, const ReadLimits& limits) {
  if (signal == SIGXCPU) return TookTooLong(limits);
  const char* name = ::sigdescr_np(signal);
  return Crashed(name ? name : "signal");
}

std::optional<Error> Exited(int code, const ReadLimits& limits) {
  if (code == kReaderAnswered) return std::nullopt;
  if (code == kReaderOutOfMemory) return TookTooMuch(limits);
  const std::string exit = "exit " + std::to_string(code);
  if (code == kReaderUsage || code == kCannotRun || code == kNotFound) {
    std::string message = "the program ";
    message.append(kReaderName).append(" does not work here (").append(exit);
    return Because(ErrorCode::kFailed, message.append("): install Hazumi again"));
  }
  return Crashed(exit);
}

// Folders in which the reader is looked for: that of this program, and the installed one.
std::vector<fs::path> ReaderFolders(const fs::path& folder) {
  return {folder, folder.parent_path() / "libexec" / "hazumi"};
}

std::string& ElsewherePath() {
  static std::string path;
  return path;
}

}  // namespace

void SetReaderPath(const std::string& path) { ElsewherePath() = path; }

std::string ReaderPath() {
  if (!ElsewherePath().empty()) return ElsewherePath();
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return "";
  for (const fs::path& folder : ReaderFolders(program.parent_path())) {
    if (fs::is_regular_file(folder / kReaderName, error)) return (folder / kReaderName).string();
  }
  return "";
}

Result<ChildOutcome> RunReader(const ReaderTask& task, const ReadOptions& options) {
  const std::string reader = options.reader.empty() ? ReaderPath() : options.reader;
  if (std::error_code ignored; reader.empty() || !fs::is_regular_file(reader, ignored)) {
    return Because(ErrorCode::kFailed,
                   "cannot be read, because the program " +
                       (reader.empty() ? kReaderName : reader) +
                       " is missing; it belongs beside hazumi, or in libexec/hazumi beside its "
                       "folder: install Hazumi again");
  }
  const long cpu_seconds = static_cast<long>(std::ceil(options.limits.seconds)) + 1;
  std::vector<std::string> arguments = {reader,
                                        task.kind,
                                        std::to_string(options.limits.memory),
                                        std::to_string(cpu_seconds),
                                        task.file,
                                        options.character,
                                        FormatNumber(options.rate),
                                        options.keys_all_frames ? "1" : "0"};
  if (!options.trouble.empty()) arguments.push_back(options.trouble);
  ChildLimits limits;
  limits.seconds = options.limits.seconds;
  limits.output_bytes = options.limits.answer;
  return RunChild(arguments, task.input, limits, options.is_cancelled);
}

std::optional<Error> WhyNoAnswer(const ChildOutcome& outcome, const ReadLimits& limits) {
  using End = ChildOutcome::End;
  switch (outcome.end) {
    case End::kCancelled:
      return Because(ErrorCode::kInterrupted, "reading it was cancelled");
    case End::kTimedOut:
      return TookTooLong(limits);
    case End::kTooMuchOutput:
      return Because(ErrorCode::kSyntax, "it holds far too much");
    case End::kSignalled:
      return Signalled(outcome.code, limits);
    case End::kExited:
      break;
  }
  return Exited(outcome.code, limits);
}

}  // namespace hazumi
