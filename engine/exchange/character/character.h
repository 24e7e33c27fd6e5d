#pragma once

// A character as files of other programs say it: bones, clips that move them, a skin. Everything is
// in the file's own axes and unit of length; nothing has been repaired or dropped without a
// warning. Readers make one, figures are made from one.

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/warning.h"
#include "engine/figure/body_role.h"
#include "engine/figure/skin.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

// What hangs on a bone, as Hazumi itself has written it: in the bone's frame, with the axes that
// Hazumi gives it [m, kg], so that the figure is known again that a file was made of.
struct BoneBody {
  struct Capsule {
    std::string name;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double radius = 0.0;
  };
  double mass = 0.0;
  Vec3 com = Vec3::Zero();
  Mat3 inertia = Mat3::Zero();  // about the centre of mass [kg m^2]
  std::vector<Capsule> capsules;
};

// Node of the file that a bone is.
struct BoneSource {
  int node = -1;  // number in the file: of glTF a node's, of BVH a joint's; -1: the format has none
  // Transforms of nodes between the bone's own and its parent's, at rest.
  Eigen::Matrix4d above = Eigen::Matrix4d::Identity();
};

// A node of the skeleton. Parents come before their children.
struct Bone {
  std::string name;  // unique, not empty
  int parent = -1;   // index of a bone; -1: none
  Pose rest;         // in its parent's frame, unit of the file
  Vec3 rest_scale = Vec3::Ones();
  std::string rotation_order;    // channels as written, such as "ZYX" for Rz Ry Rx; empty: unknown
  std::optional<Vec3> end_site;  // where the bone ends if no child says so, own frame
  bool is_joint = true;          // moved or weighted; false: only in between
  std::optional<BoneBody> body;  // not given: nobody knows
  bool is_limb_end = false;      // hung on its limb by an import (import/detached_ends.h)
  std::optional<BodyPlace> place;  // as the file says, such as an avatar
  BoneSource source;
};

// How one bone moves, in its parent's frame. Each list has one entry a frame, or none: as at rest.
struct BoneTrack {
  std::vector<Eigen::Quaterniond> rotations;  // unit
  std::vector<Vec3>
      angles;  // [rad] in the bone's rotation order, as the file has them; may be empty
  std::vector<Vec3> translations;  // origin in the parent's frame
  std::vector<Vec3> scales;
  std::vector<Eigen::Matrix4d> above;  // instead of BoneSource::above
};

struct Clip {
  std::string name;
  double seconds_per_frame = 1.0 / 30.0;
  int num_frames = 0;
  std::vector<BoneTrack> tracks;  // by bone
  int index = 0;                  // among the clips of the file
  double start_s = 0.0;           // of frame 0, in the file's time
};

enum class UpAxis { kY, kZ };

struct Character {
  std::string name;
  std::string file;  // name of the file, without its folder; empty: it comes from none
  // Names that choose this character and the others of the file; empty if it is the only one.
  std::string chosen;
  std::vector<std::string> others;
  std::string above;  // nodes that the first bone hangs on, outermost first: "Scene/Rig"
  std::vector<Bone> bones;
  std::vector<Clip> clips;
  std::vector<SkinMesh> meshes;  // their binds count `bones`
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::optional<UpAxis> up;               // not given: the file does not say
  std::optional<double> metres_per_unit;  // not given: the file does not say
  std::vector<Warning> warnings;          // what was repaired or left out
};

}  // namespace hazumi
