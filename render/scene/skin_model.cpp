#include "render/scene/skin_model.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "engine/figure/skin.h"
#include "engine/picture/decode_pictures.h"
#include "render/scene/skin_triangles.h"

namespace hazumi::render {
namespace {

constexpr float kBulkWeight = 0.4f;

// Alpha cuts holes where a good part of the texels is (nearly) clear and another one opaque. What
// is merely less than opaque, or clear everywhere, is alpha that was never meant.
bool CutsHoles(const Image& image) {
  size_t clear = 0, opaque = 0;
  const size_t texels = image.rgba.size() / 4;
  for (size_t i = 0; i < texels; ++i) {
    clear += image.rgba[4 * i + 3] < 32;
    opaque += image.rgba[4 * i + 3] > 223;
  }
  return clear * 200 > texels && opaque * 200 > texels;
}

// What ails the reader concerns all textures and is said once.
void Warn(const std::string& texture, const Error& error, std::vector<Warning>* warnings) {
  const bool is_of_reader = error.code == ErrorCode::kFailed;
  if (is_of_reader && !warnings->empty() && warnings->back().message == error.message) return;
  warnings->push_back({is_of_reader ? "textures" : texture, error.message});
}

void DecodeTextures(SkinModel* model) {
  std::vector<std::span<const std::uint8_t>> files;
  for (const Texture& texture : model->skin->textures) files.emplace_back(texture.encoded);
  for (Result<Image>& image : DecodePictures(files)) {
    const size_t i = model->textures.size();
    const std::string place =
        "textures[" + std::to_string(i) + "] " + model->skin->textures[i].name;
    if (!image.ok()) Warn(place, image.error(), &model->warnings);
    model->textures.push_back(image.ok() ? std::move(image).value() : Image());
  }
}

SkinModel::Part PartOf(const SkinModel& model, const SkinMesh& mesh) {
  const Material material =
      mesh.material < 0 ? Material() : model.skin->materials[static_cast<size_t>(mesh.material)];
  SkinModel::Part part;
  part.base_color = material.base_color;
  const auto seen = [&](int texture) {
    const bool is_seen = texture >= 0 && !mesh.texture_coordinates.empty() &&
                         model.textures[static_cast<size_t>(texture)].width > 0;
    return is_seen ? texture : -1;
  };
  part.texture = seen(material.texture);
  part.has_colors = !mesh.colors.empty();
  part.emission = material.emission;
  part.emission_texture = seen(material.emission_texture);
  part.is_mirrored =
      !mesh.binds.empty() && mesh.binds[0].inverse_bind.topLeftCorner<3, 3>().determinant() < 0.0;
  return part;
}

void AddPart(const SkinMesh& mesh, const std::vector<std::uint32_t>& indices,
             SkinModel::Surface surface, SkinModel::Part part, SkinModel* model) {
  if (indices.empty()) return;
  part.surface = surface;
  AddLevels(mesh, indices, &part, model);
  model->parts.push_back(std::move(part));
}

void AddParts(const SkinMesh& mesh, SkinModel* model) {
  using Surface = SkinModel::Surface;
  const SkinModel::Part part = PartOf(*model, mesh);
  const SkinSurface surface = SplitSurface(mesh);
  const bool has_holes =
      part.texture >= 0 && CutsHoles(model->textures[static_cast<size_t>(part.texture)]);
  AddPart(mesh, surface.closed, has_holes ? Surface::kCutout : Surface::kClosed, part, model);
  AddPart(mesh, surface.open, has_holes ? Surface::kCutout : Surface::kOpen, part, model);
  model->num_vertices += mesh.positions.size();
}

// Vertices that no triangle uses are not seen and must not enlarge what is.
std::vector<char> UsedVertices(const SkinMesh& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) used[vertex] = 1;
  }
  return used;
}

void IncludeVertex(const SkinMesh& mesh, size_t i, SkinModel* model) {
  const std::array<float, 4> weights = SaneWeights(mesh.weights[i]);
  for (size_t k = 0; k < 4; ++k) {
    if (weights[k] <= 0.0f) continue;
    const SkinMesh::Bind& bind = mesh.binds[mesh.bind_indices[i][k]];
    const Eigen::Vector4d v = mesh.positions[i].cast<double>().homogeneous();
    const Vec3 p = (bind.inverse_bind * v).head<3>();
    const size_t bone = static_cast<size_t>(bind.bone);
    model->reach[bone].Include(p);
    if (weights[k] >= kBulkWeight) model->bulk[bone].Include(p);
  }
}

void FindSeenVertices(SkinModel* model) {
  model->reach.resize(model->skin->bones.size());
  model->bulk.resize(model->skin->bones.size());
  std::uint32_t first = 0;
  for (const SkinMesh& mesh : model->skin->meshes) {
    const std::vector<char> used = UsedVertices(mesh);
    for (size_t i = 0; i < used.size(); ++i) {
      if (used[i] == 0) continue;
      model->seen_vertices.push_back(first + static_cast<std::uint32_t>(i));
      IncludeVertex(mesh, i, model);
    }
    first += static_cast<std::uint32_t>(used.size());
  }
}

}  // namespace

Result<std::shared_ptr<const SkinModel>> MakeSkinModel(std::shared_ptr<const Skin> skin) {
  const Result<Done> checked = CheckSkin(*skin);
  if (!checked.ok()) return checked.error();
  auto model = std::make_shared<SkinModel>();
  model->skin = std::move(skin);
  DecodeTextures(model.get());
  for (const SkinMesh& mesh : model->skin->meshes) AddParts(mesh, model.get());
  FindSeenVertices(model.get());
  return std::shared_ptr<const SkinModel>(std::move(model));
}

}  // namespace hazumi::render
