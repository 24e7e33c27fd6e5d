// Every claim on the human and on 200 random trees, in random states, in a random field of gravity,
// with random forces and moments on the end links.

#include "engine/dynamics/inverse_dynamics.h"
#include "tests/support/compare.h"
#include "tests/support/dense_dynamics.h"
#include "tests/support/free_figure.h"
#include "tests/support/sample.h"

namespace hazumi::test {
namespace {

constexpr double kTolerance = 1e-9;

VecX Torques(const Sample& sample, const VecX& qdd, const EndForces* ends) {
  DynamicsWorkspace ws = sample.Placed();
  InverseDynamics(sample.figure, sample.RootLessGravity(), sample.qd, qdd, ends, &ws);
  return ws.tau;
}

VecX Accelerations(const Sample& sample) {
  DynamicsWorkspace ws = sample.Placed();
  VecX qdd(sample.figure.num_joints());
  const auto singular = ForwardDynamics(sample.figure, sample.RootLessGravity(), sample.qd,
                                        sample.tau, &sample.ends, &ws, &qdd);
  EXPECT_FALSE(singular.has_value()) << "seed " << sample.seed;
  return qdd;
}

// Calls `check(sample)` for every sample; what it returns is a relative difference.
template <typename Check>
void ForAllSamples(const char* claim, Root root, const Check& check) {
  Worst worst(claim);
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    Sample sample(seed, root);
    EXPECT_LE(worst(check(sample)), kTolerance) << "seed " << seed;
  }
}

TEST(InverseDynamics, AgreesWithMujoco) {
  ForAllSamples("inverse dynamics", Root::kStill, [](Sample& s) {
    return RelativeDifference(Torques(s, s.qdd, &s.ends), s.mujoco.InverseDynamics(s.qdd, &s.ends));
  });
}

TEST(InverseDynamics, AgreesWithMujocoOnATurningAndAcceleratingRoot) {
  ForAllSamples("inverse dynamics, moving root", Root::kMoving, [](Sample& s) {
    const VecX all = s.mujoco.InverseDynamics(s.Join(s.qdd), &s.ends);
    return RelativeDifference(Torques(s, s.qdd, &s.ends), s.JointRows(all));
  });
}

TEST(InverseDynamics, GivesMujocosForceOnTheRoot) {
  ForAllSamples("force on the root", Root::kMoving, [](Sample& s) {
    DynamicsWorkspace ws = s.Placed();
    InverseDynamics(s.figure, s.RootLessGravity(), s.qd, s.qdd, &s.ends, &ws);
    const VecX all = s.mujoco.InverseDynamics(s.Join(s.qdd), &s.ends);
    return RelativeDifference(ws.bodies[0].f, all.head<3>());
  });
}

TEST(BiasVector, AgreesWithMujoco) {
  ForAllSamples("bias", Root::kStill, [](Sample& s) {
    const VecX zero = VecX::Zero(s.figure.num_joints());
    return RelativeDifference(Torques(s, zero, nullptr), s.mujoco.Bias());
  });
}

TEST(InertiaMatrix, AgreesWithMujoco) {
  ForAllSamples("H by unit accelerations", Root::kStill, [](Sample& s) {
    DynamicsWorkspace ws = s.Placed();
    MatX H;
    InertiaMatrix(s.figure, &ws, &H);
    return RelativeDifference(H, s.mujoco.InertiaMatrix());
  });
}

TEST(ForwardDynamics, DenseAgreesWithMujoco) {
  ForAllSamples("dense forward dynamics", Root::kStill, [](Sample& s) {
    return RelativeDifference(Accelerations(s), s.mujoco.ForwardDynamics(s.tau, &s.ends));
  });
}

// By the equations of a region.
TEST(TreeEquations, AccelerateAFigureAsMujocoDoes) {
  ForAllSamples("region of all joints", Root::kStill, [](Sample& s) {
    FreeFigure free(s.figure, s.moving_root.X_WR().R.transpose() * -s.gravity);
    VecX qdd(s.figure.num_joints());
    free.Accelerate(s.q, s.qd, s.tau, &qdd);
    return RelativeDifference(qdd, s.mujoco.ForwardDynamics(s.tau, nullptr));
  });
}

// MuJoCo has no forward dynamics on a root that is led: its inverse dynamics must give the torques.
TEST(ForwardDynamics, OnATurningAndAcceleratingRootIsUndoneByMujocosInverse) {
  ForAllSamples("forward dynamics, moving root", Root::kMoving, [](Sample& s) {
    const VecX all = s.mujoco.InverseDynamics(s.Join(Accelerations(s)), &s.ends);
    return RelativeDifference(s.JointRows(all), s.tau);
  });
}

TEST(OriginJacobian, AgreesWithMujoco) {
  ForAllSamples("Jacobian", Root::kStill, [](Sample& s) {
    const DynamicsWorkspace ws = s.Placed();
    const int n = s.figure.num_joints();
    Eigen::Matrix3Xd J(3, n);
    for (int i = 0; i < n; ++i) {
      J.col(i) = OriginJacobian(s.figure, ws, JointIndex(n - 1), JointIndex(i));
    }
    return RelativeDifference(J, s.mujoco.OriginJacobian(JointIndex(n - 1)));
  });
}

}  // namespace
}  // namespace hazumi::test
