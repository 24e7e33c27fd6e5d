#include "app/cli/terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "engine/base/utf8.h"

namespace hazumi {

namespace {

void AppendEscaped(char c, std::string* out) {
  constexpr const char* kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  *out += {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
}

// Of valid UTF-8. The control characters are U+0000 to U+001F, U+007F and U+0080 to U+009F.
void AppendWithoutControls(std::string_view text, std::string* out) {
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool two_bytes = byte == 0xC2 && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (two_bytes) AppendEscaped(text[i++], out);
    if (two_bytes || byte < 0x20 || byte == 0x7F) {
      AppendEscaped(text[i], out);
    } else {
      *out += text[i];
    }
  }
}

}  // namespace

std::string Printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const size_t num_valid = std::min(FindInvalidUtf8(text), text.size());
    AppendWithoutControls(text.substr(0, num_valid), &out);
    text.remove_prefix(num_valid);
    if (text.empty()) break;
    AppendEscaped(text[0], &out);
    text.remove_prefix(1);
  }
  return out;
}

std::string Shortened(std::string text) {
  constexpr size_t kHead = 1200, kTail = 600;
  if (text.size() <= kHead + kTail) return text;
  size_t from = kHead, to = text.size() - kTail;
  const auto is_inside = [&](size_t i) { return (text[i] & 0xC0) == 0x80; };  // a letter
  while (is_inside(from)) --from;
  while (to < text.size() && is_inside(to)) ++to;
  return text.replace(from, to - from, " ... ");
}

void PrintLine(std::FILE* stream, const char* format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::string text(std::max(0, std::vsnprintf(nullptr, 0, format, arguments)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  va_end(arguments);
  std::fprintf(stream, "%s\n", Shortened(Printable(text)).c_str());
}

// Opened for reading, so that what is printed there fails as it would without.
void KeepStandardStreams() {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; ++fd) {
    if (fcntl(fd, F_GETFD) < 0) open("/dev/null", O_RDONLY);
  }
}

int FinishOutput(int exit_code) {
  errno = 0;
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  if (!failed || exit_code != kExitOk) return exit_code;
  if (Interrupted()) return Complain(InterruptedError());
  return Complain(
      {ErrorCode::kCannotWrite, "standard output", "", "could not be written" + reason});
}

int ComplainOfUsage(const std::string& message) {
  PrintLine(stderr, "hazumi: %s", message.c_str());
  PrintLine(stderr, "see hazumi --help");
  return kExitUsage;
}

Progress::Progress(std::string what, int total)
    : what_(std::move(what)), total_(total), on_terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::Report(int done, const std::string& detail) {
  if (!on_terminal_) {
    PrintLine(stderr, "%s %d/%d %s", what_.c_str(), done, total_, detail.c_str());
    return;
  }
  constexpr int kWidth = 40;
  const int filled = total_ > 0 ? kWidth * done / total_ : kWidth;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %d/%d", what_.c_str(), bar.c_str(), done, total_);
}

void Progress::Finish() {
  if (on_terminal_) std::fputc('\n', stderr);
}

}  // namespace hazumi
