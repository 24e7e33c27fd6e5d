#include "engine/bake/walk/contacts_of.h"

#include "engine/bake/pose/contact_obstacles.h"

namespace hazumi {

ContactSpec ContactsOf(const RegionModel& model, const Figure& figure,
                       const std::vector<SceneObject>& scene,
                       const std::function<bool(JointIndex)>& touches) {
  ContactSpec spec;
  spec.obstacles = ObstaclesOf(scene, SceneObject::kFriction);
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
