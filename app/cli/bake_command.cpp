#include <cstdio>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "engine/base/atomic_file.h"
#include "engine/exchange/motion_csv.h"
#include "engine/exchange/motion_json.h"

namespace hazumi {

namespace {

bool IsCsv(const std::string& name) { return name.ends_with(".csv"); }

}  // namespace

int RunBake(const Options& options) {
  const std::string& out = options.output;
  if (out != "-" && !IsCsv(out) && !out.ends_with(".json")) {
    std::fprintf(stderr, "hazumi: --bake: %s: the name must end in .json or .csv, or be -\n",
                 out.c_str());
    return kExitUsage;
  }
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  const auto& [project, animation, motion, warnings] = baked.value();
  PrintWarnings(options.files[0], warnings);
  const std::string text = IsCsv(out) ? MotionToCsv(animation, motion)
                                      : MotionToJson(animation, motion, {options.timings});
  if (out != "-") {
    const Result<Done> written = WriteFileAtomically(out, text, WriteMode::kDurable);
    return written.ok() ? kExitOk : Complain(written.error());
  }
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (whole && std::fflush(stdout) == 0) return kExitOk;
  return Complain({ErrorCode::kCannotWrite, "standard output", "", "could not be written"});
}

}  // namespace hazumi
