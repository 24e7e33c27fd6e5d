#pragma once

// Curves through a run of keys with the least integral of the squared acceleration or jerk.
//
// State of the curve at a key: x = (rate), for jerk (rate, acceleration). An interval of T seconds
// between the values v0 and v1 costs at least
//
//   d^T K d,  d = (v1, x1) - Phi (v0, x0),
//
// Phi: motion of the state without acceleration, without jerk; K^-1: its Gramian. The tail of a run
// from a key on costs at least V(x) = x^T P x + 2 p^T x + c. Backward over the keys of the run
// (dynamic programming) that gives the best next state, x1 = F x0 + f. The tail does not depend on
// what lies before its first key, so that a curve can go on from any key.

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/spatial/types.h"
#include "engine/timeline/frame_time.h"
#include "engine/timeline/keyframe.h"

namespace hazumi {

class SplineRun {
 public:
  // Rate, and for least jerk the acceleration (per second).
  struct State {
    double rate = 0.0, acceleration = 0.0;
  };

  // Run of keys[first] to keys[last], first < last, all but the last of the interpolation `kind`.
  // `end_rate`: the rate at its end; none: free.
  SplineRun(const Keys& keys, size_t first, size_t last, Interpolation kind, FrameRate rate,
            std::optional<double> end_rate);

  size_t first() const { return first_; }
  size_t last() const { return last_; }
  // Best state at key `i`, first <= i < last, where the tail begins: with this rate, or none given.
  State Begin(size_t i, std::optional<double> rate) const;
  // Best state at key i + 1.
  State Next(size_t i, const State& at) const;

 private:
  struct Tail {
    MatX P, F;  // of the tail from a key on; to the next key
    VecX p, f;
  };
  VecX ToVector(const State& state) const;
  State FromVector(const VecX& x) const;

  size_t first_, last_;
  int size_;                 // of the state: 1 or 2
  std::vector<Tail> tails_;  // from each key on, but the last
};

}  // namespace hazumi
