#include "engine/region/paper_step.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/mixed_dynamics.h"

namespace hazumi {

double FrictionOfStep(double factor, double step_seconds) {
  return std::pow(factor, 30.0 * step_seconds);
}

PaperStep::PaperStep(int size)
    : qdd_(size),
      tau_(size),
      rate_m_(size),
      angle_t_(size),
      scratch_matrix_(size, size),
      scratch_vector_(size),
      corrected_(size, 0) {}

PaperStepStatus PaperStep::Advance(const PaperStepInput& input, double dt, VecX* q, VecX* qd) {
  std::fill(corrected_.begin(), corrected_.end(), 0);
  solves_ = 0;
  do {
    if (!Solve(input)) return PaperStepStatus::kSingular;
    Integrate(input, dt, *q, *qd);
    if (!IsFinite()) return PaperStepStatus::kNotFinite;
  } while (CorrectNewlyOutside(input, dt, *q, *qd));  // every pass adds at least one joint
  *q = angle_t_;
  *qd = rate_m_;
  return PaperStepStatus::kOk;
}

// Steps (2), (5) and (11): the torques given, and those that hold the corrected joints.
bool PaperStep::Solve(const PaperStepInput& input) {
  ++solves_;
  if (input.torques.size() == 0) {
    tau_.setZero();
  } else {
    tau_ = input.torques;
  }
  failed_joint_ =
      SolveMixed(*input.M, *input.b, corrected_, scratch_matrix_, scratch_vector_, qdd_, tau_);
  return failed_joint_ < 0;
}

// Steps (6)-(8). A corrected joint gets no friction factor and lands on its limit.
void PaperStep::Integrate(const PaperStepInput& input, double dt, const VecX& q, const VecX& qd) {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    rate_m_[i] = qd[i] + qdd_[i] * dt;  // (5)
    if (corrected_[i]) continue;
    rate_m_[i] *= input.friction[i];
    angle_t_[i] = q[i] + rate_m_[i] * dt;  // (6)
  }
}

// Steps (9), (10): whatever is outside now is set to the nearer limit for good.
bool PaperStep::CorrectNewlyOutside(const PaperStepInput& input, double dt, const VecX& q,
                                    const VecX& qd) {
  bool any = false;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const double inside = std::clamp(angle_t_[i], input.lower[i], input.upper[i]);
    if (corrected_[i] || inside == angle_t_[i]) continue;
    angle_t_[i] = inside;
    qdd_[i] = ((angle_t_[i] - q[i]) / dt - qd[i]) / dt;  // (7)
    corrected_[i] = 1;
    any = true;
  }
  return any;
}

bool PaperStep::IsFinite() {
  for (Eigen::Index i = 0; i < rate_m_.size(); ++i) {
    // Beyond this the angle itself is lost to rounding; an explosion ends here, not in NaN.
    if (std::abs(rate_m_[i]) < 1e9) continue;
    failed_joint_ = static_cast<int>(i);
    return false;
  }
  return true;
}

}  // namespace hazumi
