#pragma once

#include "engine/region/contact/cone_problem.h"

namespace hazumi {

// One search for the forces of a problem, which it refers to.
class ConeSolver {
 public:
  // What may be left of a solution, as a part of the largest force.
  static constexpr double kGoodEnough = 1e-6;

  explicit ConeSolver(const ConeProblem& problem);

  // True if forces() are a solution then: from everywhere, by rounds of Newton's steps and from
  // inside; from inside alone; from `start` by Newton's steps alone.
  bool Run();
  bool RunInside() { return !hopeless_ && FromInside(kGoodEnough) <= kGoodEnough && TakesEnergy(); }
  bool RunNear(const VecX& start);

  const VecX& forces() const { return l_; }
  // Multiplications so far, but for what grows with less than the square of the rows.
  double products() const { return products_; }

 private:
  void Approach(int sweeps);
  double Left(const MatX& A, const VecX& b) const;
  void StayInCones();
  bool TakesEnergy() const;
  void Sweep();
  bool Step();

  // Returns what is left.
  double FromInside(double enough);
  void StartInside();
  bool StepInside();
  void Finish(double enough, double* left);
  // Solves K x = right, in place.
  void Solve(MatX& K, VecX& right);

  const ConeProblem& given_;
  MatX A_;  // of the round
  VecX b_;
  const std::vector<ConeProblem::Block>& blocks_;
  VecX l_, step_, own_;
  bool hopeless_ = false;
  double products_ = 0.0;
  VecX z_;  // d, from inside
};

}  // namespace hazumi
