#include "app/cli/options.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <span>

#include "app/cli/exit_codes.h"
#include "app/cli/frame_names.h"
#include "app/cli/help_text.h"
#include "app/cli/option_table.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "engine/base/text.h"
#include "engine/base/version.h"
#include "engine/exchange/export_motion.h"
#include "engine/project/json/did_you_mean.h"

namespace hazumi {

namespace {

using UsageError = CLI::ValidationError;

// Of --export, those of the format that is asked for.
unsigned TasksOf(const OptionRule& task, const Options& options) {
  if (task.tasks != kExport) return task.tasks;
  if (IsVideo(options.output)) return kVideo;
  const auto format = MotionFormatOf(options.output);
  if (format == MotionFormat::kBvh) return kBvh;
  if (format == MotionFormat::kJson) return kJson;
  return format == MotionFormat::kCsv ? kCsv : kPlain;
}

// "--bake", "--export to x.glb".
std::string TaskText(const OptionRule& task, const Options& options) {
  return task.tasks == kExport ? "--export to " + options.output : task.name;
}

// Of a picture as it is drawn: colour and depth of every sample, and what is read back and written.
void RefuseLargePictures(const Options& options) {
  constexpr double kMost = 2e9;  // [bytes]
  if (!options.size) return;
  const double pixels = static_cast<double>(options.size->width) * options.size->height;
  const double bytes = pixels * (8.0 * options.samples + 20.0);
  if (bytes <= kMost) return;
  throw UsageError("--size " + std::to_string(options.size->width) + "x" +
                   std::to_string(options.size->height) + ": needs " + FormatShort(bytes / 1e9) +
                   " GB of memory; at most " + FormatShort(kMost / 1e9) +
                   " GB are taken: give fewer pixels, or --samples 1");
}

void RefuseUnknown(const CLI::App& app) {
  std::vector<std::string> known;
  for (const OptionRule& rule : AllOptions()) known.push_back(rule.name);
  for (const std::string& argument : app.remaining()) {
    const std::string name = argument.substr(0, argument.find('='));
    const auto nearest = Nearest(name, known);
    throw UsageError("unknown option " + name +
                     (nearest ? "; did you mean " + *nearest + "?" : ""));
  }
}

void Declare(std::span<const OptionRule> rules, CLI::App* app) {
  for (const OptionRule& rule : rules) {
    if (rule.value) {
      app->add_option(rule.name)->expected(1)->type_name("value");
    } else {
      app->add_flag(rule.name)->disable_flag_override();
    }
  }
}

void Read(const CLI::App& app, const OptionRule& rule, Options* options) {
  if (app.count(rule.name) == 0) return;
  const std::string text = rule.value ? app[rule.name]->as<std::string>() : "";
  if (!rule.read(text, options)) {
    throw UsageError(std::string(rule.name) + " " + text + ": " + rule.remedy);
  }
  if (rule.section == Section::kTasks || rule.is_silent) return;
  options->given.push_back(rule.name);
  if (rule.value) options->given.push_back(text);
}

// The task that is asked for, read.
const OptionRule& ReadTask(const CLI::App& app, Options* options) {
  const OptionRule* chosen = nullptr;
  for (const OptionRule& task : Tasks()) {
    if (app.count(task.name) == 0) continue;
    if (chosen) {
      throw UsageError(std::string(chosen->name) + " and " + task.name + ": one task at a time");
    }
    chosen = &task;
  }
  static constexpr OptionRule kEditInWindow = {.name = "the editor", .tasks = kWindow};
  if (!chosen) return options->task = Task::kWindow, kEditInWindow;
  Read(app, *chosen, options);
  return *chosen;
}

// A name in which no frame number has a place is that of one picture.
void CheckPictureName(const OptionRule& task, const Options& options) {
  if (!IsOnePicture(options.output)) return;
  if (options.frames && options.frames->first == options.frames->last) return;
  throw UsageError(std::string(task.name) + " " + options.output + ": " + task.remedy);
}

void CheckSweep(const CLI::App& app, const Options& options) {
  if (options.output.empty() && !options.count) throw UsageError("--sweep wants --out FOLDER");
  if ((app.count("--tasks") == 0) != (app.count("--task") == 0)) {
    throw UsageError("--tasks and --task go together: how many there are, and which one this is");
  }
  if (options.tasks > 0 && options.task_number >= options.tasks) {
    throw UsageError("--task " + std::to_string(options.task_number) + ": of " +
                     std::to_string(options.tasks) + " tasks the last one is " +
                     std::to_string(options.tasks - 1));
  }
}

void ReadOptions(const CLI::App& app, Options* options) {
  RefuseUnknown(app);
  const OptionRule& task = ReadTask(app, options);
  const unsigned tasks = TasksOf(task, *options);
  for (const OptionRule& rule : TaskOptions()) {
    if (app.count(rule.name) != 0 && !(rule.tasks & tasks)) {
      throw UsageError(std::string(rule.name) + " belongs to " + TaskNames(rule.tasks) +
                       ", not to " + TaskText(task, *options));
    }
    Read(app, rule, options);
  }
  RefuseLargePictures(*options);
  const bool is_by_itself = MotionFormatOf(options->output) || IsVideo(options->output);
  if (task.tasks == kExport && options->onto.empty() && !is_by_itself)
    throw UsageError(TaskText(task, *options) + " wants --onto SOURCE, a file of that format");
  if (task.tasks & kImport) {
    if (options->files.size() > 1) throw UsageError("--import takes one file, and no FILE beside");
    if (options->output.empty()) throw UsageError("--import wants --save OUT.kfa beside it");
    if (options->rate) options->import.fps = options->rate->FrameAt(1.0);
    return;
  }
  if (task.tasks & kRender) CheckPictureName(task, *options);
  if (task.tasks & kSweep) CheckSweep(app, *options);
  if (!(task.tasks & kProjects)) {
    if (!options->files.empty()) throw UsageError(std::string(task.name) + " takes no FILE");
    return;
  }
  if (options->files.empty() && !(task.tasks & (kRun | kWindow))) {
    throw UsageError("no FILE; name a project (.kfa)");
  }
  if (task.tasks & kVerify) {
    if (options->files.size() != 2) throw UsageError("--verify takes FILE and MADE: two names");
    return;
  }
  if (options->task != Task::kCheck && options->files.size() > 1) {
    throw UsageError(std::string(task.name) + " takes one FILE; only --check takes several");
  }
}

// CLI11's own: "--size: 1 required value missing", "--fps: At Most 1 required but received 2".
std::string Explain(const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string name = text.substr(0, text.find(':'));
  if (text.ends_with("missing")) return name + " wants a value";
  if (text.find("received") != std::string::npos) return name + " is given twice";
  if (text.ends_with("flag override"))
    return "--" + text.substr(0, text.find(' ')) + " takes no value";
  return text;
}

// Throws what CLI11 does. It only tells options, values and files apart: what they mean is in the
// table.
Options ParseOrThrow(int argc, const char* const* argv) {
  CLI::App app("", "hazumi");
  Options options;
  app.allow_extras();
  app.set_version_flag("--version", "hazumi " + ProgramVersion());
  Declare(Tasks(), &app);
  Declare(TaskOptions(), &app);
  app.add_option("FILE", options.files);
  app.parse(argc, argv);
  ReadOptions(app, &options);
  return options;
}

}  // namespace

Result<Options> ParseWords(const std::vector<std::string>& words) {
  std::vector<const char*> argv = {"hazumi"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  try {
    return ParseOrThrow(static_cast<int>(argv.size()), argv.data());
  } catch (const UsageError& error) {
    return Error{ErrorCode::kSchema, "", "", error.what()};
  } catch (const CLI::ParseError& error) {
    return Error{ErrorCode::kSchema, "", "", Explain(error)};
  }
}

ParsedCommandLine ParseCommandLine(int argc, const char* const* argv) {
  try {
    return {ParseOrThrow(argc, argv), kExitOk};
  } catch (const CLI::CallForHelp&) {
    std::fputs(HelpText().c_str(), stdout);
    return {std::nullopt, kExitOk};
  } catch (const CLI::CallForVersion& version) {
    PrintLine(stdout, "%s", version.what());
    return {std::nullopt, kExitOk};
  } catch (const UsageError& error) {
    return {std::nullopt, ComplainOfUsage(error.what())};
  } catch (const CLI::ParseError& error) {
    return {std::nullopt, ComplainOfUsage(Explain(error))};
  }
}

}  // namespace hazumi
