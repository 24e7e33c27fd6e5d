#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// A segment against a box centred on the origin of B, both in B. The kernel of distance.h.
struct SegmentBoxDistance {
  double value = 0.0;           // signed distance [m], as in Distance
  double t = 0.0;               // in [0, 1]: the segment's nearest (or deepest) point is p + t d
  Vec3 normal = Vec3::UnitX();  // unit, from the box to the segment
};

// The segment is p + t d, t in [0, 1]; d may be zero. The box is |x_i| <= half_size_i; half_size
// may have zeros. Metres.
SegmentBoxDistance SegmentToBox(const Vec3& p, const Vec3& d, const Vec3& half_size);

}  // namespace hazumi
