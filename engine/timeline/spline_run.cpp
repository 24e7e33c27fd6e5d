#include "engine/timeline/spline_run.h"

#include <cmath>

#include "engine/base/assert.h"

namespace hazumi {

namespace {

// Cost of an interval: d^T K d with d = d0 + D0 x0 + D1 x1.
struct IntervalCost {
  MatX K, D0, D1;
  VecX d0;
};

IntervalCost CostOf(double by, double T, int size) {
  IntervalCost cost;
  cost.d0 = VecX::Zero(size + 1);
  cost.d0[0] = by;
  cost.D0 = MatX::Zero(size + 1, size);
  cost.D1 = MatX::Zero(size + 1, size);
  cost.D1.bottomRows(size).setIdentity();
  cost.K.resize(size + 1, size + 1);
  if (size == 1) {
    cost.K << 12.0 / (T * T * T), -6.0 / (T * T), -6.0 / (T * T), 4.0 / T;
    cost.D0 << -T, -1.0;
    return cost;
  }
  const double T2 = T * T, T3 = T2 * T;
  cost.K << 720.0 / (T3 * T2), -360.0 / (T2 * T2), 60.0 / T3,  //
      -360.0 / (T2 * T2), 192.0 / T3, -36.0 / T2,              //
      60.0 / T3, -36.0 / T2, 9.0 / T;
  cost.D0 << -T, -0.5 * T2, -1.0, -T, 0.0, -1.0;
  return cost;
}

// Least of x^T A x + 2 b^T x for a matrix of one or two rows; where it is not unique, the shortest.
VecX LeastOf(const MatX& A, const VecX& b) {
  if (A.rows() == 1) return A(0, 0) > 0.0 ? VecX(-b / A(0, 0)) : VecX::Zero(1);
  const double trace = A.trace(), determinant = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  // Rates and accelerations differ in unit: the rank shows in scaled entries.
  if (!(A(0, 0) > 0.0) || !(A(1, 1) > 0.0)) return trace > 0.0 ? VecX(-b / trace) : VecX::Zero(2);
  if (!(determinant > 1e-9 * A(0, 0) * A(1, 1)))
    return (VecX(2) << -b[0] / A(0, 0), 0.0).finished();
  return (VecX(2) << -(A(1, 1) * b[0] - A(0, 1) * b[1]) / determinant,
          -(A(0, 0) * b[1] - A(1, 0) * b[0]) / determinant)
      .finished();
}

}  // namespace

SplineRun::SplineRun(const Keys& keys, size_t first, size_t last, Interpolation kind,
                     FrameRate rate, std::optional<double> end_rate)
    : first_(first), last_(last), size_(kind == Interpolation::kLeastJerk ? 2 : 1) {
  HAZUMI_DEMAND(first < last && last < keys.size());
  tails_.resize(last - first);
  MatX P = MatX::Zero(size_, size_);
  VecX p = VecX::Zero(size_);
  for (size_t i = last; i-- > first;) {
    const double T = rate.SecondsAt(keys[i + 1].frame - keys[i].frame);
    const IntervalCost cost = CostOf(keys[i + 1].value - keys[i].value, T, size_);
    // The best next state is linear in this one: its columns are those of the unit states.
    const MatX A = cost.D1.transpose() * cost.K * cost.D1 + P;
    const MatX B = cost.D1.transpose() * cost.K * cost.D0;
    const VecX b = cost.D1.transpose() * cost.K * cost.d0 + p;
    Tail& tail = tails_[i - first];
    tail.F = MatX::Zero(size_, size_);
    tail.f = VecX::Zero(size_);
    if (i + 1 == last && end_rate) {
      tail.f[0] = *end_rate;
      if (size_ == 2) {
        tail.f[1] = -(A(1, 0) * *end_rate + b[1]) / A(1, 1);
        tail.F.row(1) = -B.row(1) / A(1, 1);
      }
    } else {
      for (int k = 0; k < size_; ++k) tail.F.col(k) = LeastOf(A, B.col(k));
      tail.f = LeastOf(A, b);
    }
    const MatX E = cost.D0 + cost.D1 * tail.F;
    const VecX e = cost.d0 + cost.D1 * tail.f;
    const MatX next = E.transpose() * cost.K * E + tail.F.transpose() * P * tail.F;
    tail.p = E.transpose() * cost.K * e + tail.F.transpose() * (P * tail.f + p);
    tail.P = 0.5 * (next + next.transpose());
    P = tail.P;
    p = tail.p;
  }
}

VecX SplineRun::ToVector(const State& state) const {
  if (size_ == 1) return VecX::Constant(1, state.rate);
  return (VecX(2) << state.rate, state.acceleration).finished();
}

SplineRun::State SplineRun::FromVector(const VecX& x) const {
  return {x[0], size_ == 2 ? x[1] : 0.0};
}

SplineRun::State SplineRun::Begin(size_t i, std::optional<double> rate) const {
  const Tail& tail = tails_[i - first_];
  if (!rate) return FromVector(LeastOf(tail.P, tail.p));
  if (size_ == 1) return {*rate, 0.0};
  const double stiffness = tail.P(1, 1);
  return {*rate, stiffness > 0.0 ? -(tail.P(1, 0) * *rate + tail.p[1]) / stiffness : 0.0};
}

SplineRun::State SplineRun::Next(size_t i, const State& at) const {
  const Tail& tail = tails_[i - first_];
  return FromVector(tail.F * ToVector(at) + tail.f);
}

}  // namespace hazumi
