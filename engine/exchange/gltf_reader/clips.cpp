#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "engine/base/utf8.h"
#include "engine/exchange/gltf_reader/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

// Target of a channel.
struct Target {
  Json node;  // index in the document; null: none
  std::string path;
};

// "/nodes/5/rotation" [KHR_animation_pointer].
std::optional<Target> TargetOfPointer(const std::string& pointer) {
  constexpr std::string_view kNodes = "/nodes/";
  if (!pointer.starts_with(kNodes)) return std::nullopt;
  const size_t slash = pointer.find('/', kNodes.size());
  const std::string number = pointer.substr(kNodes.size(), slash - kNodes.size());
  const bool is_number = !number.empty() && number.size() < 10 &&
                         std::all_of(number.begin(), number.end(),
                                     [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!is_number || slash == std::string::npos) return std::nullopt;
  return Target{static_cast<size_t>(std::stoul(number)), pointer.substr(slash + 1)};
}

KeyInterpolation InterpolationOf(const Json& sampler) {
  const std::string name = Text(Member(sampler, "interpolation"));
  if (name == "STEP") return KeyInterpolation::kStep;
  return name == "CUBICSPLINE" ? KeyInterpolation::kSpline : KeyInterpolation::kLinear;
}

JointKeys* KeysOf(const std::string& path, KeyedMotion* motion) {
  if (path == "translation") return &motion->translation;
  if (path == "rotation") return &motion->rotation;
  return path == "scale" ? &motion->scale : nullptr;
}

class ClipAdder {
 public:
  ClipAdder(const GltfDocument& document, const GltfNodes& nodes, const std::string& file,
            GltfAccessors* accessors, Scene* scene)
      : json_(document.json), nodes_(nodes), file_(file), accessors_(*accessors), scene_(*scene) {}

  Result<Done> Add() {
    for (const Json& animation : Member(json_, "animations")) {
      if (Result<Done> added = AddClip(animation); !added.ok()) return added;
    }
    if (num_shapes_ > 0) {
      scene_.warnings.push_back(
          {"clips", std::to_string(num_shapes_) +
                        " channels move shapes (morph targets), which are not read"});
    }
    if (!others_.empty()) {
      std::string names;
      for (const std::string& name : others_) names += (names.empty() ? "" : ", ") + name;
      scene_.warnings.push_back({"clips", "what is no motion of a node is left out: " + names});
    }
    return Done{};
  }

 private:
  Error Wrong(const std::string& message) const {
    return {ErrorCode::kSchema, file_, "clip " + clip_, message + "; export the animation again"};
  }

  Result<Done> AddClip(const Json& animation) {
    clip_ = ValidUtf8(Text(Member(animation, "name")));
    if (clip_.empty()) clip_ = std::to_string(scene_.clips.size() + 1);
    std::map<int, std::unique_ptr<KeyedMotion>> motions;  // by node of the scene
    for (const Json& channel : Member(animation, "channels")) {
      const std::optional<Target> target = TargetOf(Member(channel, "target"));
      const int node = target ? nodes_.Find(target->node) : -1;
      if (node < 0) continue;
      num_shapes_ += target->path == "weights";
      std::unique_ptr<KeyedMotion>& motion = motions[node];
      if (!motion) motion = std::make_unique<KeyedMotion>();
      JointKeys* keys = KeysOf(target->path, motion.get());
      if (!keys) continue;
      const Json& sampler = Element(Member(animation, "samplers"), Member(channel, "sampler"));
      if (!sampler.is_object()) return Wrong("a channel has no sampler");
      if (Result<Done> read = ReadKeys(sampler, target->path, keys); !read.ok()) return read;
    }
    SceneClip clip;
    clip.name = Text(Member(animation, "name"));
    for (auto& [node, motion] : motions) {
      const bool moves =
          !motion->translation.empty() || !motion->rotation.empty() || !motion->scale.empty();
      if (moves) clip.motions.emplace_back(node, std::move(motion));
    }
    scene_.clips.push_back(std::move(clip));
    return Done{};
  }

  // None: it moves no node.
  std::optional<Target> TargetOf(const Json& target) {
    const std::string path = Text(Member(target, "path"));
    if (path != "pointer") return Target{Member(target, "node"), path};
    const Json& extension = Member(Member(target, "extensions"), "KHR_animation_pointer");
    const std::string pointer = Text(Member(extension, "pointer"));
    std::optional<Target> found = TargetOfPointer(pointer);
    KeyedMotion any;
    const bool moves = found && (KeysOf(found->path, &any) || found->path == "weights");
    if (moves) return found;
    others_.insert(ValidUtf8(pointer));
    return std::nullopt;
  }

  Result<Done> ReadKeys(const Json& sampler, const std::string& path, JointKeys* keys) {
    const Result<GltfValues> times = accessors_.Values(Member(sampler, "input"));
    if (!times.ok()) return times.error();
    const Result<GltfValues> values = accessors_.Values(Member(sampler, "output"));
    if (!values.ok()) return values.error();
    keys->interpolation = InterpolationOf(sampler);
    const size_t count = times.value().count;
    const size_t each = keys->interpolation == KeyInterpolation::kSpline ? 3 : 1;
    const size_t width = path == "rotation" ? 4 : 3;
    if (times.value().width != 1 || values.value().width != width ||
        values.value().count != each * count) {
      return Wrong("the " + path + " of a node has " + std::to_string(count) + " times and " +
                   std::to_string(values.value().count) + " values, which do not belong together");
    }
    keys->times = times.value().numbers;
    const auto value = [&](size_t element) {
      Eigen::Vector4d v = Eigen::Vector4d::Zero();
      for (size_t k = 0; k < width; ++k)
        v[static_cast<Eigen::Index>(k)] = values.value().At(element, k);
      return v;
    };
    for (size_t i = 0; i < count; ++i) {
      if (each == 3) keys->before.push_back(value(3 * i));
      keys->values.push_back(value(each * i + each / 3));
      if (each == 3) keys->behind.push_back(value(3 * i + 2));
    }
    return Done{};
  }

  const Json& json_;
  const GltfNodes& nodes_;
  const std::string& file_;
  GltfAccessors& accessors_;
  Scene& scene_;
  std::string clip_;  // for messages
  int num_shapes_ = 0;
  std::set<std::string> others_;  // pointers to what is not read
};

}  // namespace

Result<Done> AddGltfClips(const GltfDocument& document, const GltfNodes& nodes,
                          const std::string& file, GltfAccessors* accessors, Scene* scene) {
  return ClipAdder(document, nodes, file, accessors, scene).Add();
}

}  // namespace hazumi
