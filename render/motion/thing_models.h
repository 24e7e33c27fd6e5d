#pragma once

// Meshes of held objects, ready to be drawn.

#include <memory>
#include <vector>

#include "engine/timeline/scene_object.h"
#include "render/scene/skin_model.h"

namespace hazumi::render {

// By held object; null: its shape is drawn.
using ThingModels = std::vector<std::shared_ptr<const SkinModel>>;

// Keeps the models that were asked for last. For one document; use it on one thread.
class ThingCache {
 public:
  // Each mesh is stretched to fill the box around its object's shape. Errors: MakeSkinModel's.
  Result<ThingModels> Of(const std::vector<HeldObject>& objects);

 private:
  struct Kept {
    std::shared_ptr<const Skin> mesh;
    Vec3 size;
    std::shared_ptr<const SkinModel> model;
  };
  std::vector<Kept> kept_;
};

}  // namespace hazumi::render
