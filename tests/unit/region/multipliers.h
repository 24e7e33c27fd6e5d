#pragma once

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi::test {

// Equations of motion with constraints, by Lagrange multipliers: find x with M x - C^T f = rhs and
// C x = c.
struct Multipliers {
  MatX M;
  VecX rhs;
  MatX C;
  VecX c;

  void Add(const MatX& rows, const VecX& values);
  // The coordinates marked keep their entries of `values`.
  void Prescribe(const std::vector<char>& is_given, const VecX& values);
  VecX Solve() const;
};

}  // namespace hazumi::test
