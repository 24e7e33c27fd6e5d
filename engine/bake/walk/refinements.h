#pragma once

#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "engine/bake/recorder.h"

namespace hazumi {

// How much finer than usual exact regions are solved, where their error estimates ask for it.
class Refinements {
 public:
  explicit Refinements(const Animation& animation)
      : animation_(animation), of_region_(animation.regions.size()) {}

  // Begins a new stretch.
  void Reset();
  // The largest of some regions, which divides the tolerances of their steps.
  double SharpnessOf(const std::vector<int>& regions) const;

  // Notes the largest estimate [rad] of a region's error up to a whole frame, solved along with
  // `regions`.
  void Note(int region, int frame, double estimate, const std::vector<int>& regions);
  // Notes all angles at a whole frame, by Coordinate. A frame before the latest miss keeps those of
  // an earlier solution, which are returned. Null for other frames.
  const VecX* KeepAngles(int frame, VecX angles);
  // Notes how far the finer solution is from the angles that a frame keeps [rad].
  void NoteKept(int region, double distance);
  // Requests finer steps in the regions that miss their tolerance first, among those that began in
  // the stretch. Returns the frame of that miss; earlier frames keep their values. Returns nullopt
  // if no region has to be solved again.
  std::optional<int> SharpenFromFirstMiss(const std::vector<int>& regions);
  // Returns whether the finer steps requested last do not help, so that GiveUp has to follow.
  bool is_no_help() const { return is_no_help_; }
  // Returns to the solution before the last request. Regions that it did not help request still
  // finer steps once; where the solution failed otherwise they request no more.
  void GiveUp();
  // Records the known errors after the last solution, and warns.
  void Report(const std::vector<int>& regions, Recorder* recorder) const;

  // Requests finer steps in the whole stretch, in which these regions began (solver version 1).
  // Returns false if no region needs them.
  bool SharpenAll(const std::vector<int>& regions, Recorder* recorder);

 private:
  struct Refinement {
    double sharpness = 1.0;
    double last_estimate = std::numeric_limits<double>::infinity();  // with the one before [rad]
    std::vector<double> estimates;    // one per frame of the region [rad]
    std::vector<double> solved_with;  // the sharpness that it was solved with, likewise
    // Previous solution: frame of its first miss, the estimate there, and the largest estimate of
    // the frames that it keeps.
    std::optional<int> missed_at;
    double missed_by = 0.0, kept_estimate = 0.0;
    double kept_distance = 0.0;  // largest distance of frames that it keeps from finer solutions
    int tries = 0;               // number of finer solutions that did not help at missed_at
    bool is_no_help = false;     // the present one does not
    bool is_settled = false;     // no finer steps are requested
    bool has_failed = false;     // because a finer solution failed
  };
  size_t IndexOf(int region, int frame) const;  // of estimates
  double SafeFor(int region) const;
  std::optional<int> FirstMiss(int region) const;
  double FinerAt(int region, int frame) const;
  double EstimateBefore(int region, int frame) const;

  const Animation& animation_;
  std::vector<Refinement> of_region_, before_;  // now, and before the last request
  // Angles of the latest whole frames, by frame: now, and before the last request.
  std::map<int, VecX> angles_, angles_before_;
  std::optional<int> first_miss_;  // frame of the miss that the last request was for
  bool is_no_help_ = false;
};

}  // namespace hazumi
