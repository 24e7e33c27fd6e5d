#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/terminal.h"

namespace hazumi {

namespace {

nlohmann::ordered_json WarningsAsJson(const std::vector<Warning>& warnings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Warning& warning : warnings) {
    list.push_back({{"place", Shortened(warning.place)}, {"message", Shortened(warning.message)}});
  }
  return list;
}

nlohmann::ordered_json AnswerAsJson(const std::string& file, const Result<BakedProject>& baked) {
  if (baked.ok()) {
    return {{"file", file}, {"ok", true}, {"warnings", WarningsAsJson(baked.value().warnings)}};
  }
  const Error& error = baked.error();
  return {{"file", file},
          {"ok", false},
          {"in", error.file},
          {"place", Shortened(error.place)},
          {"message", Shortened(error.message)}};
}

}  // namespace

// Reads, resolves and bakes every file: a hold out of reach shows only then.
int RunCheck(const Options& options) {
  int exit_code = kExitOk;
  for (const std::string& file : options.files) {
    const Result<BakedProject> baked = LoadAndBake(file, options);
    if (!baked.ok() && baked.error().code == ErrorCode::kInterrupted)
      return Complain(baked.error());
    if (options.json) {
      const auto line = AnswerAsJson(file, baked)
                            .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
      std::printf("%s\n", line.c_str());
    } else if (baked.ok()) {
      PrintWarnings(file, baked.value().warnings);
      PrintLine(stdout, "%s: ok", file.c_str());
    }
    if (baked.ok()) continue;
    const int code = options.json ? ExitCodeOf(baked.error()) : Complain(baked.error());
    if (exit_code == kExitOk) exit_code = code;
  }
  return exit_code;
}

}  // namespace hazumi
