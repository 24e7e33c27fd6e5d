#include "engine/child/child_process.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <optional>
#include <thread>

#include "engine/base/atomic_file.h"

namespace hazumi {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPipeBytes = 1 << 20;  // as much as a process may ask for

class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() { Close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void Close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

// A running child; killed and reaped at the end if that has not happened before.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // The status once it has ended, without waiting. Reaped by somebody else: as if it exited with 0.
  std::optional<int> Status() {
    int status = 0;
    const pid_t got = ::waitpid(pid_, &status, WNOHANG);
    if (got == 0 || (got < 0 && errno == EINTR)) return std::nullopt;
    pid_ = -1;
    return got > 0 ? status : 0;
  }

 private:
  pid_t pid_;
};

// What the child finds: its input, no terminal, signals as by default, a group of its own so that
// Ctrl+C reaches this process only, which then stops the child.
class SpawnSettings {
 public:
  SpawnSettings(int input, int output) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, output, kChildOutput);
    ::posix_spawn_file_actions_adddup2(&actions_, input, 0);
    for (int fd = 1; fd < kChildOutput; ++fd)
      ::posix_spawn_file_actions_addopen(&actions_, fd, "/dev/null", O_RDWR, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, kChildOutput + 1);
    sigset_t all, none;
    ::sigfillset(&all);
    ::sigemptyset(&none);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  // 0 or errno.
  int Spawn(const std::vector<std::string>& arguments, pid_t* pid) const {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (const std::string& argument : arguments)
      argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    return ::posix_spawn(pid, argv[0], &actions_, &attributes_, argv.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

Error CannotStart(const std::string& program, int error) {
  return {ErrorCode::kFailed, program, "",
          std::string("cannot be started (") + std::strerror(error) + "); install Hazumi again"};
}

// Duplicated above the child's descriptors, so that opening those cannot close it.
int AboveTheChilds(int fd) { return ::fcntl(fd, F_DUPFD_CLOEXEC, kChildOutput + 1); }

// A file in memory with this content, to be read from its beginning; -1: errno.
int FileWith(std::string_view content) {
  const Descriptor file(::memfd_create("hazumi", MFD_CLOEXEC));
  const bool is_written =
      file.get() >= 0 && WriteAll(file.get(), content) && ::lseek(file.get(), 0, SEEK_SET) == 0;
  return is_written ? AboveTheChilds(file.get()) : -1;
}

// Waits for output, for an end of patience, or for the user, whichever comes first.
class Watch {
 public:
  Watch(const ChildLimits& limits, const std::function<bool()>& is_cancelled)
      : limits_(limits),
        is_cancelled_(is_cancelled),
        end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                std::chrono::duration<double>(limits.seconds))) {}

  std::optional<ChildOutcome::End> Reason(size_t output_bytes) const {
    if (is_cancelled_ && is_cancelled_()) return ChildOutcome::End::kCancelled;
    if (Clock::now() >= end_) return ChildOutcome::End::kTimedOut;
    if (output_bytes > limits_.output_bytes) return ChildOutcome::End::kTooMuchOutput;
    return std::nullopt;
  }

 private:
  const ChildLimits& limits_;
  const std::function<bool()>& is_cancelled_;
  Clock::time_point end_;
};

// Takes what there is, through the buffer; false at the end of the output.
bool Drain(int fd, std::vector<char>* buffer, std::string* output) {
  pollfd waiting = {fd, POLLIN, 0};
  if (::poll(&waiting, 1, 20) <= 0) return true;
  const ssize_t got = ::read(fd, buffer->data(), buffer->size());
  if (got > 0) output->append(buffer->data(), static_cast<size_t>(got));
  return got > 0 || (got < 0 && errno == EINTR);
}

ChildOutcome WaitFor(Child* child, int fd, const Watch& watch) {
  ChildOutcome outcome;
  std::vector<char> buffer(kPipeBytes);
  bool has_more = true;
  while (true) {
    if (has_more) has_more = Drain(fd, &buffer, &outcome.output);
    if (const auto reason = watch.Reason(outcome.output.size())) {
      outcome.end = *reason;
      return outcome;
    }
    if (has_more) continue;
    if (const std::optional<int> status = child->Status()) {
      const bool exited = WIFEXITED(*status);
      outcome.end = exited ? ChildOutcome::End::kExited : ChildOutcome::End::kSignalled;
      outcome.code = exited ? WEXITSTATUS(*status) : WTERMSIG(*status);
      return outcome;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

// Runs a child that reads `input`, a descriptor above the child's own; -1: see errno.
Result<ChildOutcome> Run(Descriptor* input, const std::vector<std::string>& arguments,
                         const ChildLimits& limits, const std::function<bool()>& is_cancelled) {
  if (input->get() < 0) return CannotStart(arguments[0], errno);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return CannotStart(arguments[0], errno);
  const Descriptor read_end(ends[0]);
  Descriptor write_end(ends[1]);
  ::fcntl(write_end.get(), F_SETPIPE_SZ, kPipeBytes);  // smaller, it is only slower
  Descriptor output(AboveTheChilds(write_end.get()));
  if (output.get() < 0) return CannotStart(arguments[0], errno);
  write_end.Close();
  const Watch watch(limits, is_cancelled);
  pid_t pid = -1;
  if (const int error = SpawnSettings(input->get(), output.get()).Spawn(arguments, &pid))
    return CannotStart(arguments[0], error);
  Child child(pid);
  output.Close();
  input->Close();
  return WaitFor(&child, read_end.get(), watch);
}

}  // namespace

Result<ChildOutcome> RunChild(const std::vector<std::string>& arguments, std::string_view input,
                              const ChildLimits& limits,
                              const std::function<bool()>& is_cancelled) {
  Descriptor content(FileWith(input));
  return Run(&content, arguments, limits, is_cancelled);
}

Result<ChildOutcome> RunChildOn(int file, const std::vector<std::string>& arguments,
                                const ChildLimits& limits,
                                const std::function<bool()>& is_cancelled) {
  Descriptor content(AboveTheChilds(file));
  return Run(&content, arguments, limits, is_cancelled);
}

}  // namespace hazumi
