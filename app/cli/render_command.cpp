#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/frame_names.h"
#include "app/cli/interrupt.h"
#include "app/cli/pictures.h"
#include "app/cli/report_text.h"
#include "app/cli/terminal.h"
#include "app/cli/verify.h"
#include "engine/base/version.h"

namespace hazumi {

namespace {

std::string WithoutControls(std::string text) {
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  return text;
}

// No dates, so that equal input gives equal bytes.
std::vector<render::PngText> Metadata(const BakedProject& baked, const Options& options,
                                      int frame) {
  const SolverSettings& solver = baked.animation.solver;
  return {{"Software", std::string("Hazumi ") + kVersion},
          {"Project", WithoutControls(baked.project.name)},
          {"Frame", std::to_string(frame)},
          {"Solver", FinenessText(solver.method, solver.step, solver.tolerance) + ", version " +
                         std::to_string(solver.version)},
          {"Maker", MadeByText()},
          {"Options", nlohmann::json(options.given)
                          .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)}};
}

int RenderBaked(const BakedProject& baked, const FrameRange& frames, const Options& options) {
  const Result<Motion> path_motion = PathMotion(baked, options);
  if (!path_motion.ok()) return Complain(path_motion.error());
  const Result<FrameNames> names = FrameNames::Create(options.output);
  if (!names.ok()) return Complain(names.error());
  const PictureSize size = PictureSizeOf(options);
  const Result<render::FigureSkin> skin = SkinOn(baked, options.files[0]);
  if (!skin.ok()) return Complain(skin.error());
  const Result<render::ThingModels> things = ThingsOf(baked, options.files[0]);
  if (!things.ok()) return Complain(things.error());
  const Result<render::ReferenceFilm> film = FilmOf(baked, options.files[0], options.open_outside);
  if (!film.ok()) return Complain(film.error());
  Pictures pictures(baked, frames, path_motion.value(), skin.value(), things.value(), film.value(),
                    size, options);
  Progress progress("render", pictures.count());
  const auto name = [&](int i) { return names.value().Of(pictures.FrameOf(i)); };
  render::Sequence sequence = pictures.Sequence();
  sequence.path = [&](int i) { return std::filesystem::path(name(i)); };
  sequence.metadata = [&](int i) { return Metadata(baked, options, pictures.FrameOf(i)); };
  sequence.progress = [&](int done) { progress.Report(done, name(done - 1)); };
  const Result<int> written = RenderSequence(SequenceOptionsOf(options, size), sequence);
  progress.Finish();
  if (!written.ok()) return Complain(written.error());
  return Interrupted() ? Complain(InterruptedError()) : kExitOk;
}

}  // namespace

int RunRender(const Options& options) {
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  PrintWarnings(options.files[0], baked.value().warnings);
  const std::optional<FrameRange> frames = ChosenFrames(baked.value().motion, options, "drawing");
  if (!frames || !HasFewGhosts(baked.value().motion, options)) return kExitUsage;
  return RenderBaked(baked.value(), *frames, options);
}

}  // namespace hazumi
