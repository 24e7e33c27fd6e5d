#include "tests/unit/region/arm_swing.h"

#include "engine/region/region_system.h"
#include "tests/support/figures.h"

namespace hazumi::test {

std::vector<JointIndex> AllJoints(const Figure& figure) {
  std::vector<JointIndex> all;
  for (int j = 0; j < figure.num_joints(); ++j) all.emplace_back(j);
  return all;
}

SwingEnd Swing::Run() const {
  const int n = figure.num_joints();
  DynamicsWorkspace ws(figure);
  RegionSystem system(figure, AllJoints(figure));
  PaperStep paper(n);
  PaperStepInput input{&system.M(), &system.b(), friction, lower, upper};
  for (double& f : input.friction) f = FrictionOfStep(f, step);
  PassiveState state{Pose(), RootMotion(), q, qd, VecX::Zero(n)};
  for (int k = 0; k < steps; ++k) {
    system.Evaluate(state, RootCoupling::kPrescribed, JointIndex(), gravity, &ws);
    const PaperStepStatus status = paper.Advance(input, step, &state.q, &state.qd);
    if (status != PaperStepStatus::kOk) return {status, state.q, state.qd, k};
  }
  return {PaperStepStatus::kOk, state.q, state.qd, steps};
}

SwingEnd RunArmCase(const ArmCase& c, int steps_per_frame) {
  const Figure arm = Arm7();
  return Swing{arm,
               c.start_deg / kRadian,
               c.start_rate,
               c.friction,
               c.lower_deg / kRadian,
               c.upper_deg / kRadian,
               kArmCaseGravity,
               1.0 / (30.0 * steps_per_frame),
               kArmCaseFrames * steps_per_frame}
      .Run();
}

}  // namespace hazumi::test
