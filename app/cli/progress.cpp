#include "app/cli/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "app/cli/terminal.h"

namespace hazumi {

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
