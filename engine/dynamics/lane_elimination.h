#include "engine/dynamics/lane_sweeps.h"

// Forward dynamics by articulated bodies [Featherstone 2008, 7.3].
//
// The motion at qdd = 0 and its forces are known, so only what torques add is left: alpha and a of
// each body beyond that motion, with no velocity terms. Beyond joint i the figure answers
//   n = J alpha + H a + n0,   f = H^T alpha + M a + f0     (about the origin, in B).
// A hinge about e_k with torque tau asks n_k = tau; with D = J_kk that gives
//   qdd = (tau - n0_k)/D - (J_k./D) alpha - (H_k./D) a,
// and takes row and column k out of (J, H, M). One hinge follows the other from the body inwards,
// in axes that turn with each: three hinges leave J = 0 and H = 0, a ball joint that passes on no
// moment, and near the pose where they line up nothing is lost by cancellation.

template <typename V>
struct ArticulatedBody {
  Triple<V> n, f;
  Symmetric<V> J;
  Square<V> H;  // rows: moment; columns: acceleration
  Symmetric<V> M;
};

// A pivot below this part of the trace of J is nothing but rounding.
constexpr double kSmallestPivot = 1e-14;

// Axis of no hinge.
constexpr int kNone = -1;

// One elimination, of the hinge about e_K, and the turn to the axes before it. With one lane every
// turn is a hinge of the one body, so that row K is zero after it; and if the hinge beyond it lay
// along e_P, so is row P from before. With more lanes some may sit the turn out: `used` is 0 there,
// the pivot 1, and nothing changes. At the root H, M and f are not needed: it does not answer.
template <int K, int P, int W, bool kAtRoot>
struct Elimination {
  using V = typename LanesOf<W>::Real;
  using Bits = typename LanesOf<W>::Bits;
  static constexpr int I = (K + 1) % 3, J = (K + 2) % 3;
  static constexpr bool kAlone = W == 1;
  static constexpr bool kHasI = P != I, kHasJ = P != J;

  // Returns where the pivot is too small.
  static HAZUMI_LANE_INLINE Bits Run(V used, double* row, ArticulatedBody<V>* A) {
    const V D = kAlone ? A->J.d[K] : A->J.d[K] * used + (1.0 - used);
    const V trace = A->J.d[0] + A->J.d[1] + A->J.d[2];
    const Bits small =
        ~Greater(D, (kAlone ? kSmallestPivot * trace : kSmallestPivot * used * trace));
    Store<W>(row + LaneRow::kSmall * W, SameBits<V>(small));
    const V inverse = used / D;
    const V tau = Load<W>(row + LaneRow::kGiven * W);
    const V u = kAlone ? tau - A->n.e[K] : used * (tau - A->n.e[K]);
    Reduce(used, inverse, u, row + LaneRow::kPivot * W, A);
    TurnBack(LoadTurn<W>(row), A);
    return small;
  }

 private:
  // The fields of a pivot: (tau - n0_k)/D, J_kI/D, J_kJ/D, H_k./D.
  static HAZUMI_LANE_INLINE void Reduce(V used, V inverse, V u, double* pivot,
                                        ArticulatedBody<V>* A) {
    const V zero = {}, kept = 1.0 - used, k = inverse * u;
    const V ki = kHasI ? A->J.o[J] : zero, kj = kHasJ ? A->J.o[I] : zero;
    const V gi = kHasI ? inverse * ki : zero, gj = kHasJ ? inverse * kj : zero;
    Store<W>(pivot, k);
    Store<W>(pivot + W, gi);
    Store<W>(pivot + 2 * W, gj);
    A->n.e[K] += u;
    if (kHasI) A->n.e[I] += ki * k;
    if (kHasJ) A->n.e[J] += kj * k;
    if (kHasI) A->J.d[I] -= gi * ki;
    if (kHasJ) A->J.d[J] -= gj * kj;
    if (kHasI && kHasJ) A->J.o[K] -= gi * kj;
    A->J.o[J] = kAlone ? zero : kept * ki;
    A->J.o[I] = kAlone ? zero : kept * kj;
    A->J.d[K] = kAlone ? zero : kept * A->J.d[K];
    if (kAtRoot) return;
    const Triple<V> h = A->H.row[K], g = Scaled(inverse, h);
    StoreTriple<W>(pivot + 3 * W, g);
    for (int c = 0; c < 3; ++c) {
      A->f.e[c] += h.e[c] * k;
      if (kHasI) A->H.row[I].e[c] -= gi * h.e[c];
      if (kHasJ) A->H.row[J].e[c] -= gj * h.e[c];
      A->H.row[K].e[c] = kAlone ? zero : kept * h.e[c];
      A->M.d[c] -= g.e[c] * h.e[c];
      A->M.o[c] -= g.e[(c + 1) % 3] * h.e[(c + 2) % 3];
    }
  }

  static HAZUMI_LANE_INLINE void TurnBack(const Turn<V>& turn, ArticulatedBody<V>* A) {
    Inwards<K>(turn, &A->n);
    if constexpr (kAlone && P != kNone) {
      // Of J only one number is left, and of H one row.
      constexpr int Q = P == I ? J : I;
      const V to_i = Q == I ? turn.c : -turn.s, to_j = Q == I ? turn.s : turn.c;
      const V left = A->J.d[Q], part = to_i * left;
      A->J.d[I] = to_i * part;
      A->J.d[J] = to_j * (to_j * left);
      A->J.o[K] = to_j * part;
      if (kAtRoot) return;
      Triple<V> row = A->H.row[Q];
      Inwards<K>(turn, &row);
      A->H.row[I] = Scaled(to_i, row);
      A->H.row[J] = Scaled(to_j, row);
    } else {
      Inwards<K>(turn, &A->J);
      if (kAtRoot) return;
      Inwards<K>(turn, &A->H);
    }
    Inwards<K>(turn, &A->f);
    Inwards<K>(turn, &A->M);
  }
};

// Visits the turns of a step from the body inwards.
template <int W, bool kAtRoot>
struct EliminationAcross {
  using V = typename LanesOf<W>::Real;
  explicit EliminationAcross(const LanePlan& of) : plan(of) {}

  const LanePlan& plan;
  ArticulatedBody<V> A;
  typename LanesOf<W>::Bits small = {};
  int before = kNone;

  template <int K>
  HAZUMI_LANE_INLINE void At(double* row, int r) {
    const V sign = Load<W>(plan.row_sign.data() + r * W), used = sign * sign;
    constexpr int I = (K + 1) % 3, J = (K + 2) % 3;
    if (W == 1 && before == I) {
      small |= Elimination < K, W == 1 ? I : kNone, W, kAtRoot > ::Run(used, row, &A);
    } else if (W == 1 && before == J) {
      small |= Elimination < K, W == 1 ? J : kNone, W, kAtRoot > ::Run(used, row, &A);
    } else {
      small |= Elimination<K, kNone, W, kAtRoot>::Run(used, row, &A);
    }
    before = K;
  }
};

// About another origin, from which the present one is at r; with a = a' - r x alpha
//   H' = H + r x M,  J' = J + (r x H^T)^T + r x H'^T,  n' = n + r x f.
template <typename V>
HAZUMI_LANE_INLINE void Shift(const Triple<V>& r, ArticulatedBody<V>* A) {
  A->n = A->n + Cross(r, A->f);
  Triple<V> arm[3];
  for (int i = 0; i < 3; ++i) arm[i] = Cross(r, A->H.row[i]);
  for (int c = 0; c < 3; ++c) {
    const Triple<V> column = {{A->M.at(0, c), A->M.at(1, c), A->M.at(2, c)}};
    const Triple<V> moment = Cross(r, column);
    for (int i = 0; i < 3; ++i) A->H.row[i].e[c] += moment.e[i];
  }
  Triple<V> arm_after[3];
  for (int i = 0; i < 3; ++i) arm_after[i] = Cross(r, A->H.row[i]);
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) A->J.at(i, j) += arm[i].e[j] + arm_after[j].e[i];
  }
}

template <typename V>
HAZUMI_LANE_INLINE void TurnInwards(const Square<V>& F, ArticulatedBody<V>* A) {
  A->n = F * A->n;
  A->f = F * A->f;
  A->J = Conjugated(F, A->J);
  A->H = Conjugated(F, A->H);
  A->M = Conjugated(F, A->M);
}

// The body's own inertia, [h]x and m 1 for H and M, with what hangs on it.
template <int W, typename V>
HAZUMI_LANE_INLINE void Gather(const LanePlan& plan, const StepView<W>& view, const double* scratch,
                               ArticulatedBody<V>* A) {
  const Triple<V> h = LoadTriple<W>(view.constants + LaneConstants::kMoment * W);
  const V mass = Load<W>(view.constants + LaneConstants::kMass * W), zero = {};
  A->n = LoadTriple<W>(view.field(LaneState::kLoad));
  A->f = LoadTriple<W>(view.field(LaneState::kLoad + 3));
  A->J = LoadSymmetric<W>(view.constants + LaneConstants::kInertia * W);
  A->H.row[0] = {{zero, -h.e[2], h.e[1]}};
  A->H.row[1] = {{h.e[2], zero, -h.e[0]}};
  A->H.row[2] = {{-h.e[1], h.e[0], zero}};
  A->M = {{mass, mass, mass}, {zero, zero, zero}};
  static_assert(sizeof *A == LaneState::kLoadFields * sizeof(V));
  AddChildren<W, LaneState::kLoadFields>(plan, view.step, scratch, reinterpret_cast<V*>(A));
}

template <int W, bool kAtRoot>
HAZUMI_LANE_INLINE typename LanesOf<W>::Bits EliminateStep(const LanePlan& plan,
                                                           const StepView<W>& view,
                                                           double* scratch) {
  using V = typename LanesOf<W>::Real;
  double* rows = scratch + plan.row(0);
  EliminationAcross<W, kAtRoot> across(plan);
  Gather<W>(plan, view, scratch, &across.A);
  for (int r = view.step.end_row - 1; r >= view.step.first_row; --r) {
    VisitRow<W>(plan, r, rows, &across);
  }
  if constexpr (!kAtRoot) {
    ArticulatedBody<V>& A = across.A;
    if (view.step.turned) TurnInwards(view.F(), &A);
    if (view.step.shifted) Shift(view.origin(), &A);
    const V* fields = reinterpret_cast<const V*>(&A);
    for (int f = 0; f < LaneState::kLoadFields; ++f) {
      Store<W>(view.field(LaneState::kLoad + f), fields[f]);
    }
  }
  return across.small;
}

// Outwards again: qdd of a hinge from the response before it. What alpha is beyond the hinge does
// not depend on what it was about the hinge, and is not reckoned by way of it: hinges that almost
// line up have huge opposite accelerations.
template <int W, bool kAtRoot>
struct ResponseAcross {
  using V = typename LanesOf<W>::Real;
  const LanePlan& plan;
  Triple<V> alpha, a;

  template <int K>
  HAZUMI_LANE_INLINE void At(double* row, int r) {
    constexpr int I = (K + 1) % 3, J = (K + 2) % 3;
    const auto turn = LoadTurn<W>(row);
    Outwards<K>(turn, &alpha);
    if (!kAtRoot) Outwards<K>(turn, &a);
    const double* pivot = row + LaneRow::kPivot * W;
    V beyond =
        Load<W>(pivot) - Load<W>(pivot + W) * alpha.e[I] - Load<W>(pivot + 2 * W) * alpha.e[J];
    if (!kAtRoot) beyond -= Dot(LoadTriple<W>(pivot + 3 * W), a);
    const V before = alpha.e[K];
    if (W == 1) {
      Store<W>(row + LaneRow::kGiven * W, beyond - before);
      alpha.e[K] = beyond;
    } else {
      const V sign = Load<W>(plan.row_sign.data() + r * W), used = sign * sign;
      Store<W>(row + LaneRow::kGiven * W, beyond - used * before);
      alpha.e[K] = beyond + (1.0 - used) * before;
    }
  }
};

template <int W, bool kAtRoot>
HAZUMI_LANE_INLINE void RespondStep(const LanePlan& plan, const StepView<W>& view,
                                    double* scratch) {
  using V = typename LanesOf<W>::Real;
  double* rows = scratch + plan.row(0);
  V parent[6] = {};
  if (!kAtRoot) FetchFields<W, 6>(scratch, view.step.parent, LaneState::kResponse, parent);
  ResponseAcross<W, kAtRoot> across{
      plan, {{parent[0], parent[1], parent[2]}}, {{parent[3], parent[4], parent[5]}}};
  if (!kAtRoot) {
    if (view.step.shifted) across.a = across.a + Cross(across.alpha, view.origin());
    if (view.step.turned) {
      const Square<V> F = view.F();
      across.alpha = TransposeTimes(F, across.alpha);
      across.a = TransposeTimes(F, across.a);
    }
  }
  for (int r = view.step.first_row; r < view.step.end_row; ++r) VisitRow<W>(plan, r, rows, &across);
  StoreTriple<W>(view.field(LaneState::kResponse), across.alpha);
  StoreTriple<W>(view.field(LaneState::kResponse + 3), across.a);
}

template <int W>
bool Accelerations(const LanePlan& plan, const double* tau, double* qdd, double* scratch) {
  SetGiven<W>(plan, tau, scratch);
  const int steps = static_cast<int>(plan.steps.size());
  typename LanesOf<W>::Bits small = {};
  for (int s = steps - 1; s >= 0; --s) {
    const StepView<W> view(plan, s, scratch);
    small |= view.step.at_root ? EliminateStep<W, true>(plan, view, scratch)
                               : EliminateStep<W, false>(plan, view, scratch);
  }
  if (AnySet(small)) {
    LeaveLanes();
    return false;
  }
  for (int s = 0; s < steps; ++s) {
    const StepView<W> view(plan, s, scratch);
    if (view.step.at_root) {
      RespondStep<W, true>(plan, view, scratch);
    } else {
      RespondStep<W, false>(plan, view, scratch);
    }
  }
  GetGiven<W>(plan, scratch, qdd);
  LeaveLanes();
  return true;
}
