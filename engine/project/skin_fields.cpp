// A skin in a project: what is large is base64 of little-endian bytes.

#include <bit>
#include <cstring>

#include "engine/base/base64.h"
#include "engine/figure/skin.h"
#include "engine/project/fields/project_fields.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/read_value.h"

namespace hazumi {

namespace {

static_assert(std::endian::native == std::endian::little, "bytes are written as they lie");

// Any list of plain numbers, or of arrays or small vectors of them.
template <typename T>
Json Bytes(const std::vector<T>& values) {
  return ToBase64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

template <typename T>
void TakeBytes(FieldReader& in, const char* name, const std::string& text, std::vector<T>& values) {
  const std::optional<std::string> bytes = FromBase64(text);
  if (!bytes || bytes->size() % sizeof(T) != 0) return in.At(name).Report(Check::kNotBytes);
  values.resize(bytes->size() / sizeof(T));
  if (!bytes->empty()) std::memcpy(static_cast<void*>(values.data()), bytes->data(), bytes->size());
}

template <typename T>
void ReadBytes(FieldReader& in, const char* name, std::vector<T>& values) {
  std::string text;
  in.Required({name}, text);
  TakeBytes(in, name, text, values);
}

// Not given: empty.
template <typename T>
void ReadOptionalBytes(FieldReader& in, const char* name, std::vector<T>& values) {
  std::string text;
  in.Optional({name}, text);
  TakeBytes(in, name, text, values);
}

Json ToJson(const SkinBone& bone) {
  if (bone.share == 1.0) return bone.joint;
  return {{"joint", bone.joint}, {"share", bone.share}};
}

Json ToJson(const SkinMesh::Bind& bind) {
  Json matrix = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix.push_back(bind.inverse_bind(row, column));
  }
  return {{"bone", bind.bone}, {"inverse_bind", std::move(matrix)}};
}

Json ToJson(const SkinMesh& mesh) {
  Json binds = Json::array();
  for (const SkinMesh::Bind& bind : mesh.binds) binds.push_back(ToJson(bind));
  Json json = {{"name", mesh.name},
               {"material", mesh.material},
               {"binds", std::move(binds)},
               {"positions", Bytes(mesh.positions)},
               {"normals", Bytes(mesh.normals)},
               {"texture_coordinates", Bytes(mesh.texture_coordinates)},
               {"bind_indices", Bytes(mesh.bind_indices)},
               {"weights", Bytes(mesh.weights)},
               {"triangles", Bytes(mesh.triangles)}};
  if (!mesh.colors.empty()) json["colors"] = Bytes(mesh.colors);
  return json;
}

Json ToJson(const Material& material) {
  const auto& c = material.base_color;
  Json json = {{"name", material.name},
               {"base_color", Json::array({c[0], c[1], c[2], c[3]})},
               {"texture", material.texture}};
  const auto& e = material.emission;
  if (e != Material().emission) json["emission"] = Json::array({e[0], e[1], e[2]});
  if (material.emission_texture >= 0) json["emission_texture"] = material.emission_texture;
  return json;
}

Json ToJson(const Texture& texture) {
  return {{"name", texture.name}, {"image", Bytes(texture.encoded)}};
}

template <typename T>
Json ListToJson(const std::vector<T>& items) {
  Json list = Json::array();
  for (const T& item : items) list.push_back(ToJson(item));
  return list;
}

}  // namespace

static void ReadValue(const Json& json, const Site& site, SkinBone& bone) {
  if (!json.is_object()) return hazumi::ReadValue(json, site, bone.joint);
  ReadObject(json, site, bone, [](FieldReader& in, SkinBone& shared) {
    in.Required({"joint"}, shared.joint);
    in.Required({"share"}, shared.share);
  });
}

static void Describe(FieldReader& in, SkinMesh::Bind& bind) {
  std::array<double, 12> matrix{};
  in.Required({"bone"}, bind.bone);
  in.Required({"inverse_bind"}, matrix);
  for (int i = 0; i < 12; ++i) bind.inverse_bind(i / 4, i % 4) = matrix[i];
}

static void Describe(FieldReader& in, SkinMesh& mesh) {
  in.Required({"name"}, mesh.name);
  in.Required({"material"}, mesh.material);
  in.Required({"binds"}, mesh.binds);
  ReadBytes(in, "positions", mesh.positions);
  ReadBytes(in, "normals", mesh.normals);
  ReadBytes(in, "texture_coordinates", mesh.texture_coordinates);
  ReadOptionalBytes(in, "colors", mesh.colors);
  ReadBytes(in, "bind_indices", mesh.bind_indices);
  ReadBytes(in, "weights", mesh.weights);
  ReadBytes(in, "triangles", mesh.triangles);
}

static void Describe(FieldReader& in, Material& material) {
  std::array<double, 4> color{};
  in.Required({"name"}, material.name);
  in.Required({"base_color"}, color);
  in.Required({"texture"}, material.texture);
  std::array<double, 3> emission{};
  in.Optional({"emission"}, emission);
  in.Optional({"emission_texture"}, material.emission_texture, -1);
  for (size_t i = 0; i < 4; ++i) material.base_color[i] = static_cast<float>(color[i]);
  for (size_t i = 0; i < 3; ++i) material.emission[i] = static_cast<float>(emission[i]);
}

static void Describe(FieldReader& in, Texture& texture) {
  in.Required({"name"}, texture.name);
  ReadBytes(in, "image", texture.encoded);
}

static void Describe(FieldReader& in, Skin& skin) {
  in.Required({"bones"}, skin.bones);
  in.Required({"meshes"}, skin.meshes);
  in.Optional({"materials"}, skin.materials);
  in.Optional({"textures"}, skin.textures);
}

// Null if it is not sound, which is reported.
static std::shared_ptr<const Skin> ReadSkin(const Json& json, const Site& site) {
  Skin skin;
  ReadValue(json, site, skin);
  if (!site.errors->ok()) return nullptr;
  if (const Result<Done> checked = CheckSkin(skin); !checked.ok()) {
    site.Field(checked.error().place).Report(Check::kBadMesh, {checked.error().message});
    return nullptr;
  }
  return std::make_shared<const Skin>(std::move(skin));
}

static Json SkinToJson(const Skin& skin) {
  return {{"bones", ListToJson(skin.bones)},
          {"meshes", ListToJson(skin.meshes)},
          {"materials", ListToJson(skin.materials)},
          {"textures", ListToJson(skin.textures)}};
}

void ReadValue(const Json& json, const Site& site, ProjectMesh& value) {
  value.skin = ReadSkin(json, site);
}

Json ToJson(const ProjectMesh& value) { return value ? SkinToJson(*value.skin) : Json(); }

void ReadValue(const Json& json, const Site& site, ProjectSkin& value) {
  if (json.is_object() && json.contains("shipped")) {
    return ReadObject(json, site, value, [](FieldReader& in, ProjectSkin& reference) {
      in.Required({"shipped"}, reference.shipped.emplace());
    });
  }
  value.skin = ReadSkin(json, site);
}

Json ToJson(const ProjectSkin& value) {
  if (!value) return nullptr;
  if (value.shipped) return {{"shipped", NameOf(*value.shipped)}};
  return SkinToJson(*value.skin);
}

}  // namespace hazumi
