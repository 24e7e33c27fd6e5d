// The tasks: what a call is for.

#include "app/cli/frame_names.h"
#include "app/cli/option_values.h"
#include "app/cli/table/sections.h"
#include "engine/exchange/export_motion.h"
#include "engine/exchange/onto/export_onto.h"

namespace hazumi {

namespace {

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
  return MotionFormatOf(text) || IsVideo(text) || CanBeOnto(text);
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

bool ReadShell(const std::string& text, Options* options) {
  options->task = Task::kCompletion;
  options->shell = text;
  return text == "bash" || text == "zsh" || text == "fish";
}

template <Task kTask>
bool Choose(const std::string&, Options* options) {
  options->task = kTask;
  return true;
}

constexpr OptionRule kTaskRules[] = {
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
             "figure's mesh), .csv, .json or .mp4; with --onto in .vrm too",
     .call = "OUT [options] FILE",
     .files = "bvh gltf glb vrm csv json mp4",
     .remedy = "the name must end in .bvh, .gltf, .glb, .csv, .json or .mp4",
     .read = ReadExport},
    {.name = "--check",
     .tasks = kCheck,
     .help =
         "say of each file, a project or one of another program, whether it can be animated, and "
         "if not, why; and what is wrong with its motion",
     .call = "[options] FILE...",
     .read = Choose<Task::kCheck>},
    {.name = "--info",
     .tasks = kInfo,
     .help = "say what is in the file, its events, and where most is asked of muscles",
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

// A bit that two tasks had would let the options of one go with the other.
constexpr bool TasksAreDistinct() {
  unsigned seen = kWindow;
  for (const OptionRule& task : kTaskRules) {
    if (seen & task.tasks) return false;
    seen |= task.tasks;
  }
  return true;
}
static_assert(TasksAreDistinct());

}  // namespace

std::span<const OptionRule> TaskRules() { return kTaskRules; }

}  // namespace hazumi
