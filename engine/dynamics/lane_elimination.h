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

// The fields of a pivot: (tau - n0_k)/D, J_kI/D, J_kJ/D, H_k./D, and bits: set where D is too
// small. kAtRoot: the body's parent does not answer, so that H, M and f are not needed.
template <int K, int W, bool kAtRoot, typename V>
HAZUMI_LANE_INLINE typename LanesOf<W>::Bits Eliminate(const StepView<W>& view,
                                                       ArticulatedBody<V>* A) {
  constexpr int I = (K + 1) % 3, J = (K + 2) % 3;
  const V used = Load<W>(view.constants + (LaneConstants::kUsed + K) * W);
  const V kept = 1.0 - used;
  const V tau = Load<W>(view.row(K) + LaneRow::kGiven * W);
  const V trace = A->J.d[0] + A->J.d[1] + A->J.d[2];
  const V D = A->J.d[K] * used + kept;
  const auto small = ~Greater<W>(D, kSmallestPivot * used * trace);
  const V inverse = used / D;
  const V ki = A->J.o[J], kj = A->J.o[I];
  const V gi = inverse * ki, gj = inverse * kj;
  const V u = used * (tau - A->n.e[K]), k = inverse * u;
  double* pivot = view.pivot(K);
  Store<W>(pivot, k);
  Store<W>(pivot + W, gi);
  Store<W>(pivot + 2 * W, gj);
  Store<W>(pivot + 6 * W, SameBits<V>(small));
  A->n.e[K] += u;
  A->n.e[I] += ki * k;
  A->n.e[J] += kj * k;
  A->J.d[I] -= gi * ki;
  A->J.d[J] -= gj * kj;
  A->J.o[K] -= gi * kj;
  A->J.o[J] = kept * ki;
  A->J.o[I] = kept * kj;
  A->J.d[K] *= kept;
  if constexpr (!kAtRoot) {
    const Triple<V> h = A->H.row[K], g = Scaled(inverse, h);
    StoreTriple<W>(pivot + 3 * W, g);
    for (int c = 0; c < 3; ++c) {
      A->f.e[c] += h.e[c] * k;
      A->H.row[I].e[c] -= gi * h.e[c];
      A->H.row[J].e[c] -= gj * h.e[c];
      A->H.row[K].e[c] = kept * h.e[c];
      A->M.d[c] -= g.e[c] * h.e[c];
      A->M.o[c] -= g.e[(c + 1) % 3] * h.e[(c + 2) % 3];
    }
  }
  return small;
}

template <int K, bool kAtRoot, typename V>
HAZUMI_LANE_INLINE void TurnInwards(const Turn<V>& turn, ArticulatedBody<V>* A) {
  Inwards<K>(turn, &A->n);
  Inwards<K>(turn, &A->J);
  if constexpr (!kAtRoot) {
    Inwards<K>(turn, &A->f);
    Inwards<K>(turn, &A->H);
    Inwards<K>(turn, &A->M);
  }
}

template <int K, int W, bool kAtRoot, typename V>
HAZUMI_LANE_INLINE typename LanesOf<W>::Bits EliminateSlot(const StepView<W>& view,
                                                           ArticulatedBody<V>* A) {
  if ((view.step.slots >> K & 1) == 0) return typename LanesOf<W>::Bits{};
  const auto small = Eliminate<K, W, kAtRoot>(view, A);
  TurnInwards<K, kAtRoot>(view.turn(K), A);
  return small;
}

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
template <int W, bool kAtRoot, typename V>
HAZUMI_LANE_INLINE ArticulatedBody<V> Gather(const LanePlan& plan, const StepView<W>& view,
                                             const double* scratch) {
  const Symmetric<V> I_o = LoadSymmetric<W>(view.constants + LaneConstants::kInertia * W);
  const Triple<V> h = LoadTriple<W>(view.constants + LaneConstants::kMoment * W);
  const V mass = Load<W>(view.constants + LaneConstants::kMass * W), zero = {};
  const Triple<V> n = LoadTriple<W>(view.field(LaneState::kLoad));
  const Triple<V> f = LoadTriple<W>(view.field(LaneState::kLoad + 3));
  ArticulatedBody<V> A = {
      n,
      f,
      I_o,
      {{{{zero, -h.e[2], h.e[1]}}, {{h.e[2], zero, -h.e[0]}}, {{-h.e[1], h.e[0], zero}}}},
      {{mass, mass, mass}, {zero, zero, zero}}};
  static_assert(sizeof A == LaneState::kLoadFields * sizeof(V));
  V* fields = reinterpret_cast<V*>(&A);
  AddChildren<W, LaneState::kLoadFields>(plan, view.step, scratch, fields);
  return A;
}

template <int W, bool kAtRoot>
HAZUMI_LANE_INLINE typename LanesOf<W>::Bits EliminateStep(const LanePlan& plan,
                                                           const StepView<W>& view,
                                                           double* scratch) {
  using V = typename LanesOf<W>::Real;
  ArticulatedBody<V> A = Gather<W, kAtRoot, V>(plan, view, scratch);
  auto small = EliminateSlot<2, W, kAtRoot>(view, &A);
  small |= EliminateSlot<1, W, kAtRoot>(view, &A);
  small |= EliminateSlot<0, W, kAtRoot>(view, &A);
  if constexpr (!kAtRoot) {
    if (view.step.turned) TurnInwards(view.F(), &A);
    if (view.step.shifted) Shift(view.origin(), &A);
    const V* fields = reinterpret_cast<const V*>(&A);
    for (int f = 0; f < LaneState::kLoadFields; ++f) {
      Store<W>(view.field(LaneState::kLoad + f), fields[f]);
    }
  }
  return small;
}

// Outwards again: qdd of one slot from the response before it. What alpha is beyond the hinge does
// not depend on what it was about the hinge, and is not reckoned by way of it: hinges that almost
// line up have huge opposite accelerations.
template <int K, int W, bool kAtRoot, typename V>
HAZUMI_LANE_INLINE void Respond(const StepView<W>& view, Triple<V>* alpha, Triple<V>* a) {
  if ((view.step.slots >> K & 1) == 0) return;
  constexpr int I = (K + 1) % 3, J = (K + 2) % 3;
  const Turn<V> turn = view.turn(K);
  Outwards<K>(turn, alpha);
  if (!kAtRoot) Outwards<K>(turn, a);
  const double* pivot = view.pivot(K);
  const V used = Load<W>(view.constants + (LaneConstants::kUsed + K) * W), kept = 1.0 - used;
  V beyond =
      Load<W>(pivot) - Load<W>(pivot + W) * alpha->e[I] - Load<W>(pivot + 2 * W) * alpha->e[J];
  if (!kAtRoot) beyond -= Dot(LoadTriple<W>(pivot + 3 * W), *a);
  Store<W>(view.row(K) + LaneRow::kGiven * W, beyond - used * alpha->e[K]);
  alpha->e[K] = beyond + kept * alpha->e[K];
}

template <int W, bool kAtRoot>
HAZUMI_LANE_INLINE void RespondStep(const StepView<W>& view, const double* scratch) {
  using V = typename LanesOf<W>::Real;
  V parent[6] = {};
  if (!kAtRoot) FetchFields<W, 6>(scratch, view.step.parent, LaneState::kResponse, parent);
  Triple<V> alpha = {{parent[0], parent[1], parent[2]}}, a = {{parent[3], parent[4], parent[5]}};
  if (!kAtRoot) {
    if (view.step.shifted) a = a + Cross(alpha, view.origin());
    if (view.step.turned) {
      const Square<V> F = view.F();
      alpha = TransposeTimes(F, alpha);
      a = TransposeTimes(F, a);
    }
  }
  Respond<0, W, kAtRoot>(view, &alpha, &a);
  Respond<1, W, kAtRoot>(view, &alpha, &a);
  Respond<2, W, kAtRoot>(view, &alpha, &a);
  StoreTriple<W>(view.field(LaneState::kResponse), alpha);
  StoreTriple<W>(view.field(LaneState::kResponse + 3), a);
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
  if (AnySet<W>(small)) return false;
  for (int s = 0; s < steps; ++s) {
    const StepView<W> view(plan, s, scratch);
    view.step.at_root ? RespondStep<W, true>(view, scratch) : RespondStep<W, false>(view, scratch);
  }
  GetGiven<W>(plan, scratch, qdd);
  return true;
}
