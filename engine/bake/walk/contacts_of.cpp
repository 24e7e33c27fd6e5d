// Between two surfaces with coefficients of friction a and b that of both is sqrt(a b).

#include "engine/bake/walk/contacts_of.h"

#include <cmath>

namespace hazumi {

namespace {

void AddObstacle(const SceneObject& object, int index, ContactSpec* spec) {
  ContactObstacle obstacle;
  obstacle.object = index;
  obstacle.friction = std::sqrt(SceneObject::kFriction * object.friction);
  if (const auto* plane = std::get_if<Plane>(&object.shape)) {
    obstacle.normal = plane->normal;
    obstacle.offset = plane->offset;
  } else if (const auto* box = std::get_if<Box>(&object.shape)) {
    obstacle.is_box = true;
    obstacle.p = box->X_WB.p;
    obstacle.R = box->X_WB.R;
    obstacle.half_size = box->half_size;
  } else {
    return;  // scenes have no capsules
  }
  spec->obstacles.push_back(obstacle);
}

}  // namespace

ContactSpec ContactsOf(const RegionModel& model, const Figure& figure,
                       const std::vector<SceneObject>& scene,
                       const std::function<bool(JointIndex)>& touches) {
  ContactSpec spec;
  for (size_t i = 0; i < scene.size(); ++i) AddObstacle(scene[i], static_cast<int>(i), &spec);
  for (size_t i = 0; i < figure.links().size(); ++i) {
    const Link& link = figure.links()[i];
    if (!touches(link.joint)) continue;
    const NodeJoint* seat = model.SeatOf(link.joint);
    if (!seat || !model.nodes[seat->node].is_dynamic) continue;
    spec.capsules.push_back({seat->node, OnNode(*seat, link.capsule.a),
                             OnNode(*seat, link.capsule.b), link.capsule.radius,
                             static_cast<int>(i)});
  }
  return spec;
}

}  // namespace hazumi
