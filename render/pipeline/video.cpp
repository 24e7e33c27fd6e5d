#include "render/pipeline/video.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/atomic_file.h"
#include "engine/base/input_files.h"
#include "engine/media/decode_sound.h"

extern char** environ;

namespace hazumi::render {

namespace fs = std::filesystem;

namespace {

constexpr int kUnnamedInFfmpeg = 3, kSoundInFfmpeg = 4;  // descriptors after its input and outputs

std::vector<std::string> Arguments(const VideoFormat& format, const std::string& output) {
  const std::string size = std::to_string(format.width) + "x" + std::to_string(format.height);
  const std::string rate = std::to_string(format.rate_num) + "/" + std::to_string(format.rate_den);
  std::vector<std::string> arguments = {
      "ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
      // what comes: rows of red, green, blue and a byte that says nothing
      "-f", "rawvideo", "-pixel_format", "rgb0", "-video_size", size, "-framerate", rate, "-i",
      "pipe:0"};
  const auto add = [&](const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
  };
  if (format.sound) {
    add({"-f", "s16le", "-ac", std::to_string(SoundFormat().channels), "-ar",
         std::to_string(kSoundRate), "-i", "pipe:" + std::to_string(kSoundInFfmpeg), "-map",
         "0:v:0", "-map", "1:a:0", "-c:a", "aac", "-b:a", "192k"});
  } else {
    add({"-an"});
  }
  // what shall become of it: plays everywhere, begins to play before it is all there
  add({"-vf",
       "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
       "-c:v",
       "libx264",
       "-preset",
       "medium",
       "-crf",
       "18",
       "-color_range",
       "tv",
       "-colorspace",
       "bt709",
       "-color_primaries",
       "bt709",
       "-color_trc",
       "bt709",
       "-movflags",
       "+faststart",
       "-f",
       "mp4",
       "file:" + output});
  return arguments;
}

// Hidden beside the file, so that it can take its name at once.
fs::path TemporaryPath(const fs::path& path) {
  const std::string name = "." + path.filename().string() + "." + std::to_string(getpid());
  return path.parent_path() / (name + ".tmp");
}

// A file in the folder that has no name yet, so that nothing is left of it whatever becomes of us;
// -1 where the file system has none such.
int OpenUnnamed(const fs::path& beside) {
  const fs::path folder = beside.has_parent_path() ? beside.parent_path() : ".";
  return open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
}

// What it is called meanwhile, by the process that has it open.
std::string OpenFileName(int fd) { return "/proc/self/fd/" + std::to_string(fd); }

// The lines of a text in one.
std::string OneLine(const std::string& text) {
  std::string line;
  for (const char c : text.substr(0, text.find_last_not_of(" \r\n") + 1)) {
    if (c == '\n') line += "; ";
    if (c != '\n' && c != '\r') line += c;
  }
  return line;
}

}  // namespace

// ffmpeg at work.
struct VideoWriter::Process {
  VideoFormat format;
  fs::path target, temporary;
  int unnamed = -1;  // what `temporary` will be the name of; -1: it is from the start
  pid_t id = -1;     // -1: ended
  int input = -1;    // a socket: writing to it raises no signal when ffmpeg has gone
  int output = -1;   // what it says, a file in memory
  int sound = -1;    // file in memory with the samples; -1: no sound

  ~Process();
  Result<Done> TakeSound(const std::atomic<bool>* cancel);
  // 0, or errno.
  int Spawn(int its_input);
  // Lets it end by itself. True: it did its work.
  bool Wait();
  // Gives the whole file its name. 0, or errno.
  int Name();
  Error Complaint() const;
};

VideoWriter::Process::~Process() {
  if (input >= 0) close(input);
  if (id > 0) {
    kill(id, SIGKILL);
    Wait();
  }
  if (output >= 0) close(output);
  if (sound >= 0) close(sound);
  if (unnamed >= 0) close(unnamed);
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

int VideoWriter::Process::Spawn(int its_input) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, its_input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, output, STDERR_FILENO);
  // In a group of its own: Ctrl+C is for us to deal with.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  if (unnamed >= 0) posix_spawn_file_actions_adddup2(&files, unnamed, kUnnamedInFfmpeg);
  if (sound >= 0) posix_spawn_file_actions_adddup2(&files, sound, kSoundInFfmpeg);
  std::vector<std::string> arguments =
      Arguments(format, unnamed >= 0 ? OpenFileName(kUnnamedInFfmpeg) : temporary.string());
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t child = -1;
  const int failed = posix_spawnp(&child, "ffmpeg", &files, &attributes, pointers.data(), environ);
  if (failed == 0) id = child;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return failed;
}

bool VideoWriter::Process::Wait() {
  if (input >= 0) close(std::exchange(input, -1));
  int status = 0;
  while (id > 0 && waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  id = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int VideoWriter::Process::Name() {
  if (unnamed >= 0) {
    std::error_code ignored;
    fs::remove(temporary, ignored);  // of a process with our number that was killed just here
    const int failed = linkat(AT_FDCWD, OpenFileName(unnamed).c_str(), AT_FDCWD, temporary.c_str(),
                              AT_SYMLINK_FOLLOW);
    if (failed != 0) return errno;
  }
  return std::rename(temporary.c_str(), target.c_str()) == 0 ? 0 : errno;
}

Error VideoWriter::Process::Complaint() const {
  std::string text(2000, '\0');
  const ssize_t count = pread(output, text.data(), text.size(), 0);
  text = OneLine(text.substr(0, static_cast<size_t>(std::max<ssize_t>(count, 0))));
  return {ErrorCode::kFailed, format.path.string(), "ffmpeg",
          text.empty() ? "ended before the video was whole, and says nothing" : text};
}

// Writes the samples to a file in memory. Returns its descriptor, which is above those of ffmpeg.
static Result<int> FileOf(const Sound& sound, const std::string& video) {
  const int written = memfd_create("sound", MFD_CLOEXEC);
  const std::string_view bytes(reinterpret_cast<const char*>(sound.samples.data()),
                               sound.samples.size() * sizeof sound.samples[0]);
  const bool is_whole =
      written >= 0 && WriteAll(written, bytes) && lseek(written, 0, SEEK_SET) == 0;
  const int file = is_whole ? fcntl(written, F_DUPFD_CLOEXEC, kSoundInFfmpeg + 1) : -1;
  const int failed = errno;
  if (written >= 0) close(written);
  if (file >= 0) return file;
  return Error{ErrorCode::kFailed, video, "",
               std::string("no room for its sound: ") + std::strerror(failed)};
}

// Decodes the whole sound before any picture is drawn, so that a bad sound is reported at once.
Result<Done> VideoWriter::Process::TakeSound(const std::atomic<bool>* cancel) {
  if (!format.sound) return Done();
  const Result<Sound> decoded =
      DecodeSoundPart(*format.sound, [cancel] { return cancel && *cancel; });
  if (!decoded.ok()) return decoded.error();
  const Result<int> file = FileOf(decoded.value(), format.path.string());
  if (!file.ok()) return file.error();
  sound = file.value();
  return Done();
}

Result<VideoWriter> VideoWriter::Start(const VideoFormat& format, const std::atomic<bool>* cancel) {
  const std::string file = format.path.string();
  if (const auto kept = WhyKept(file)) return *kept;
  if (format.width % 2 != 0 || format.height % 2 != 0) {
    return Error{ErrorCode::kFailed, file, "",
                 "H.264 with 4:2:0 colours has even sizes only; choose a size a pixel larger"};
  }
  auto process = std::make_unique<Process>();
  process->format = format;
  if (const Result<Done> taken = process->TakeSound(cancel); !taken.ok()) return taken.error();
  process->target = FollowLinks(format.path);
  process->temporary = TemporaryPath(process->target);
  process->unnamed = OpenUnnamed(process->target);
  process->output = memfd_create("ffmpeg", MFD_CLOEXEC);
  int ends[2];
  if (process->output < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    return Error{ErrorCode::kFailed, file, "",
                 std::string("no pipe to ffmpeg: ") + std::strerror(errno)};
  }
  process->input = ends[0];
  const int failed = process->Spawn(ends[1]);
  close(ends[1]);
  if (failed == ENOENT) {
    return Error{ErrorCode::kFailed, file, "",
                 "the program ffmpeg, which makes videos, is not installed; "
                 "on Debian: apt install ffmpeg"};
  }
  if (failed != 0) {
    return Error{ErrorCode::kFailed, file, "ffmpeg",
                 std::string("cannot be started: ") + std::strerror(failed)};
  }
  return VideoWriter(std::move(process));
}

VideoWriter::VideoWriter(std::unique_ptr<Process> process) : process_(std::move(process)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<Done> VideoWriter::Write(const Image& image) {
  HAZUMI_DEMAND_EQ(image.width, process_->format.width);
  HAZUMI_DEMAND_EQ(image.height, process_->format.height);
  for (size_t sent = 0; sent < image.rgba.size();) {
    const ssize_t count =
        send(process_->input, image.rgba.data() + sent, image.rgba.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      process_->Wait();
      return process_->Complaint();
    }
    sent += static_cast<size_t>(count);
  }
  return Done{};
}

static Error Interrupted() { return {ErrorCode::kInterrupted, "", "", "interrupted"}; }

Result<Done> VideoWriter::Finish(const std::atomic<bool>* cancel) {
  if (!process_->Wait()) return process_->Complaint();
  if (cancel && *cancel) return Interrupted();
  const int failed = process_->Name();
  if (failed == 0) return Done{};
  return Error{ErrorCode::kCannotWrite, process_->format.path.string(), "",
               std::string("cannot be written: ") + std::strerror(failed)};
}

Result<int> RenderVideo(const SequenceOptions& options, const Sequence& sequence,
                        const VideoFormat& format) {
  Result<VideoWriter> writer = VideoWriter::Start(format, sequence.cancel);
  if (!writer.ok()) return writer.error();
  Sequence into_video = sequence;
  into_video.write = [&](int, const Image& image) { return writer.value().Write(image); };
  Result<int> drawn = RenderSequence(options, into_video);
  if (!drawn.ok()) return drawn;
  if (sequence.cancel && *sequence.cancel) return Interrupted();
  const Result<Done> finished = writer.value().Finish(sequence.cancel);
  if (!finished.ok()) return finished.error();
  return drawn;
}

}  // namespace hazumi::render
