#pragma once

#include <cstddef>
#include <vector>

#include "engine/timeline/solver_rules.h"

namespace hazumi {

// How near a limit counts as at it, and how slow as at rest there, for each hinge: the more, the
// more often the hinge has come to its limits of late, so that hinges that throw each other off
// their limits come to rest. [METHOD 3.5]
class StickyLimits {
 public:
  StickyLimits(const SolverRules& rules, int num_hinges);

  // Nothing has happened yet.
  void Begin();
  // An event at t [s], and a hinge that it finds at a limit that did not hold it.
  void CountEvent(double t);
  void CountArrival(int hinge, double t);
  void ForgetEvents() { events_.clear(); }
  // Number of events in 1/30 s before t.
  int RecentEvents(double t) const;

  double distance(int hinge) const { return distance_[static_cast<std::size_t>(hinge)]; }  // [rad]
  double rest_rate(int hinge) const { return kRatePerDistance * distance(hinge); }  // [rad/s]
  // Rate at rest at a limit that is not sticky [rad/s].
  static double least_rest_rate();

 private:
  static constexpr double kRatePerDistance = 30.0;  // [1/s]

  bool counts_by_hinge_;
  std::vector<double> events_;                 // the latest ones [s]
  std::vector<std::vector<double>> arrivals_;  // by hinge, likewise
  std::vector<double> distance_;               // by hinge
};

}  // namespace hazumi
