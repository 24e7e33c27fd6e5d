#pragma once

#include <memory>
#include <string>

#include "app/cli/options.h"
#include "engine/sweep/sweep_run.h"
#include "engine/sweep/sweep_store.h"
#include "render/motion/figure_skin.h"

namespace hazumi {

// Draws cells of a sweep into its folder as its picture says: frames side by side, or a video. Used
// on one thread.
class CellPictures {
 public:
  // Whether what the sweep says of pictures is right, before a folder is made. Errors: kSchema,
  // whose place is in the sweep file: options of drawing that are none, or frames that the project
  // has not; kNoInput: a reference outside of the project's folder, without `open_outside`.
  static Result<Done> Check(const Sweep& sweep, bool open_outside);
  // Errors: those of Check, and of what draws.
  static Result<CellPictures> Create(const Sweep& sweep, const SweepStore& store,
                                     bool open_outside);
  ~CellPictures();
  CellPictures(CellPictures&&) noexcept;
  CellPictures& operator=(CellPictures&&) = delete;

  // Errors: of drawing and writing.
  Result<Done> Draw(const SweptCell& cell);

 private:
  struct Parts;
  explicit CellPictures(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

// What a cell's picture ends in: ".png" or ".mp4"; null: there are none.
const char* PictureSuffix(const SweepPlan& plan);

}  // namespace hazumi
