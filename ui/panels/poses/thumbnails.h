#pragma once

// Small pictures of poses on the project's figure, drawn beside the interface and kept.

#include <memory>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/picture/image.h"
#include "engine/project/pose_file.h"
#include "ui/panels/dialogs/background_task.h"
#include "ui/panels/poses/state.h"

namespace hazumi::ui {

// The figure in a pose, seen from the side and before it: what the pose does not say is at rest,
// and without a height it stands on the ground.
render::Scene SceneOf(const SavedPose& pose, const std::shared_ptr<const Figure>& figure);

class Thumbnails {
 public:
  explicit Thumbnails(PictureKeeper pictures) : pictures_(std::move(pictures)) {}
  ~Thumbnails() { Clear(); }
  Thumbnails(const Thumbnails&) = delete;
  Thumbnails& operator=(const Thumbnails&) = delete;

  // The texture of a pose's picture; 0 as long as there is none, it will then be drawn.
  unsigned TextureOf(const SavedPose& pose);
  // Once a frame, before the pictures are asked for: pictures are of this figure and size.
  void Begin(std::shared_ptr<const Figure> figure, int edge_px);
  // And behind: what was asked for and is not there is begun.
  void End();
  bool is_busy() const { return task_ != nullptr; }

 private:
  struct Kept {
    SavedPose pose;
    unsigned texture = 0;
  };
  void Clear();
  void TakeDrawn();

  PictureKeeper pictures_;
  std::shared_ptr<const Figure> figure_;
  int edge_px_ = 0;
  std::vector<Kept> kept_;
  std::vector<SavedPose> wanted_, being_drawn_;
  bool is_of_before_ = false;  // what is being drawn is of another figure or size
  std::unique_ptr<BackgroundTask<std::vector<Image>>> task_;
};

}  // namespace hazumi::ui
