#pragma once

#include <optional>

#include "app/cli/commands.h"
#include "render/motion/motion_scene.h"
#include "render/motion/reference_film.h"
#include "render/pipeline/sequence.h"

namespace hazumi {

// The output frames asked for, as far as the motion has them; none after a complaint. `doing` says
// what becomes of them: "drawing".
std::optional<FrameRange> ChosenFrames(const Motion& motion, const Options& options,
                                       const char* doing);

// Whether so many ghosts can be drawn as the options ask for; false after a complaint.
bool HasFewGhosts(const Motion& motion, const Options& options);

// The size asked for, or 1280 x 720.
PictureSize PictureSizeOf(const Options& options);

render::SequenceOptions SequenceOptionsOf(const Options& options, PictureSize size);

// The motion with so many frames a second that its paths are smooth; empty if none are asked for.
// Errors: those of Bake.
Result<Motion> PathMotion(const BakedProject& baked, const Options& options);

// The project's skin, ready to be drawn; without a model if it has none. Prints what cannot be
// seen.
Result<render::FigureSkin> SkinOn(const BakedProject& baked, const std::string& file);

// Meshes of what the project's figure holds.
Result<render::ThingModels> ThingsOf(const BakedProject& baked, const std::string& file);

// The project's reference, if it is seen in pictures. Errors: of ReferenceFilm::Load.
Result<render::ReferenceFilm> FilmOf(const BakedProject& baked, const std::string& file,
                                     bool open_outside);

// Draws the frames of a baked project as the options want them. What is given must outlive it.
class Pictures {
 public:
  Pictures(const BakedProject& baked, const FrameRange& frames, const Motion& path_motion,
           render::FigureSkin skin, render::ThingModels things, render::ReferenceFilm film,
           PictureSize size, const Options& options);
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;

  int count() const { return frames_.last - frames_.first + 1; }
  int FrameOf(int i) const { return frames_.first + i; }
  // Scenes, their number, and that an interrupt ends it. Must not outlive this.
  render::Sequence Sequence();

 private:
  const BakedProject& baked_;
  FrameRange frames_;
  render::MotionScene scenes_;
  render::ReferenceFilm film_;
};

}  // namespace hazumi
