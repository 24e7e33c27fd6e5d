#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/bake/recorder.h"

namespace hazumi {

// How much finer than usual exact regions are solved, where their error estimates ask for it.
class Refinements {
 public:
  explicit Refinements(const Animation& animation)
      : animation_(animation), of_region_(animation.regions.size()) {}

  // A new stretch begins.
  void Reset() { of_region_.assign(animation_.regions.size(), Refinement()); }
  // The largest of some regions, which divides the tolerances of their steps.
  double SharpnessOf(const std::vector<int>& regions) const;

  // Notes the largest estimate [rad] of a region's error up to a whole frame.
  void Note(int region, int frame, double estimate);
  // Asks for finer steps in the regions that miss their tolerance first, of those that began in
  // the stretch. Returns the frame where they do: what was found before it stays. None: nothing
  // is to be done again.
  std::optional<int> SharpenFromFirstMiss(const std::vector<int>& regions);
  // The finer steps that were asked for last did not help: they are not asked for any more.
  bool has_given_up() const { return has_given_up_; }
  // Writes what is known of the errors when all is done, and warns.
  void Report(const std::vector<int>& regions, Recorder* recorder) const;

  // Solver version 1: after a stretch in which these regions began, asks for finer steps in all of
  // it. False if there is nothing to ask for.
  bool SharpenAll(const std::vector<int>& regions, Recorder* recorder);

 private:
  struct Refinement {
    double sharpness = 1.0;
    double last_estimate = std::numeric_limits<double>::infinity();  // with the one before [rad]
    std::vector<double> estimates;  // by frame since the region's first one [rad]
    // Of the solution before the present one: where it missed, and by how much; what it leaves.
    std::optional<int> missed_at;
    double missed_by = 0.0, sharpness_before = 1.0, kept_estimate = 0.0;
    bool is_settled = false;  // finer steps do not help
  };
  double SafeFor(int region) const;
  std::optional<int> FirstMiss(int region) const;
  double EstimateBefore(int region, int frame) const;

  const Animation& animation_;
  std::vector<Refinement> of_region_;
  bool has_given_up_ = false;
};

}  // namespace hazumi
