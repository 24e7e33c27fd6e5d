#pragma once

// The passive step with friction and limits [Arai 2.4, steps (1)-(11)].

#include <optional>
#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// The free joints' side of one step: k values each.
struct PaperStepInput {
  const MatX* M = nullptr;  // inertia matrix and bias of the free joints (RegionSystem)
  const VecX* b = nullptr;
  VecX friction;      // factor for this step, in [0, 1]
  VecX lower, upper;  // [rad]
  VecX torques = {};  // that act on the joints [N m]; empty: none
};

// Friction is a factor per 1/30 s: a step of h seconds multiplies by f^(30 h).
double FrictionOfStep(double factor, double step_seconds);

enum class PaperStepStatus { kOk, kSingular, kNotFinite };

class PaperStep {
 public:
  explicit PaperStep(int size);

  // Advances angles q [rad] and rates qd [rad/s] by `dt` seconds. On failure they are left alone
  // and `failed_joint` says which row.
  PaperStepStatus Advance(const PaperStepInput& input, double dt, VecX* q, VecX* qd);

  // After Advance: joints corrected to a limit in this step, and what it took.
  const std::vector<char>& corrected() const { return corrected_; }
  int solves() const { return solves_; }
  int failed_joint() const { return failed_joint_; }

 private:
  bool Solve(const PaperStepInput& input);
  void Integrate(const PaperStepInput& input, double dt, const VecX& q, const VecX& qd);
  bool CorrectNewlyOutside(const PaperStepInput& input, double dt, const VecX& q, const VecX& qd);
  bool IsFinite();

  VecX qdd_, tau_, rate_m_, angle_t_;  // the paper's Theta_c'', T, Theta_m', Theta_t
  MatX scratch_matrix_;
  VecX scratch_vector_;
  std::vector<char> corrected_;
  int solves_ = 0;
  int failed_joint_ = -1;
};

}  // namespace hazumi
