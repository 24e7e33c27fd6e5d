#include "engine/figure/skin.h"

#include <algorithm>

namespace hazumi {

namespace {

bool IsIndex(int i, size_t size) { return i >= 0 && static_cast<size_t>(i) < size; }

template <typename Vectors>
bool AreFinite(const Vectors& vectors) {
  return std::all_of(vectors.begin(), vectors.end(),
                     [](const auto& vector) { return vector.allFinite(); });
}

bool BindsAreGood(const SkinMesh& mesh, const Skin& skin) {
  return !mesh.binds.empty() &&
         std::all_of(mesh.binds.begin(), mesh.binds.end(), [&](const SkinMesh::Bind& bind) {
           return IsIndex(bind.bone, skin.bones.size()) && bind.inverse_bind.allFinite();
         });
}

bool VerticesAreGood(const SkinMesh& mesh) {
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    for (size_t k = 0; k < 4; ++k) {
      const bool is_good = mesh.bind_indices[v][k] < mesh.binds.size() &&
                           mesh.weights[v][k] >= 0.0f && mesh.weights[v][k] <= 1.001f;
      if (!is_good) return false;
    }
  }
  return true;
}

}  // namespace

std::string WhatIsWrongWith(const SkinMesh& mesh, const Skin& skin) {
  const size_t num = mesh.positions.size();
  const bool even = mesh.normals.size() == num && mesh.bind_indices.size() == num &&
                    mesh.weights.size() == num &&
                    (mesh.texture_coordinates.empty() || mesh.texture_coordinates.size() == num);
  if (!even) return "its vertices have more of one property than of another";
  if (!BindsAreGood(mesh, skin)) return "its binds name no bone of the skin, or are not finite";
  if (!VerticesAreGood(mesh)) return "a vertex follows a bind that is not there, or by no weight";
  const bool finite =
      AreFinite(mesh.positions) && AreFinite(mesh.normals) && AreFinite(mesh.texture_coordinates);
  if (!finite) return "a vertex is not finite";
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      if (corner >= num) return "a triangle has a corner that is not there";
    }
  }
  const bool looks = mesh.material == -1 || IsIndex(mesh.material, skin.materials.size());
  return looks ? "" : "its material is not there";
}

}  // namespace hazumi
