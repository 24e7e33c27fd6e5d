#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// What constraints ask of free hinges with accelerations x, or jumps of rates, and forces l of
// theirs:
//   J x + c + G l = 0
// with G what gives way to them besides the hinges. The forces push along P.
struct LimitRows {
  MatX J, G;
  VecX c;
  MatX P;         // empty: J
  VecX softness;  // as SolveGivingWay has it; empty: the least forces that do it
  const MatX& push() const { return P.size() > 0 ? P : J; }
};

}  // namespace hazumi
