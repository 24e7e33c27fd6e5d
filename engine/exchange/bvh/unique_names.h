#pragma once

#include <string>
#include <vector>

#include "engine/exchange/character/character.h"

namespace hazumi {

struct RenamedBone {
  size_t bone = 0;
  std::string old_name;
};

// Gives bones whose name an earlier one has names of their own: "Arm" becomes "Arm_2".
std::vector<RenamedBone> MakeNamesUnique(std::vector<Bone>* bones);

}  // namespace hazumi
