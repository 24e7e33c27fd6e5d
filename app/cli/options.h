#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/exchange/import/import_project.h"
#include "engine/spatial/types.h"
#include "engine/timeline/animation.h"
#include "render/motion/motion_scene.h"

namespace hazumi {

// kWindow: no other task was named.
enum class Task {
  kWindow,
  kRender,
  kExport,
  kBake,
  kCheck,
  kInfo,
  kFlight,
  kImport,
  kRun,
  kOperators,
  kSchema,
  kSweep,
  kVerify,
  kFields,
  kQuantities,
  kManual,
  kCompletion
};

struct FrameRange {
  int first = 0, last = 0;  // inclusive
};

struct PictureSize {
  int width = 0, height = 0;
};

// A view that replaces the project's camera: a named side, or eye, target and field of view.
struct CameraChoice {
  std::string side;  // front, back, left, right, top, three-quarter; empty: as below
  Vec3 eye = Vec3::Zero(), target = Vec3::Zero();
  double vertical_fov_deg = 35.0;
};

// What the command line asks for. See `hazumi --help`.
struct Options {
  Task task = Task::kWindow;
  std::string output;  // of --render, --export, --bake, --save and --out
  std::string script;  // of --run and --sweep
  std::string shell;   // of --completion: bash, zsh or fish
  std::vector<std::string>
      files;  // --check takes several, --run and the window one or none, the others one

  std::optional<FrameRange> frames;
  std::optional<PictureSize> size;  // not given: 1280x720, of the editor 1280x800
  int samples = 4;
  std::optional<CameraChoice> camera;
  int threads = 2;  // any number from 1; two at most are used
  int ghosts = 0;   // one every so many frames; 0: none
  bool paths = false;
  bool marks = false;
  bool tint = false;
  render::FigureLook body = render::FigureLook::kSkin;
  bool shadow = true;
  bool frame_number = false;
  bool open_outside = false;  // sounds and references that lie outside of the project's folder

  ImportOptions import;  // how files of other programs are read
  std::string onto;      // of --export: the file that the motion is put into
  std::string roles;     // file with roles of bones
  bool all_warnings = false;
  bool strict = false;  // option of --check

  std::optional<Method> method;
  std::optional<double> step_s;
  std::optional<double> tolerance_deg;
  std::optional<FrameRate> rate;
  bool z_up = false;       // of BVH; else y up
  bool in_metres = false;  // of BVH; else in centimetres
  bool timings = false;
  bool torques = false;
  bool effort = false;
  bool trace = false;  // of the window
  bool json = false;

  // Of --sweep.
  int tasks = 0;        // 0: all cells
  int task_number = 0;  // from 0 to tasks - 1
  bool count = false;

  // Those that were given and change what comes out, as words: "--fps", "60".
  std::vector<std::string> given;
};

// Either options, or an exit code after the message (help, version, what is wrong) was printed.
struct ParsedCommandLine {
  std::optional<Options> options;
  int exit_code = 0;
};
ParsedCommandLine ParseCommandLine(int argc, const char* const* argv);

// The same of words, without the program's name. Errors: kSchema, with what is wrong.
Result<Options> ParseWords(const std::vector<std::string>& words);

}  // namespace hazumi
