#include "engine/exchange/gltf/gltf_bodies.h"
#include "engine/exchange/gltf_reader/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

Error NoNodes(const std::string& file, const char* what) {
  return {ErrorCode::kSemantics, file, "nodes",
          std::string(what) + ", so that the file holds no character; export it again"};
}

Json RootsOf(const Json& nodes) {
  std::vector<char> is_child(nodes.size(), 0);
  for (const Json& node : nodes) {
    for (const Json& child : Member(node, "children")) {
      if (Element(nodes, child).is_object()) is_child[child.get<size_t>()] = 1;
    }
  }
  Json roots = Json::array();
  for (size_t i = 0; i < nodes.size(); ++i)
    if (!is_child[i]) roots.push_back(i);
  return roots;
}

std::string SceneName(const Json& scene) {
  const std::string name = Text(Member(scene, "name"));
  return name.empty() ? "" : " (\"" + name + "\")";
}

// Indices of the roots.
Result<Json> ChooseRoots(const Json& json, const std::string& file,
                         std::vector<Warning>* warnings) {
  const Json& nodes = Member(json, "nodes");
  if (!nodes.is_array() || nodes.empty()) return NoNodes(file, "there are none");
  const Json& scenes = Member(json, "scenes");
  const bool states_one = Element(scenes, Member(json, "scene")).is_object();
  if (!states_one && scenes.is_array() && scenes.size() > 1) {
    warnings->push_back({"scene", "none of the " + std::to_string(scenes.size()) +
                                      " scenes is the default one; the first" +
                                      SceneName(scenes[0]) + " is read"});
  }
  const Json& chosen = states_one ? Element(scenes, Member(json, "scene")) : Element(scenes, 0u);
  Json roots = chosen.is_object() ? Member(chosen, "nodes") : RootsOf(nodes);
  if (!roots.is_array() || roots.empty())
    return NoNodes(file, chosen.is_object() ? "the scene has none" : "each is a child of another");
  return roots;
}

Eigen::Matrix4d TransformOf(const Json& node) {
  const std::vector<double> matrix = Numbers(Member(node, "matrix"), 16);
  if (!matrix.empty()) return Eigen::Map<const Eigen::Matrix4d>(matrix.data());  // by columns
  const std::vector<double> t = Numbers(Member(node, "translation"), 3),
                            r = Numbers(Member(node, "rotation"), 4),
                            s = Numbers(Member(node, "scale"), 3);
  Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
  if (!r.empty()) {
    const Eigen::Quaterniond q(r[3], r[0], r[1], r[2]);
    if (q.norm() > 1e-9) local.topLeftCorner<3, 3>() = q.normalized().toRotationMatrix();
  }
  for (int k = 0; k < 3; ++k) {
    if (!s.empty()) local.col(k) *= s[static_cast<size_t>(k)];
    if (!t.empty()) local(k, 3) = t[static_cast<size_t>(k)];
  }
  return local;
}

bool IsView(const Json& node) {
  const Json& extensions = Member(node, "extensions");
  return (node.contains("camera") || extensions.contains("KHR_lights_punctual")) &&
         Member(node, "children").empty();
}

class NodeAdder {
 public:
  NodeAdder(const GltfDocument& document, const std::string& file, Scene* scene)
      : json_(document.json), nodes_(Member(json_, "nodes")), file_(file), scene_(*scene) {
    // Who wrote a file last says so; other programs may keep extras of what they have changed.
    is_ours_ = Text(Member(Member(json_, "asset"), "generator")).starts_with("Hazumi");
  }

  Result<GltfNodes> Add() {
    const Result<Json> roots = ChooseRoots(json_, file_, &scene_.warnings);
    if (!roots.ok()) return roots.error();
    made_.in_scene.assign(nodes_.size(), -1);
    if (roots.value().size() > 1) {
      scene_.nodes.emplace_back();
      scene_.nodes[0].name = "ROOT";
    }
    const int above = roots.value().size() > 1 ? 0 : -1;
    if (Result<Done> added = AddBelow(roots.value(), above); !added.ok()) return added.error();
    return std::move(made_);
  }

 private:
  struct Waiting {
    Json index;
    int parent;
  };

  Result<Done> AddBelow(const Json& roots, int above) {
    std::vector<Waiting> waiting;
    const auto add = [&](const Json& indices, int parent) {
      for (size_t i = indices.size(); i-- > 0;) waiting.push_back({indices[i], parent});
    };
    add(roots, above);
    while (!waiting.empty()) {
      const Waiting next = std::move(waiting.back());
      waiting.pop_back();
      const Json& node = Element(nodes_, next.index);
      if (!node.is_object()) return Wrong(next.index.dump(), "is not there");
      int& place = made_.in_scene[next.index.get<size_t>()];
      if (place >= 0) return Wrong(next.index.dump(), "is a child of two nodes, or of itself");
      place = static_cast<int>(scene_.nodes.size());
      AddNode(node, next.index.get<size_t>(), next.parent);
      const Json& children = Member(node, "children");
      if (children.is_array()) add(children, place);
    }
    return Done{};
  }

  Error Wrong(const std::string& index, const std::string& message) const {
    return {ErrorCode::kSchema, file_, "nodes[" + index + "]",
            message + "; the file is broken: export it again"};
  }

  void AddNode(const Json& node, size_t index, int parent) {
    SceneNode made;
    made.name = Text(Member(node, "name"));
    if (made.name.empty()) made.name = "node_" + std::to_string(index);
    made.parent = parent;
    made.number = static_cast<int>(index);
    made.local = TransformOf(node);
    made.is_view = IsView(node);
    const Json& written = Member(Member(node, "extras"), "hazumi");
    if (is_ours_ && !written.is_null()) {
      made.body = BodyFromGltf(written);
      if (!made.body) {
        scene_.warnings.push_back({"node " + made.name,
                                   "its shape and mass cannot be read from its extras; they are "
                                   "guessed"});
      }
    }
    scene_.nodes.push_back(std::move(made));
  }

  const Json& json_;
  const Json& nodes_;
  const std::string& file_;
  Scene& scene_;
  bool is_ours_ = false;
  GltfNodes made_;
};

}  // namespace

int GltfNodes::Find(const Json& index) const {
  if (!index.is_number_unsigned() || index.get<uint64_t>() >= in_scene.size()) return -1;
  return in_scene[index.get<size_t>()];
}

Result<GltfNodes> AddGltfNodes(const GltfDocument& document, const std::string& file,
                               Scene* scene) {
  return NodeAdder(document, file, scene).Add();
}

}  // namespace hazumi
