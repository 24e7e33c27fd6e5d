#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

// A thing beside the skeleton, in the axes and lengths of the file.
struct GltfProp {
  SkinMesh mesh;    // without binds, about the thing's own origin
  int bone = -1;    // that carries it; -1: none, it moves by itself
  Pose rest;        // in the frame of its bone, or in the world
  BoneTrack track;  // as the character's first clip moves it there; empty: it stays
};

// kText: one file, the buffer inside it as a data URI. kBinary: .glb.
enum class GltfContainer { kText, kBinary };

struct GltfOptions {
  GltfContainer container = GltfContainer::kBinary;
  std::string generator = "Hazumi";
  std::string extras;                // of the animations: a JSON object; empty: none
  std::vector<GltfProp> props = {};  // their materials are the character's
  std::string above = {};            // nodes on which the skeleton hangs: "Rig/root"; empty: none
};

// A character as a glTF 2.0 file. Axes and lengths are written as they are: glTF's are y up, facing
// z, and metres.
//
// Bones are nodes, all of them joints of the skin. Of a clip only bones that move have a channel,
// and those that rest elsewhere than in `rest` a channel of two equal keys; times begin at 0. Of a
// texture coordinate, normal or weight that glTF forbids (weights that do not sum to 1, normals of
// no length), the weights are made to sum to 1 and the mesh's normals are left out. A mesh without
// triangles is not written. What hangs on a bone is in the extras of its node (gltf_bodies.h). A
// prop is a node with its mesh: a child of its bone's, or of the scene.
//
// Errors, kSemantics: a texture that is neither PNG nor JPEG, a mesh bound twice to one bone,
// numbers that are not finite or not those of a float, `extras` that is no JSON object.
Result<std::string> GltfFile(const Character& character, const GltfOptions& options);

}  // namespace hazumi
