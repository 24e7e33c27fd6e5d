#include "engine/analysis/lanes/place_lanes.h"

// Inverse dynamics, a frame in each lane, in world axes: the equations of inverse_dynamics.cpp,
// with the own forces F, N of all bodies summed up about the root's origin p_R on the way outwards,
//   F_R = sum F_i,   N_R = sum N_i + (p_i - p_R) x F_i,
// which is known before anything goes inwards.

struct LaneMotion {
  LaneTriple w, alpha, a;
};
struct LaneLoad {
  LaneTriple f, n;
};

HAZUMI_LANE_INLINE LaneTriple InWorld(const LaneAxes& R, const LaneTriple& x) {
  return InWorld(R, x.e[0], x.e[1], x.e[2]);
}
HAZUMI_LANE_INLINE LaneTriple InBody(const LaneAxes& R, const LaneTriple& x) {
  return {{Dot(R.column[0], x), Dot(R.column[1], x), Dot(R.column[2], x)}};
}
HAZUMI_LANE_INLINE LaneTriple Between(const LaneTriple& from, const LaneTriple& to) {
  return {{to.e[0] - from.e[0], to.e[1] - from.e[1], to.e[2] - from.e[2]}};
}

HAZUMI_LANE_INLINE LaneTriple AxisOf(const PlacedHinge& hinge, const double* placed) {
  if (hinge.unit_axis >= 0) {
    return Scaled(All(hinge.sign), LoadTriple<4>(placed + 12 * hinge.unit_axis));
  }
  return InWorld(LoadAxes(placed), All(hinge.axis[0]), All(hinge.axis[1]), All(hinge.axis[2]));
}

HAZUMI_LANE_INLINE LaneMotion LoadMotion(const double* at) {
  return {LoadTriple<4>(at), LoadTriple<4>(at + 12), LoadTriple<4>(at + 24)};
}
HAZUMI_LANE_INLINE void StoreMotion(double* at, const LaneMotion& m) {
  StoreTriple<4>(at, m.w);
  StoreTriple<4>(at + 12, m.alpha);
  StoreTriple<4>(at + 24, m.a);
}
HAZUMI_LANE_INLINE LaneLoad LoadLoad(const double* at) {
  return {LoadTriple<4>(at), LoadTriple<4>(at + 12)};
}
HAZUMI_LANE_INLINE void StoreLoad(double* at, const LaneLoad& load) {
  StoreTriple<4>(at, load.f);
  StoreTriple<4>(at + 12, load.n);
}

// A load at a point, told about another one that is further by -r.
HAZUMI_LANE_INLINE void AddAt(const LaneTriple& r, const LaneLoad& load, LaneLoad* sum) {
  sum->f = sum->f + load.f;
  sum->n = sum->n + load.n + Cross(r, load.f);
}

// What a body's own motion asks for, about its origin.
HAZUMI_LANE_INLINE LaneLoad OwnLoad(const double* inertia, const LaneAxes& R, const LaneMotion& m) {
  const LaneTriple c = InWorld(R, LoadTriple<4>(inertia + 4 * InertiaField::kCom));
  const LaneTriple f = Scaled(Load<4>(inertia + 4 * InertiaField::kMass),
                              m.a + Cross(m.alpha, c) + Cross(m.w, Cross(m.w, c)));
  const Symmetric<LaneReal> I = LoadSymmetric<4>(inertia + 4 * InertiaField::kInertia);
  const LaneTriple w = InBody(R, m.w);
  return {f, InWorld(R, I * InBody(R, m.alpha) + Cross(w, I * w)) + Cross(c, f)};
}

void Demand(const FourMotions& four) {
  const LaneTriple p_root = LoadTriple<4>(four.placed + 36);
  LaneLoad needed = OwnLoad(four.inertias, LoadAxes(four.placed), LoadMotion(four.motions));
  for (int j = 0; j < four.num_hinges; ++j) {
    const PlacedHinge& hinge = four.hinges[j];
    const double* placed = four.placed + 4 * kPlacedFields * (j + 1);
    const LaneTriple p = LoadTriple<4>(placed + 36), axis = AxisOf(hinge, placed);
    LaneMotion m = LoadMotion(four.motions + 4 * kMotionFields * hinge.parent);
    if (hinge.is_shifted) {
      const LaneTriple r =
          Between(LoadTriple<4>(four.placed + 4 * kPlacedFields * hinge.parent + 36), p);
      m.a = m.a + Cross(m.alpha, r) + Cross(m.w, Cross(m.w, r));
    }
    const LaneTriple turn = Scaled(CollectAt(four.rates, j), axis);
    m.alpha = m.alpha + Scaled(CollectAt(four.accelerations, j), axis) + Cross(m.w, turn);
    m.w = m.w + turn;
    StoreMotion(four.motions + 4 * kMotionFields * (j + 1), m);
    LaneLoad own = {};
    if (!hinge.is_massless) {
      own = OwnLoad(four.inertias + 4 * InertiaField::kNumFields * (j + 1), LoadAxes(placed), m);
      AddAt(Between(p_root, p), own, &needed);
    }
    StoreLoad(four.loads + 4 * kLoadFields * (j + 1), own);
  }
  StoreLoad(four.needed, needed);
  LeaveLanes();
}

void Relay(const FourMotions& four) {
  for (int j = four.num_hinges - 1; j >= 0; --j) {
    const PlacedHinge& hinge = four.hinges[j];
    const double* placed = four.placed + 4 * kPlacedFields * (j + 1);
    const LaneLoad load = LoadLoad(four.loads + 4 * kLoadFields * (j + 1));
    Store<4>(four.torques + 4 * j, Dot(AxisOf(hinge, placed), load.n));
    if (hinge.parent == 0) continue;
    double* at = four.loads + 4 * kLoadFields * hinge.parent;
    const double* from = four.placed + 4 * kPlacedFields * hinge.parent + 36;
    LaneLoad sum = LoadLoad(at);
    AddAt(Between(LoadTriple<4>(from), LoadTriple<4>(placed + 36)), load, &sum);
    StoreLoad(at, sum);
  }
  LeaveLanes();
}
