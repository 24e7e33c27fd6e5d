#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "engine/exchange/gltf_reader/compression.h"
#include "engine/exchange/gltf_reader/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;
using Triangle = std::array<uint32_t, 3>;

enum Mode : size_t { kTriangles = 4, kStrip = 5, kFan = 6 };

// Triangles of indices, counter-clockwise.
std::vector<Triangle> TrianglesOf(size_t mode, const std::vector<uint32_t>& indices) {
  std::vector<Triangle> triangles;
  const size_t count = indices.size();
  for (size_t i = 2; i < count; i += mode == kTriangles ? 3 : 1) {
    const bool is_odd = mode == kStrip && i % 2 == 1;
    const uint32_t first = mode == kFan ? indices[0] : indices[i - 2];
    triangles.push_back(is_odd ? Triangle{indices[i - 1], first, indices[i]}
                               : Triangle{first, indices[i - 1], indices[i]});
  }
  return triangles;
}

// Vertices at one place share a normal.
void AddNormals(SceneMesh* mesh) {
  using Place = std::array<float, 3>;
  const auto place = [&](uint32_t v) {
    const Eigen::Vector3f& p = mesh->positions[v];
    return Place{p.x(), p.y(), p.z()};
  };
  std::map<Place, Eigen::Vector3f> sums;
  for (const auto& [a, b, c] : mesh->triangles) {
    const auto& p = mesh->positions;
    const Eigen::Vector3f twice_area = (p[b] - p[a]).cross(p[c] - p[a]);
    for (const uint32_t v : {a, b, c})
      sums.try_emplace(place(v), Eigen::Vector3f::Zero()).first->second += twice_area;
  }
  for (uint32_t v = 0; v < mesh->positions.size(); ++v) {
    const auto sum = sums.find(place(v));
    mesh->normals.push_back(sum == sums.end() ? Eigen::Vector3f::UnitZ().eval() : sum->second);
  }
}

struct Skin {
  std::vector<int> nodes;  // of the scene; -1: not in it
  std::vector<Eigen::Matrix4d> inverse_binds;
};

class MeshAdder {
 public:
  MeshAdder(const GltfDocument& document, const GltfNodes& nodes, const std::string& file,
            GltfAccessors* accessors, Scene* scene)
      : json_(document.json), nodes_(nodes), file_(file), accessors_(*accessors), scene_(*scene) {}

  Result<Done> Add() {
    const Json& list = Member(json_, "nodes");
    for (size_t i = 0; i < nodes_.in_scene.size(); ++i) {
      const int node = nodes_.in_scene[i];
      if (node < 0 || !list[i].contains("mesh")) continue;
      if (Result<Done> added = AddOfNode(list[i], node); !added.ok()) return added;
    }
    return Done{};
  }

 private:
  Error Wrong(const std::string& place, const std::string& message) const {
    return {ErrorCode::kSchema, file_, place, message + "; the file is broken: export it again"};
  }

  Result<Done> AddOfNode(const Json& node, int index) {
    const Json& mesh = Element(Member(json_, "meshes"), node["mesh"]);
    if (!mesh.is_object()) return Wrong("meshes", "a mesh of a node is not there");
    const Json& primitives = Member(mesh, "primitives");
    for (size_t p = 0; primitives.is_array() && p < primitives.size(); ++p) {
      const Json& skin = Member(node, "skin");
      const auto key = std::tuple(node["mesh"].get<size_t>(), p, skin.dump());
      const auto known = made_.find(key);
      if (known != made_.end()) {
        scene_.nodes[static_cast<size_t>(index)].meshes.push_back(known->second);
        continue;
      }
      const size_t mode = Count(primitives[p], "mode", kTriangles);
      if (mode < kTriangles || mode > kFan) continue;  // points and lines
      Result<SceneMesh> made = MeshOf(primitives[p], skin, PlaceOf(node["mesh"], p));
      if (!made.ok()) return made.error();
      made.value().name = Text(Member(mesh, "name"));
      made_[key] = static_cast<int>(scene_.meshes.size());
      scene_.nodes[static_cast<size_t>(index)].meshes.push_back(made_[key]);
      scene_.meshes.push_back(std::move(made).value());
    }
    std::vector<int>& of_node = scene_.nodes[static_cast<size_t>(index)].meshes;
    if (!of_node.empty()) return Done{};
    of_node.push_back(static_cast<int>(scene_.meshes.size()));  // of points, lines or nothing
    scene_.meshes.emplace_back();
    return Done{};
  }

  static std::string PlaceOf(const Json& mesh, size_t primitive) {
    return "meshes[" + mesh.dump() + "].primitives[" + std::to_string(primitive) + "]";
  }

  Result<SceneMesh> MeshOf(const Json& primitive, const Json& skin, const std::string& place) {
    SceneMesh mesh;
    const Json& attributes = Member(primitive, "attributes");
    if (Result<Done> decoded = Decode(primitive, place); !decoded.ok()) return decoded.error();
    if (Result<Done> added = AddVertices(attributes, place, &mesh); !added.ok())
      return added.error();
    if (Result<Done> added = AddTriangles(primitive, place, &mesh); !added.ok())
      return added.error();
    if (mesh.normals.empty()) AddNormals(&mesh);
    const Json& material = Member(primitive, "material");
    if (Element(Member(json_, "materials"), material).is_object())
      mesh.material = material.get<int>();
    mesh.is_skinned = !skin.is_null() && attributes.contains("JOINTS_0");
    if (!mesh.is_skinned) return mesh;
    if (Result<Done> added = AddBinds(attributes, skin, place, &mesh); !added.ok())
      return added.error();
    return mesh;
  }

  // What is compressed is decoded before it is looked at.
  Result<Done> Decode(const Json& primitive, const std::string& place) {
    draco_.reset();
    const Json& extension = Member(Member(primitive, "extensions"), "KHR_draco_mesh_compression");
    if (extension.is_null()) return Done{};
    const Result<std::string_view> bytes = accessors_.View(Member(extension, "bufferView"));
    if (!bytes.ok()) return bytes.error();
    Result<DracoPrimitive> decoded = DecodeDraco(extension, bytes.value(), place, file_);
    if (!decoded.ok()) return decoded.error();
    draco_ = std::move(decoded).value();
    return Done{};
  }

  Result<GltfValues> ValuesOf(const Json& attributes, const std::string& name) {
    if (draco_) {
      const auto found = draco_->attributes.find(name);
      if (found != draco_->attributes.end()) return found->second;
    }
    return accessors_.Values(attributes[name]);
  }

  // None: there is no such attribute. Error: it has another width, or not as many elements.
  Result<std::optional<GltfValues>> Attribute(const Json& attributes, const std::string& name,
                                              size_t width, std::optional<size_t> count,
                                              const std::string& place) {
    if (!attributes.contains(name)) return std::optional<GltfValues>();
    Result<GltfValues> values = ValuesOf(attributes, name);
    if (!values.ok()) return values.error();
    if (values.value().width != width || (count && values.value().count != *count))
      return Wrong(place, "its " + name + " are not as many as glTF wants");
    return std::optional(std::move(values).value());
  }

  Result<Done> AddVertices(const Json& attributes, const std::string& place, SceneMesh* mesh) {
    const auto positions = Attribute(attributes, "POSITION", 3, std::nullopt, place);
    if (!positions.ok()) return positions.error();
    if (!positions.value()) return Done{};  // of nothing
    const size_t count = positions.value()->count;
    const auto normals = Attribute(attributes, "NORMAL", 3, count, place);
    if (!normals.ok()) return normals.error();
    const auto coordinates = Attribute(attributes, "TEXCOORD_0", 2, count, place);
    if (!coordinates.ok()) return coordinates.error();
    if (Result<Done> added = AddColors(attributes, count, place, mesh); !added.ok())
      return added.error();
    const auto vector = [](const GltfValues& values, size_t v) {
      return Eigen::Vector3d(values.At(v, 0), values.At(v, 1), values.At(v, 2))
          .cast<float>()
          .eval();
    };
    for (size_t v = 0; v < count; ++v) {
      mesh->positions.push_back(vector(*positions.value(), v));
      if (normals.value()) mesh->normals.push_back(vector(*normals.value(), v));
      if (!coordinates.value()) continue;
      mesh->texture_coordinates.push_back(
          Eigen::Vector2d(coordinates.value()->At(v, 0), coordinates.value()->At(v, 1))
              .cast<float>());
    }
    return Done{};
  }

  // With or without alpha, which is not drawn.
  Result<Done> AddColors(const Json& attributes, size_t count, const std::string& place,
                         SceneMesh* mesh) {
    if (!attributes.contains("COLOR_0")) return Done{};
    const Result<GltfValues> values = ValuesOf(attributes, "COLOR_0");
    if (!values.ok()) return values.error();
    const GltfValues& colors = values.value();
    if (colors.count != count || (colors.width != 3 && colors.width != 4))
      return Wrong(place, "its COLOR_0 are not as many as glTF wants");
    for (size_t v = 0; v < count; ++v) {
      mesh->colors.push_back(
          Eigen::Vector3d(colors.At(v, 0), colors.At(v, 1), colors.At(v, 2)).cast<float>());
    }
    return Done{};
  }

  Result<Done> AddTriangles(const Json& primitive, const std::string& place, SceneMesh* mesh) {
    std::vector<uint32_t> indices;
    const size_t num_vertices = mesh->positions.size();
    if (draco_) {
      indices = draco_->indices;
    } else if (primitive.contains("indices")) {
      const Result<GltfValues> values = accessors_.Values(primitive["indices"]);
      if (!values.ok()) return values.error();
      for (const double index : values.value().numbers) {
        const bool is_index = index >= 0.0 && index < static_cast<double>(num_vertices);
        indices.push_back(is_index ? static_cast<uint32_t>(index) : UINT32_MAX);
      }
    } else {
      for (size_t v = 0; v < num_vertices; ++v) indices.push_back(static_cast<uint32_t>(v));
    }
    for (const uint32_t index : indices)
      if (index >= num_vertices) return Wrong(place, "has a triangle without a vertex");
    mesh->triangles =
        TrianglesOf(draco_ ? kTriangles : Count(primitive, "mode", kTriangles), indices);
    return Done{};
  }

  Result<Done> AddBinds(const Json& attributes, const Json& skin_index, const std::string& place,
                        SceneMesh* mesh) {
    const Result<const Skin*> skin = SkinOf(skin_index);
    if (!skin.ok()) return skin.error();
    const Skin& from = *skin.value();
    std::vector<SceneMesh::Bind> binds(from.nodes.size());
    for (size_t j = 0; j < binds.size(); ++j) {
      binds[j].node = from.nodes[j];
      binds[j].inverse_bind = from.inverse_binds[j];
    }
    for (int set = 0;; ++set) {
      const std::string number = "_" + std::to_string(set);
      const size_t count = mesh->positions.size();
      const auto joints = Attribute(attributes, "JOINTS" + number, 4, count, place);
      if (!joints.ok()) return joints.error();
      const auto weights = Attribute(attributes, "WEIGHTS" + number, 4, count, place);
      if (!weights.ok()) return weights.error();
      if (!joints.value() || !weights.value()) break;
      for (size_t i = 0; i < 4 * count; ++i) {
        const double joint = joints.value()->numbers[i];
        const auto weight = static_cast<float>(weights.value()->numbers[i]);
        if (!(weight > 0.0f)) continue;
        if (!(joint >= 0.0 && joint < static_cast<double>(binds.size())))
          return Wrong(place, "has a weight of a joint that is not there");
        binds[static_cast<size_t>(joint)].weights.push_back({static_cast<uint32_t>(i / 4), weight});
      }
    }
    for (SceneMesh::Bind& bind : binds)
      if (bind.node >= 0) mesh->binds.push_back(std::move(bind));
    return Done{};
  }

  Result<const Skin*> SkinOf(const Json& index) {
    const std::string place = "skins[" + index.dump() + "]";
    const Json& from = Element(Member(json_, "skins"), index);
    const Json& joints = Member(from, "joints");
    if (!joints.is_array() || joints.empty()) return Wrong(place, "has no joints");
    const auto known = skins_.find(index.get<size_t>());
    if (known != skins_.end()) return &known->second;
    Skin skin;
    for (const Json& joint : joints) skin.nodes.push_back(nodes_.Find(joint));
    skin.inverse_binds.assign(joints.size(), Eigen::Matrix4d::Identity());
    if (from.contains("inverseBindMatrices")) {
      const Result<GltfValues> values = accessors_.Values(from["inverseBindMatrices"]);
      if (!values.ok() || values.value().width != 16 || values.value().is_whole ||
          values.value().count < joints.size()) {
        return Error{ErrorCode::kSchema, file_, place,
                     "its inverse bind matrices are no list of one 4x4 matrix of 32-bit floats for "
                     "each joint; export it again"};
      }
      for (size_t j = 0; j < joints.size(); ++j) {
        skin.inverse_binds[j] =
            Eigen::Map<const Eigen::Matrix4d>(values.value().numbers.data() + 16 * j);
      }
    }
    return &skins_.emplace(index.get<size_t>(), std::move(skin)).first->second;
  }

  const Json& json_;
  const GltfNodes& nodes_;
  const std::string& file_;
  GltfAccessors& accessors_;
  Scene& scene_;
  std::map<std::tuple<size_t, size_t, std::string>, int> made_;  // by mesh, primitive and skin
  std::map<size_t, Skin> skins_;
  std::optional<DracoPrimitive> draco_;  // of the primitive that is being read
};

}  // namespace

Result<Done> AddGltfMeshes(const GltfDocument& document, const GltfNodes& nodes,
                           const std::string& file, GltfAccessors* accessors, Scene* scene) {
  return MeshAdder(document, nodes, file, accessors, scene).Add();
}

}  // namespace hazumi
