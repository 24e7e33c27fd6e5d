#pragma once

// What a file of a character's format says, whatever the format: nodes that hang on each other,
// meshes on them, curves that move them. Readers of formats make a Scene, in the file's own axes
// and unit of length; `scene_character.h` makes a Character of it.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/warning.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/scene/node_motion.h"

namespace hazumi {

struct SceneNode {
  std::string name;                                     // as written: may be empty, or another's
  int parent = -1;                                      // -1: the root
  int number = -1;                                      // in the file; -1: its format has none
  Eigen::Matrix4d local = Eigen::Matrix4d::Identity();  // at rest, in the parent's frame
  std::vector<int> meshes;                              // that hang on it, or whose skin does
  bool is_helper = false;          // a part of the transform of the node below it, its first child
  bool is_view = false;            // a camera or a light, on which nothing hangs
  std::optional<BoneBody> body;    // what Hazumi itself has written of it
  std::optional<BodyPlace> place;  // as the file says
};

// Triangles with one material. What `binds` move is a skin, which lies where its bones are, not
// where the mesh's node is.
struct SceneMesh {
  // The vertices that follow a node, and their share of it.
  struct Bind {
    int node = -1;
    Eigen::Matrix4d inverse_bind = Eigen::Matrix4d::Identity();  // mesh to node at rest
    std::vector<std::pair<uint32_t, float>> weights;             // by vertex, positive
  };
  std::string name;
  int material = -1;  // -1: none
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Eigen::Vector2f> texture_coordinates;  // v downwards; empty: none
  std::vector<Eigen::Vector3f> colors;               // linear RGB; empty: none
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<Bind> binds;
  bool is_skinned = false;
};

struct SceneClip {
  std::string name;
  std::vector<std::pair<int, std::unique_ptr<NodeMotion>>> motions;  // by node
  double likely_rate = 0.0;  // frames per second that the file states; 0: it does not
};

// A picture in the file itself, or the name of a file.
struct ScenePicture {
  std::string name;
  std::optional<std::string> bytes;  // none: in the file of this name
};

struct SceneMaterial {
  std::string name;
  std::array<float, 4> base_color = {0.8f, 0.8f, 0.8f, 1.0f};  // linear RGB, alpha
  int picture = -1;
  std::array<float, 3> emission = {0.0f, 0.0f, 0.0f};  // linear RGB
  int emission_picture = -1;
};

struct Scene {
  std::vector<SceneNode> nodes;  // parents before children, each followed by its first child
  std::vector<SceneMesh> meshes;
  std::vector<SceneClip> clips;
  std::vector<SceneMaterial> materials;
  std::vector<ScenePicture> pictures;
  std::optional<UpAxis> up;
  std::optional<double> metres_per_unit;
  std::vector<Warning> warnings;
};

}  // namespace hazumi
