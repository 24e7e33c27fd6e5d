#include "engine/timeline/placement_span.h"

#include "engine/figure/figure.h"

namespace hazumi {

std::vector<GroupIndex> SolvedJoints(const IkHold& hold, const Figure& figure) {
  constexpr int kAll = 0;
  if (hold.reach == HoldReach::kBody) return ChainOf(hold.joint, kAll, figure);
  return ChainOf(hold.joint, std::nullopt, figure);
}

}  // namespace hazumi
