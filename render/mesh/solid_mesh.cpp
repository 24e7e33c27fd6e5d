#include "render/mesh/solid_mesh.h"

namespace hazumi::render {
namespace {

template <typename Shape>
void AppendAll(const std::vector<Shape>& shapes, SolidKind kind,
               void (*append)(const Shape&, SolidMesh&), SolidMesh& mesh) {
  for (const Shape& shape : shapes) {
    const SolidKind its_kind = shape.color.a < 1.0f ? SolidKind::kGhost : SolidKind::kOpaque;
    if (its_kind == kind) append(shape, mesh);
  }
}

}  // namespace

void SolidMesh::Clear() {
  vertices.clear();
  indices.clear();
}

void AppendSolids(const Scene& scene, SolidKind kind, SolidMesh& mesh) {
  AppendAll(scene.capsules, kind, AppendTaperedCapsule, mesh);
  AppendAll(scene.ellipsoids, kind, AppendEllipsoid, mesh);
  AppendAll(scene.boxes, kind, AppendBox, mesh);
}

}  // namespace hazumi::render
