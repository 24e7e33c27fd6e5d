#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/exact_step.h"

namespace hazumi {

// Where in a step a hinge reaches a limit, or a ball joint a pole. [METHOD 3.4]
class HitSearch {
 public:
  // All must outlive it.
  HitSearch(const RegionDynamics* dynamics, const LimitRange* limits, ExactStep* step);

  enum class Found { kNothing, kHit, kPole };
  // The first time in the step at which a hinge goes out or a ball joint passes a pole: ends the
  // step there, or just beyond the pole. `held`: hinges that cannot go out. `follows_event`: the
  // step begins with rates or forces that have jumped.
  Found Find(const std::vector<char>& held, bool follows_event);

 private:
  // A hinge goes out.
  struct Crossing {
    double time;
    int hinge;
  };
  // Where a ball joint is nearest to a pole.
  struct Pole {
    double time;
    int node;
  };

  bool FindSuspects(const std::vector<char>& held);
  void Look(double t, HingeState* state);
  std::optional<Crossing> FirstCrossing(const std::vector<char>& held, double before, double t);
  void EndStepAt(double t);
  std::optional<Pole> FindPole(double before, double t);
  bool Leaves(const Pole& pole);
  std::optional<Pole> PoleAt(const Crossing& hit) const;
  bool IsByPole(int hinge, double distance) const;
  double PoleRate(const Pole& pole) const;
  const SolverRules& rules() const { return dynamics_->mode().contacts.rules(); }
  int FirstHinge(int node) const { return dynamics_->layout().node(node).first_hinge; }
  std::optional<double> FindCrossing(int hinge, int side, double before, double t);
  double RateAt(double t, int hinge, int side);
  struct Limit {
    int hinge, side;
    double at;  // [rad]
    double Beyond(double q) const { return side * (q - at); }
  };
  std::optional<double> CrossingTime(const Limit& limit, double inside, double outside);

  const RegionDynamics* dynamics_;
  const LimitRange* limits_;
  ExactStep* step_;
  std::vector<int> suspects_;  // nodes
  HingeState look_, before_, sample_;
};

}  // namespace hazumi
