#include "ui/panels/viewport/solids.h"

#include <algorithm>

namespace hazumi::ui {

namespace {

std::variant<Box, Ball> Placed(const HeldObject& object, const hazumi::Pose& X_WO) {
  if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
    return Ball{X_WO.p, sphere->radius};
  }
  return Box{X_WO, std::get<BoxShape>(object.shape).half_size};
}

}  // namespace

Vec3 Solid::center() const {
  const auto* box = std::get_if<Box>(&shape);
  return box ? box->X_WB.p : std::get<Ball>(shape).center;
}

// The animation has its objects in the order of the project, the frame perhaps those of before an
// edit.
std::vector<Solid> SolidsOf(edit::Session* session, const PosedFigure& figure) {
  std::vector<Solid> solids;
  const Animation* animation = session->animation();
  if (!animation) return solids;
  const Project& project = session->project();
  for (size_t i = 0; i < animation->scene.size(); ++i) {
    const Box* box = std::get_if<Box>(&animation->scene[i].shape);
    const ProjectSceneObject& object = project.scene.objects[i];
    if (box) solids.push_back({object.identity.id, object.name, *box});
  }
  const std::vector<ObjectPose>& poses = figure.frame().objects;
  const size_t count = std::min(poses.size(), animation->held_objects.size());
  for (size_t i = 0; i < count; ++i) {
    const ProjectHeldObject& object = project.held_objects[i];
    solids.push_back(
        {object.identity.id, object.name, Placed(animation->held_objects[i], poses[i].X_WO), true});
  }
  return solids;
}

const Solid* FindSolid(ItemId id, const std::vector<Solid>& solids) {
  for (const Solid& solid : solids) {
    if (id.is_valid() && solid.id == id) return &solid;
  }
  return nullptr;
}

}  // namespace hazumi::ui
