#pragma once

#include <vector>

#include "engine/exchange/import/body_part.h"
#include "engine/exchange/import/segment_table.h"

namespace hazumi {

struct NamedBone {
  std::string name;
  int parent = -1;  // comes before it; -1: none
};

// A bone among others.
struct BoneInBody {
  BodyName name;  // kOther: says nothing, and hangs on no hand, foot or head
  BodySegment segment = BodySegment::kNone;
  bool operator==(const BoneInBody&) const = default;
};

// What each bone of a skeleton is. Bones that name nothing belong to what they hang on: a finger to
// its hand, a sword too, a cape to the trunk. Segments are kNone, all of them, unless the names are
// those of a body: a trunk or a head, and a limb of a side.
std::vector<BoneInBody> BonesInBody(const std::vector<NamedBone>& bones);

}  // namespace hazumi
