#pragma once

#include <limits>
#include <vector>

#include "engine/bake/recorder.h"

namespace hazumi {

// How much finer than usual exact regions are solved, where their error estimates ask for it.
class Refinements {
 public:
  explicit Refinements(size_t num_regions) : of_region_(num_regions) {}

  void Reset() { of_region_.assign(of_region_.size(), Refinement()); }
  // The largest of some regions, which divides the tolerances of their steps.
  double SharpnessOf(const std::vector<int>& regions) const;
  // After a stretch in which these regions began: asks for finer steps where the estimate says that
  // one may miss its tolerance, as long as that helps. False if there is nothing to ask for.
  bool Sharpen(const std::vector<int>& regions, Recorder* recorder);

 private:
  struct Refinement {
    double sharpness = 1.0;
    double last_estimate = std::numeric_limits<double>::infinity();  // with the one before [rad]
  };
  std::vector<Refinement> of_region_;
};

}  // namespace hazumi
