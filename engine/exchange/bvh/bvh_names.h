#pragma once

// Names in a BVH file: of the channels of its motion, and of bones.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/exchange/character/character.h"

namespace hazumi {

// One column of the motion.
struct BvhChannel {
  int bone = 0;
  int axis = 0;  // 0 x, 1 y, 2 z
  bool is_rotation = false;
};

// Such as "Xposition".
std::string ChannelName(const BvhChannel& channel);
// That of a name, in any case; of bone 0.
std::optional<BvhChannel> ChannelNamed(std::string_view name);

struct RenamedBone {
  size_t bone = 0;
  std::string old_name;
};

// Gives bones whose name an earlier one has names of their own: "Arm" becomes "Arm_2".
std::vector<RenamedBone> MakeNamesUnique(std::vector<Bone>* bones);

}  // namespace hazumi
