#pragma once

// The one table of what can be said on the command line. What is taken (options.cpp), the help and
// the manual page (help_text.h) and what shells complete (completion.h) follow from it: a new
// option is a new entry in the file of its section (table/), and a member of Options.

#include <span>
#include <string>
#include <vector>

#include "app/cli/options.h"

namespace hazumi {

// Tasks, a bit each. Of --export the formats are tasks of their own.
enum TaskBits : unsigned {
  kRender = 1u << 0,
  kBake = 1u << 1,
  kCheck = 1u << 2,
  kInfo = 1u << 3,
  kFlight = 1u << 4,
  kImport = 1u << 5,
  kRun = 1u << 6,
  kOperators = 1u << 7,
  kWindow = 1u << 8,  // no task named
  kBvh = 1u << 9,     // --export, by the format
  kVideo = 1u << 10,
  kJson = 1u << 11,
  kCsv = 1u << 12,
  kPlain = 1u << 13,  // others
  kSchema = 1u << 14,
  kSweep = 1u << 15,
  kVerify = 1u << 16,
  kFields = 1u << 17,
  kQuantities = 1u << 18,
  kManual = 1u << 19,
  kCompletion = 1u << 20,
  kExport = kBvh | kVideo | kJson | kCsv | kPlain,
  kDraw = kRender | kVideo,
  kMotion = kRender | kBake | kCheck | kInfo | kFlight | kExport,
  // Those that read files of other programs.
  kForeign = kRender | kBake | kInfo | kFlight | kImport | kExport,
  // Those that take a FILE: a project, of some one of another program.
  kProjects = kMotion | kRun | kWindow | kVerify | kFields,
  kCharacters = kForeign & ~kImport,
};

// Parts of the help, in this order.
enum class Section { kTasks, kDrawing, kForeignFiles, kMotion, kOutput, kSweep, kEditor };
struct SectionTitle {
  Section section;
  const char* title;
};

// An option, the tasks it belongs to, how its value is read, and what is said of it. Texts are
// wrapped where they are printed; '\n' in one begins a new line.
struct OptionRule {
  const char* name = nullptr;  // "--size"
  unsigned tasks = 0;
  Section section = Section::kTasks;
  // The word for its value, "WxH". A flag has none.
  const char* value = nullptr;
  const char* help = nullptr;
  // What holds without it, "1280x720". None: nothing to say.
  const char* fallback = nullptr;
  // Said after that, on lines of their own.
  const char* more = nullptr;
  // Of a task: what follows it in a call, "OUT [options] FILE". None: not among the calls.
  const char* call = nullptr;
  // For shells: the words that the value can be, "exact paper"; or the suffixes of the files that
  // it names, "json csv", "*" any file, "/" a folder.
  const char* choices = nullptr;
  const char* files = nullptr;
  // What to do about a value that cannot be read. A flag has none.
  const char* remedy = nullptr;
  // Of an option: whether it goes with --bake, --render or --export and leaves what they write as
  // it is.
  bool is_silent = false;
  // Puts the value where it belongs. Returns whether it is one.
  bool (*read)(const std::string& text, Options* options) = nullptr;
};

// Tasks: one at a time. Then what goes with them, in the order of the help.
std::span<const OptionRule> Tasks();
std::span<const OptionRule> TaskOptions();
// --help and --version, which the parser of the command line knows by itself.
std::span<const OptionRule> StandardOptions();
// All three.
std::vector<OptionRule> AllOptions();

std::span<const SectionTitle> Sections();

// Suffixes of what a FILE may be: of a project, and of other programs' characters, "bvh fbx".
inline constexpr const char* kProjectSuffix = "kfa";
inline constexpr const char* kCharacterSuffixes = "bvh fbx gltf glb dae";

// The tasks by name: "--check and --info", "--export to .bvh", "the editor".
std::string TaskNames(unsigned tasks);

}  // namespace hazumi
