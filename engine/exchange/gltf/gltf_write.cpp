#include "engine/exchange/gltf/gltf_write.h"

#include <cmath>
#include <utility>

#include "engine/base/assert.h"
#include "engine/base/base64.h"
#include "engine/exchange/gltf/glb_chunks.h"
#include "engine/exchange/gltf/gltf_bodies.h"
#include "engine/exchange/gltf/gltf_clips.h"
#include "engine/exchange/gltf/gltf_materials.h"
#include "engine/exchange/gltf/gltf_mesh.h"

namespace hazumi {

namespace {

class GltfWriter {
 public:
  GltfWriter(const Character& character, const GltfOptions& options)
      : character_(character),
        options_(options),
        skins_(character.bones),
        materials_(character, &buffer_) {}

  Result<std::string> Write() {
    AddBones();
    for (size_t i = 0; i < character_.meshes.size(); ++i) {
      if (auto error = AddMesh(i)) return *error;
    }
    for (const GltfProp& prop : options_.props) AddProp(prop);
    if (const auto texture = materials_.unknown_texture()) {
      return Wrong("textures[" + std::to_string(*texture) + "]",
                   "neither PNG nor JPEG, which are all that glTF has");
    }
    if (auto error = AddAnimations()) return *error;
    Assemble();
    if (!buffer_.is_finite() || !has_finite_nodes_) {
      return Wrong("", "glTF cannot hold numbers that are not finite or beyond 3e38");
    }
    return options_.container == GltfContainer::kText ? AsText() : AsBinary();
  }

 private:
  static Error Wrong(const std::string& place, const std::string& message) {
    return {ErrorCode::kSemantics, "", place, message};
  }

  // Node i is bone i. Several roots get a node above them: a skin has one.
  void AddBones() {
    std::vector<size_t> roots;
    for (const Bone& bone : character_.bones) {
      const size_t i = nodes_.size();
      nodes_.push_back(NodeOf(bone.name, bone.rest, bone.rest_scale));
      if (bone.body) nodes_.back()["extras"]["hazumi"] = GltfBody(*bone.body);
      if (bone.parent < 0) roots.push_back(i);
      if (bone.parent >= 0) nodes_[static_cast<size_t>(bone.parent)]["children"].push_back(i);
    }
    if (roots.size() > 1) {
      skeleton_ = nodes_.size();
      nodes_.push_back({{"name", "all_roots"}, {"children", roots}});
    } else if (!roots.empty()) {
      skeleton_ = roots[0];
    }
    if (roots.empty()) return;
    size_t top = skeleton_;
    for (size_t end = options_.above.size(); end > 0;) {
      const size_t slash = options_.above.rfind('/', end - 1);
      const size_t begin = slash == std::string::npos ? 0 : slash + 1;
      nodes_.push_back({{"name", options_.above.substr(begin, end - begin)},
                        {"children", GltfJson::array({top})}});
      top = nodes_.size() - 1;
      end = begin == 0 ? 0 : slash;
    }
    top_.push_back(top);
  }

  GltfJson NodeOf(const std::string& name, const Pose& rest, const Vec3& s) {
    GltfJson node = {{"name", name}};
    const Vec3& p = rest.p;
    has_finite_nodes_ = has_finite_nodes_ && p.allFinite() && s.allFinite() && rest.R.allFinite();
    if (p != Vec3::Zero()) node["translation"] = {p.x(), p.y(), p.z()};
    if (!rest.R.isIdentity(0.0)) {
      node["rotation"] = GltfQuaternion(Eigen::Quaterniond(rest.R));
    }
    if (s != Vec3::Ones()) node["scale"] = {s.x(), s.y(), s.z()};
    return node;
  }

  std::optional<Error> AddMesh(size_t i) {
    const SkinMesh& mesh = character_.meshes[i];
    if (!HasTriangles(mesh)) return std::nullopt;
    GltfJson node = {{"name", mesh.name}, {"mesh", meshes_.size()}};
    if (!mesh.binds.empty()) {
      const auto skin = skins_.Bind(mesh);
      if (!skin) {
        return Wrong("meshes[" + std::to_string(i) + "]",
                     "bound to one bone twice in different ways; bind each bone once");
      }
      node["skin"] = *skin;
    }
    meshes_.push_back(Written(mesh));
    top_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
    return std::nullopt;
  }

  GltfJson Written(const SkinMesh& mesh) {
    GltfJson written = GltfMesh(mesh, &buffer_);
    if (mesh.material >= 0) {
      const bool has_texture = !mesh.texture_coordinates.empty();
      written["primitives"][0]["material"] = materials_.Number(mesh.material, has_texture);
    }
    return written;
  }

  void AddProp(const GltfProp& prop) {
    prop_nodes_.push_back(nodes_.size());
    if (prop.bone < 0) {
      top_.push_back(nodes_.size());
    } else {
      nodes_[static_cast<size_t>(prop.bone)]["children"].push_back(nodes_.size());
    }
    GltfJson node = NodeOf(prop.mesh.name, prop.rest, Vec3::Ones());
    if (HasTriangles(prop.mesh)) {
      node["mesh"] = meshes_.size();
      meshes_.push_back(Written(prop.mesh));
    }
    nodes_.push_back(std::move(node));
  }

  // Props are moved by the first clip alone.
  std::vector<GltfMovedNode> MovedBy(const Clip& clip) const {
    std::vector<GltfMovedNode> moved;
    for (size_t i = 0; i < character_.bones.size(); ++i) {
      const Bone& bone = character_.bones[i];
      moved.push_back({i, bone.rest, bone.rest_scale, &clip.tracks[i]});
    }
    for (size_t i = 0; i < prop_nodes_.size() && &clip == &character_.clips.front(); ++i) {
      const GltfProp& prop = options_.props[i];
      moved.push_back({prop_nodes_[i], prop.rest, Vec3::Ones(), &prop.track});
    }
    return moved;
  }

  std::optional<Error> AddAnimations() {
    GltfJson extras;
    if (!options_.extras.empty()) {
      extras = GltfJson::parse(options_.extras, nullptr, /*allow_exceptions=*/false);
      if (!extras.is_object()) return Wrong("extras", "must be a JSON object");
    }
    for (const Clip& clip : character_.clips) {
      HAZUMI_DEMAND_EQ(clip.tracks.size(), character_.bones.size());
      GltfJson animation = GltfAnimation(MovedBy(clip), clip, &buffer_);
      if (animation.is_null()) continue;
      if (!extras.is_null()) animation["extras"] = extras;
      animations_.push_back(std::move(animation));
    }
    return std::nullopt;
  }

  void Assemble() {
    json_["asset"] = {{"version", "2.0"}, {"generator", options_.generator}};
    json_["scene"] = 0;
    GltfJson scene = {{"name", character_.name}};
    if (!top_.empty()) scene["nodes"] = top_;
    json_["scenes"] = GltfJson::array({scene});
    Put("nodes", nodes_);
    Put("meshes", meshes_);
    Put("skins", skins_.Write(static_cast<int>(skeleton_), &buffer_));
    Put("materials", materials_.materials());
    Put("textures", materials_.textures());
    Put("images", materials_.images());
    if (materials_.has_bright()) json_["extensionsUsed"] = {"KHR_materials_emissive_strength"};
    Put("animations", animations_);
    Put("accessors", buffer_.accessors());
    Put("bufferViews", buffer_.views());
  }

  // glTF has no empty lists.
  void Put(const char* name, const GltfJson& list) {
    if (!list.empty()) json_[name] = list;
  }

  std::string Dump(int indent) const {
    return json_.dump(indent, ' ', false, GltfJson::error_handler_t::replace);
  }

  std::string AsText() {
    if (!buffer_.bytes().empty()) {
      const std::string uri = "data:application/octet-stream;base64," + ToBase64(buffer_.bytes());
      json_["buffers"] = GltfJson::array({{{"byteLength", buffer_.bytes().size()}, {"uri", uri}}});
    }
    return Dump(1) + "\n";
  }

  Result<std::string> AsBinary() {
    std::string bytes = buffer_.bytes();
    if (!bytes.empty()) {
      json_["buffers"] = GltfJson::array({{{"byteLength", bytes.size()}}});
    }
    return GlbFile(Dump(-1), std::move(bytes));
  }

  const Character& character_;
  const GltfOptions& options_;
  GltfBuffer buffer_;
  GltfSkins skins_;
  GltfMaterials materials_;
  GltfJson json_;
  GltfJson nodes_ = GltfJson::array(), meshes_ = GltfJson::array(), animations_ = GltfJson::array();
  std::vector<size_t> top_;         // nodes of the scene
  std::vector<size_t> prop_nodes_;  // by prop
  size_t skeleton_ = 0;
  bool has_finite_nodes_ = true;
};

}  // namespace

Result<std::string> GltfFile(const Character& character, const GltfOptions& options) {
  return GltfWriter(character, options).Write();
}

}  // namespace hazumi
