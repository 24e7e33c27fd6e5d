// What walks say alike: why they cannot go on, and what a placement did.

#include "engine/bake/walk/region_walk.h"

#include <algorithm>

#include "engine/base/text.h"

namespace hazumi {

Error RegionWalk::CannotGoOnAfter(double frame, JointIndex joint, const std::string& cause) const {
  const Figure& figure = context_.poses.figure();
  const std::string who = joint.is_valid() ? "joint \"" + figure.joint(joint).name + "\""
                                           : "root \"" + figure.root_name() + "\"";
  return {ErrorCode::kSemantics, "",
          PlaceOfRegion(joint.is_valid() ? std::optional(joint) : std::nullopt),
          "cannot go on after frame " + FormatShort(frame) + ": " + who + ": " + cause};
}

std::string RegionWalk::PlaceOfRegion(std::optional<JointIndex> joint) const {
  std::vector<int> candidates = *active();
  std::erase_if(candidates, [&](int r) {
    const auto& joints = context_.animation.regions[r].joints;
    return joint && !std::binary_search(joints.begin(), joints.end(), *joint);
  });
  if (candidates.size() != 1) return "regions";
  return "regions[" + std::to_string(candidates[0]) + "]";
}

void RegionWalk::AddEvent(EventKind kind, double frame, std::optional<GroupIndex> joint) {
  context_.recorder.AddEvent(kind, frame, joint ? context_.NameOf(*joint) : "");
}

}  // namespace hazumi
