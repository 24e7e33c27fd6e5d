#include "engine/exchange/assimp/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

// Indices of the nodes that are no node's child.
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

Error NoNodes(const std::string& file, const char* what) {
  return {ErrorCode::kSemantics, file, "nodes",
          std::string(what) + ", so that the file holds no character; export it again"};
}

std::string SceneName(const Json& scene) {
  const Json& name = Member(scene, "name");
  return name.is_string() ? " (\"" + name.get<std::string>() + "\")" : "";
}

}  // namespace

Result<Done> ChooseScene(GltfDocument* document, const std::string& file,
                         std::vector<Warning>* warnings) {
  Json& json = document->json;
  const Json& nodes = Member(json, "nodes");
  if (!nodes.is_array() || nodes.empty()) return NoNodes(file, "there are none");
  if (json.contains("scene")) return Done{};
  const Json& scenes = Member(json, "scenes");
  if (!scenes.is_array() || scenes.empty()) {
    const Json roots = RootsOf(nodes);
    if (roots.empty()) return NoNodes(file, "each is a child of another");
    json["scenes"] = Json::array({{{"nodes", roots}}});
  } else if (scenes.size() > 1) {
    warnings->push_back({"scene", "none of the " + std::to_string(scenes.size()) +
                                      " scenes is the default one; the first" +
                                      SceneName(scenes[0]) + " is read"});
  }
  json["scene"] = 0;
  return Done{};
}

}  // namespace hazumi
