// A number k of a law has one sign up to a kink and the other one from there on:
//   k(start) k(end) < 0,   k(t) = 0.
// What comes back to its first sign within one step is not seen.

#include "engine/region/exact/kink_search.h"

#include <algorithm>
#include <cmath>

#include "engine/base/root.h"

namespace hazumi {

double KinkSearch::KinkAt(int kink, double t) {
  dynamics_->FindKinks(step_->Glance(t), &inside_);
  return inside_[kink];
}

std::optional<double> KinkSearch::Find() {
  constexpr double kAtOne = 1e-9;  // what begins so near a kink has passed it, of its change
  dynamics_->FindKinks(step_->PlaceStart(), &start_);
  dynamics_->FindKinks(step_->PlaceEnd(), &end_);
  const double start = step_->start_time();
  std::optional<double> first;
  for (int i = 0; i < static_cast<int>(end_.size()); ++i) {
    if (start_[i] * end_[i] >= 0.0 || std::abs(start_[i]) < kAtOne * std::abs(end_[i])) continue;
    const double side = std::copysign(1.0, end_[i]);
    const auto passed = [&](double t) { return side * KinkAt(i, t); };
    const double last = first.value_or(step_->time()), f = first ? passed(last) : side * end_[i];
    if (f <= 0.0) continue;
    first = Narrow({start, side * start_[i], last, f}, kSameTime, passed).b;
  }
  return first && *first < step_->time() - kSameTime ? first : std::nullopt;
}

}  // namespace hazumi
