// The dynamics of whole figures on the human and on 200 random trees, in random states, in a random
// field of gravity, with random forces and moments on the end links.

#include "engine/dynamics/figure_dynamics.h"
#include "tests/support/compare.h"
#include "tests/support/sample.h"

namespace hazumi::test {
namespace {

VecX Torques(const Sample& s, const VecX& qdd) {
  const FigureDynamics dynamics(s.figure);
  FigureScratch scratch = dynamics.MakeScratch();
  VecX tau(s.figure.num_joints());
  dynamics.InverseDynamics(s.moving_root.X_WR(), s.RootLessGravity(), s.q, s.qd, qdd, &s.ends,
                           &scratch, &tau);
  return tau;
}

// Calls `check(sample)` for every sample; what it returns is a relative difference.
template <typename Check>
void ForAllSamples(const char* claim, Root root, double tolerance, const Check& check) {
  Worst worst(claim);
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    Sample sample(seed, root);
    EXPECT_LE(worst(check(sample)), tolerance) << "seed " << seed;
  }
}

TEST(FigureDynamics, InverseAgreesWithMujoco) {
  ForAllSamples("figure inverse", Root::kStill, 1e-11, [](Sample& s) {
    return RelativeDifference(Torques(s, s.qdd), s.mujoco.InverseDynamics(s.qdd, &s.ends));
  });
}

TEST(FigureDynamics, InverseAgreesWithMujocoOnATurningAndAcceleratingRoot) {
  ForAllSamples("figure inverse, moving root", Root::kMoving, 1e-11, [](Sample& s) {
    const VecX all = s.mujoco.InverseDynamics(s.Join(s.qdd), &s.ends);
    return RelativeDifference(Torques(s, s.qdd), s.JointRows(all));
  });
}

TEST(FigureDynamics, InverseAgreesWithTheRecursionInWorldAxes) {
  ForAllSamples("figure inverse, two routes", Root::kMoving, 1e-12, [](Sample& s) {
    DynamicsWorkspace ws = s.Placed();
    InverseDynamics(s.figure, s.RootLessGravity(), s.qd, s.qdd, &s.ends, &ws);
    return RelativeDifference(Torques(s, s.qdd), ws.tau);
  });
}

}  // namespace
}  // namespace hazumi::test
