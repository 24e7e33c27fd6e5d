#include "app/cli/commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "engine/analysis/held_turn.h"
#include "engine/analysis/problems/problems.h"
#include "engine/bake/bake.h"
#include "engine/bake/bake_size.h"
#include "engine/base/text.h"
#include "engine/exchange/content.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "engine/exchange/reader/whole_file.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"

namespace hazumi {

int Complain(const Error& error) {
  PrintLine(stderr, "hazumi: %s", error.ToString().c_str());
  return ExitCodeOf(error);
}

Error InFile(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

namespace {

// --method, --step and --tolerance go before what the file and its regions say.
void ApplySolverOptions(const Options& options, Project* project) {
  ProjectSolver& solver = project->solver;
  solver.method = options.method.value_or(solver.method);
  if (options.step_s) solver.step_s = options.step_s;
  if (options.tolerance_deg) solver.tolerance_deg = options.tolerance_deg;
  for (ProjectRegion& region : project->regions) {
    if (options.method) region.method.reset();
    if (options.step_s) region.step_s.reset();
    if (options.tolerance_deg) region.tolerance_deg.reset();
  }
}

bool Uses(const Animation& animation, Method method) {
  return animation.solver.method == method ||
         std::any_of(animation.regions.begin(), animation.regions.end(),
                     [&](const DynamicsRegion& region) {
                       return !region.is_muted && region.method == method;
                     });
}

// Of options that only the method not used would heed.
void WarnAboutSolverOptions(const Options& options, const Animation& animation,
                            std::vector<Warning>* warnings) {
  if (options.step_s && !Uses(animation, Method::kPaper)) {
    warnings->push_back(
        {"--step", "has no effect: everything is solved by method exact; use --tolerance"});
  }
  if (options.tolerance_deg && !Uses(animation, Method::kExact)) {
    warnings->push_back(
        {"--tolerance", "has no effect: everything is solved by method paper; use --step"});
  }
}

constexpr double kLong = 100e6;     // [bytes]
constexpr double kLongCheck = 5e6;  // a thousand frames, for --check takes a fifth of a second

// Whether the frames take less memory than this [bytes].
bool IsShort(const Animation& animation, const Options& options, double most) {
  return MotionBytes(animation, options.rate.value_or(animation.rate)) <= most;
}

// Returns whether to compute the effort. The torques are part of it, and so are problems, which
// --info and --check report of a short animation.
bool FindsEffort(const Animation& animation, const Options& options) {
  if (options.effort || options.torques) return true;
  if (options.task == Task::kInfo) return IsShort(animation, options, kLong);
  return options.task == Task::kCheck && IsShort(animation, options, kLongCheck);
}

// Returns whether to search for residual moments. Long animations are not searched.
bool FindsHeldTurns(const Animation& animation, const Options& options) {
  return MayHoldTurns(animation) && IsShort(animation, options, kLong);
}

// Returns whether the bake keeps frames. --check and --info show none, but effort is computed from
// them.
bool KeepsFrames(const Animation& animation, const Options& options) {
  const bool shows_none = options.task == Task::kInfo || options.task == Task::kCheck;
  return !shows_none || FindsEffort(animation, options) || FindsHeldTurns(animation, options);
}

// What is made of a frame besides the frame itself, about [bytes].
double BytesOfOneFrame(const Animation& animation, const Options& options) {
  const double joints = animation.figure->num_joints();
  const bool is_motion_file = options.task == Task::kBake || options.task == Task::kExport;
  const double effort = options.effort || options.torques ? 100.0 * joints + 2000.0 : 0.0;
  return effort + (is_motion_file && !IsVideo(options.output) ? 300.0 * joints + 1000.0 : 0.0);
}

// A project has a million frames at most, and so has what is made of it.
std::optional<Error> CheckLength(const Animation& animation, const Options& options) {
  constexpr double kMostFrames = 1e6;
  if (!options.rate) return std::nullopt;
  const double frames = NumOutputFrames(animation, *options.rate);
  if (frames <= kMostFrames) return std::nullopt;
  return Error{ErrorCode::kSemantics, "", "--fps",
               FormatNumber(frames) + " output frames; 1000000 are the most, choose a lower rate"};
}

// What a task makes of a motion takes memory besides it.
std::optional<Error> CheckMemory(const Animation& animation, const Options& options) {
  if (!KeepsFrames(animation, options)) return std::nullopt;
  const FrameRate rate = options.rate.value_or(animation.rate);
  const double made = BytesOfOneFrame(animation, options) * NumOutputFrames(animation, rate);
  return CheckBytes(MotionBytes(animation, rate) + made, animation, rate);
}

// Projects are told by their suffix, all else by content: a .json may be either.
bool IsProject(const std::string& file) {
  if (file.ends_with(".kfa")) return true;
  if (!file.ends_with(".json")) return false;
  const Result<std::string> beginning = FileBeginning(file, kContentBytes);
  return beginning.ok() && !FormatOf(ReadUse::kCharacter, beginning.value(), file).ok();
}

Result<Project> LoadOrImport(const std::string& file, const ImportOptions& options,
                             ImportReport* report) {
  if (IsProject(file)) return LoadProject(file);
  Result<Imported> imported = Import(file, options);
  if (!imported.ok()) return imported.error();
  *report = std::move(imported.value().report);
  return std::move(imported.value().project);
}

}  // namespace

Error InterruptedError() { return {ErrorCode::kInterrupted, "", "", "interrupted"}; }

Result<Imported> Import(const std::string& file, const ImportOptions& options) {
  ReadOptions reading = ReadOptionsFor(options);
  reading.is_cancelled = [] { return Interrupted().load(); };
  const Result<Character> character = ReadCharacter(file, reading);
  if (!character.ok()) return character.error();
  Result<Imported> imported = ImportProject(character.value(), options);
  if (Interrupted()) return InterruptedError();
  if (!imported.ok()) return InFile(imported.error(), file);
  return imported;
}

Result<ImportOptions> ImportOptionsOf(const Options& options) {
  ImportOptions how = options.import;
  if (options.roles.empty()) return how;
  Result<RoleMap> roles = ReadRoles(options.roles);
  if (!roles.ok()) return roles.error();
  how.roles = std::move(roles).value();
  return how;
}

// Work limit of --check, which should take at most a fifth of a second (Work).
static constexpr double kMostCheckWork = 1.5e5;

// Energy is what --info and JSON tell.
static BakeOptions BakeOptionsOf(const Animation& animation, const Options& options) {
  BakeOptions baking;
  baking.output_rate = options.rate;
  baking.cancel = &Interrupted();
  baking.energy = options.task == Task::kInfo || options.task == Task::kBake ||
                  (options.task == Task::kExport && options.output.ends_with(".json"));
  baking.seams = baking.energy;
  baking.accelerations = FindsEffort(animation, options) || FindsHeldTurns(animation, options);
  baking.keep_frames = KeepsFrames(animation, options);
  if (options.task == Task::kCheck) baking.most_work = kMostCheckWork;
  return baking;
}

static void Add(std::vector<Warning> more, std::vector<Warning>* warnings) {
  warnings->insert(warnings->end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
}

Result<BakedProject> LoadAndBake(const std::string& file, const Options& options) {
  ImportReport report;
  const Result<ImportOptions> how = ImportOptionsOf(options);
  if (!how.ok()) return how.error();
  Result<Project> project = LoadOrImport(file, how.value(), &report);
  if (!project.ok()) return InFile(project.error(), file);
  if (Interrupted()) return InterruptedError();
  ApplySolverOptions(options, &project.value());
  Result<Compiled> compiled = CompileAnimation(project.value(), &Interrupted());
  if (Interrupted()) return InterruptedError();
  if (!compiled.ok()) return InFile(compiled.error(), file);
  Animation& animation = compiled.value().animation;
  if (auto error = CheckLength(animation, options)) return InFile(*error, file);
  if (auto error = CheckMemory(animation, options)) return InFile(*error, file);
  Result<Motion> motion = Bake(animation, BakeOptionsOf(animation, options));
  if (Interrupted()) return InterruptedError();
  if (!motion.ok()) return InFile(motion.error(), file);
  std::vector<Warning> warnings =
      Shortened(report.warnings, options.all_warnings ? 0 : kShortReport);
  Add(std::move(compiled.value().warnings), &warnings);
  WarnAboutSolverOptions(options, animation, &warnings);
  Add(motion.value().warnings, &warnings);
  if (FindsHeldTurns(animation, options)) {
    Add(WarningsOf(FindHeldTurns(animation, motion.value()), animation), &warnings);
  }
  return BakedProject{std::move(project).value(), std::move(animation), std::move(motion).value(),
                      std::move(warnings)};
}

std::vector<std::string> ProblemTexts(const BakedProject& baked, const Effort& effort) {
  const Animation& animation = baked.animation;
  std::vector<std::string> texts;
  if (baked.motion.frames.empty()) return texts;
  const Analyses analyses =
      AnalysesOf(animation, baked.motion, effort, baked.project.size_is_guessed);
  for (const Finding& finding : FindProblems(animation, baked.motion, analyses)) {
    if (!IsAWarning(finding)) texts.push_back(TextOf(finding, animation));
  }
  return texts;
}

void PrintNotes(const std::string& file, const Motion& motion) {
  for (size_t r = 0; r < motion.regions.size(); ++r) {
    const std::optional<double> from = motion.regions[r].OneOfSeveralFrom();
    if (!from) continue;
    PrintLine(stderr,
              "hazumi: %s: regions[%zu]: note: from frame %s on this is one of several likely "
              "motions; after hard contacts the least difference decides which",
              file.c_str(), r, FormatShort(*from).c_str());
  }
}

void PrintWarnings(const std::string& file, const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) {
    PrintLine(stderr, "hazumi: %s: %s: warning: %s", file.c_str(), warning.place.c_str(),
              warning.message.c_str());
  }
}

}  // namespace hazumi
