#include "engine/bake/island_curves.h"

#include <utility>

namespace hazumi {

namespace {

// action(hinge), in the order of the numbers.
template <typename Model, typename Action>
void ForEachDrivenHinge(Model& model, Action&& action) {
  for (auto& node : model.nodes) {
    if (node.role != Role::kDriven) continue;
    for (int h = 0; h < node.num_hinges; ++h) action(node.hinges[h]);
  }
}

}  // namespace

RegionModel WithOwnCurves(RegionModel model) {
  Coordinate count = 0;
  ForEachDrivenHinge(model, [&](NodeHinge& hinge) { hinge.coordinate = count++; });
  return model;
}

std::shared_ptr<const DrivenMotion> CurvesOf(const RegionModel& model, const DrivenMotion& driven) {
  DrivenMotion curves;
  curves.holds_until = driven.holds_until;
  ForEachDrivenHinge(model, [&](const NodeHinge& hinge) {
    curves.angles.push_back(driven.angles[hinge.coordinate]);
  });
  if (model.coupling == RootCoupling::kPrescribed) curves.root_position = driven.root_position;
  if (driven.drives.empty()) return std::make_shared<const DrivenMotion>(std::move(curves));
  for (const ModelNode& node : model.nodes) {
    if (node.role != Role::kFree) continue;
    for (int h = 0; h < node.num_hinges; ++h) {
      const Coordinate hinge = node.hinges[h].coordinate;
      curves.drives.push_back(driven.drives[hinge]);
      if (!driven.springs.empty()) curves.springs.push_back(driven.springs[hinge]);
    }
  }
  return std::make_shared<const DrivenMotion>(std::move(curves));
}

}  // namespace hazumi
