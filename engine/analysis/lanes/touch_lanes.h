#include "engine/analysis/lanes/demand_lanes.h"

// Balls of radius r near planes and boxes, a frame in each lane. With q the centre in the frame of
// a box of half size h, grown by a margin, and e_i = |q_i| - h_i:
//   apart:       distance = |max(e, 0)| - margin - r,  normal along max(e, 0)
//   overlapping: distance = max e_i - margin - r,      normal along that axis
// each on the side of q: what SignedDistance has of a capsule without length.

HAZUMI_LANE_INLINE LaneReal Only(LaneReal x, LaneBits where) {
  return SameBits<LaneReal>(SameBits<LaneBits>(x) & where);
}
HAZUMI_LANE_INLINE LaneTriple Only(const LaneTriple& x, LaneBits where) {
  return {{Only(x.e[0], where), Only(x.e[1], where), Only(x.e[2], where)}};
}

HAZUMI_LANE_INLINE LaneBits Either(LaneBits x, LaneBits other, LaneBits where) {
  return (x & where) | (other & ~where);
}
HAZUMI_LANE_INLINE LaneReal Either(LaneReal x, LaneReal other, LaneBits where) {
  return SameBits<LaneReal>(Either(SameBits<LaneBits>(x), SameBits<LaneBits>(other), where));
}
HAZUMI_LANE_INLINE LaneTriple Either(const LaneTriple& x, const LaneTriple& other, LaneBits where) {
  return {{Either(x.e[0], other.e[0], where), Either(x.e[1], other.e[1], where),
           Either(x.e[2], other.e[2], where)}};
}

HAZUMI_LANE_INLINE LaneTriple AllThree(const double* x) {
  return {{All(x[0]), All(x[1]), All(x[2])}};
}

// Of the centre of a ball, its radius not counted.
struct LaneNearest {
  LaneReal value;  // [m]
  LaneTriple normal;
};

HAZUMI_LANE_INLINE LaneNearest ToPlane(const TouchedShape& plane, const LaneTriple& centre) {
  const LaneTriple normal = AllThree(plane.normal);
  return {Dot(normal, centre) - plane.offset, normal};
}

HAZUMI_LANE_INLINE LaneNearest ToBox(const TouchedShape& box, const LaneTriple& centre) {
  constexpr double kTouching = 1e-12;  // nearer counts as overlapping [m]
  const LaneReal zero = All(0.0);
  const LaneBits sign = SameBits<LaneBits>(All(-0.0));
  const LaneTriple from = centre + Scaled(All(-1.0), AllThree(box.p_WB));
  LaneTriple side, excess, gap;  // side: of q, its sign alone
  for (int i = 0; i < 3; ++i) {
    const LaneReal q = Dot(AllThree(box.R_WB + 3 * i), from);
    side.e[i] = SameBits<LaneReal>(SameBits<LaneBits>(q) & sign);
    excess.e[i] = SameBits<LaneReal>(SameBits<LaneBits>(q) & ~sign) - box.half_size[i];
    gap.e[i] = Only(excess.e[i], Greater(excess.e[i], zero));
  }
  LaneReal value = SquareRoot(Dot(gap, gap));
  const LaneBits overlaps = ~Greater(value, All(kTouching));
  LaneTriple along = Scaled(All(1.0) / (value + Only(All(1.0), overlaps)), gap);
  if (AnySet(overlaps)) {
    LaneReal deepest = excess.e[0];
    LaneTriple axis = {{All(1.0), zero, zero}};
    for (int i = 1; i < 3; ++i) {
      const LaneBits is_less = Greater(excess.e[i], deepest);
      const LaneTriple own = {{zero, All(i == 1), All(i == 2)}};
      deepest = Either(excess.e[i], deepest, is_less);
      axis = Either(own, axis, is_less);
    }
    value = Either(deepest, value, overlaps);
    along = Either(axis, along, overlaps);
  }
  LaneTriple normal = {{zero, zero, zero}};
  for (int i = 0; i < 3; ++i) {
    const LaneReal signed_along =
        SameBits<LaneReal>(SameBits<LaneBits>(along.e[i]) ^ SameBits<LaneBits>(side.e[i]));
    normal = normal + Scaled(signed_along, AllThree(box.R_WB + 3 * i));
  }
  return {value - box.margin, normal};
}

void Touch(const TouchingBall* balls, int num_balls, const TouchedShape* shapes, int num_shapes,
           const double* placed, double* touches, double* clearances, long stride) {
  for (int i = 0; i < num_balls; ++i, touches += 4 * TouchField::kNumFields, clearances += stride) {
    const TouchingBall& ball = balls[i];
    const double* body = placed + 4 * kPlacedFields * ball.body;
    const LaneTriple centre =
        LoadTriple<4>(body + 36) +
        InWorld(LoadAxes(body), All(ball.centre[0]), All(ball.centre[1]), All(ball.centre[2]));
    LaneNearest nearest = {All(1e300), {{All(0.0), All(0.0), All(1.0)}}};
    for (int s = 0; s < num_shapes; ++s) {
      const LaneNearest near =
          shapes[s].is_plane ? ToPlane(shapes[s], centre) : ToBox(shapes[s], centre);
      const LaneBits is_nearer = Greater(nearest.value, near.value);
      nearest.value = Either(near.value, nearest.value, is_nearer);
      nearest.normal = Either(near.normal, nearest.normal, is_nearer);
    }
    StoreTriple<4>(touches + 4 * TouchField::kCentre, centre);
    StoreTriple<4>(touches + 4 * TouchField::kNormal, nearest.normal);
    Store<4>(clearances, nearest.value - ball.radius);
  }
  LeaveLanes();
}
