#include "engine/solve/aim_solver.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hazumi::solve {
namespace {

// A hinge of unit inertia without weight, over a time of 1 s.
struct Wheel {
  explicit Wheel(int frames, int knots) {
    problem.chain.step = 1.0 / frames;
    problem.chain.joints = {{Vec3::Zero(), {{Vec3::UnitZ(), false}}}};
    problem.hinges.resize(1);
    problem.hinges[0].lower = -100.0;
    problem.hinges[0].upper = 100.0;
    problem.hinges[0].strength = 1000.0;
    problem.acceleration = 0.0;
    RigidInertia body;
    body.mass = 1e-9;
    body.I_com = Mat3::Identity();
    for (int t = 0; t < frames + 2; ++t) {
      problem.chain.carrier.push_back({});
      problem.chain.bodies.push_back({body});
    }
    for (int k = 0; k <= knots; ++k) problem.knots.push_back(1 + frames * k / knots);
    problem.given = MatX::Zero(1, frames + 2);
  }
  AimedMotion Solve() { return AimSolver(problem, problem.given).Solve(); }
  // Integral of the squared torque [N^2 m^2 s].
  double Cost(const AimedMotion& motion) const {
    const auto squared = [&](Eigen::Index t) { return std::pow(motion.torques(0, t), 2); };
    const Eigen::Index last = motion.torques.cols() - 2;
    double sum = -0.5 * squared(1);
    for (Eigen::Index t = 1; t <= last; ++t) sum += squared(t);
    // The torque at the end follows from the two before it.
    const double end = 2.0 * motion.torques(0, last) - motion.torques(0, last - 1);
    return (sum + 0.5 * end * end) * problem.chain.step;
  }
  AimProblem problem;
};

// A particle of 1 kg that goes 1 m in 1 s, from rest to rest: 12 m^2 d^2 / T^3.
TEST(AimSolver, MovesAParticleWithTheLeastForce) {
  Wheel wheel(400, 8);
  wheel.problem.angles = {{401, 0, 1.0}};
  wheel.problem.rates = {{401, 0, 0.0}};
  const AimedMotion motion = wheel.Solve();
  EXPECT_NEAR(wheel.Cost(motion), 12.0, 12.0 * 1e-4);
  EXPECT_NEAR(motion.angles(0, 201), 0.5, 1e-4);
  EXPECT_NEAR(motion.torques(0, 101), 3.0, 0.02);  // 6 - 12 t
}

// A particle with a free end rate needs a quarter of that: 3 m^2 d^2 / T^3.
TEST(AimSolver, LeavesARateFreeThatNobodyAsksFor) {
  Wheel wheel(400, 8);
  wheel.problem.angles = {{401, 0, 1.0}};
  EXPECT_NEAR(wheel.Cost(wheel.Solve()), 3.0, 3.0 * 1e-4);
}

// Friction is free: a wheel that would roll to where it is wanted gets no torque.
TEST(AimSolver, GivesNothingToWhatArrivesByItself) {
  constexpr double kRate = 2.0, kFriction = 6.7;  // [rad/s, 1/s]
  Wheel wheel(200, 40);
  wheel.problem.hinges[0].friction = kFriction;
  wheel.problem.hinges[0].start_rate = kRate;
  const double way = kRate / kFriction * (1.0 - std::exp(-kFriction));
  wheel.problem.angles = {{201, 0, way}};
  const AimedMotion motion = wheel.Solve();
  EXPECT_LT(wheel.Cost(motion), 1e-4);
  wheel.problem.angles[0].angle = -way;
  EXPECT_GT(wheel.Cost(wheel.Solve()), 1.0);
}

TEST(AimSolver, StaysInsideLimits) {
  Wheel wheel(100, 10);
  wheel.problem.hinges[0].start_rate = 2.5;
  wheel.problem.hinges[0].upper = 1.0;
  wheel.problem.hinges[0].strength = 5.0;
  wheel.problem.angles = {{101, 0, 0.5}};
  const AimedMotion motion = wheel.Solve();
  EXPECT_LT(motion.angles.maxCoeff(), 1.02);
  EXPECT_NEAR(motion.angles(0, 101), 0.5, 0.02);
}

// Derivative of a pendulum's motion by a torque, against the linearized equation.
TEST(AimSolver, SaysWhatTorquesChange) {
  Wheel wheel(100, 5);
  AimProblem& problem = wheel.problem;
  problem.chain.gravity = {0.0, -9.81, 0.0};
  problem.hinges[0].friction = 1.0;
  problem.hinges[0].strength = 5.0;
  for (auto& bodies : problem.chain.bodies) bodies[0].mass = 1.0;
  for (auto& bodies : problem.chain.bodies) bodies[0].com = {0.3, 0.0, 0.0};
  problem.angles = {{101, 0, 0.7}};
  AimSolver solver(problem, problem.given);
  const AimedMotion motion = solver.Solve();
  MatX weights = MatX::Zero(102, 1);
  for (int t = 20; t < 60; ++t) weights(t, 0) = 1.0;
  const std::vector<MatX> changes = solver.ChangesWith(weights);
  // The same by integration of the linearized equation of motion: I x'' + I c x' - w sin(q) x = u.
  double x = 0.0, v = 0.0;
  const double I = 1.0 + 0.09, h = problem.chain.step / 20.0;
  for (int t = 1; t < 101; ++t) {
    const double q = motion.angles(0, t);
    for (int k = 0; k < 20; ++k) {
      // A weight acts half a frame to both sides.
      const double u = t + (k + 0.5) / 20.0 >= 19.5 && t + (k + 0.5) / 20.0 < 59.5 ? 1.0 : 0.0;
      const double a = (u + 9.81 * 0.3 * std::sin(q) * x) / I - v;
      v += h * a;
      x += h * v;
    }
  }
  EXPECT_NEAR(changes[101](0, 0), x, 0.01 * x);
}

}  // namespace
}  // namespace hazumi::solve
