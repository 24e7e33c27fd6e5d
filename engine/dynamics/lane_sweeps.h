#include "engine/dynamics/lane_trig.h"

// The sweeps of LaneKernels: motion, forces, torques.

// N fields of whichever lanes the source names, from `field` on.
template <int W, int N>
HAZUMI_LANE_INLINE void FetchFields(const double* scratch, const LaneSource& source, int field,
                                    typename LanesOf<W>::Real* fields) {
  if (W == 1 || source.contiguous) {
    LoadFields<W, N>(scratch + source.from[0] + field * W, fields);
    return;
  }
  for (int f = 0; f < N; ++f) fields[f] = Collect<W>(scratch + (field + f) * W, source.from.data());
}

// Adds what the children ask for to the first N fields of a load.
template <int W, int N>
HAZUMI_LANE_INLINE void AddChildren(const LanePlan& plan, const LaneStep& step,
                                    const double* scratch, typename LanesOf<W>::Real* load) {
  for (int child = step.first_child; child < step.end_child; ++child) {
    const LaneSource& source = plan.children[child];
    if (W == 1 || source.contiguous) {
      const double* at = scratch + source.from[0];
      for (int f = 0; f < N; ++f) load[f] += Load<W>(at + f * W);
    } else {
      for (int f = 0; f < N; ++f) load[f] += Collect<W>(scratch + f * W, source.from.data());
    }
  }
}

// Where the fields of a step are.
template <int W>
struct StepView {
  StepView(const LanePlan& plan, int s, double* scratch)
      : step(plan.steps[s]),
        constants(plan.constants.data() + s * LaneConstants::kFields * W),
        state(scratch + plan.state(s)) {}

  Triple<typename LanesOf<W>::Real> origin() const {
    return LoadTriple<W>(constants + LaneConstants::kOrigin * W);
  }
  Square<typename LanesOf<W>::Real> F() const {
    return LoadSquare<W>(constants + LaneConstants::kF * W);
  }
  double* field(int f) const { return state + f * W; }
  const LaneStep& step;
  const double* constants;
  double* state;
};

template <int W>
HAZUMI_LANE_INLINE Turn<typename LanesOf<W>::Real> LoadTurn(const double* row) {
  return {Load<W>(row + LaneRow::kCosine * W), Load<W>(row + LaneRow::kSine * W)};
}

// Calls the visitor's At<K>(row, entries), K the axis of the turn.
template <int W, typename Visitor>
HAZUMI_LANE_INLINE void VisitRow(const LanePlan& plan, int r, double* rows, Visitor* visitor) {
  double* row = rows + r * LaneRow::kFields * W;
  switch (plan.row_axis[r]) {
    case 0:
      return visitor->template At<0>(row, r);
    case 1:
      return visitor->template At<1>(row, r);
    default:
      return visitor->template At<2>(row, r);
  }
}

// Joint values in the order of rows, with the sign of each hinge.
template <int W>
HAZUMI_LANE_INLINE typename LanesOf<W>::Real OfJoints(const LanePlan& plan, int r,
                                                      const double* values) {
  return Load<W>(plan.row_sign.data() + r * W) * Collect<W>(values, plan.row_joint.data() + r * W);
}

template <int W>
void SetGiven(const LanePlan& plan, const double* values, double* scratch) {
  const int rows = plan.num_rows();
  double* row = scratch + plan.row(0) + LaneRow::kGiven * W;
  for (int r = 0; r < rows; ++r, row += LaneRow::kFields * W) {
    Store<W>(row, OfJoints<W>(plan, r, values));
  }
}

template <int W>
void GetGiven(const LanePlan& plan, const double* scratch, double* values) {
  const int n = static_cast<int>(plan.joint_at.size());
  const int* at = plan.joint_at.data();
  const double *sign = plan.joint_sign.data(), *given = scratch + LaneRow::kGiven * W;
  for (int j = 0; j < n; ++j) values[j] = sign[j] * given[at[j]];
}

// The angles that are too large for the polynomials.
template <int W>
__attribute__((noinline)) void SetLargeTurns(const LanePlan& plan, const double* q,
                                             double* scratch) {
  for (int r = 0; r < plan.num_rows(); ++r) {
    double* row = scratch + plan.row(r);
    for (int l = 0; l < W; ++l) {
      const double angle = plan.row_sign.data()[r * W + l] * q[plan.row_joint[r * W + l]];
      if (__builtin_fabs(angle) <= kLargestAngle) continue;
      row[LaneRow::kSine * W + l] = __builtin_sin(angle);
      row[LaneRow::kCosine * W + l] = __builtin_cos(angle);
    }
  }
}

template <int W>
void SetTurns(const LanePlan& plan, const double* q, const double* qd, double* scratch) {
  using V = typename LanesOf<W>::Real;
  const int rows = plan.num_rows();
  typename LanesOf<W>::Bits large = {};
  double* row = scratch + plan.row(0);
  for (int r = 0; r < rows; ++r, row += LaneRow::kFields * W) {
    const V angle = OfJoints<W>(plan, r, q);
    V sine, cosine;
    SineAndCosine<W>(angle, &sine, &cosine);
    large |= IsLarge<W>(angle);
    Store<W>(row + LaneRow::kSine * W, sine);
    Store<W>(row + LaneRow::kCosine * W, cosine);
    Store<W>(row + LaneRow::kRate * W, OfJoints<W>(plan, r, qd));
  }
  if (AnySet(large)) SetLargeTurns<W>(plan, q, scratch);
}

// Motion of a body, in its own axes: w, alpha, and a of its origin.
template <typename V>
struct LaneMotion {
  Triple<V> w, alpha, a;
};

// Across a hinge: into the axes beyond it, and its own rate and acceleration on top:
//   w += e qd,  alpha += e qdd + w x e qd.
template <int W>
struct MotionAcross {
  LaneMotion<typename LanesOf<W>::Real> m;

  template <int K>
  HAZUMI_LANE_INLINE void At(const double* row, int) {
    constexpr int I = (K + 1) % 3, J = (K + 2) % 3;
    const auto turn = LoadTurn<W>(row);
    Outwards<K>(turn, &m.w);
    Outwards<K>(turn, &m.alpha);
    Outwards<K>(turn, &m.a);
    const auto rate = Load<W>(row + LaneRow::kRate * W);
    m.alpha.e[I] += m.w.e[J] * rate;
    m.alpha.e[J] -= m.w.e[I] * rate;
    m.w.e[K] += rate;
    m.alpha.e[K] += Load<W>(row + LaneRow::kGiven * W);
  }
};

// a + alpha x r + w x (w x r)
template <typename V>
HAZUMI_LANE_INLINE Triple<V> AccelerationAt(const LaneMotion<V>& m, const Triple<V>& r) {
  return m.a + Cross(m.alpha, r) + Cross(m.w, Cross(m.w, r));
}

// The moment about the origin and the force that the body's own inertia asks for, h = m c:
//   n = I_o alpha + w x I_o w + h x a,  f = m a + alpha x h + w x (w x h)
template <int W, typename V>
HAZUMI_LANE_INLINE void StoreOwnForce(const StepView<W>& view, const LaneMotion<V>& m) {
  const Symmetric<V> I_o = LoadSymmetric<W>(view.constants + LaneConstants::kInertia * W);
  const Triple<V> h = LoadTriple<W>(view.constants + LaneConstants::kMoment * W);
  const V mass = Load<W>(view.constants + LaneConstants::kMass * W);
  StoreTriple<W>(view.field(LaneState::kLoad),
                 I_o * m.alpha + Cross(m.w, I_o * m.w) + Cross(h, m.a));
  StoreTriple<W>(view.field(LaneState::kLoad + 3),
                 Scaled(mass, m.a) + Cross(m.alpha, h) + Cross(m.w, Cross(m.w, h)));
}

// Outwards: the motion of every body and its own force.
template <int W>
void MoveBodies(const LanePlan& plan, double* scratch) {
  using V = typename LanesOf<W>::Real;
  double* rows = scratch + plan.row(0);
  const int steps = static_cast<int>(plan.steps.size());
  for (int s = 0; s < steps; ++s) {
    const StepView<W> view(plan, s, scratch);
    V parent[9];
    FetchFields<W, 9>(scratch, view.step.parent, LaneState::kMotion, parent);
    MotionAcross<W> across = {{{{parent[0], parent[1], parent[2]}},
                               {{parent[3], parent[4], parent[5]}},
                               {{parent[6], parent[7], parent[8]}}}};
    LaneMotion<V>& m = across.m;
    if (view.step.shifted) m.a = AccelerationAt(m, view.origin());
    if (view.step.turned) {
      const Square<V> F = view.F();
      m = {TransposeTimes(F, m.w), TransposeTimes(F, m.alpha), TransposeTimes(F, m.a)};
    }
    for (int r = view.step.first_row; r < view.step.end_row; ++r)
      VisitRow<W>(plan, r, rows, &across);
    StoreTriple<W>(view.field(LaneState::kMotion), m.w);
    StoreTriple<W>(view.field(LaneState::kMotion + 3), m.alpha);
    StoreTriple<W>(view.field(LaneState::kMotion + 6), m.a);
    StoreOwnForce(view, m);
  }
}

template <int W>
void Start(const LanePlan& plan, const double* q, const double* qd, const double* qdd,
           double* scratch) {
  SetTurns<W>(plan, q, qd, scratch);
  SetGiven<W>(plan, qdd, scratch);
  MoveBodies<W>(plan, scratch);
  LeaveLanes();
}

// Back across a hinge: its torque is the moment about it.
template <int W>
struct ForceAcross {
  Triple<typename LanesOf<W>::Real> n, f;

  template <int K>
  HAZUMI_LANE_INLINE void At(double* row, int) {
    Store<W>(row + LaneRow::kGiven * W, n.e[K]);
    const auto turn = LoadTurn<W>(row);
    Inwards<K>(turn, &n);
    Inwards<K>(turn, &f);
  }
};

// Inwards: what every body asks of its parent, or of the root, and torques on the way.
template <int W>
void Torques(const LanePlan& plan, double* tau, double* scratch) {
  using V = typename LanesOf<W>::Real;
  double* rows = scratch + plan.row(0);
  for (int s = static_cast<int>(plan.steps.size()) - 1; s >= 0; --s) {
    const StepView<W> view(plan, s, scratch);
    V load[LaneState::kLoadFields];
    LoadFields<W, LaneState::kLoadFields>(view.field(LaneState::kLoad), load);
    AddChildren<W, LaneState::kLoadFields>(plan, view.step, scratch, load);
    ForceAcross<W> across = {{{load[0], load[1], load[2]}}, {{load[3], load[4], load[5]}}};
    for (int r = view.step.end_row - 1; r >= view.step.first_row; --r) {
      VisitRow<W>(plan, r, rows, &across);
    }
    if (view.step.turned) {
      const Square<V> F = view.F();
      across.n = F * across.n;
      across.f = F * across.f;
    }
    if (view.step.shifted) across.n = across.n + Cross(view.origin(), across.f);
    StoreTriple<W>(view.field(LaneState::kLoad), across.n);
    StoreTriple<W>(view.field(LaneState::kLoad + 3), across.f);
  }
  GetGiven<W>(plan, scratch, tau);
  LeaveLanes();
}
