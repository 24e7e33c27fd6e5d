#pragma once

// A character as files of other programs say it: bones, clips that move them, a skin. Everything is
// in the file's own axes and unit of length; nothing has been repaired or dropped without a
// warning. Readers make one, figures are made from one.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/warning.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

// A node of the skeleton. Parents come before their children.
struct Bone {
  std::string name;  // unique, not empty
  int parent = -1;   // index of a bone; -1: none
  Pose rest;         // in its parent's frame, unit of the file
  Vec3 rest_scale = Vec3::Ones();
  std::string rotation_order;    // channels as written, such as "ZYX" for Rz Ry Rx; empty: unknown
  std::optional<Vec3> end_site;  // where the bone ends if no child says so, own frame
  bool is_joint = true;          // moved or weighted; false: only in between
};

// How one bone moves, in its parent's frame. Each list has one entry a frame, or none: as at rest.
struct BoneTrack {
  std::vector<Eigen::Quaterniond> rotations;  // unit
  std::vector<Vec3>
      angles;  // [rad] in the bone's rotation order, as the file has them; may be empty
  std::vector<Vec3> translations;  // origin in the parent's frame
  std::vector<Vec3> scales;
};

struct Clip {
  std::string name;
  double seconds_per_frame = 1.0 / 30.0;
  int num_frames = 0;
  std::vector<BoneTrack> tracks;  // by bone
};

struct Texture {
  std::string name;
  std::vector<uint8_t> encoded;  // a PNG or JPEG file
};

struct Material {
  std::string name;
  std::array<float, 4> base_color = {0.8f, 0.8f, 0.8f, 1.0f};  // linear RGB, alpha
  int texture = -1;                                            // index of Character::textures
};

// A mesh that follows bones. A vertex in the world, of weights w and bones B of its binds, is the
// sum of w X_WB inverse_bind v.
struct SkinMesh {
  struct Bind {
    int bone = 0;
    Eigen::Matrix4d inverse_bind = Eigen::Matrix4d::Identity();
  };
  std::string name;
  std::vector<Bind> binds;
  std::vector<Eigen::Vector3f> positions, normals;    // normals: as many, unit
  std::vector<Eigen::Vector2f> texture_coordinates;   // as many, or none; v downwards as in glTF
  std::vector<std::array<uint16_t, 4>> bind_indices;  // as many; into `binds`
  std::vector<std::array<float, 4>> weights;          // as many; sums are 1
  std::vector<std::array<uint32_t, 3>> triangles;     // counter-clockwise outside
  int material = -1;                                  // index of Character::materials
};

enum class UpAxis { kY, kZ };

struct Character {
  std::string name;
  std::vector<Bone> bones;
  std::vector<Clip> clips;
  std::vector<SkinMesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::optional<UpAxis> up;               // not given: the file does not say
  std::optional<double> metres_per_unit;  // not given: the file does not say
  std::vector<Warning> warnings;          // what was repaired or left out
};

}  // namespace hazumi
