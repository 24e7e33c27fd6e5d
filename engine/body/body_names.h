#pragma once

#include <vector>

#include "engine/body/body_part.h"

namespace hazumi {

struct NamedBone {
  std::string name;
  int parent = -1;  // comes before it; -1: none
};

// Part that each bone of a skeleton is. kOther: its name says nothing, and it hangs on no hand,
// foot or head. What hangs on one of those is a part of it: a finger of its hand, and a sword too.
std::vector<BodyName> BonesInBody(const std::vector<NamedBone>& bones);

// Whether these are the parts of a body: a trunk or a head, and a limb of a side.
bool IsBody(const std::vector<BodyName>& bones);

}  // namespace hazumi
