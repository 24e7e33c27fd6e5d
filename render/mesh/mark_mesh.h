#pragma once

#include "render/mesh/flat_mesh.h"
#include "render/mesh/projector.h"
#include "render/scene/scene.h"

namespace hazumi::render {

// The scene's polylines and markers, projected; those on top apart from those solids may hide.
struct MarkMeshes {
  FlatMesh hidden_by_solids;
  FlatMesh on_top;
};
MarkMeshes BuildMarks(const Scene& scene, const Projector& projector);

// Cuts a line into dashes of length dash_m with gaps as long; the first dash starts at the first
// point. dash_m <= 0 leaves the line whole.
std::vector<std::vector<Vec3>> SplitIntoDashes(const std::vector<Vec3>& points, double dash_m);

}  // namespace hazumi::render
