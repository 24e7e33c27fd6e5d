#pragma once

// Hinges in a row as one rotation.

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

struct RowHinge {
  Vec3 axis = Vec3::UnitX();  // unit vector, all angles of the row zero, all in one frame
  bool is_fixed = false;
};

// From the parent out: Rot(axis 0, angle 0) Rot(axis 1, angle 1) ...
using HingeRow = std::vector<RowHinge>;

Mat3 RotationOf(const HingeRow& row, const std::vector<double>& angles);

// Changes the angles [rad], but for those of fixed hinges, to the nearest ones by which the row
// turns as `R` does, or as nearly as its hinges can. Gives what is left between the two [rad].
double TurnTo(const Mat3& R, const HingeRow& row, std::vector<double>* angles);

}  // namespace hazumi
