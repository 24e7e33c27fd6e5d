#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

struct EigenSystem {
  VecX values;   // ascending
  MatX vectors;  // of length one, as columns
};
// Of a symmetric matrix, of which the lower triangle is read.
EigenSystem EigenSystemOf(const MatX& A);

}  // namespace hazumi
