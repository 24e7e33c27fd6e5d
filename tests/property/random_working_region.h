#pragma once

#include <array>
#include <cstdint>

#include "engine/timeline/animation.h"

namespace hazumi::test {

// What may act on a region besides gravity, friction and limits.
enum class Acting { kDrives, kForces, kContacts, kConstraints };
inline constexpr std::array kAllActing = {Acting::kDrives, Acting::kForces, Acting::kContacts,
                                          Acting::kConstraints};
constexpr const char* NameOf(Acting acting) {
  constexpr const char* kNames[] = {"drives", "forces", "contacts", "constraints"};
  return kNames[static_cast<int>(acting)];
}

struct WorkingRegion {
  Animation animation;
  std::array<bool, kAllActing.size()> acts = {};  // by Acting
  bool has(Acting acting) const { return acts[static_cast<size_t>(acting)]; }
};

// A random figure with limits, of which regions of the method exact move a part or all for 30
// frames: two limbs, in one region or two, or the whole figure, its root keyed, pinned or in
// flight. Each kind of what may act is there in every second one, whatever the others do. All of it
// can be: constraints without time to close have no gap and hold nothing that is moved by keys,
// what touches begins outside, no drive is on a joint that cannot move.
WorkingRegion RandomWorkingRegion(uint64_t seed);

}  // namespace hazumi::test
