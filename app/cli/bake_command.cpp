#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <string_view>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/verify.h"
#include "engine/base/atomic_file.h"
#include "engine/exchange/motion_text.h"

namespace hazumi {

namespace {

bool IsCsv(const std::string& name) { return name.ends_with(".csv"); }

// In pieces that a pipe takes whole or not at all: an interrupt ends it though nobody reads.
bool WriteToStandardOutput(std::string_view text) {
  while (!text.empty() && !Interrupted()) {
    const ssize_t count =
        write(STDOUT_FILENO, text.data(), std::min<size_t>(text.size(), PIPE_BUF));
    if (count < 0 && errno != EINTR) return false;
    text.remove_prefix(std::max<ssize_t>(count, 0));
  }
  return text.empty();
}

}  // namespace

int RunBake(const Options& options) {
  const std::string& out = options.output;
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  const auto& [project, animation, motion, warnings] = baked.value();
  PrintWarnings(options.files[0], warnings);
  PrintNotes(options.files[0], motion);
  const std::string text =
      IsCsv(out)
          ? MotionToCsv(animation, motion, options.torques, options.effort)
          : MotionToJson(
                animation, motion,
                {options.timings, options.torques, {MadeByText(), options.given}, options.effort});
  if (Interrupted()) return Complain(InterruptedError());
  if (out != "-") {
    const Result<Done> written = WriteFileAtomically(out, text, WriteMode::kDurable);
    return written.ok() ? kExitOk : Complain(written.error());
  }
  if (WriteToStandardOutput(text)) return kExitOk;
  if (Interrupted()) return Complain(InterruptedError());
  return Complain({ErrorCode::kCannotWrite, "standard output", "", "could not be written"});
}

}  // namespace hazumi
