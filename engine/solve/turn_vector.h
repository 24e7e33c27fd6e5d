#pragma once

// Rotations as vectors r [rad]: by |r| about r.
//
//   R(r) = 1 + sin a / a [r] + (1 - cos a) / a^2 [r]^2,   a = |r|, [r] x = r cross x
//   R(r(x + dx)) = R(r) R(dr),  dr = V(r) dx-wise:  V(r) = 1 + [r] / 2 + c [r]^2,
//   c = (1 - a / 2 cot(a / 2)) / a^2

#include "engine/spatial/types.h"

namespace hazumi::solve {

// [r]: its product with x is r cross x.
Mat3 CrossMatrix(const Vec3& r);

// The rotation of a vector [rad].
Mat3 RotationBy(const Vec3& r);

// The shortest vector whose rotation is R [rad]; of half a turn one of two.
Vec3 TurnVector(const Mat3& R);

// Derivative V of the vector of R when R turns on by a little vector d: TurnVector(R(r) R(d)) =
// r + V d + O(d^2). By R(d) R(r) it is the transpose of V. For |r| below a whole turn.
Mat3 TurnVectorChange(const Vec3& r);

}  // namespace hazumi::solve
