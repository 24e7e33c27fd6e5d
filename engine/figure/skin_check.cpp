#include <algorithm>

#include "engine/figure/skin.h"

namespace hazumi {

namespace {

std::string Item(const char* list, size_t i) {
  return std::string(list) + "[" + std::to_string(i) + "]";
}

Error WrongSkin(const std::string& place, const std::string& message) {
  return {ErrorCode::kSemantics, "", place, message};
}

bool IsIndex(int i, size_t size) { return i >= 0 && static_cast<size_t>(i) < size; }
bool IsIndexOrNone(int i, size_t size) { return i == -1 || IsIndex(i, size); }

Result<Done> CheckLengths(const SkinMesh& mesh, const std::string& place) {
  const size_t n = mesh.positions.size();
  const auto wrong = [&](const char* list, size_t size) {
    return WrongSkin(place + "." + list, "has " + std::to_string(size) + " entries for " +
                                             std::to_string(n) + " vertices; import the mesh anew");
  };
  if (mesh.normals.size() != n) return wrong("normals", mesh.normals.size());
  if (mesh.bind_indices.size() != n) return wrong("bind_indices", mesh.bind_indices.size());
  if (mesh.weights.size() != n) return wrong("weights", mesh.weights.size());
  const size_t places = mesh.texture_coordinates.size();
  if (places != 0 && places != n) return wrong("texture_coordinates", places);
  if (!mesh.colors.empty() && mesh.colors.size() != n) return wrong("colors", mesh.colors.size());
  return Done{};
}

bool IsFinite(const SkinMesh& mesh, size_t i) {
  return mesh.positions[i].allFinite() && mesh.normals[i].allFinite() &&
         (mesh.texture_coordinates.empty() || mesh.texture_coordinates[i].allFinite()) &&
         (mesh.colors.empty() || mesh.colors[i].allFinite());
}

// A little more than 1 is left by rounding to fewer digits.
bool IsWeight(float w) { return w >= 0.0f && w <= 1.001f; }

Result<Done> CheckVertices(const SkinMesh& mesh, const std::string& place) {
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!IsFinite(mesh, i)) {
      return WrongSkin(place + "." + Item("positions", i), "the vertex is not finite");
    }
    if (!std::all_of(mesh.weights[i].begin(), mesh.weights[i].end(), IsWeight)) {
      return WrongSkin(place + "." + Item("weights", i), "must be numbers from 0 to 1");
    }
    for (const std::uint16_t bind : mesh.bind_indices[i]) {
      if (bind >= mesh.binds.size()) {
        return WrongSkin(place + "." + Item("bind_indices", i),
                         "there is no bind " + std::to_string(bind) + "; the mesh has " +
                             std::to_string(mesh.binds.size()));
      }
    }
  }
  return Done{};
}

Result<Done> CheckBindsAndTriangles(const Skin& skin, const SkinMesh& mesh,
                                    const std::string& place) {
  for (size_t i = 0; i < mesh.binds.size(); ++i) {
    if (!IsIndex(mesh.binds[i].bone, skin.bones.size())) {
      return WrongSkin(place + "." + Item("binds", i) + ".bone", "there is no such bone");
    }
    if (!mesh.binds[i].inverse_bind.allFinite()) {
      return WrongSkin(place + "." + Item("binds", i) + ".inverse_bind", "is not finite");
    }
  }
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      if (vertex >= mesh.positions.size()) {
        return WrongSkin(place + "." + Item("triangles", i),
                         "there is no vertex " + std::to_string(vertex));
      }
    }
  }
  return Done{};
}

Result<Done> CheckMesh(const Skin& skin, const SkinMesh& mesh, const std::string& place) {
  if (!IsIndexOrNone(mesh.material, skin.materials.size())) {
    return WrongSkin(place + ".material", "there is no such material");
  }
  Result<Done> checked = CheckLengths(mesh, place);
  if (checked.ok()) checked = CheckVertices(mesh, place);
  return checked.ok() ? CheckBindsAndTriangles(skin, mesh, place) : checked;
}

}  // namespace

Result<Done> CheckSkin(const Skin& skin) {
  for (size_t i = 0; i < skin.bones.size(); ++i) {
    const double share = skin.bones[i].share;
    if (!(share >= 0.0 && share <= 1.0)) {
      return WrongSkin(Item("bones", i) + ".share", "must be a number from 0 to 1");
    }
  }
  for (size_t i = 0; i < skin.materials.size(); ++i) {
    if (!IsIndexOrNone(skin.materials[i].texture, skin.textures.size())) {
      return WrongSkin(Item("materials", i) + ".texture", "there is no such texture");
    }
    if (!IsIndexOrNone(skin.materials[i].emission_texture, skin.textures.size())) {
      return WrongSkin(Item("materials", i) + ".emission_texture", "there is no such texture");
    }
  }
  for (size_t i = 0; i < skin.meshes.size(); ++i) {
    Result<Done> checked = CheckMesh(skin, skin.meshes[i], Item("meshes", i));
    if (!checked.ok()) return checked;
  }
  return Done{};
}

}  // namespace hazumi
