#include "engine/exchange/reader/read_in_child.h"

#include <signal.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/base/text.h"
#include "engine/exchange/character/character_bytes.h"
#include "engine/exchange/reader/child_process.h"
#include "engine/exchange/reader/exit_codes.h"

namespace hazumi {
namespace {

namespace fs = std::filesystem;
constexpr const char* kReaderName = "hazumi-reader";
constexpr const char* kRemedy =
    "; the file is probably broken: export it again, or in another format";

Error Failed(const std::string& file, const std::string& message,
             ErrorCode code = ErrorCode::kFailed) {
  return {code, file, "", message};
}

std::string TimeMessage(const ReadLimits& limits) {
  return "reading it took more than " + FormatShort(limits.seconds) + " s and was stopped" +
         kRemedy;
}

std::string MemoryMessage(const ReadLimits& limits) {
  return "reading it needed more than " +
         FormatShort(static_cast<double>(limits.memory) / (1024.0 * 1024.0)) +
         " MB of memory and was stopped" + kRemedy;
}

Error SignalError(const std::string& file, int signal, const ReadLimits& limits) {
  if (signal == SIGXCPU) return Failed(file, TimeMessage(limits));
  const char* name = ::sigdescr_np(signal);
  return Failed(
      file, std::string("the reader crashed on it (") + (name ? name : "signal") + ")" + kRemedy);
}

Result<Character> Judge(const std::string& file, const ChildOutcome& outcome,
                        const ReadLimits& limits) {
  using End = ChildOutcome::End;
  switch (outcome.end) {
    case End::kCancelled:
      return Failed(file, "reading it was cancelled", ErrorCode::kInterrupted);
    case End::kTimedOut:
      return Failed(file, TimeMessage(limits));
    case End::kTooMuchOutput:
      return Failed(file, std::string("it holds far too much for a character") + kRemedy);
    case End::kSignalled:
      return SignalError(file, outcome.code, limits);
    case End::kExited:
      break;
  }
  if (outcome.code == kReaderOutOfMemory) return Failed(file, MemoryMessage(limits));
  if (outcome.code != kReaderAnswered) {
    return Failed(file,
                  "the reader crashed on it (exit " + std::to_string(outcome.code) + ")" + kRemedy);
  }
  return CharacterFromBytes(outcome.output, file);
}

}  // namespace

std::string ReaderPath() {
  std::error_code error;
  if (const char* named = std::getenv("HAZUMI_READER"); named && *named) return named;
  fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int up = 0; !error && up <= 4 && folder.has_relative_path(); ++up) {
    if (fs::is_regular_file(folder / kReaderName, error)) return (folder / kReaderName).string();
    error.clear();
    folder = folder.parent_path();
  }
  return "";
}

Result<Character> ReadInChild(const std::string& path, const ReadOptions& options) {
  const std::string reader = options.reader.empty() ? ReaderPath() : options.reader;
  if (std::error_code ignored; reader.empty() || !fs::is_regular_file(reader, ignored)) {
    return Failed(path, std::string("cannot be read, because the program ") +
                            (reader.empty() ? kReaderName : reader) +
                            " is missing; it belongs beside hazumi: install Hazumi again, or set "
                            "HAZUMI_READER to where it is");
  }
  std::vector<std::string> arguments = {
      reader, path, std::to_string(options.limits.memory),
      std::to_string(static_cast<long>(std::ceil(options.limits.seconds)) + 1)};
  if (!options.trouble.empty()) arguments.push_back(options.trouble);
  ChildLimits limits;
  limits.seconds = options.limits.seconds;
  limits.output_bytes = options.limits.answer;
  Result<ChildOutcome> outcome = RunChild(arguments, limits, options.is_cancelled);
  if (!outcome.ok()) return outcome.error();
  return Judge(path, outcome.value(), options.limits);
}

}  // namespace hazumi
