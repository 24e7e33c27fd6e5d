#include "tests/unit/region/arm_swing.h"

#include <cmath>

#include "tests/support/compare.h"
#include "tests/support/dense_dynamics.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

double WorstErrorDeg(const VecX& q, const Vec7& expected_deg) {
  return (q * kRadian - expected_deg).cwiseAbs().maxCoeff();
}

void ExpectResults(const ArmCase& arm_case, double tolerance_deg) {
  for (const PaperResult& result : arm_case.results) {
    const SwingEnd end = RunArmCase(arm_case, result.steps_per_frame);
    ASSERT_EQ(end.status, PaperStepStatus::kOk) << arm_case.name;
    EXPECT_LE(WorstErrorDeg(end.q, result.end_deg), tolerance_deg)
        << arm_case.name << ", paper/" << result.steps_per_frame;
  }
}

TEST(PaperStep, ReproducesTheKnownSwingWithLimits) { ExpectResults(SwingWithLimits(), 1e-5); }

TEST(PaperStep, ReproducesTheKnownFreeSwing) { ExpectResults(FreeSwing(), 1e-5); }

// Rounding grows a millionfold near the singular pose: a digit is given up for it.
TEST(PaperStep, ReproducesTheKnownSwingNearGimbalLock) { ExpectResults(NearGimbal(), 1e-4); }

TEST(PaperStep, ConvergesWithOrderOneToTheKnownSwings) {
  for (const ArmCase& c : {SwingWithLimits(), FreeSwing()}) {
    const double coarse = WorstErrorDeg(RunArmCase(c, 100).q, c.converged_deg);
    const double fine = WorstErrorDeg(RunArmCase(c, 400).q, c.converged_deg);
    EXPECT_NEAR(coarse / fine, 4.0, 1.0) << c.name;
  }
}

TEST(PaperStep, ExplodesNearGimbalLockWithAStatusAndNeverNaN) {
  const SwingEnd end = RunArmCase(NearGimbal(), 100);
  EXPECT_EQ(end.status, PaperStepStatus::kNotFinite);
  EXPECT_TRUE(end.q.allFinite());
  EXPECT_TRUE(end.qd.allFinite());
}

TEST(ForwardDynamics, StartsTheKnownSwings) {
  const Figure arm = Arm7();
  RootMotion root;
  root.a.z() = kArmCaseGravity;
  for (const ArmCase& c : {SwingWithLimits(), FreeSwing(), NearGimbal()}) {
    DynamicsWorkspace ws(arm);
    const VecX q = c.start_deg / kRadian, qd = c.start_rate, zero = VecX::Zero(7);
    ComputePositions(arm, Pose(), q, &ws);
    InverseDynamics(arm, root, qd, zero, nullptr, &ws);
    EXPECT_LE(RelativeDifference(ws.tau, c.bias), 1e-8) << c.name;
    VecX qdd(7);
    ASSERT_FALSE(ForwardDynamics(arm, root, qd, zero, nullptr, &ws, &qdd)) << c.name;
    EXPECT_LE(RelativeDifference(qdd, c.free_acceleration), 1e-8) << c.name;
  }
}

// Released at rest from 100 degrees, a pendulum hangs straight down after a quarter of its period,
// K(k) / w with k = sin(50 degrees) and w^2 = m g l / I, at the rate 2 k w.
TEST(PaperStep, SwingsAPendulumLikeTheEllipticIntegralToFirstOrder) {
  const Figure pendulum = Pendulum(2.0, 0.05, 0.6);
  const double inertia = 2.0 * (3.0 * 0.05 * 0.05 + 0.6 * 0.6) / 12.0 + 2.0 * 0.3 * 0.3;
  const double w = std::sqrt(2.0 * 9.81 * 0.3 / inertia);
  const double start = 100.0 / kRadian, k = std::sin(0.5 * start);
  const double quarter = std::comp_ellint_1(k) / w;
  const VecX one = VecX::Ones(1);
  const auto error = [&](int steps) {
    const SwingEnd end = Swing{pendulum,  start * one, 0.0 * one,       one,  -9.0 * one,
                               9.0 * one, 9.81,        quarter / steps, steps}
                             .Run();
    return Eigen::Vector2d(end.q[0], end.qd[0] + 2.0 * k * w);
  };
  const Eigen::Vector2d coarse = error(1000), fine = error(4000);
  EXPECT_LE(fine.norm(), 5e-3);
  EXPECT_NEAR(coarse.norm() / fine.norm(), 4.0, 0.1);
}

// Without a field and with friction the rate of one hinge decays exactly by f per 1/30 s, however
// the time is cut.
TEST(PaperStep, FrictionIsARateWhateverTheStep) {
  const Figure pendulum = Pendulum(2.0, 0.05, 0.6);
  const VecX one = VecX::Ones(1);
  for (const int per_frame : {1, 3, 10}) {
    const SwingEnd end = Swing{pendulum,     0.0 * one, 5.0 * one, 0.7 * one,
                               -9.0 * one,   9.0 * one, 0.0,       1.0 / (30.0 * per_frame),
                               6 * per_frame}
                             .Run();
    EXPECT_NEAR(end.qd[0], 5.0 * std::pow(0.7, 6), 1e-12) << per_frame << " steps a frame";
  }
}

}  // namespace
}  // namespace hazumi::test
