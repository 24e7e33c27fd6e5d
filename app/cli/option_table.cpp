#include "app/cli/option_table.h"

#include <limits>

#include "app/cli/frame_names.h"
#include "app/cli/option_values.h"
#include "engine/exchange/export_motion.h"
#include "engine/project/fields/project_fields.h"

namespace hazumi {

namespace {

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

constexpr const char* kPictureNames =
    "put #### where the frame number goes, or name a folder; one picture is a .png with --frames N";

bool ReadPictures(const std::string& text, Options* options) {
  options->task = Task::kRender;
  options->output = text;
  return !text.empty() && (!IsOnePicture(text) || text.ends_with(".png"));
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

bool ReadSweep(const std::string& text, Options* options) {
  options->task = Task::kSweep;
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

bool ReadShell(const std::string& text, Options* options) {
  options->task = Task::kCompletion;
  options->shell = text;
  return text == "bash" || text == "zsh" || text == "fish";
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
    {.name = "--render",
     .tasks = kRender,
     .value = "OUT",
     .help = "draw frames as PNG pictures; OUT is a folder, or a name with #### where the frame "
             "number goes, or with --frames N the name of one picture",
     .call = "OUT [options] FILE",
     .files = "/",
     .remedy = kPictureNames,
     .read = ReadPictures},
    {.name = "--bake",
     .tasks = kBake,
     .value = "OUT",
     .help = "write the motion: OUT ends in .json or .csv; - is standard output, as JSON",
     .call = "OUT [options] FILE",
     .files = "json csv",
     .remedy = "the name must end in .json or .csv, or be -",
     .read = ReadMotionFile},
    {.name = "--export",
     .tasks = kExport,
     .value = "OUT",
     .help = "write the motion for other programs: OUT ends in .bvh, .gltf, .glb (with the "
             "figure's mesh), .csv, .json or .mp4",
     .call = "OUT [options] FILE",
     .files = "bvh gltf glb csv json mp4",
     .remedy = "the name must end in .bvh, .gltf, .glb, .csv, .json or .mp4",
     .read = ReadExport},
    {.name = "--check",
     .tasks = kCheck,
     .help =
         "say of each file, a project or one of another program, whether it can be animated, and "
         "if not, why",
     .call = "[options] FILE...",
     .read = Choose<Task::kCheck>},
    {.name = "--info",
     .tasks = kInfo,
     .help = "say what is in the file, and its events",
     .call = "[options] FILE",
     .read = Choose<Task::kInfo>},
    {.name = "--flight",
     .tasks = kFlight,
     .help = "find the flights: take-off, apex, landing, the gravity that the path of the centre "
             "of mass implies, and whether the clip plays too slow or fast; how far the feet "
             "slide",
     .call = "[options] FILE",
     .read = Choose<Task::kFlight>},
    {.name = "--import",
     .tasks = kImport,
     .value = "CHARACTER",
     .help = "make a project of a character and its clip: BVH, FBX, glTF, GLB or Collada; says "
             "what was guessed and what is dropped",
     .call = "CHARACTER --save OUT.kfa [options]",
     .files = kCharacterSuffixes,
     .remedy = "name a file: BVH, FBX, glTF, GLB or Collada",
     .read = ReadImported},
    {.name = "--run",
     .tasks = kRun,
     .value = "SCRIPT",
     .help = "edit the project, or a new one: SCRIPT is a JSON list of operators, such as\n"
             "[{\"op\": \"key.set\", \"curve\": \"r_knee\",\n"
             "\"frame\": 5, \"value\": 1},\n"
             "{\"op\": \"file.save\", \"path\": \"my.kfa\"}]\n"
             "nothing is saved unless it says \"file.save\"; with \"capture\" and a \"path\" the "
             "editor is drawn, without a display, --size wide and high (1280x800)",
     .call = "SCRIPT [--size WxH] [FILE]",
     .files = "json",
     .remedy = "name a script, a JSON list of operators",
     .read = ReadScript},
    {.name = "--verify",
     .tasks = kVerify,
     .help = "make the motion or the pictures again, and say whether every value and every pixel "
             "is as it is in MADE: what --bake wrote as .json, or a folder of --render; exit code "
             "1 where one differs",
     .call = "FILE MADE",
     .read = Choose<Task::kVerify>},
    {.name = "--sweep",
     .tasks = kSweep,
     .value = "SWEEP",
     .help = "bake, measure and draw variations of a project, as the file SWEEP says; the table "
             "is FOLDER/sweep.csv. What is in FOLDER already is not computed again",
     .call = "SWEEP.json --out FOLDER [--tasks N --task K]",
     .files = "json",
     .remedy = "name a sweep file (.json)",
     .read = ReadSweep},
    {.name = "--fields",
     .tasks = kFields,
     .help = "list the addresses of a project's fields, with their values: what a sweep can vary",
     .call = "FILE",
     .read = Choose<Task::kFields>},
    {.name = "--quantities",
     .tasks = kQuantities,
     .help = "list what a sweep can measure",
     .read = Choose<Task::kQuantities>},
    {.name = "--operators",
     .tasks = kOperators,
     .help = "list the operators and their parameters",
     .read = Choose<Task::kOperators>},
    {.name = "--schema",
     .tasks = kSchema,
     .help = "write the JSON schema of .kfa files",
     .read = Choose<Task::kSchema>},
    {.name = "--man",
     .tasks = kManual,
     .help = "write the manual page, for man -l -",
     .read = Choose<Task::kManual>},
    {.name = "--completion",
     .tasks = kCompletion,
     .value = "SHELL",
     .help = "write what SHELL completes calls by: bash, zsh or fish",
     .choices = "bash zsh fish",
     .remedy = "give bash, zsh or fish",
     .read = ReadShell},
};

constexpr OptionRule kStandard[] = {
    {.name = "--help", .help = "say all this"},
    {.name = "--version", .help = "say the version, and the commit that it was built from"},
};

constexpr OptionRule kOptions[] = {
    {.name = "--frames",
     .tasks = kRender | kExport,
     .section = Section::kDrawing,
     .value = "A..B",
     .help = "only these frames, or one: N",
     .fallback = "all",
     .more = "--frames counts output frames when --fps is given, and belongs to --export of any "
             "format",
     .remedy = "give a frame, or A..B with A <= B",
     .is_silent = true,
     .read = [](const std::string& text, Options* o) { return Keep(ReadRange(text), &o->frames); }},
    {.name = "--size",
     .tasks = kDraw | kRun,
     .section = Section::kDrawing,
     .value = "WxH",
     .help = "picture size in pixels, 16 to 16384",
     .fallback = "1280x720",
     .more = "of videos even: an odd one grows by a pixel",
     .remedy = "give WxH, each from 16 to 16384",
     .read = [](const std::string& text, Options* o) { return Keep(ReadSize(text), &o->size); }},
    {.name = "--camera",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "VIEW",
     .help = "front, back, left, right, top, three-quarter, or EX,EY,EZ,TX,TY,TZ[,FOV]: eye and "
             "target in metres, angle in degrees",
     .fallback = "the file's, or three-quarter",
     .choices = "front back left right top three-quarter",
     .remedy = "give front, back, left, right, top, three-quarter, or EX,EY,EZ,TX,TY,TZ[,FOV]",
     .read = [](const std::string& text,
                Options* o) { return Keep(ReadCamera(text), &o->camera); }},
    {.name = "--samples",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "N",
     .help = "samples a pixel, 1 or 4",
     .fallback = "4",
     .choices = "1 4",
     .remedy = "give 1 or 4",
     .read =
         [](const std::string& text, Options* o) {
           return KeepInt(text, 1, 4, &o->samples) && (o->samples == 1 || o->samples == 4);
         }},
    {.name = "--threads",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "N",
     .help = "at most 2 are used: one draws, one writes",
     .fallback = "2",
     .remedy = "give a whole number from 1",
     .is_silent = true,
     .read =
         [](const std::string& text, Options* o) {
           return KeepInt(text, 1, std::numeric_limits<int>::max(), &o->threads);
         }},
    {.name = "--body",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "LOOK",
     .help = "skin, capsules, or both: the capsules in a see-through skin; figures without a skin "
             "are capsules",
     .fallback = "skin",
     .choices = "skin capsules both",
     .remedy = "give skin, capsules or both",
     .read = [](const std::string& text, Options* o) { return Keep(ReadBody(text), &o->body); }},
    {.name = "--ghosts",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "N",
     .help = "a translucent figure every N frames",
     .fallback = "none",
     .remedy = "give a whole number from 1 to 1000000",
     .read = [](const std::string& text,
                Options* o) { return KeepInt(text, 1, 1000000, &o->ghosts); }},
    {.name = "--paths",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw the paths of centre of mass, hands, feet and head",
     .read = Set<&Options::paths>},
    {.name = "--marks",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw a ring at the pinned joint",
     .read = Set<&Options::marks>},
    {.name = "--tint",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "tint the joints that a dynamics region moves",
     .read = Set<&Options::tint>},
    {.name = "--frame-number",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw the frame number",
     .read = Set<&Options::frame_number>},
    {.name = "--no-shadow",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw no shadow",
     .read = Set<&Options::shadow, false>},
    {.name = "--save",
     .tasks = kImport,
     .section = Section::kForeignFiles,
     .value = "OUT.kfa",
     .help = "of --import: the project that is written",
     .files = kProjectSuffix,
     .remedy = "the name must end in .kfa",
     .read = ReadSaved},
    {.name = "--clip",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "NAME",
     .help = "which of its clips",
     .fallback = "the first",
     .remedy = "name a clip of the file",
     .read =
         [](const std::string& text, Options* o) {
           o->import.clip = text;
           return !text.empty();
         }},
    {.name = "--up",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "y|z",
     .help = "the axis that is up",
     .fallback = "the file's, or guessed",
     .choices = "y z",
     .remedy = "give y or z",
     .read = ReadUp},
    {.name = "--unit",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "M",
     .help = "metres of its unit of length",
     .fallback = "the file's, or guessed",
     .remedy = "give the metres of the file's unit, such as 0.01",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 1e6, &o->import.metres_per_unit); }},
    {.name = "--height",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "M",
     .help = "or how tall the character is, in metres",
     .remedy = "give metres, such as 1.75",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 1000.0, &o->import.height_m); }},
    {.name = "--mass",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "KG",
     .help = "of all of it",
     .fallback = "of a person so tall",
     .remedy = "give kilograms, such as 70",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 1e6, &o->import.mass_kg); }},
    {.name = "--reduce",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "DEG",
     .help = "keys only where they are needed, so that angles stay within DEG degrees of the clip",
     .fallback = "a key every frame",
     .remedy = "give degrees, such as 1",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 90.0, &o->import.reduce_deg); }},
    {.name = "--limits",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "L",
     .help = "clip: joints go a little farther than in the clip; none",
     .choices = "clip none",
     .remedy = "give clip or none",
     .read = ReadLimits},
    {.name = "--no-skin",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .help = "leave out its meshes",
     .read =
         [](const std::string&, Options* o) {
           o->import.skin = false;
           return true;
         }},
    {.name = "--all-warnings",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .help = "say all that is dropped or changed, not the first ten lines",
     .is_silent = true,
     .read = Set<&Options::all_warnings>},
    {.name = "--method",
     .tasks = kMotion,
     .section = Section::kMotion,
     .value = "M",
     .help = "exact, or paper: the steps of the published method",
     .choices = "exact paper",
     .remedy = "the methods are: exact, paper",
     .read = ReadMethod},
    {.name = "--tolerance",
     .tasks = kMotion,
     .section = Section::kMotion,
     .value = "DEG",
     .help = "of method exact: greatest error of an angle in a region, in degrees, 1e-10 to 5",
     .remedy = "give degrees from 1e-10 to 5",
     .read = ReadField<kToleranceField, &Options::tolerance_deg>},
    {.name = "--step",
     .tasks = kMotion,
     .section = Section::kMotion,
     .value = "S",
     .help = "of method paper: its step in seconds, 0.000001 to 1",
     .remedy = "give seconds from 0.000001 to 1",
     .read = ReadField<kStepField, &Options::step_s>},
    {.name = "--fps",
     .tasks = kRender | kBake | kInfo | kFlight | kImport | kExport,
     .section = Section::kOutput,
     .value = "N",
     .help = "output frames a second, 0.1 to 10000, such as 60, 29.97 or 30000/1001; the motion "
             "is the same",
     .fallback = "the file's",
     .more = "with --render, --bake, --export, --info, --flight",
     .remedy = "give 0.1 to 10000 frames a second, such as 60, 29.97 or 30000/1001",
     .read = [](const std::string& text, Options* o) { return Keep(ReadRate(text), &o->rate); }},
    {.name = "--bvh-up",
     .tasks = kBvh,
     .section = Section::kOutput,
     .value = "y|z",
     .help = "of --export to .bvh: the axis that is up",
     .fallback = "y",
     .choices = "y z",
     .remedy = "give y or z",
     .read = ReadBvhUp},
    {.name = "--bvh-unit",
     .tasks = kBvh,
     .section = Section::kOutput,
     .value = "m|cm",
     .help = "of --export to .bvh: its unit of length",
     .fallback = "cm",
     .choices = "m cm",
     .remedy = "give m or cm",
     .read = ReadBvhUnit},
    {.name = "--timings",
     .tasks = kBake | kJson,
     .section = Section::kOutput,
     .help = "with --bake and --export to .json: reports carry microseconds, off by default so "
             "that two are equal bytes",
     .is_silent = true,
     .read = Set<&Options::timings>},
    {.name = "--torques",
     .tasks = kBake | kJson | kCsv,
     .section = Section::kOutput,
     .help = "with --bake and --export to .json and .csv: also the torque that every joint needs, "
             "by inverse dynamics, and the force that nothing supplies",
     .read = Set<&Options::torques>},
    {.name = "--effort",
     .tasks = kBake | kJson | kCsv | kInfo,
     .section = Section::kOutput,
     .help =
         "with --bake and --export to .json and .csv: also the torque that muscles give in every "
         "joint, as a share of its strength too, and what ground and pin carry; with --info: "
         "the largest of them",
     .read = Set<&Options::effort>},
    {.name = "--json",
     .tasks = kCheck | kInfo | kFlight,
     .section = Section::kOutput,
     .help = "with --check, --info, --flight: answer in JSON",
     .is_silent = true,
     .read = Set<&Options::json>},
    {.name = "--out",
     .tasks = kSweep,
     .section = Section::kSweep,
     .value = "FOLDER",
     .help = "where the results are",
     .files = "/",
     .remedy = "name a folder",
     .read =
         [](const std::string& text, Options* o) {
           o->output = text;
           return !text.empty();
         }},
    {.name = "--tasks",
     .tasks = kSweep,
     .section = Section::kSweep,
     .value = "N",
     .help = "share the cells out among N tasks, on one machine or many",
     .fallback = "all cells",
     .remedy = "give a whole number from 1 to 1000000",
     .read = [](const std::string& text,
                Options* o) { return KeepInt(text, 1, 1000000, &o->tasks); }},
    {.name = "--task",
     .tasks = kSweep,
     .section = Section::kSweep,
     .value = "K",
     .help = "this one's share, from 0 to N - 1; the table is made by a last call without it",
     .remedy = "give a whole number from 0",
     .read = [](const std::string& text,
                Options* o) { return KeepInt(text, 0, 999999, &o->task_number); }},
    {.name = "--count",
     .tasks = kSweep,
     .section = Section::kSweep,
     .help = "only say how many cells there are",
     .read = Set<&Options::count>},
    {.name = "--trace",
     .tasks = kWindow,
     .section = Section::kEditor,
     .help = "say in the end how many events changed the project and how long they took until the "
             "picture was finished, and how many frames playback showed, passed over, and showed "
             "late",
     .read = Set<&Options::trace>},
};

constexpr SectionTitle kSections[] = {
    {Section::kTasks, "Tasks"},
    {Section::kDrawing, "Drawing, with --render and --export to .mp4"},
    {Section::kForeignFiles, "Reading files of other programs"},
    {Section::kMotion, "Motion, with any task, instead of what the file and its regions say"},
    {Section::kOutput, "Output"},
    {Section::kSweep, "Sweeps, with --sweep"},
    {Section::kEditor, "Editor"},
};

// A bit that two tasks had would let the options of one go with the other.
constexpr bool TasksAreDistinct() {
  unsigned seen = kWindow;
  for (const OptionRule& task : kTasks) {
    if (seen & task.tasks) return false;
    seen |= task.tasks;
  }
  return true;
}
static_assert(TasksAreDistinct());

}  // namespace

std::span<const OptionRule> Tasks() { return kTasks; }
std::span<const OptionRule> TaskOptions() { return kOptions; }
std::span<const OptionRule> StandardOptions() { return kStandard; }
std::span<const SectionTitle> Sections() { return kSections; }

std::vector<OptionRule> AllOptions() {
  std::vector<OptionRule> all(std::begin(kTasks), std::end(kTasks));
  all.insert(all.end(), std::begin(kStandard), std::end(kStandard));
  all.insert(all.end(), std::begin(kOptions), std::end(kOptions));
  return all;
}

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
  add(kWindow, "the editor");
  return text;
}

}  // namespace hazumi
