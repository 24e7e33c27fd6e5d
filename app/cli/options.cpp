#include "app/cli/options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "app/cli/exit_codes.h"
#include "app/cli/version.h"

namespace hazumi {

namespace {

constexpr const char* kFooter = R"(
Exit codes: 0 ok, 1 failed, 2 usage, 65 bad data, 66 no input, 73 cannot write, 130 interrupted.
Results go to standard output, progress to standard error.

  hazumi --render out/throw throw.kfa            frames out/throw/frame_0000.png ...
  hazumi --render out/t_####.png --frames 5..15 --size 640x360 throw.kfa
  hazumi --bake motion.json jump.kfa             angles, positions, events; - for standard output
  hazumi --check *.kfa)";

std::optional<FrameRange> ParseRange(const std::string& text) {
  FrameRange range;
  int used = 0;
  if (std::sscanf(text.c_str(), "%d..%d%n", &range.first, &range.last, &used) == 2 &&
      used == static_cast<int>(text.size())) {
    return range;
  }
  if (std::sscanf(text.c_str(), "%d%n", &range.first, &used) == 1 &&
      used == static_cast<int>(text.size())) {
    range.last = range.first;
    return range;
  }
  return std::nullopt;
}

bool ParseSize(const std::string& text, int* width, int* height) {
  int used = 0;
  return std::sscanf(text.c_str(), "%dx%d%n", width, height, &used) == 2 &&
         used == static_cast<int>(text.size()) && *width >= 16 && *height >= 16 &&
         *width <= 16384 && *height <= 16384;
}

// "30", "29.97" or "30000/1001".
std::optional<FrameRate> ParseRate(const std::string& text) {
  FrameRate rate;
  int used = 0;
  const int size = static_cast<int>(text.size());
  if (std::sscanf(text.c_str(), "%d/%d%n", &rate.num, &rate.den, &used) == 2 && used == size &&
      rate.num > 0 && rate.den > 0) {
    return rate;
  }
  double fps = 0.0;
  if (std::sscanf(text.c_str(), "%lf%n", &fps, &used) != 1 || used != size) return std::nullopt;
  if (!(fps >= 0.001 && fps <= 100000.0)) return std::nullopt;
  rate.den = fps == static_cast<int>(fps) ? 1 : 1000;
  rate.num = static_cast<int>(std::lround(fps * rate.den));
  return rate;
}

std::optional<CameraChoice> ParseCamera(const std::string& text) {
  for (const char* side : {"front", "back", "left", "right", "top", "three-quarter"}) {
    if (text == side) return CameraChoice{side};
  }
  CameraChoice camera;
  Vec3 &e = camera.eye, &t = camera.target;
  const int got = std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf", &e.x(), &e.y(), &e.z(),
                              &t.x(), &t.y(), &t.z(), &camera.vertical_fov_deg);
  const bool sane =
      (e - t).norm() > 1e-6 && camera.vertical_fov_deg > 0.1 && camera.vertical_fov_deg < 170.0;
  if (got < 6 || !sane) return std::nullopt;
  return camera;
}

// The texts of options that need more than CLI11's own conversions.
struct RawOptions {
  std::string render, bake, frames, size, camera, fps, method;
  bool check = false, info = false, no_shadow = false;
};

void Declare(CLI::App* app, RawOptions* raw, Options* options) {
  app->set_version_flag("--version", std::string("hazumi ") + kVersion);
  app->footer(kFooter);
  auto* tasks = app->add_option_group("Tasks", "One of these");
  tasks
      ->add_option("--render", raw->render,
                   "Draw frames to OUT: a folder, or a pattern with #### for the frame number")
      ->type_name("OUT");
  tasks->add_option("--bake", raw->bake, "Write the motion to OUT: .json or .csv, - for JSON")
      ->type_name("OUT");
  tasks->add_flag("--check", raw->check, "Say of each file whether it can be animated");
  tasks->add_flag("--info", raw->info, "Say what is in the file");
  tasks->require_option(1);
  app->add_option("FILE", options->files, "Project (.kfa)")->required();

  auto* draw = app->add_option_group("Drawing");
  draw->add_option("--frames", raw->frames, "Only these frames")->type_name("A..B");
  draw->add_option("--size", raw->size, "Picture size in pixels [1280x720]")->type_name("WxH");
  draw->add_option("--samples", options->samples, "Samples a pixel: 1 or 4 [4]")
      ->check(CLI::IsMember({1, 4}));
  draw->add_option("--camera", raw->camera,
                   "front, back, left, right, top, three-quarter, or ex,ey,ez,tx,ty,tz[,fov]")
      ->type_name("VIEW");
  draw->add_option("--threads", options->threads, "1, or 2: one draws, one writes [2]")
      ->check(CLI::Range(1, 2));
  draw->add_option("--ghosts", options->ghosts, "A translucent figure every N frames")
      ->check(CLI::Range(1, 1000000))
      ->type_name("N");
  draw->add_flag("--paths", options->paths, "Draw the paths of CoM, hands and feet");
  draw->add_flag("--marks", options->marks, "Draw a ring at the pinned joint");
  draw->add_flag("--tint", options->tint, "Tint the joints that a dynamics region moves");
  draw->add_flag("--frame-number", options->frame_number, "Draw the frame number");
  draw->add_flag("--no-shadow", raw->no_shadow, "Draw no shadow");

  auto* solve = app->add_option_group("Motion");
  solve->add_option("--method", raw->method, "Instead of the file's: paper")
      ->check(CLI::IsMember({"paper"}));
  solve->add_option("--step", options->step_s, "Solver step in seconds, instead of the file's")
      ->check(CLI::Range(1e-6, 10.0))
      ->type_name("S");
  solve->add_option("--fps", raw->fps, "Frames a second of the output; the motion is the same")
      ->type_name("N[/D]");
  solve->add_flag("--timings", options->timings, "Bake: also write how long each region took");
  app->add_flag("--json", options->json, "Check and info: answer in JSON");
}

void Require(bool good, const std::string& option, const std::string& wanted) {
  if (!good) throw CLI::ValidationError(option, "wants " + wanted);
}

void Interpret(const RawOptions& raw, Options* options) {
  options->task = !raw.render.empty() ? Task::kRender
                  : !raw.bake.empty() ? Task::kBake
                  : raw.check         ? Task::kCheck
                  : raw.info          ? Task::kInfo
                                      : Task::kNone;
  options->output = raw.render.empty() ? raw.bake : raw.render;
  Require(options->task != Task::kNone, "OUT", "a name");
  Require(options->task == Task::kCheck || options->files.size() == 1, "FILE",
          "one file; only --check takes several");
  options->shadow = !raw.no_shadow;
  if (!raw.method.empty()) options->method = Method::kPaper;
  if (!raw.frames.empty()) {
    options->frames = ParseRange(raw.frames);
    Require(options->frames && options->frames->first <= options->frames->last, "--frames",
            "a frame, or A..B with A <= B");
  }
  Require(raw.size.empty() || ParseSize(raw.size, &options->width, &options->height), "--size",
          "WxH, each from 16 to 16384");
  if (!raw.camera.empty()) {
    options->camera = ParseCamera(raw.camera);
    Require(options->camera.has_value(), "--camera",
            "front, back, left, right, top, three-quarter, or ex,ey,ez,tx,ty,tz[,fov]");
  }
  if (raw.fps.empty()) return;
  options->rate = ParseRate(raw.fps);
  Require(options->rate.has_value(), "--fps", "a positive number or fraction");
}

}  // namespace

ParsedCommandLine ParseCommandLine(int argc, const char* const* argv) {
  CLI::App app("Hazumi: keyframe animation with regions that swing by their own inertia", "hazumi");
  RawOptions raw;
  Options options;
  Declare(&app, &raw, &options);
  try {
    app.parse(argc, argv);
    Interpret(raw, &options);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return {std::nullopt, code == 0 ? kExitOk : kExitUsage};
  }
  return {options, kExitOk};
}

}  // namespace hazumi
