#pragma once

// A mesh that follows the bodies of a figure: linear blend skinning. Drawing only; no effect on
// motion or contact.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"

namespace hazumi {

struct Texture {
  std::string name;
  std::vector<uint8_t> encoded;  // a PNG or JPEG file
  bool operator==(const Texture&) const = default;
};

struct Material {
  std::string name;
  std::array<float, 4> base_color = {0.8f, 0.8f, 0.8f, 1.0f};  // linear RGB, alpha
  int texture = -1;                                            // index of a texture, or none
  std::array<float, 3> emission = {0.0f, 0.0f, 0.0f};          // linear RGB, seen without light
  int emission_texture = -1;                                   // times it: index, or none
  bool operator==(const Material&) const = default;
};

// A vertex in the world, of weights w and bones B of its binds, is the sum of w X_WB inverse_bind
// v.
struct SkinMesh {
  struct Bind {
    int bone = 0;
    Eigen::Matrix4d inverse_bind = Eigen::Matrix4d::Identity();
    bool operator==(const Bind&) const = default;
  };
  std::string name;
  std::vector<Bind> binds;
  std::vector<Eigen::Vector3f> positions, normals;    // normals: as many, unit
  std::vector<Eigen::Vector2f> texture_coordinates;   // as many, or none; v downwards as in glTF
  std::vector<Eigen::Vector3f> colors;                // as many, or none; linear RGB, a factor
  std::vector<std::array<uint16_t, 4>> bind_indices;  // as many; into `binds`
  std::vector<std::array<float, 4>> weights;          // as many; sums are 1
  std::vector<std::array<uint32_t, 3>> triangles;     // counter-clockwise outside
  int material = -1;                                  // index of a material, or none
  bool operator==(const SkinMesh&) const = default;

  // From a vertex to the bone, of a mesh that has a single one: the sum of w inverse_bind.
  Eigen::Matrix4d BindOf(size_t vertex) const;
};

// A point by an affine transform, and a unit normal by its inverse transpose; one that has no
// direction then stays as it is.
Eigen::Vector3d PointBy(const Eigen::Matrix4d& M, const Eigen::Vector3f& point);
Eigen::Vector3d NormalBy(const Eigen::Matrix4d& M, const Eigen::Vector3f& normal);

// What moves a part of a skin: the body beyond a joint, or the root, by name. With a share less
// than 1 it turns only so far, each hinge's angle times the share, about the joint's place: between
// the bodies before and beyond a joint, so that skin bent far does not fold through the joint.
struct SkinBone {
  std::string joint;  // the root, a joint (all its hinges), or a hinge with those before it in full
  double share = 1.0;

  SkinBone() = default;
  SkinBone(std::string name, double part = 1.0) : joint(std::move(name)), share(part) {}
  SkinBone(const char* name, double part = 1.0) : joint(name), share(part) {}
  bool operator==(const SkinBone&) const = default;
};

// The skin of a figure, in metres; binds are to its bones.
struct Skin {
  std::vector<SkinBone> bones;  // counted by SkinMesh::Bind::bone
  std::vector<SkinMesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  bool operator==(const Skin&) const = default;
};

// Whether all of a skin fits together, so that it can be drawn and written without looking again.
// Errors: kSemantics with the first place, such as `meshes[0].binds[1].bone`, that is an index out
// of range, a list of another length than the positions, a number that is not finite or a weight
// outside 0 to 1.
Result<Done> CheckSkin(const Skin& skin);

}  // namespace hazumi
