#include "engine/media/ffmpeg.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "engine/child/child_process.h"

namespace hazumi {

namespace {

constexpr int kNotFound = 127;  // as env ends when there is no such program
constexpr ChildLimits kLimits = {.seconds = 60.0, .output_bytes = 512ull << 20};

// env looks for it in $PATH.
std::vector<std::string> Arguments(const std::filesystem::path& file,
                                   const std::vector<std::string>& output) {
  std::vector<std::string> all = {"/usr/bin/env", "ffmpeg", "-nostdin", "-loglevel", "quiet"};
  const std::vector<std::string> input = MediaInput(file);
  all.insert(all.end(), input.begin(), input.end());
  all.insert(all.end(), output.begin(), output.end());
  all.push_back("pipe:" + std::to_string(kChildOutput));
  return all;
}

// Empty: it can be opened.
std::string WhyNotOpened(const std::filesystem::path& file) {
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) return "is a folder";
  errno = 0;
  if (std::ifstream(file, std::ios::binary)) return "";
  return std::string("cannot be read: ") + std::strerror(errno);
}

}  // namespace

std::vector<std::string> MediaInput(const std::filesystem::path& file) {
  return {"-protocol_whitelist", "file", "-i", "file:" + file.string()};
}

Result<std::string> RunFfmpeg(const std::filesystem::path& file,
                              const std::vector<std::string>& output, const MediaKind& kind,
                              const std::function<bool()>& is_cancelled) {
  using End = ChildOutcome::End;
  const auto error = [&](ErrorCode code, const std::string& message) {
    return Error{code, file.string(), "", message};
  };
  const std::string name = kind.name, unopened = WhyNotOpened(file);
  if (!unopened.empty()) {
    return error(ErrorCode::kNoInput, unopened + "; choose the project's " + name + " again");
  }
  Result<ChildOutcome> run = RunChild(Arguments(file, output), "", kLimits, is_cancelled);
  if (!run.ok()) return run.error();
  const ChildOutcome& outcome = run.value();
  if (outcome.end == End::kCancelled) return error(ErrorCode::kInterrupted, "interrupted");
  if (outcome.end == End::kTimedOut || outcome.end == End::kTooMuchOutput) {
    return error(ErrorCode::kFailed, "is too long a " + name + "; cut it to what is needed");
  }
  if (outcome.end == End::kExited && outcome.code == kNotFound) {
    return error(ErrorCode::kFailed,
                 "the program ffmpeg, which reads it, is not installed; "
                 "on Debian: apt install ffmpeg");
  }
  const bool is_whole = outcome.end == End::kExited && outcome.code == 0;
  if (!is_whole || outcome.output.empty()) {
    return error(ErrorCode::kSyntax,
                 "ffmpeg finds no " + name + " in it, or it is damaged; " + kind.remedy);
  }
  return std::move(run.value().output);
}

}  // namespace hazumi
