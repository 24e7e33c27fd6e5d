#pragma once

// Gauss and Newton's method for a sum of squares, damped as Levenberg does.

#include <algorithm>
#include <optional>

#include "engine/solve/band_system.h"

namespace hazumi::solve {

struct SquaresLimits {
  int most_iterations = 12;
  double least_gain = 1e-4;   // of the cost; with less an iteration was the last one
  double longest_step = 0.5;  // of any unknown
};

struct SquaresReport {
  int iterations = 0;
  double cost_before = 0.0, cost_after = 0.0;
};

// `Problem` has
//   double Linearize(BandSystem*)   the cost now; adds residuals with their derivatives
//   double CostAfter(const VecX&)   the cost after a step from now
//   void Accept()                   takes the step that was tried last
template <typename Problem>
SquaresReport Minimize(const SquaresLimits& limits, Problem* problem, BandSystem* system) {
  constexpr int kMostTries = 8;
  SquaresReport report;
  double damping = 1e-6;
  VecX step;
  // Takes a step that makes the sum smaller, shorter and shorter ones if need be.
  const auto improve = [&](double cost) -> std::optional<double> {
    for (int attempt = 0; attempt < kMostTries; ++attempt) {
      if (system->Solve(damping, &step)) {
        const double longest = step.cwiseAbs().maxCoeff();
        if (longest > limits.longest_step) step *= limits.longest_step / longest;
        const double better = problem->CostAfter(step);
        if (better < cost) {
          problem->Accept();
          damping = std::max(damping / 10.0, 1e-9);
          return better;
        }
      }
      damping = std::max(damping * 20.0, 1e-6);
    }
    return std::nullopt;
  };
  for (int i = 0; i < limits.most_iterations; ++i) {
    system->Clear();
    const double cost = problem->Linearize(system);
    if (i == 0) report.cost_before = cost;
    report.cost_after = cost;
    ++report.iterations;
    const std::optional<double> better = improve(cost);
    if (!better) break;
    report.cost_after = *better;
    if (cost - *better < limits.least_gain * cost) break;
  }
  return report;
}

}  // namespace hazumi::solve
