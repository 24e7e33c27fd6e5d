#pragma once

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// The mixed problem [Arai 2.4 (11)]: H qdd = T - B, where for each coordinate either the
// acceleration is given (given[i] true: qdd[i] is read) or the torque is (T[i] is read). Fills in
// the other half of qdd and T. Scratch: A (n x n) and x (n), contents lost. Returns as
// FactorCholesky, -1 for success, with the row counted in the coordinates of H.
int SolveMixed(const Eigen::Ref<const MatX>& H, const Eigen::Ref<const VecX>& B,
               const std::vector<char>& given, Eigen::Ref<MatX> A, Eigen::Ref<VecX> x,
               Eigen::Ref<VecX> qdd, Eigen::Ref<VecX> T);

}  // namespace hazumi
