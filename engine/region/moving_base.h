#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "engine/region/node_motion.h"

namespace hazumi {

// How the node that carries an island of free joints moves: all that the island feels of the rest
// of the figure [METHOD 6.3]. The chain that moves it is evaluated at a few Chebyshev points of a
// stretch of time and fitted, as long as what is left out is rounding; after that it costs a
// polynomial. Never changes once made: islands that hang on one node share it, in any thread.
class MovingBase {
 public:
  // The carrier's motion at a time, computed by its chain.
  struct Frame {
    small::M3 R;
    small::V3 w, alpha, a;  // `a` is that of its origin, minus gravity
  };

  // Fits the motion, smooth from `start` to `smooth_until` [s], up to `end`, and up to
  // DrivenMotion::kLongestCut beyond for steps that may be cut. No fit depends on `end`. `chain`:
  // Frame(double t).
  template <typename Chain>
  MovingBase(double start, double end, double smooth_until, Chain&& chain) {
    double length = kLongest;
    covered_until_ = start;
    const double least = std::min(smooth_until, end + DrivenMotion::kLongestCut);
    for (double& from = covered_until_; from < least || fits_.empty();) {
      if (fits_.size() == kMostFits) return;
      // Equal fits to the end rather than a tiny last one.
      const double rest = std::max(0.0, smooth_until - from);
      if (std::isfinite(rest)) {
        length = rest / std::max(1.0, std::ceil(rest / length * (1.0 - 1e-9)));
      }
      from = Extend(from, chain, &length);
      if (smooth_until - from < kSameTime) break;
    }
    if (smooth_until - covered_until_ < kSameTime) {
      covered_until_ = std::numeric_limits<double>::infinity();
    }
  }

  // False late in a motion that is too wild or too long to be fitted to its end.
  bool Covers(double t) const { return t <= covered_until_; }
  Frame At(double t) const { return Evaluate(FitFor(t), t); }

 private:
  static constexpr int kPoints = 14;
  static constexpr int kValues = 14;          // quaternion, w, alpha, a, and one to fill up
  static constexpr double kLongest = 0.15;    // [s]
  static constexpr double kShortest = 1e-4;   // [s]
  static constexpr double kSameTime = 1e-12;  // [s]
  static constexpr size_t kMostFits = 4096;   // 6 MB; ten minutes of a person's motion
  using Samples = std::array<std::array<double, kValues>, kPoints>;
  struct Fit {
    double middle, half;
    std::array<std::array<double, kValues>, kPoints> c;  // by power of (t - middle) / half
  };

  // One fit of at most *length seconds, which becomes what the next may try; returns its end.
  template <typename Chain>
  double Extend(double from, Chain&& chain, double* length) {
    Fit fit;
    Samples samples;
    for (;;) {
      fit.middle = from + 0.5 * *length;
      fit.half = 0.5 * *length;
      for (int i = 0; i < kPoints; ++i) {
        Take(chain(fit.middle + fit.half * Point(i)), i, &samples);
      }
      const double left_out = SetFit(samples, &fit);
      const double tried = *length;
      const bool is_good = left_out <= 1.0 || tried < kShortest;
      *length = std::min(kLongest, tried * Growth(left_out, is_good));
      if (!is_good) continue;
      fits_.push_back(fit);
      return from + tried;
    }
  }

  static double Point(int i);
  static void Take(const Frame& frame, int i, Samples* samples);
  // Returns what the fit leaves out, in units of rounding.
  static double SetFit(const Samples& samples, Fit* fit);
  static double Growth(double left_out, bool is_good);
  const Fit& FitFor(double t) const;
  static Frame Evaluate(const Fit& fit, double t);

  double covered_until_;   // [s]
  std::vector<Fit> fits_;  // in order of time, without gaps
};

}  // namespace hazumi
