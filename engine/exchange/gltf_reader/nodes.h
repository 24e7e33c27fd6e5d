#pragma once

#include "engine/exchange/gltf_reader/document.h"
#include "engine/exchange/scene/scene.h"

namespace hazumi {

// Nodes of the document's default scene, else of its first one, else all that are no child: in the
// order of a Scene. Several roots get one more above them.
struct GltfNodes {
  std::vector<int> in_scene;  // by node of the document: index in the scene; -1: not in it

  // By an index as JSON has it; -1: no node of the scene.
  int Find(const nlohmann::json& index) const;
};

// Adds nodes at rest, and what Hazumi itself has written of their bodies. Warns of the choice of a
// scene. Error: there are none, or they are no trees.
Result<GltfNodes> AddGltfNodes(const GltfDocument& document, const std::string& file, Scene* scene);

}  // namespace hazumi
