#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "engine/base/assert.h"
#include "engine/region/exact/dop853_tableau.h"
#include "engine/region/exact/dopri5_tableau.h"

namespace hazumi {

// One step of Dormand and Prince's Runge-Kutta method of order 8(5,3) for y' = f(t, y), with dense
// output of order 7 [Hairer, Norsett, Wanner 1993, II.5, II.6]. The field is any callable
// (double t, const double* y, double* dy). A step allocates nothing. Steps that something else
// keeps short take half as many evaluations by their method of order 5(4), with dense output of
// order 4.
class Dop853 {
 public:
  void Resize(int size) {
    n_ = size;
    k_.resize(static_cast<size_t>(kStages) * size);
    dense_.resize(static_cast<size_t>(kDense) * size);
    stage_.resize(size);
    y0_.resize(size);
    y1_.resize(size);
  }

  // Begins at (t, y).
  template <typename Field>
  void Start(double t, const double* y, Field&& field) {
    t0_ = t;
    h_ = 0.0;
    std::copy_n(y, n_, y0_.data());
    std::copy_n(y, n_, y1_.data());
    field(t, y0_.data(), k(12));
  }

  // Computes the step of h seconds from the end of the last accepted one, without accepting it.
  // Returns its error in units of `scale` (by component): at most 1 is as good as asked.
  template <typename Field>
  double Try(double h, const double* scale, Field&& field) {
    using namespace dop853;
    trial_h_ = h;
    is_short_ = false;
    const double t = t0_ + h_;
    std::copy_n(k(12), n_, k(0));
    Stages(h, t, field, std::make_integer_sequence<int, 11>());
    Combine<12, kA>(y1_.data(), h);
    return Error(h, scale);
  }

  // The same by the method of order 5.
  template <typename Field>
  double TryShort(double h, const double* scale, Field&& field) {
    trial_h_ = h;
    is_short_ = true;
    std::copy_n(k(12), n_, k(0));
    ShortStages(h, t0_ + h_, field, std::make_integer_sequence<int, 6>());
    return std::abs(h) * Worst(dopri5::kE4, scale);
  }

  // Adds the estimated error of the step tried last to its result, `times` times.
  void AddError(double times) {
    HAZUMI_ASSERT(!is_short_);
    for (int i = 0; i < n_; ++i) {
      stage_[i] += times * error_share_ * trial_h_ * Sum(dop853::kE5, i);
    }
  }

  // Accepts the step tried last: the solution at its end is y().
  template <typename Field>
  void Accept(Field&& field) {
    t0_ += h_;
    h_ = trial_h_;
    y0_.swap(y1_);
    y1_.swap(stage_);
    if (is_short_) {
      std::copy_n(k(6), n_, k(12));
    } else {
      field(t0_ + h_, y1_.data(), k(12));
    }
    has_dense_ = false;
  }

  double start_time() const { return t0_; }
  double end_time() const { return t0_ + h_; }
  const double* y() const { return y1_.data(); }
  const double* start_y() const { return y0_.data(); }
  // f at the end of the step.
  const double* end_derivative() const { return k_.data() + static_cast<size_t>(12) * n_; }
  const double* start_derivative() const { return k_.data(); }

  // Three more evaluations for the inside of the accepted step, unless it was short.
  template <typename Field>
  void MakeDense(Field&& field) {
    using namespace dop853;
    if (has_dense_) return;
    has_dense_ = true;
    if (!is_short_) DenseStages(field, std::make_integer_sequence<int, 3>());
    for (int i = 0; i < n_; ++i) {
      const double change = y1_[i] - y0_[i];
      const double bend = h_ * k(0)[i] - change;
      dense(0)[i] = y0_[i];
      dense(1)[i] = change;
      dense(2)[i] = bend;
      dense(3)[i] = change - h_ * k(12)[i] - bend;
    }
    for (int d = 0; d < 4; ++d) {
      std::fill_n(dense(4 + d), n_, 0.0);
      for (int s = 0; s < 16 && !is_short_; ++s) Add(h_ * kD[d][s], k(s), dense(4 + d));
    }
    for (int s = 0; s < 7 && is_short_; ++s) Add(h_ * dopri5::kD[s], k(s), dense(4));
  }

  // The solution inside the accepted step; needs MakeDense.
  void At(double t, double* y) const {
    const double s = h_ > 0.0 ? (t - t0_) / h_ : 0.0, s1 = 1.0 - s;
    const double* d = dense_.data();
    for (int i = 0; i < n_; ++i, ++d) {
      double sum = d[7 * n_];
      sum = d[6 * n_] + s * sum;
      sum = d[5 * n_] + s1 * sum;
      sum = d[4 * n_] + s * sum;
      sum = d[3 * n_] + s1 * sum;
      sum = d[2 * n_] + s * sum;
      sum = d[n_] + s1 * sum;
      y[i] = d[0] + s * sum;
    }
  }

  // Derivative of At with respect to time, times the length of the step.
  void ChangeAt(double t, double* change) const {
    const double s = h_ > 0.0 ? (t - t0_) / h_ : 0.0, s1 = 1.0 - s;
    const double* d = dense_.data();
    for (int i = 0; i < n_; ++i, ++d) {
      double sum = d[7 * n_], slope = 0.0;
      for (int row = 6; row >= 0; --row) {
        const bool is_even = row % 2 == 0;
        const double by = is_even ? s : s1;
        slope = (is_even ? sum : -sum) + by * slope;
        sum = d[row * n_] + by * sum;
      }
      change[i] = slope;
    }
  }

  // The component with the largest error in the step tried last.
  int worst_component() const { return worst_; }

 private:
  static constexpr int kStages = 16, kDense = 8;

  double* k(int stage) { return k_.data() + static_cast<size_t>(stage) * n_; }
  double* dense(int row) { return dense_.data() + static_cast<size_t>(row) * n_; }

  void Add(double factor, const double* x, double* sum) const {
    if (factor == 0.0) return;
    for (int i = 0; i < n_; ++i) sum[i] += factor * x[i];
  }

  // stage_ := y + h sum of A[kRow] k
  template <int kRow, const auto& kA>
  void Combine(const double* y, double h) {
    constexpr int kColumns = std::min<int>(kRow, std::size(kA[kRow]));
    Combine<kRow, kA>(y, h, std::make_integer_sequence<int, kColumns>());
  }
  template <int kRow, const auto& kA, int... kColumns>
  void Combine(const double* y, double h, std::integer_sequence<int, kColumns...>) {
    const double* const base = k_.data();
    double* const out = stage_.data();
    const int n = n_;
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      ((kA[kRow][kColumns] != 0.0 ? void(sum += kA[kRow][kColumns] * base[kColumns * n + i])
                                  : void()),
       ...);
      out[i] = y[i] + h * sum;
    }
  }

  template <typename Field, int... kStage>
  void Stages(double h, double t, Field& field, std::integer_sequence<int, kStage...>) {
    ((Combine<kStage + 1, dop853::kA>(y1_.data(), h),
      field(t + dop853::kC[kStage + 1] * h, stage_.data(), k(kStage + 1))),
     ...);
  }
  template <typename Field, int... kStage>
  void ShortStages(double h, double t, Field& field, std::integer_sequence<int, kStage...>) {
    ((Combine<kStage + 1, dopri5::kA>(y1_.data(), h),
      field(t + dopri5::kC[kStage + 1] * h, stage_.data(), k(kStage + 1))),
     ...);
  }
  template <typename Field, int... kStage>
  void DenseStages(Field& field, std::integer_sequence<int, kStage...>) {
    ((Combine<kStage + 13, dop853::kA>(y0_.data(), h_),
      field(t0_ + dop853::kC[kStage + 13] * h_, stage_.data(), k(kStage + 13))),
     ...);
  }

  template <size_t kCount>
  double Sum(const double (&formula)[kCount], int component) {
    double sum = 0.0;
    for (size_t s = 0; s < kCount; ++s) sum += formula[s] * k(static_cast<int>(s))[component];
    return sum;
  }

  // The largest of the errors that a formula tells, in units of `scale`.
  template <size_t kCount>
  double Worst(const double (&formula)[kCount], const double* scale) {
    double worst = 0.0;
    worst_ = 0;
    for (int i = 0; i < n_; ++i) {
      const double e = Sum(formula, i);
      if (!(std::abs(e) / scale[i] <= worst)) worst_ = i;  // a NaN is the worst
      if (!std::isfinite(e)) return std::abs(e);
      worst = std::max(worst, std::abs(e) / scale[i]);
    }
    return worst;
  }

  double Error(double h, const double* scale) {
    const double third = Worst(dop853::kE3, scale), fifth = Worst(dop853::kE5, scale);
    const double squares = fifth * fifth + 0.01 * third * third;
    if (!std::isfinite(squares)) return HUGE_VAL;
    error_share_ = 0.0;
    if (fifth < 1e-100) return 0.0;  // its square may be zero
    error_share_ = fifth / std::sqrt(squares);
    return std::abs(h) * fifth * fifth / std::sqrt(squares);
  }

  int n_ = 0, worst_ = 0;
  double t0_ = 0.0, h_ = 0.0, trial_h_ = 0.0;
  double error_share_ = 0.0;  // the error is that part of what the fifth order's formula tells
  bool is_short_ = false, has_dense_ = false;
  std::vector<double> k_, dense_, stage_, y0_, y1_;
};

}  // namespace hazumi
