#include "app/cli/options.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <span>

#include "app/cli/exit_codes.h"
#include "app/cli/frame_names.h"
#include "app/cli/help_text.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "engine/base/text.h"
#include "engine/base/version.h"
#include "engine/exchange/export_motion.h"
#include "engine/project/fields/project_fields.h"
#include "engine/project/json/did_you_mean.h"

namespace hazumi {

namespace {

using UsageError = CLI::ValidationError;

enum TaskBits : unsigned {
  kRender = 1,
  kBake = 2,
  kCheck = 4,
  kInfo = 8,
  kFlight = 16,
  kImport = 32,
  kRun = 64,
  kOperators = 128,
  kWindow = 256,  // no task named
  kBvh = 512,     // --export, by the format
  kVideo = 1024,
  kJson = 2048,
  kCsv = 4096,
  kPlain = 8192,  // others
  kSchema = 16384,
  kExport = kBvh | kVideo | kJson | kCsv | kPlain,
  kDraw = kRender | kVideo,
  kMotion = kRender | kBake | kCheck | kInfo | kFlight | kExport,
  // Those that read files of other programs.
  kForeign = kRender | kBake | kInfo | kFlight | kImport | kExport,
};

// An option, the tasks it belongs to, and how its value is read. A flag has no `remedy`; another
// option's says what to do about a value that cannot be read.
struct OptionRule {
  const char* name;
  unsigned tasks;
  const char* remedy;
  bool (*read)(const std::string& text, Options* options);
};

template <typename Value, typename Field>
bool Keep(const std::optional<Value>& value, Field* field) {
  if (value) *field = *value;
  return value.has_value();
}

bool KeepInt(const std::string& text, int least, int most, int* field) {
  const auto number = ReadInt(text);
  return number && *number >= least && *number <= most && Keep(number, field);
}

// As in files.
template <const Field& kField, std::optional<double> Options::*kMember>
bool ReadField(const std::string& text, Options* options) {
  const auto number = ReadFinite(text);
  return number && *number >= kField.range.lower && *number <= kField.range.upper &&
         Keep(number, &(options->*kMember));
}

bool ReadMethod(const std::string& text, Options* options) {
  for (const auto& method : EnumNames<Method>::kNames) {
    if (text == method.name) options->method = method.value;
  }
  return options->method.has_value();
}

bool ReadPictures(const std::string& text, Options* options) {
  options->task = Task::kRender;
  options->output = text;
  return !text.empty() && !IsOnePicture(text);
}

bool ReadMotionFile(const std::string& text, Options* options) {
  options->task = Task::kBake;
  options->output = text;
  return text == "-" || text.ends_with(".json") || text.ends_with(".csv");
}

bool ReadExport(const std::string& text, Options* options) {
  options->task = Task::kExport;
  options->output = text;
  return MotionFormatOf(text) || IsVideo(text);
}

bool ReadBvhUp(const std::string& text, Options* options) {
  options->z_up = text == "z";
  return text == "y" || text == "z";
}

bool ReadBvhUnit(const std::string& text, Options* options) {
  options->in_metres = text == "m";
  return text == "m" || text == "cm";
}

bool ReadScript(const std::string& text, Options* options) {
  options->task = Task::kRun;
  options->script = text;
  return !text.empty();
}

bool ReadImported(const std::string& text, Options* options) {
  options->task = Task::kImport;
  options->files.push_back(text);
  return !text.empty();
}

bool ReadSaved(const std::string& text, Options* options) {
  options->output = text;
  return text.ends_with(".kfa");
}

bool ReadUp(const std::string& text, Options* options) {
  if (text == "y") options->import.up = UpAxis::kY;
  if (text == "z") options->import.up = UpAxis::kZ;
  return options->import.up.has_value();
}

bool ReadLimits(const std::string& text, Options* options) {
  if (text == "none") options->import.limits = ImportLimits::kNone;
  return text == "none" || text == "clip";
}

// A positive number, `most` at most.
bool KeepPositive(const std::string& text, double most, std::optional<double>* field) {
  const auto number = ReadFinite(text);
  return number && *number > 0.0 && *number <= most && Keep(number, field);
}

template <bool Options::*kField, bool kValue = true>
bool Set(const std::string&, Options* options) {
  options->*kField = kValue;
  return true;
}

template <Task kTask>
bool Choose(const std::string&, Options* options) {
  options->task = kTask;
  return true;
}

constexpr OptionRule kTasks[] = {
    {"--render", kRender, "put #### where the frame number goes, or name a folder", ReadPictures},
    {"--bake", kBake, "the name must end in .json or .csv, or be -", ReadMotionFile},
    {"--export", kExport, "the name must end in .bvh, .gltf, .glb, .csv, .json or .mp4",
     ReadExport},
    {"--check", kCheck, nullptr, Choose<Task::kCheck>},
    {"--info", kInfo, nullptr, Choose<Task::kInfo>},
    {"--flight", kFlight, nullptr, Choose<Task::kFlight>},
    {"--import", kImport, "name a file: BVH, FBX, glTF, GLB or Collada", ReadImported},
    {"--run", kRun, "name a script, a JSON list of operators", ReadScript},
    {"--operators", kOperators, nullptr, Choose<Task::kOperators>},
    {"--schema", kSchema, nullptr, Choose<Task::kSchema>},
};

constexpr OptionRule kRules[] = {
    {"--frames", kRender | kExport, "give a frame, or A..B with A <= B",
     [](const std::string& text, Options* o) { return Keep(ReadRange(text), &o->frames); }},
    {"--size", kDraw | kRun, "give WxH, each from 16 to 16384",
     [](const std::string& text, Options* o) { return Keep(ReadSize(text), &o->size); }},
    {"--samples", kDraw, "give 1 or 4",
     [](const std::string& text, Options* o) {
       return KeepInt(text, 1, 4, &o->samples) && (o->samples == 1 || o->samples == 4);
     }},
    {"--camera", kDraw,
     "give front, back, left, right, top, three-quarter, or EX,EY,EZ,TX,TY,TZ[,FOV]",
     [](const std::string& text, Options* o) { return Keep(ReadCamera(text), &o->camera); }},
    {"--threads", kDraw, "give a whole number from 1",
     [](const std::string& text, Options* o) {
       return KeepInt(text, 1, std::numeric_limits<int>::max(), &o->threads);
     }},
    {"--ghosts", kDraw, "give a whole number from 1 to 1000000",
     [](const std::string& text, Options* o) { return KeepInt(text, 1, 1000000, &o->ghosts); }},
    {"--body", kDraw, "give skin, capsules or both",
     [](const std::string& text, Options* o) { return Keep(ReadBody(text), &o->body); }},
    {"--paths", kDraw, nullptr, Set<&Options::paths>},
    {"--marks", kDraw, nullptr, Set<&Options::marks>},
    {"--tint", kDraw, nullptr, Set<&Options::tint>},
    {"--frame-number", kDraw, nullptr, Set<&Options::frame_number>},
    {"--no-shadow", kDraw, nullptr, Set<&Options::shadow, false>},
    {"--save", kImport, "the name must end in .kfa", ReadSaved},
    {"--clip", kForeign, "name a clip of the file",
     [](const std::string& text, Options* o) {
       o->import.clip = text;
       return !text.empty();
     }},
    {"--up", kForeign, "give y or z", ReadUp},
    {"--unit", kForeign, "give the metres of the file's unit, such as 0.01",
     [](const std::string& text, Options* o) {
       return KeepPositive(text, 1e6, &o->import.metres_per_unit);
     }},
    {"--height", kForeign, "give metres, such as 1.75",
     [](const std::string& text, Options* o) {
       return KeepPositive(text, 1000.0, &o->import.height_m);
     }},
    {"--mass", kForeign, "give kilograms, such as 70",
     [](const std::string& text, Options* o) {
       return KeepPositive(text, 1e6, &o->import.mass_kg);
     }},
    {"--reduce", kForeign, "give degrees, such as 1",
     [](const std::string& text, Options* o) {
       return KeepPositive(text, 90.0, &o->import.reduce_deg);
     }},
    {"--limits", kForeign, "give clip or none", ReadLimits},
    {"--no-skin", kForeign, nullptr,
     [](const std::string&, Options* o) {
       o->import.skin = false;
       return true;
     }},
    {"--all-warnings", kForeign, nullptr, Set<&Options::all_warnings>},
    {"--method", kMotion, "the methods are: exact, paper", ReadMethod},
    {"--step", kMotion, "give seconds from 0.000001 to 1", ReadField<kStepField, &Options::step_s>},
    {"--tolerance", kMotion, "give degrees from 1e-10 to 5",
     ReadField<kToleranceField, &Options::tolerance_deg>},
    {"--fps", kRender | kBake | kInfo | kFlight | kImport | kExport,
     "give 0.1 to 10000 frames a second, such as 60, 29.97 or 30000/1001",
     [](const std::string& text, Options* o) { return Keep(ReadRate(text), &o->rate); }},
    {"--bvh-up", kBvh, "give y or z", ReadBvhUp},
    {"--bvh-unit", kBvh, "give m or cm", ReadBvhUnit},
    {"--timings", kBake | kJson, nullptr, Set<&Options::timings>},
    {"--torques", kBake | kJson | kCsv, nullptr, Set<&Options::torques>},
    {"--trace", kWindow, nullptr, Set<&Options::trace>},
    {"--json", kCheck | kInfo | kFlight, nullptr, Set<&Options::json>},
};

// "--check and --info", "--export to .bvh"
std::string TaskNames(unsigned tasks) {
  std::string text;
  const auto add = [&](unsigned named, const std::string& name) {
    if ((named & tasks) != named) return;
    tasks &= ~named;
    text += (text.empty() ? "" : tasks ? ", " : " and ") + name;
  };
  for (const OptionRule& task : kTasks) add(task.tasks, task.name);
  for (const auto& [format, suffix] : {std::pair(kBvh, ".bvh"), std::pair(kJson, ".json"),
                                       std::pair(kCsv, ".csv"), std::pair(kVideo, ".mp4")})
    add(format, std::string("--export to ") + suffix);
  return text;
}

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
  std::vector<std::string> known = {"--help", "--version"};
  for (const OptionRule& rule : kTasks) known.push_back(rule.name);
  for (const OptionRule& rule : kRules) known.push_back(rule.name);
  for (const std::string& argument : app.remaining()) {
    const std::string name = argument.substr(0, argument.find('='));
    const auto nearest = Nearest(name, known);
    throw UsageError("unknown option " + name +
                     (nearest ? "; did you mean " + *nearest + "?" : ""));
  }
}

void Declare(std::span<const OptionRule> rules, CLI::App* app) {
  for (const OptionRule& rule : rules) {
    if (rule.remedy) {
      app->add_option(rule.name)->expected(1)->type_name("value");
    } else {
      app->add_flag(rule.name)->disable_flag_override();
    }
  }
}

void Read(const CLI::App& app, const OptionRule& rule, Options* options) {
  if (app.count(rule.name) == 0) return;
  const std::string text = rule.remedy ? app[rule.name]->as<std::string>() : "";
  if (rule.read(text, options)) return;
  throw UsageError(std::string(rule.name) + " " + text + ": " + rule.remedy);
}

// The task that is asked for, read.
const OptionRule& ReadTask(const CLI::App& app, Options* options) {
  const OptionRule* chosen = nullptr;
  for (const OptionRule& task : kTasks) {
    if (app.count(task.name) == 0) continue;
    if (chosen) {
      throw UsageError(std::string(chosen->name) + " and " + task.name + ": one task at a time");
    }
    chosen = &task;
  }
  static constexpr OptionRule kEditInWindow = {"the editor", kWindow, nullptr,
                                               Choose<Task::kWindow>};
  if (!chosen) return options->task = Task::kWindow, kEditInWindow;
  Read(app, *chosen, options);
  return *chosen;
}

void ReadOptions(const CLI::App& app, Options* options) {
  RefuseUnknown(app);
  const OptionRule& task = ReadTask(app, options);
  const unsigned tasks = TasksOf(task, *options);
  for (const OptionRule& rule : kRules) {
    if (app.count(rule.name) != 0 && !(rule.tasks & tasks)) {
      throw UsageError(std::string(rule.name) + " belongs to " + TaskNames(rule.tasks) +
                       ", not to " + TaskText(task, *options));
    }
    Read(app, rule, options);
  }
  RefuseLargePictures(*options);
  if (task.tasks & kImport) {
    if (options->files.size() > 1) throw UsageError("--import takes one file, and no FILE beside");
    if (options->output.empty()) throw UsageError("--import wants --save OUT.kfa beside it");
    if (options->rate) options->import.fps = options->rate->FrameAt(1.0);
    return;
  }
  if (task.tasks & (kOperators | kSchema)) {
    if (!options->files.empty()) throw UsageError(std::string(task.name) + " takes no FILE");
    return;
  }
  if (options->files.empty() && !(task.tasks & (kRun | kWindow))) {
    throw UsageError("no FILE; name a project (.kfa)");
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

}  // namespace

// CLI11 only tells options, values and files apart: what they mean is in the rules above.
ParsedCommandLine ParseCommandLine(int argc, const char* const* argv) {
  CLI::App app("", "hazumi");
  Options options;
  app.allow_extras();
  app.set_version_flag("--version", "hazumi " + ProgramVersion());
  Declare(kTasks, &app);
  Declare(kRules, &app);
  app.add_option("FILE", options.files);
  try {
    app.parse(argc, argv);
    ReadOptions(app, &options);
  } catch (const CLI::CallForHelp&) {
    std::fputs(kHelpText, stdout);
    return {std::nullopt, kExitOk};
  } catch (const CLI::CallForVersion& version) {
    PrintLine(stdout, "%s", version.what());
    return {std::nullopt, kExitOk};
  } catch (const UsageError& error) {
    return {std::nullopt, ComplainOfUsage(error.what())};
  } catch (const CLI::ParseError& error) {
    return {std::nullopt, ComplainOfUsage(Explain(error))};
  }
  return {options, kExitOk};
}

}  // namespace hazumi
