#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/exact_step.h"

namespace hazumi {

// Where in a step a contact closes, opens, begins to slide or comes to rest. [METHOD 12]
class ContactSearch {
 public:
  // Both must outlive it.
  ContactSearch(RegionDynamics* dynamics, ExactStep* step);

  // Ends the step at the first such time. False: there is none. `follows_event`: the step begins
  // with rates or forces that have jumped.
  bool Find(bool follows_event);
  // Returns whether the latest Find found a change, and whether that is the end of sliding.
  bool has_found() const { return has_found_; }
  bool found_stop() const { return found_stop_; }
  // After a Find that found nothing, or a cut of the step: updates the contacts to its end. Returns
  // whether a sliding direction has turned too far.
  bool FollowToEnd();
  // In time-stepping mode: ends the step, at whose end nodes are at `now`, where a new contact has
  // penetrated a little.
  bool FindBlow(const RegionState& now);

 private:
  std::optional<double> FirstChange(double before, double t, bool looks_at_forces);
  double Excess(double t);
  void See(double t);
  std::optional<double> Dip(int pair, double before, double t);
  double ChangeAround(int pair, double t);
  double Change(int pair, double t);

  RegionDynamics* dynamics_;
  ExactStep* step_;
  struct Changed {
    int pair;
    double time;  // at which it has [s]
  };
  struct Seen {
    double change = -1.0;
    double gap = 0.0, rate = 0.0;  // of an open pair, beyond the allowed gap [m], [m/s]
    bool is_open = false;          // and there is a gap
  };
  std::vector<Changed> changed_;
  std::vector<Seen> seen_, before_;  // by pair, at the latest look and the one before
  std::vector<int> deep_;            // pairs
  // Excess that the event before the step left, as a share of all pushes then [N].
  double allowed_ = 0.0, pushes_at_start_ = 0.0;
  double forces_before_ = 0.0;  // when they were looked at last [s]
  bool has_found_ = false, found_stop_ = false;
};

}  // namespace hazumi
