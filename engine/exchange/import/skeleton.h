#pragma once

// Internal. The bones of a character that become a figure, and where they are: at rest and frame by
// frame. In the file's axes and unit.

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/body/body_names.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/import/segment_table.h"
#include "engine/figure/body_role.h"

namespace hazumi {

// A bone in the world of the file: what lies at x in its frame is at p + R stretch x. The stretch
// is symmetric: the scales of the bone and of those above it, which turn against each other.
struct BonePose {
  Mat3 R = Mat3::Identity();
  Vec3 p = Vec3::Zero();
  Mat3 stretch = Mat3::Identity();

  Vec3 At(const Vec3& x) const { return p + R * (stretch * x); }
  bool is_even() const;  // stretched alike along all axes
};

// A bone on its parent: turned, placed and scaled in its frame.
BonePose BelowPose(const BonePose& parent, const Mat3& R, const Vec3& p, const Vec3& scale);

// Of all bones at a frame; without a clip, at rest.
std::vector<BonePose> PosesAt(const Character& character, const Clip* clip, int frame);

// A bone that becomes a joint, or the root.
struct KeptBone {
  int bone = 0;
  int parent = -1;  // index of a kept bone; -1: it is the root
  std::vector<int> children;
  BodyName body;
  BodySegment segment = BodySegment::kNone;
  BodyPlace place;
};

struct Skeleton {
  std::vector<KeptBone> bones;  // parents first; the first one is the root
  std::vector<int> kept;        // by bone of the character: index in `bones`, or -1
  std::vector<BonePose> rest;   // by bone of the character
  std::vector<std::string> left_out;
  bool has_four_legs = false;
};

// Flags by bone: the bone carries skin or, in a character without skin, moves and is no rig handle.
std::vector<char> WantedBones(const Character& character);

// The root is the lowest bone that carries all joints of which anything hangs: what is above it
// moves it, what stands beside it and carries no skin, such as handles of a rig, is left out.
// Errors: kSemantics if there is no bone.
Result<Skeleton> SkeletonOf(const Character& character);

}  // namespace hazumi
