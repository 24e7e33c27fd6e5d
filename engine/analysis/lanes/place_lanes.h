#include "engine/spatial/lanes/lane_trig.h"

// Forward kinematics, a frame in each lane: from the parent P of a joint at p_PJ, R_PJ with axis e
//   p_J = p_P + R_P p_PJ,   R_J = R_P R_PJ (c 1 + s [e] + (1 - c) e e^T).

using LaneReal = LanesOf<4>::Real;
using LaneBits = LanesOf<4>::Bits;
using LaneTriple = Triple<LaneReal>;

// Axes of a body in the world.
struct LaneAxes {
  LaneTriple column[3];
};

HAZUMI_LANE_INLINE LaneAxes LoadAxes(const double* placed) {
  return {{LoadTriple<4>(placed), LoadTriple<4>(placed + 12), LoadTriple<4>(placed + 24)}};
}

HAZUMI_LANE_INLINE LaneTriple InWorld(const LaneAxes& R, LaneReal x, LaneReal y, LaneReal z) {
  return Scaled(x, R.column[0]) + Scaled(y, R.column[1]) + Scaled(z, R.column[2]);
}

HAZUMI_LANE_INLINE LaneReal All(double x) { return FromFour(x, x, x, x); }

// The same entry of four arrays.
HAZUMI_LANE_INLINE LaneReal CollectAt(const double* const of[4], int i) {
  return FromFour(of[0][i], of[1][i], of[2][i], of[3][i]);
}

HAZUMI_LANE_INLINE LaneAxes Times(const LaneAxes& R, const LaneReal* by) {
  return {{InWorld(R, by[0], by[1], by[2]), InWorld(R, by[3], by[4], by[5]),
           InWorld(R, by[6], by[7], by[8])}};
}

template <int K>
HAZUMI_LANE_INLINE void TurnAboutUnit(LaneReal s, LaneReal c, LaneAxes* R) {
  constexpr int I = (K + 1) % 3, J = (K + 2) % 3;
  const LaneTriple was = R->column[I];
  R->column[I] = Scaled(c, was) + Scaled(s, R->column[J]);
  R->column[J] = Scaled(c, R->column[J]) + Scaled(-s, was);
}

HAZUMI_LANE_INLINE void TurnAbout(const double* axis, LaneReal s, LaneReal c, LaneAxes* R) {
  const LaneReal x = All(axis[0]), y = All(axis[1]), z = All(axis[2]), d = 1.0 - c;
  const LaneReal by[9] = {c + d * x * x,     d * x * y + s * z, d * x * z - s * y,
                          d * x * y - s * z, c + d * y * y,     d * y * z + s * x,
                          d * x * z + s * y, d * y * z - s * x, c + d * z * z};
  *R = Times(*R, by);
}

// Of angles that are too large for the polynomials.
__attribute__((noinline)) void LargeSineAndCosine(const double* angles, double* sine,
                                                  double* cosine) {
  for (int l = 0; l < 4; ++l) {
    sine[l] = __builtin_sin(angles[l]);
    cosine[l] = __builtin_cos(angles[l]);
  }
}

HAZUMI_LANE_INLINE void TurnHinge(const PlacedHinge& hinge, LaneReal angle, LaneAxes* R) {
  LaneReal s, c;
  SineAndCosine<4>(angle, &s, &c);
  if (AnySet(IsLarge<4>(angle))) {
    alignas(32) double angles[4], sine[4], cosine[4];
    Store<4>(angles, angle);
    LargeSineAndCosine(angles, sine, cosine);
    s = Load<4>(sine);
    c = Load<4>(cosine);
  }
  s = hinge.sign * s;
  switch (hinge.unit_axis) {
    case 0:
      return TurnAboutUnit<0>(s, c, R);
    case 1:
      return TurnAboutUnit<1>(s, c, R);
    case 2:
      return TurnAboutUnit<2>(s, c, R);
    default:
      return TurnAbout(hinge.axis, s, c, R);
  }
}

void Place(const PlacedHinge* hinges, int num_hinges, const double* const angles[4],
           double* placed) {
  for (int j = 0; j < num_hinges; ++j) {
    const PlacedHinge& hinge = hinges[j];
    const double* parent = placed + 4 * kPlacedFields * hinge.parent;
    double* own = placed + 4 * kPlacedFields * (j + 1);
    LaneAxes R = LoadAxes(parent);
    LaneTriple p = LoadTriple<4>(parent + 36);
    if (hinge.is_shifted) {
      p = p + InWorld(R, All(hinge.p_PJ[0]), All(hinge.p_PJ[1]), All(hinge.p_PJ[2]));
    }
    StoreTriple<4>(own + 36, p);
    if (!hinge.is_parallel) {
      LaneReal by[9];
      for (int i = 0; i < 9; ++i) by[i] = All(hinge.R_PJ[i]);
      R = Times(R, by);
    }
    TurnHinge(hinge, CollectAt(angles, j), &R);
    for (int k = 0; k < 3; ++k) StoreTriple<4>(own + 12 * k, R.column[k]);
  }
  LeaveLanes();
}
