#pragma once

#include <limits>
#include <vector>

#include "engine/bake/walk/active_regions.h"

namespace hazumi {

// Estimates of the error of each active region, from its solutions and control solutions.
// [METHOD 8.2]
class RegionEstimates {
 public:
  // `regions` must outlive this object.
  explicit RegionEstimates(const ActiveRegions* regions)
      : regions_(*regions), estimates_(regions->size()) {}

  // Islands begin anew at t [s].
  void BeginIslands(double t);
  // Adds what is found at t [s]: errors by place in ActiveRegions::indices [rad].
  void Add(double t, const std::vector<double>& errors);
  // The regions of these coordinates are in time-stepping mode from t on [s].
  void NoteTimeStepping(const std::vector<Coordinate>& hinges, double t);
  // Returns whether the region of a coordinate entered time-stepping mode before t [s].
  bool HasTimeStepped(Coordinate c, double t) const {
    return estimates_[regions_.PlaceOf(c)].time_stepping_from < t;
  }
  // The solution and the control solution of these coordinates are on different branches from t on
  // [s].
  void NoteBranches(const std::vector<Coordinate>& hinges, double t);

  // Estimate of the error of a region. A body that tumbles in the end, in time-stepping mode, is
  // estimated for as long as its estimate was within the tolerance.
  struct Estimate {
    double error = 0.0;                                      // the largest up to there [rad]
    double until = std::numeric_limits<double>::infinity();  // [s]
    // Time from which the events of the solution and the control solution differ [s].
    double branches_from = std::numeric_limits<double>::infinity();
  };
  Estimate Of(size_t place) const;
  // Returns the largest estimate so far, also while the figure tumbles [rad].
  double LargestOf(size_t place) const { return estimates_[place].error; }

 private:
  struct Record {
    double error = 0.0, within = 0.0;  // the largest, and of those before one beyond the tolerance
    double within_until = 0.0;         // [s]
    bool is_beyond = false;
    double time_stepping_from = std::numeric_limits<double>::infinity();  // [s]
    double branches_from = std::numeric_limits<double>::infinity();       // [s]
  };

  const ActiveRegions& regions_;
  std::vector<Record> estimates_;  // by place
};

}  // namespace hazumi
