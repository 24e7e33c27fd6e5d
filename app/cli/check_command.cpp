#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/terminal.h"
#include "engine/project/figure_file.h"
#include "engine/project/json/text_file.h"
#include "engine/sweep/sweep_plan.h"

namespace hazumi {

namespace {

nlohmann::ordered_json WarningsAsJson(const std::vector<Warning>& warnings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Warning& warning : warnings) {
    list.push_back({{"place", Shortened(warning.place)}, {"message", Shortened(warning.message)}});
  }
  return list;
}

// Result of checking a file: its warnings, problems of the motion and, with --strict, its unknown
// fields.
struct Checked {
  std::vector<Warning> warnings, unknown;
  std::vector<std::string> problems = {};
};

nlohmann::ordered_json AnswerAsJson(const std::string& file, const Result<Checked>& checked) {
  if (checked.ok()) {
    nlohmann::ordered_json answer = {{"file", file},
                                     {"ok", checked.value().unknown.empty()},
                                     {"warnings", WarningsAsJson(checked.value().warnings)},
                                     {"problems", checked.value().problems}};
    const auto unknown = WarningsAsJson(checked.value().unknown);
    if (!unknown.empty()) answer["unknown"] = unknown;
    return answer;
  }
  const Error& error = checked.error();
  return {{"file", file},
          {"ok", false},
          {"in", error.file},
          {"place", Shortened(error.place)},
          {"message", Shortened(error.message)}};
}

// Format that a JSON file states; empty if it states none.
std::string FormatIn(const std::string& file) {
  const Result<std::string> text = ReadTextFile(file);
  if (!text.ok()) return "";
  const auto json = nlohmann::ordered_json::parse(text.value(), nullptr, false);
  if (!json.is_object() || !json.contains("format") || !json["format"].is_string()) return "";
  return json["format"].get<std::string>();
}

// Result for a figure file or a sweep file; nullopt for any other file.
std::optional<Result<Checked>> CheckByItself(const std::string& file) {
  const std::string format = file.ends_with(".json") ? FormatIn(file) : "";
  Checked checked;
  if (format == "hazumi-figure") {
    const Result<FigureSpec> figure = LoadFigure(file, &checked.warnings, &checked.unknown);
    return figure.ok() ? Result<Checked>(checked) : figure.error();
  }
  if (format != "hazumi-sweep") return std::nullopt;
  const Result<SweepPlan> sweep = LoadSweep(file);
  if (!sweep.ok()) return sweep.error();
  return Checked{sweep.value().read.warnings, sweep.value().read.unknown};
}

Result<Checked> CheckFile(const std::string& file, const Options& options) {
  if (options.strict) {
    if (const auto checked = CheckByItself(file)) return *checked;
  }
  Result<BakedProject> baked = LoadAndBake(file, options);
  if (!baked.ok()) return baked.error();
  Checked checked;
  checked.problems =
      ProblemTexts(baked.value(), EffortOf(baked.value().animation, baked.value().motion));
  checked.warnings = std::move(baked.value().warnings);
  if (options.strict) checked.unknown = std::move(baked.value().project.read.unknown);
  return checked;
}

void Print(const std::string& file, const Checked& checked) {
  PrintWarnings(file, checked.warnings);
  for (const Warning& field : checked.unknown) {
    Complain({ErrorCode::kSchema, file, field.place, field.message});
  }
  for (const std::string& problem : checked.problems) {
    PrintLine(stderr, "hazumi: %s: problem: %s", file.c_str(), problem.c_str());
  }
  if (checked.unknown.empty()) PrintLine(stdout, "%s: ok", file.c_str());
}

int ExitCodeOf(const Result<Checked>& checked) {
  if (!checked.ok()) return ExitCodeOf(checked.error());
  return checked.value().unknown.empty() ? kExitOk : kExitBadData;
}

}  // namespace

// Reads, resolves and bakes every file: a hold out of reach shows only then.
int RunCheck(const Options& options) {
  int exit_code = kExitOk;
  for (const std::string& file : options.files) {
    const Result<Checked> checked = CheckFile(file, options);
    if (!checked.ok() && checked.error().code == ErrorCode::kInterrupted)
      return Complain(checked.error());
    if (options.json) {
      const auto line = AnswerAsJson(file, checked)
                            .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
      std::printf("%s\n", line.c_str());
    } else if (checked.ok()) {
      Print(file, checked.value());
    } else {
      Complain(checked.error());
    }
    if (exit_code == kExitOk) exit_code = ExitCodeOf(checked);
  }
  return exit_code;
}

}  // namespace hazumi
