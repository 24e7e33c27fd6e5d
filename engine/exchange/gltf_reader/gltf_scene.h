#pragma once

// Internal. Adds the parts of a glTF document to a Scene: ReadGltf calls them in this order.

#include "engine/exchange/gltf_reader/accessors.h"
#include "engine/exchange/gltf_reader/document.h"
#include "engine/exchange/scene/scene.h"

namespace hazumi {

// Nodes of the document's default scene, else of its first one, else all that are no child: in the
// order of a Scene. Several roots get one more above them.
struct GltfNodes {
  std::vector<int> in_scene;  // by node of the document: index in the scene; -1: not in it

  // Returns the node with an index as JSON has it; -1: no node of the scene.
  int Find(const nlohmann::json& index) const;
};

// Adds nodes at rest, and what Hazumi itself has written of their bodies. Warns of the choice of a
// scene. Error: there are none, or they are no trees.
Result<GltfNodes> AddGltfNodes(const GltfDocument& document, const std::string& file, Scene* scene);

// Says what nodes are in a body where the document is an avatar (VRM) that says it.
void AddVrmPlaces(const GltfDocument& document, const GltfNodes& nodes, Scene* scene);

// Warns of what looks otherwise than in the file because it is not read.
void WarnOfNotRead(const GltfDocument& document, Scene* scene);

// Adds materials and their pictures, in the document's order.
void AddGltfMaterials(const GltfDocument& document, GltfAccessors* accessors, Scene* scene);

// Adds the meshes of the scene's nodes: a SceneMesh for each primitive with triangles, and again
// for each other skin. Where normals are missing they are the mean of the triangles' around a
// place, by area. Errors: accessors that cannot be read, indices out of range, skins without
// matrices.
Result<Done> AddGltfMeshes(const GltfDocument& document, const GltfNodes& nodes,
                           const std::string& file, GltfAccessors* accessors, Scene* scene);

// Adds animations as far as they move nodes of the scene, by channels or by pointers
// (KHR_animation_pointer) to a node's translation, rotation or scale. A channel without a node is
// left out, as glTF demands. Warns of what else is moved: shapes, materials. Errors: keys that
// cannot be read, or not as many values as times.
Result<Done> AddGltfClips(const GltfDocument& document, const GltfNodes& nodes,
                          const std::string& file, GltfAccessors* accessors, Scene* scene);

}  // namespace hazumi
