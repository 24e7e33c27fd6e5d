#include "engine/exchange/onto/gltf_onto.h"

#include <cmath>
#include <optional>

#include "engine/base/base64.h"
#include "engine/base/text.h"
#include "engine/exchange/gltf/glb_chunks.h"
#include "engine/exchange/gltf/gltf_buffer.h"
#include "engine/exchange/gltf/gltf_clips.h"
#include "engine/exchange/units.h"

namespace hazumi {

namespace {

Error Broken(const std::string& place, const std::string& message) {
  return {ErrorCode::kSchema, "", place, message + "; the file has changed since it was imported"};
}

Result<GltfJson> Parsed(std::string_view bytes) {
  std::string_view text = IsGlb(bytes) ? ChunkOf(bytes, GlbChunk::kJson) : bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  GltfJson json = GltfJson::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object())
    return Error{ErrorCode::kSyntax, "", "", "its JSON is broken; export the file again"};
  return json;
}

// A list that may be missing.
GltfJson* ListOf(GltfJson* json, const char* name) {
  GltfJson& list = (*json)[name];
  if (!list.is_array()) list = GltfJson::array();
  return &list;
}

// Index of an element, which JSON may write 1 or 1.0.
std::optional<size_t> IndexOf(const GltfJson& json, const char* name) {
  if (!json.is_object() || !json.contains(name) || !json[name].is_number()) return std::nullopt;
  const double index = json[name].get<double>();
  if (!(index >= 0.0 && index < 1e9)) return std::nullopt;
  return static_cast<size_t>(index);
}

std::string TextOf(const GltfJson& json, const char* name) {
  const bool has_text = json.is_object() && json.contains(name) && json[name].is_string();
  return has_text ? json[name].get<std::string>() : "";
}

// Whether a channel moves a node so: by its number, or by a pointer.
bool Moves(const GltfJson& channel, size_t node, const std::string& path) {
  if (!channel.is_object() || !channel.contains("target")) return false;
  const GltfJson& target = channel["target"];
  if (TextOf(target, "path") != "pointer")
    return TextOf(target, "path") == path && IndexOf(target, "node") == node;
  const std::string pointer = "/nodes/" + std::to_string(node) + "/" + path;
  if (!target.contains("extensions") || !target["extensions"].is_object()) return false;
  const GltfJson& extensions = target["extensions"];
  return extensions.contains("KHR_animation_pointer") &&
         TextOf(extensions["KHR_animation_pointer"], "pointer") == pointer;
}

class OntoGltf {
 public:
  OntoGltf(std::string_view bytes, GltfJson json, const EditedClip& clip)
      : bytes_(bytes), json_(std::move(json)), clip_(clip) {}

  Result<std::string> Write() {
    if (clip_.bones.empty()) return std::string(bytes_);
    if (auto error = FindAnimation()) return *error;
    if (auto error = AddTimes()) return *error;
    for (const EditedBone& bone : clip_.bones) {
      if (auto error = AddBone(bone)) return *error;
    }
    if (!buffer_.is_finite())
      return Error{ErrorCode::kSemantics, "", clip_.name, "its numbers are too large for a float"};
    return Assembled();
  }

 private:
  std::optional<Error> FindAnimation() {
    GltfJson* animations = ListOf(&json_, "animations");
    if (clip_.index < 0) {
      animations->push_back({{"name", clip_.name.empty() ? "motion" : clip_.name},
                             {"channels", GltfJson::array()},
                             {"samplers", GltfJson::array()}});
      animation_ = animations->size() - 1;
      return std::nullopt;
    }
    animation_ = static_cast<size_t>(clip_.index);
    if (animation_ < animations->size() && (*animations)[animation_].is_object())
      return std::nullopt;
    return Broken("animations", "clip " + std::to_string(clip_.index + 1) + " is not there");
  }

  GltfJson* Animation() { return &json_["animations"][animation_]; }

  std::optional<Error> AddTimes() {
    std::vector<float> times;
    for (int i = 0; i < clip_.num_frames; ++i) {
      const double t = clip_.start_s + (clip_.first + i) * clip_.seconds_per_frame;
      times.push_back(static_cast<float>(std::abs(t) < 1e-9 ? 0.0 : t));
    }
    if (times.front() < 0.0f) {
      return Error{ErrorCode::kSemantics, "", "frame " + std::to_string(clip_.first),
                   "lies before the file's time 0; export frames from " +
                       std::to_string(
                           static_cast<int>(std::ceil(-clip_.start_s / clip_.seconds_per_frame))) +
                       " on"};
    }
    times_ = AddFloats(times, 1, /*with_bounds=*/true);
    return std::nullopt;
  }

  std::optional<Error> AddBone(const EditedBone& bone) {
    GltfJson* nodes = ListOf(&json_, "nodes");
    const auto number = static_cast<size_t>(bone.node);
    if (bone.node < 0 || number >= nodes->size() || !(*nodes)[number].is_object())
      return Broken("nodes", "the bone " + bone.name + " is not there");
    SplitMatrix(&(*nodes)[number]);
    std::vector<float> values;
    if (!bone.rotations.empty()) {
      for (const Eigen::Quaterniond& q : bone.rotations) {
        for (const double x : GltfQuaternion(q)) values.push_back(static_cast<float>(x));
      }
      SetChannel(number, "rotation", AddFloats(values, 4, false));
    }
    if (bone.translations.empty()) return std::nullopt;
    values.clear();
    for (const Vec3& p : bone.translations) {
      for (const double x : p) values.push_back(static_cast<float>(x));
    }
    SetChannel(number, "translation", AddFloats(values, 3, false));
    return std::nullopt;
  }

  // A node that is animated has no matrix [glTF 2.0, 3.6.2].
  static void SplitMatrix(GltfJson* node) {
    if (!node->contains("matrix") || !(*node)["matrix"].is_array() ||
        (*node)["matrix"].size() != 16)
      return;
    Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
    for (int i = 0; i < 16; ++i) {
      const GltfJson& number = (*node)["matrix"][static_cast<size_t>(i)];
      if (!number.is_number()) return;
      M(i % 4, i / 4) = number.get<double>();
    }
    Vec3 scale = M.topLeftCorner<3, 3>().colwise().norm().transpose();
    if (M.topLeftCorner<3, 3>().determinant() < 0.0) scale = -scale;
    const Mat3 R = M.topLeftCorner<3, 3>() * scale.cwiseInverse().asDiagonal();
    node->erase("matrix");
    (*node)["translation"] = {M(0, 3), M(1, 3), M(2, 3)};
    (*node)["rotation"] = GltfQuaternion(Eigen::Quaterniond(R));
    (*node)["scale"] = {scale.x(), scale.y(), scale.z()};
  }

  void SetChannel(size_t node, const std::string& path, size_t output) {
    GltfJson* channels = ListOf(Animation(), "channels");
    GltfJson* samplers = ListOf(Animation(), "samplers");
    const GltfJson sampler = {{"input", times_}, {"interpolation", "LINEAR"}, {"output", output}};
    for (GltfJson& channel : *channels) {
      if (!Moves(channel, node, path)) continue;
      const auto own = IndexOf(channel, "sampler");
      if (own && *own < samplers->size() && IsOnlyOneOf(*channels, *own)) {
        (*samplers)[*own] = sampler;
      } else {
        channel["sampler"] = samplers->size();
        samplers->push_back(sampler);
      }
      return;
    }
    channels->push_back(
        {{"sampler", samplers->size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers->push_back(sampler);
  }

  static bool IsOnlyOneOf(const GltfJson& channels, size_t sampler) {
    int users = 0;
    for (const GltfJson& channel : channels) users += IndexOf(channel, "sampler") == sampler;
    return users == 1;
  }

  // Number of the accessor in the file.
  size_t AddFloats(const std::vector<float>& values, int components, bool with_bounds) {
    buffer_.AddFloats(values, components, GltfUse::kPlain, with_bounds);
    return ListOf(&json_, "accessors")->size() + buffer_.accessors().size() - 1;
  }

  Result<std::string> Assembled() {
    GltfJson* buffers = ListOf(&json_, "buffers");
    const bool is_glb = IsGlb(bytes_);
    const bool has_own = is_glb && (buffers->empty() || !(*buffers)[0].contains("uri"));
    std::string binary = is_glb ? std::string(ChunkOf(bytes_, GlbChunk::kBinary)) : "";
    size_t number = buffers->size(), offset = 0;
    if (has_own) {
      number = 0;
      if (buffers->empty()) buffers->push_back({{"byteLength", 0}});
      binary.resize(IndexOf((*buffers)[0], "byteLength").value_or(0));
      binary.resize((binary.size() + 3) / 4 * 4);
      offset = binary.size();
      binary += buffer_.bytes();
      (*buffers)[0]["byteLength"] = binary.size();
    } else {
      buffers->push_back(
          {{"byteLength", buffer_.bytes().size()},
           {"uri", "data:application/octet-stream;base64," + ToBase64(buffer_.bytes())}});
    }
    AddViews(number, offset);
    if (!is_glb) return json_.dump(2, ' ', false, GltfJson::error_handler_t::replace) + "\n";
    return GlbFile(json_.dump(-1, ' ', false, GltfJson::error_handler_t::replace),
                   std::move(binary), OtherChunks(bytes_));
  }

  void AddViews(size_t buffer, size_t offset) {
    GltfJson* views = ListOf(&json_, "bufferViews");
    GltfJson* accessors = ListOf(&json_, "accessors");
    const size_t first = views->size();
    for (GltfJson view : buffer_.views()) {
      view["buffer"] = buffer;
      view["byteOffset"] = view["byteOffset"].get<size_t>() + offset;
      views->push_back(std::move(view));
    }
    for (GltfJson accessor : buffer_.accessors()) {
      accessor["bufferView"] = accessor["bufferView"].get<size_t>() + first;
      accessors->push_back(std::move(accessor));
    }
  }

  const std::string_view bytes_;
  GltfJson json_;
  const EditedClip& clip_;
  GltfBuffer buffer_;
  size_t animation_ = 0, times_ = 0;
};

}  // namespace

Result<std::string> GltfOnto(std::string_view bytes, const EditedClip& clip) {
  Result<GltfJson> json = Parsed(bytes);
  if (!json.ok()) return json.error();
  return OntoGltf(bytes, std::move(json).value(), clip).Write();
}

Result<bool> HasFilesBeside(std::string_view bytes) {
  const Result<GltfJson> json = Parsed(bytes);
  if (!json.ok()) return json.error();
  for (const char* list : {"buffers", "images"}) {
    if (!json.value().contains(list) || !json.value()[list].is_array()) continue;
    for (const GltfJson& part : json.value()[list]) {
      const std::string uri = TextOf(part, "uri");
      if (!uri.empty() && !LowerCase(uri).starts_with("data:")) return true;
    }
  }
  return false;
}

}  // namespace hazumi
