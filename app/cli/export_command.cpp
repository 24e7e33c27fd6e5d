#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/option_values.h"
#include "app/cli/pictures.h"
#include "app/cli/terminal.h"
#include "app/cli/verify.h"
#include "engine/base/atomic_file.h"
#include "engine/base/version.h"
#include "engine/exchange/export_motion.h"
#include "engine/exchange/onto/export_onto.h"
#include "render/motion/figure_skin.h"
#include "render/pipeline/video.h"
#include "ui/edit/media_files.h"
#include "ui/edit/operators/foreign_files.h"

namespace hazumi {

namespace {

std::string Generator() { return std::string("Hazumi ") + kVersion; }

// Of a motion it matters which frames there are, too.
std::vector<std::string> GivenOf(const Options& options) {
  std::vector<std::string> given = options.given;
  if (options.frames) {
    given.push_back("--frames=" + std::to_string(options.frames->first) + ".." +
                    std::to_string(options.frames->last));
  }
  return given;
}

int ExportFile(const BakedProject& baked, const FrameRange& frames, const Options& options) {
  const Skin capsules = baked.project.skin ? Skin() : render::SkinOfLinks(*baked.animation.figure);
  MotionExportOptions settings;
  settings.format = MotionFormatOf(options.output).value();
  if (!baked.project.name.empty()) settings.name = baked.project.name;
  settings.generator = Generator();
  settings.up = options.z_up ? UpAxis::kZ : UpAxis::kY;
  settings.metres_per_unit = options.in_metres ? 1.0 : 0.01;
  settings.skin = baked.project.skin ? baked.project.skin.meshes().get() : &capsules;
  if (baked.project.source) settings.above = baked.project.source->above;
  settings.timings = options.timings;
  settings.torques = options.torques;
  settings.effort = options.effort;
  settings.made_by = {MadeByText(), GivenOf(options)};
  PrintWarnings(options.files[0], LeftOutOf(baked.animation, settings.format));
  // Without --frames also what happens between the last output frame and the motion's end.
  const Motion motion =
      options.frames ? PartOf(baked.motion, frames.first, frames.last) : baked.motion;
  const Result<std::string> bytes = ExportMotion(baked.animation, motion, settings);
  if (Interrupted()) return Complain(InterruptedError());
  if (!bytes.ok()) return Complain(bytes.error());
  const auto written = WriteFileAtomically(options.output, bytes.value(), WriteMode::kDurable);
  return written.ok() ? kExitOk : Complain(written.error());
}

// Puts the motion into the file that the figure was imported from.
int ExportOntoSource(const BakedProject& baked, const FrameRange& frames, const Options& options) {
  OntoOptions onto;
  onto.source = options.onto;
  onto.how = baked.project.source ? OptionsOf(*baked.project.source) : options.import;
  onto.output = options.output;
  onto.is_cancelled = [] { return Interrupted().load(); };
  const Motion motion = PartOf(baked.motion, frames.first, frames.last);
  const Result<OntoFile> file = ExportOnto(baked.animation, motion, onto);
  if (Interrupted()) return Complain(InterruptedError());
  if (!file.ok()) return Complain(file.error());
  const auto written = WriteFileAtomically(options.output, file.value().bytes, WriteMode::kDurable);
  if (!written.ok()) return Complain(written.error());
  std::string names;
  for (const std::string& bone : file.value().bones) names += (names.empty() ? "" : ", ") + bone;
  PrintLine(stdout, "%s", names.empty() ? "no bone has changed" : ("changed: " + names).c_str());
  return kExitOk;
}

// Each side a pixel more where it is odd: colours are stored for two by two pixels.
PictureSize EvenSize(const PictureSize& size) {
  const PictureSize even{size.width + size.width % 2, size.height + size.height % 2};
  if (even.width != size.width || even.height != size.height) {
    PrintLine(stderr, "hazumi: warning: --size %dx%d: videos have even sizes; drawing %dx%d",
              size.width, size.height, even.width, even.height);
  }
  return even;
}

int ExportVideo(const BakedProject& baked, const FrameRange& frames, const Options& options) {
  const FrameRate& rate = baked.motion.rate;
  const auto sound = edit::HeardIn(baked.project, options.files[0], rate.SecondsAt(frames.first),
                                   rate.SecondsAt(frames.last - frames.first + 1),
                                   edit::MediaAccess(options.open_outside));
  if (!sound.ok()) return Complain(sound.error());
  const Result<Motion> path_motion = PathMotion(baked, options);
  if (!path_motion.ok()) return Complain(path_motion.error());
  const PictureSize size = EvenSize(PictureSizeOf(options));
  const Result<render::FigureSkin> skin = SkinOn(baked, options.files[0]);
  if (!skin.ok()) return Complain(skin.error());
  const Result<render::ThingModels> things = ThingsOf(baked, options.files[0]);
  if (!things.ok()) return Complain(things.error());
  const Result<render::ReferenceFilm> film = FilmOf(baked, options.files[0], options.open_outside);
  if (!film.ok()) return Complain(film.error());
  Pictures pictures(baked, frames, path_motion.value(), skin.value(), things.value(), film.value(),
                    size, options);
  Progress progress("export", pictures.count());
  render::Sequence sequence = pictures.Sequence();
  sequence.progress = [&](int done) {
    progress.Report(done, "frame " + std::to_string(pictures.FrameOf(done - 1)));
  };
  const Result<int> drawn =
      RenderVideo(SequenceOptionsOf(options, size), sequence,
                  {options.output, size.width, size.height, rate.num, rate.den, sound.value()});
  progress.Finish();
  return drawn.ok() ? kExitOk : Complain(drawn.error());
}

}  // namespace

int RunExport(const Options& options) {
  if (const auto error = edit::CheckPlace(options.output)) return Complain(*error);
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  PrintWarnings(options.files[0], baked.value().warnings);
  const auto frames = ChosenFrames(baked.value().motion, options, "writing");
  if (!frames || !HasFewGhosts(baked.value().motion, options)) return kExitUsage;
  if (!options.onto.empty()) return ExportOntoSource(baked.value(), *frames, options);
  return IsVideo(options.output) ? ExportVideo(baked.value(), *frames, options)
                                 : ExportFile(baked.value(), *frames, options);
}

}  // namespace hazumi
