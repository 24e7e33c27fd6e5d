#include "render/motion/thing_models.h"

#include <algorithm>

#include "engine/timeline/scene_object.h"

namespace hazumi::render {

Result<ThingModels> ThingCache::Of(const std::vector<HeldObject>& objects) {
  std::vector<Kept> used;
  ThingModels models;
  for (const HeldObject& object : objects) {
    models.emplace_back();
    if (!object.mesh) continue;
    const Vec3 size = BoxAround(object);
    const auto same = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
      return kept.mesh == object.mesh && kept.size == size;
    });
    if (same != kept_.end()) {
      used.push_back(*same);
    } else {
      Result<std::shared_ptr<const SkinModel>> model =
          MakeSkinModel(std::make_shared<const Skin>(Stretched(*object.mesh, size)));
      if (!model.ok()) return model.error();
      used.push_back({object.mesh, size, std::move(model).value()});
    }
    models.back() = used.back().model;
  }
  kept_ = std::move(used);
  return models;
}

}  // namespace hazumi::render
