#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// What constraints ask of free hinges with accelerations x, or jumps of rates, and forces l of
// theirs:
//   J x + c + G l = 0
// with G what gives way to them besides the hinges.
struct LimitRows {
  MatX J, G;
  VecX c;
};

}  // namespace hazumi
