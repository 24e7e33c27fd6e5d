#include "render/scene/skin_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "render/image/decode.h"

namespace hazumi::render {
namespace {

constexpr std::int64_t kMostTexturePixels = 2 * kMostPixels;  // of all textures together
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

void DecodeTextures(SkinModel* model) {
  std::int64_t pixels = 0;
  for (size_t i = 0; i < model->skin->textures.size(); ++i) {
    const Texture& texture = model->skin->textures[i];
    Result<Image> image = DecodeImage(texture.encoded);
    const std::string place = "textures[" + std::to_string(i) + "] " + texture.name;
    if (!image.ok()) model->warnings.push_back({place, image.error().message});
    Image decoded = image.ok() ? std::move(image).value() : Image();
    pixels += std::int64_t{decoded.width} * decoded.height;
    if (pixels > kMostTexturePixels) {
      model->warnings.push_back({place, "is left out: all textures together may have " +
                                            std::to_string(kMostTexturePixels) + " pixels"});
      decoded = Image();
    }
    model->is_cutout.push_back(CutsHoles(decoded));
    model->textures.push_back(std::move(decoded));
  }
}

SkinModel::Part PartOf(const SkinModel& model, size_t mesh_index) {
  const SkinMesh& mesh = model.skin->meshes[mesh_index];
  const Material material =
      mesh.material < 0 ? Material() : model.skin->materials[static_cast<size_t>(mesh.material)];
  SkinModel::Part part{mesh_index,          model.num_vertices,
                       model.num_indices,   3 * mesh.triangles.size(),
                       material.base_color, material.texture};
  const bool has_texture = part.texture >= 0 && !mesh.texture_coordinates.empty() &&
                           model.textures[static_cast<size_t>(part.texture)].width > 0;
  if (!has_texture) part.texture = -1;
  return part;
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

void FindBoxes(SkinModel* model) {
  model->reach.resize(model->skin->bones.size());
  model->bulk.resize(model->skin->bones.size());
  for (const SkinMesh& mesh : model->skin->meshes) {
    const std::vector<char> used = UsedVertices(mesh);
    for (size_t i = 0; i < used.size(); ++i) {
      if (used[i] != 0) IncludeVertex(mesh, i, model);
    }
  }
}

}  // namespace

Result<std::shared_ptr<const SkinModel>> MakeSkinModel(std::shared_ptr<const Skin> skin) {
  const Result<Done> checked = CheckSkin(*skin);
  if (!checked.ok()) return checked.error();
  auto model = std::make_shared<SkinModel>();
  model->skin = std::move(skin);
  DecodeTextures(model.get());
  for (size_t i = 0; i < model->skin->meshes.size(); ++i) {
    model->parts.push_back(PartOf(*model, i));
    model->num_vertices += model->skin->meshes[i].positions.size();
    model->num_indices += model->parts.back().num_indices;
  }
  FindBoxes(model.get());
  return std::shared_ptr<const SkinModel>(std::move(model));
}

}  // namespace hazumi::render
