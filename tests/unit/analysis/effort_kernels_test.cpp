// Effort's kernels: the same bits by both instruction sets, positions against those of the
// dynamics, and contact forces that do not depend on those of the frames before.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/contact_forces.h"
#include "engine/analysis/touching.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "tests/support/figures.h"
#include "tests/unit/analysis/lane_frames.h"

namespace hazumi::test {
namespace {

// How far bodies are from where the dynamics has them.
double WorstPlace(const Figure& figure, const Stance& stance, const PlacedFrame& placed) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, stance.X_WR, stance.q, &ws);
  double worst = 0.0;
  for (int j = -1; j < figure.num_joints(); ++j) {
    const JointIndex joint = j < 0 ? JointIndex() : JointIndex(j);
    const BodyScratch& body = ws.body(joint);
    worst = std::max(worst, (placed.p(joint) - body.p).norm());
    for (int k = 0; k < 3; ++k) {
      worst = std::max(worst, (placed.Turned(joint, Vec3::Unit(k)) - body.R.col(k)).norm());
    }
  }
  return worst;
}

// Numbers of frames that fill the lanes, and that do not.
TEST(PlacedFrames, AreWhereTheDynamicsHasThem) {
  Random random(5);
  for (int k = 0; k < 40; ++k) {
    const Figure figure = k == 0 ? Human37() : Build(RandomTreeSpec(&random));
    std::vector<Stance> stances = RandomStances(figure, 1 + k % 9, &random);
    stances[0].q[0] = 1e6;  // too large for polynomials
    for (const EffortKernels& kernels : AllKernels()) {
      const PlacedFrames placed = PlaceAll(figure, stances, kernels);
      for (size_t i = 0; i < stances.size(); ++i) {
        EXPECT_LT(WorstPlace(figure, stances[i], placed[i]), 1e-12) << k << " " << i;
      }
    }
  }
}

TEST(PlacedFrames, HaveTheSameBitsByAllInstructions) {
  Random random(6);
  const Figure figure = Human37();
  const std::vector<Stance> stances = RandomStances(figure, 10, &random);
  const PlacedFrames expected = PlaceAll(figure, stances, BaselineEffortKernels());
  for (const EffortKernels& kernels : AllKernels()) {
    const PlacedFrames placed = PlaceAll(figure, stances, kernels);
    for (size_t i = 0; i < stances.size(); ++i) {
      for (int j = 0; j < figure.num_joints(); ++j) {
        EXPECT_EQ(placed[i].p(JointIndex(j)), expected[i].p(JointIndex(j)));
        for (int k = 0; k < 3; ++k) {
          EXPECT_EQ(placed[i].Turned(JointIndex(j), Vec3::Unit(k)),
                    expected[i].Turned(JointIndex(j), Vec3::Unit(k)));
        }
      }
    }
  }
}

// A ball, some of them inside, near each kind of shape.
TEST(Touching, IsWhereDistancesHaveIt) {
  Random random(7);
  const Figure figure = Human37();
  const std::vector<Obstacle> obstacles = {
      Plane{Vec3(0.0, 0.6, 0.8), -0.3},
      Box{{AxisRotation<double>(Vec3::UnitX(), 0.6, 0.8), Vec3(0.1, 0.2, 0.3)},
          Vec3(0.8, 0.9, 1.0)},
      Box{{}, Vec3(0.7, 0.3, 0.0)}, Capsule{Vec3(-0.5, 0.2, 0.1), Vec3(0.3, 0.4, -0.2), 0.25}};
  int inside = 0;
  for (int k = 0; k < 100; ++k) {
    const std::vector<Stance> stances = RandomStances(figure, 4, &random);
    const JointIndex joint(k % figure.num_joints());
    TouchingBall ball;
    ball.body = joint.value() + 1;
    ball.radius = 0.05;
    const Vec3 centre = random.Vector3(0.5);
    std::copy_n(centre.data(), 3, ball.centre);
    for (const EffortKernels& kernels : AllKernels()) {
      const PlacedFrames placed = PlaceAll(figure, stances, kernels);
      for (const Obstacle& obstacle : obstacles) {
        const TouchedShape shape = PrepareShape(obstacle);
        LaneArray touches(4 * TouchField::kNumFields), clearances(4);
        kernels.touch(&ball, 1, &shape, 1, placed.FourWith(0), touches.data(), clearances.data(),
                      4);
        for (size_t i = 0; i < 4; ++i) {
          const Vec3 p = placed[i].PointOf(joint, centre);
          const Distance expected = SignedDistance(Capsule{p, p, ball.radius}, obstacle);
          inside += expected.value < -ball.radius;
          EXPECT_NEAR(clearances.data()[i], expected.value, 1e-12);
          for (size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(touches.data()[4 * (TouchField::kNormal + axis) + i],
                        expected.normal[static_cast<long>(axis)], 1e-9);
          }
        }
      }
    }
  }
  EXPECT_GT(inside, 40);
}

StrengthCurve RandomCurve(StrengthCurve::Form form, Random* random) {
  StrengthCurve curve;
  curve.form = form;
  curve.torque = random->Uniform(10.0, 200.0);
  curve.best_angle = random->Uniform(-1.0, 1.0);
  curve.width = random->Uniform(0.3, 1.5);
  curve.rate_75 = random->Uniform(1.0, 2.0);
  curve.rate_50 = random->Uniform(1.1, 2.9) * curve.rate_75;
  curve.lengthening = random->Uniform(0.0, 0.1);
  curve.fastest = random->Uniform(5.0, 20.0);
  return curve;
}

// Beyond what muscles reach, too, and against stops.
TEST(Shares, AreThoseOfStrengths) {
  using Form = StrengthCurve::Form;
  Random random(9);
  int least = 0, stopped = 0;
  for (int k = 0; k < 300; ++k) {
    const Form forms[] = {Form::kConstant, Form::kCosine, Form::kBell};
    const JointStrength strength = {RandomCurve(forms[k % 3], &random),
                                    RandomCurve(forms[k / 3 % 3], &random)};
    const HingeStrength hinge = {&strength, -1.5, 1.5};
    LaneArray torques(4), shares(4), leasts(4);
    double angle[4], rate[4];
    const double *angles[4], *rates[4];
    for (int i = 0; i < 4; ++i) {
      torques.data()[i] = random.Uniform(-300.0, 300.0);
      angles[i] = &(angle[i] = random.Uniform(-2.0, 2.0));
      rates[i] = &(rate[i] = random.Uniform(-25.0, 25.0));
    }
    for (const EffortKernels& kernels : AllKernels()) {
      kernels.share(&hinge, 1, torques.data(), angles, rates, shares.data(), leasts.data());
      for (int i = 0; i < 4; ++i) {
        const double torque = torques.data()[i];
        const Strength expected = torque >= 0.0 ? StrengthAt(strength.positive, angle[i], rate[i])
                                                : StrengthAt(strength.negative, angle[i], -rate[i]);
        const bool is_stopped = torque > 0.0 ? angle[i] < -1.5 : angle[i] > 1.5;
        const double share = is_stopped ? 0.0 : std::abs(torque) / expected.torque;
        EXPECT_NEAR(shares.data()[i], share, 1e-13 * share);
        EXPECT_EQ(leasts.data()[i] != 0.0, expected.is_at_least && !is_stopped);
        least += expected.is_at_least;
        stopped += is_stopped;
      }
    }
  }
  EXPECT_GT(least, 100);
  EXPECT_GT(stopped, 100);
}

// Feet that carry a weight that sways, brakes and leans, more at times than they can.
struct Asked {
  std::vector<ContactPoint> points;
  Wrench needed;
};

std::vector<Asked> Sway() {
  std::vector<Asked> frames;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.05 * i;
    Asked& asked = frames.emplace_back();
    for (int k = 0; k < (i < 120 ? 9 : 6); ++k) {
      ContactPoint point;
      point.p = {0.1 * (k % 3) + 0.02 * std::sin(t), 0.15 * (k / 3), 0.01 * std::cos(t + k)};
      point.weight = 0.3 + 0.1 * k;
      asked.points.push_back(point);
    }
    asked.needed.force = {500.0 * std::sin(t), 300.0 * std::cos(1.7 * t), 700.0};
    asked.needed.moment = {100.0 + 60.0 * std::sin(2.0 * t), -70.0 + 60.0 * std::cos(t),
                           30.0 * std::sin(t)};
  }
  return frames;
}

TEST(ContactForces, AreTheSameWhateverWasAskedBefore) {
  ContactForceSolver solver;
  int met = 0;
  const std::vector<Asked> frames = Sway();
  for (size_t i = 0; i < frames.size(); ++i) {
    const Asked& asked = frames[i];
    std::vector<Vec3> forces, alone;
    const Wrench rest =
        solver.Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &forces);
    ContactForceSolver().Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &alone);
    met += rest.force.norm() + rest.moment.norm() < 1e-5;
    for (size_t k = 0; k < forces.size(); ++k) {
      EXPECT_LT((forces[k] - alone[k]).norm(), 1e-5) << i << " " << k;
    }
  }
  EXPECT_GT(met, 40);
  EXPECT_LT(met, 160);
}

TEST(ContactForces, HaveTheSameBitsByAllInstructions) {
  for (const EffortKernels& kernels : AllKernels()) {
    ContactForceSolver solver(kernels), expected(BaselineEffortKernels());
    for (const Asked& asked : Sway()) {
      std::vector<Vec3> forces, same;
      solver.Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &forces);
      expected.Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &same);
      for (size_t k = 0; k < forces.size(); ++k) EXPECT_EQ(forces[k], same[k]);
    }
  }
}

}  // namespace
}  // namespace hazumi::test
