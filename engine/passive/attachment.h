#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "engine/passive/node_motion.h"

namespace hazumi {

// How the node that carries a group of free joints moves: all that the group feels of the rest of
// the figure [METHOD 4]. The chain that moves it is evaluated at a few Chebyshev points of a
// stretch of time and fitted, as long as what is left out is rounding; after that it costs a
// polynomial.
class Attachment {
 public:
  // The carrier's motion at a time, computed by its chain.
  struct Frame {
    small::M3 R;
    small::V3 w, alpha, a;  // `a` is that of its origin, minus gravity
  };

  // Forgets everything; the motion is smooth from `start` to `end` [s].
  void Begin(double start, double end) {
    fits_.clear();
    end_ = end;
    next_start_ = start;
    next_length_ = kLongest;
    last_ = 0;
  }

  // `chain`: Frame(double t).
  template <typename Chain>
  Frame At(double t, Chain&& chain) {
    while (t > next_start_ || fits_.empty()) {
      if (next_start_ >= end_) break;
      Extend(chain);
    }
    return Evaluate(FitFor(t), t);
  }

 private:
  static constexpr int kPoints = 14;
  static constexpr int kValues = 14;         // quaternion, w, alpha, a, and one to fill up
  static constexpr double kLongest = 0.15;   // [s]
  static constexpr double kShortest = 1e-4;  // [s]
  using Samples = std::array<std::array<double, kValues>, kPoints>;
  struct Fit {
    double middle, half;
    std::array<std::array<double, kValues>, kPoints> c;  // by power of (t - middle) / half
  };

  template <typename Chain>
  void Extend(Chain&& chain) {
    double length = std::min(next_length_, end_ - next_start_);
    Fit fit;
    Samples samples;
    for (;; length *= 0.5) {
      fit.middle = next_start_ + 0.5 * length;
      fit.half = 0.5 * length;
      for (int i = 0; i < kPoints; ++i) {
        Take(chain(fit.middle + fit.half * Point(i)), i, &samples);
      }
      if (SetFit(samples, &fit) || length < kShortest) break;
    }
    next_length_ = std::min(kLongest, 2.0 * length);
    next_start_ += length;
    if (end_ - next_start_ < 1e-12) next_start_ = end_;
    fits_.push_back(fit);
  }

  static double Point(int i);
  static void Take(const Frame& frame, int i, Samples* samples);
  // False if the fit leaves out more than rounding.
  static bool SetFit(const Samples& samples, Fit* fit);
  const Fit& FitFor(double t);
  static Frame Evaluate(const Fit& fit, double t);

  std::vector<Fit> fits_;  // in order of time, without gaps
  size_t last_ = 0;
  double end_ = 0.0, next_start_ = 0.0, next_length_ = kLongest;
};

}  // namespace hazumi
