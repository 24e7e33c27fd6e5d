#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/picture/image.h"
#include "render/scene/scene.h"
#include "ui/panels/poses/library.h"

namespace hazumi::ui {

class Thumbnails;

// Small pictures as textures; given by whoever owns the GL context.
struct PictureKeeper {
  // Draws scenes that are as wide as high; from any thread.
  std::function<Result<std::vector<Image>>(const std::vector<render::Scene>& scenes, int edge_px)>
      draw;
  // Puts a picture into a texture, and takes such a texture away.
  std::function<unsigned(const Image& picture)> add;
  std::function<void(unsigned texture)> free;
};

// The poses among the properties.
struct PosesState {
  PoseLibrary library;
  std::shared_ptr<Thumbnails> thumbnails;  // made when they are first shown
  bool is_flipped = false;                 // what is clicked is applied left for right
};

}  // namespace hazumi::ui
