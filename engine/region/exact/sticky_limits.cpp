// Distance d that counts as at a limit, and rate r as at rest there, for a hinge that has come to
// its limits k times within 1/30 s, among n events of all hinges:
//   d = 1e-10 rad * 2^max(0, min(k - 4, n - 24, 20)),   r = 30/s * d.
// Version 1 of the solver takes n - 24 in place of k - 4. [METHOD 3.5]

#include "engine/region/exact/sticky_limits.h"

#include <algorithm>
#include <cmath>

#include "engine/region/exact/limit_range.h"

namespace hazumi {

namespace {

constexpr double kWindow = 1.0 / 30.0;  // [s]
constexpr int kMostDoublings = 20;
constexpr int kMostArrivals = 4, kMostEvents = 24;  // before limits become sticky

// Number of arrivals beyond which a limit becomes no stickier.
constexpr std::size_t kMostTimes = kMostArrivals + kMostDoublings;

void ForgetBefore(double t, std::vector<double>* times) {
  times->erase(times->begin(),
               std::find_if(times->begin(), times->end(), [t](double time) { return time >= t; }));
}

double Sticky(int excess) { return kTouch * std::exp2(std::clamp(excess, 0, kMostDoublings)); }

}  // namespace

StickyLimits::StickyLimits(const SolverRules& rules, int num_hinges)
    : counts_by_hinge_(rules.sticks_by_hinge),
      arrivals_(static_cast<size_t>(num_hinges)),
      distance_(static_cast<size_t>(num_hinges), kTouch) {
  events_.reserve(256);
  for (std::vector<double>& times : arrivals_) times.reserve(kMostTimes);
}

void StickyLimits::Begin() {
  events_.clear();
  for (std::vector<double>& times : arrivals_) times.clear();
  std::fill(distance_.begin(), distance_.end(), kTouch);
}

void StickyLimits::CountEvent(double t) {
  ForgetBefore(t - kWindow, &events_);
  events_.push_back(t);
  const int excess = static_cast<int>(events_.size()) - kMostEvents;
  for (size_t i = 0; i < distance_.size(); ++i) {
    ForgetBefore(t - kWindow, &arrivals_[i]);
    const int of_hinge = static_cast<int>(arrivals_[i].size()) - kMostArrivals;
    distance_[i] = Sticky(counts_by_hinge_ ? std::min(excess, of_hinge) : excess);
  }
}

void StickyLimits::CountArrival(int hinge, double t) {
  std::vector<double>& times = arrivals_[static_cast<std::size_t>(hinge)];
  if (times.size() == kMostTimes) times.erase(times.begin());
  times.push_back(t);
}

int StickyLimits::RecentEvents(double t) const {
  return static_cast<int>(std::count_if(events_.begin(), events_.end(),
                                        [t](double time) { return time >= t - kWindow; }));
}

double StickyLimits::least_rest_rate() { return kRatePerDistance * kTouch; }

}  // namespace hazumi
