#pragma once

#include <vector>

#include "engine/analysis/motion_series.h"
#include "engine/analysis/parabola.h"

namespace hazumi {

struct Range {
  double low = 0.0, high = 0.0;
  bool Contains(double value) const { return low <= value && value <= high; }
};

// The gravity that flights imply, and how far it can be believed.
struct GravityEstimate {
  double gravity = 0.0;         // downward [m/s^2]
  double error = 0.0;           // standard error of this flight alone [m/s^2]
  std::vector<double> by_mass;  // what one standard error of each class of masses adds [m/s^2]

  // All of it, as a standard error: what belongs to the flight, to the masses and to every flight
  // of the clip alike.
  double StandardError() const;
  // In which the true one lies in 95 of 100 cases.
  Range Interval() const;
};

// Of the parabola through frames first..last.
GravityEstimate EstimateGravity(const MotionSeries& series, const Parabola& fit, int first,
                                int last);

// What errors of the masses leave between the CoM and its parabola over frames first..last, as a
// standard error: of the heights, and of the distances from uniform motion (rms) [m].
struct MassResiduals {
  double height = 0.0, horizontal = 0.0;
};
MassResiduals ResidualsByMass(const MotionSeries& series, int first, int last);

// The mean of several flights: masses err in all of them alike, the rest in each for itself.
GravityEstimate MeanGravity(const std::vector<GravityEstimate>& flights);

}  // namespace hazumi
