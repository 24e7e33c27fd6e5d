#include "engine/bake/pose/contact_obstacles.h"

namespace hazumi {

std::vector<ContactObstacle> ObstaclesOf(const std::vector<SceneObject>& scene, double friction) {
  std::vector<ContactObstacle> obstacles;
  for (size_t i = 0; i < scene.size(); ++i) {
    const SceneObject& object = scene[i];
    ContactObstacle obstacle;
    obstacle.object = static_cast<int>(i);
    obstacle.friction = MixFriction(friction, object.friction);
    if (const auto* plane = std::get_if<Plane>(&object.shape)) {
      obstacle.normal = plane->normal;
      obstacle.offset = plane->offset;
    } else if (const auto* box = std::get_if<Box>(&object.shape)) {
      obstacle.is_box = true;
      obstacle.p = box->X_WB.p;
      obstacle.R = box->X_WB.R;
      obstacle.half_size = box->half_size;
    } else {
      continue;  // scenes have no capsules
    }
    obstacles.push_back(obstacle);
  }
  return obstacles;
}

}  // namespace hazumi
