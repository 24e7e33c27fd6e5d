#include "engine/media/ffmpeg.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "engine/child/child_process.h"

namespace hazumi {

namespace {

constexpr int kNoProgram = 127;  // exit code of env and prlimit if there is no such program
constexpr ChildLimits kLimits = {.seconds = 60.0, .output_bytes = 512ull << 20};

// Formats that contain their sounds and pictures. Left out: playlists and lists of files (hls,
// dash, concat, image2), text drawn as pictures (tty), devices, networks.
constexpr const char* kFormats =
    "wav,w64,aiff,au,caf,mp3,flac,ogg,aac,ac3,amr,mov,matroska,avi,asf,flv,mpeg,mpegts,mpegvideo,"
    "h264,hevc,mxf,gif,apng,mjpeg,png_pipe,jpeg_pipe,bmp_pipe,webp_pipe,tiff_pipe";

// Command line of ffmpeg. prlimit(1) limits address space (that of hazumi-reader), processor time
// [s] and files written (none). The input is descriptor 0, because ffmpeg takes formats and, with a
// % in it, series of files from a name. env finds the programs in $PATH.
std::vector<std::string> Arguments(const std::vector<std::string>& output) {
  std::vector<std::string> all = {
      "/usr/bin/env",        "prlimit", "--as=2147483648",   "--cpu=60",  "--core=0",
      "--fsize=0",           "ffmpeg",  "-nostdin",          "-loglevel", "quiet",
      "-protocol_whitelist", "file",    "-format_whitelist", kFormats,    "-i",
      "file:/proc/self/fd/0"};
  all.insert(all.end(), output.begin(), output.end());
  all.push_back("pipe:" + std::to_string(kChildOutput));
  return all;
}

// Open regular file, or the reason why it cannot be opened.
class OpenMedia {
 public:
  explicit OpenMedia(const std::filesystem::path& file)
      // O_NONBLOCK: opening a pipe without a writer would block.
      : fd_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat status;
    if (fd_ < 0 || ::fstat(fd_, &status) != 0) {
      why_not_ = std::string("cannot be read: ") + std::strerror(errno);
    } else if (S_ISDIR(status.st_mode)) {
      why_not_ = "is a folder";
    } else if (!S_ISREG(status.st_mode)) {
      why_not_ = "cannot be read: it is not a file";
    }
  }
  ~OpenMedia() {
    if (fd_ >= 0) ::close(fd_);
  }
  OpenMedia(const OpenMedia&) = delete;
  OpenMedia& operator=(const OpenMedia&) = delete;

  int fd() const { return fd_; }
  const std::string& why_not() const { return why_not_; }  // empty: open

 private:
  int fd_;
  std::string why_not_;
};

bool HasHitALimit(const ChildOutcome& outcome) {
  using End = ChildOutcome::End;
  const bool by_signal =
      outcome.end == End::kSignalled && (outcome.code == SIGXCPU || outcome.code == SIGKILL);
  return by_signal || outcome.end == End::kTimedOut || outcome.end == End::kTooMuchOutput;
}

}  // namespace

Result<std::string> RunFfmpeg(const std::filesystem::path& file,
                              const std::vector<std::string>& output, const MediaKind& kind,
                              const std::function<bool()>& is_cancelled) {
  using End = ChildOutcome::End;
  const auto error = [&](ErrorCode code, const std::string& message) {
    return Error{code, file.string(), "", message};
  };
  const std::string name = kind.name;
  const OpenMedia media(file);
  if (!media.why_not().empty()) {
    return error(ErrorCode::kNoInput,
                 media.why_not() + "; choose the project's " + name + " again");
  }
  Result<ChildOutcome> run = RunChildOn(media.fd(), Arguments(output), kLimits, is_cancelled);
  if (!run.ok()) return run.error();
  const ChildOutcome& outcome = run.value();
  if (outcome.end == End::kCancelled) return error(ErrorCode::kInterrupted, "interrupted");
  if (HasHitALimit(outcome)) {
    return error(ErrorCode::kFailed, "is too long a " + name + "; cut it to what is needed");
  }
  if (outcome.end == End::kExited && outcome.code == kNoProgram) {
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
