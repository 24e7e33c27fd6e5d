// Effort's kernels: the same bits by both instruction sets, positions against those of the
// dynamics, and contact forces that do not depend on those of the frames before.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/contact_forces.h"
#include "engine/analysis/placed_frames.h"
#include "engine/dynamics/figure_dynamics.h"
#include "engine/dynamics/kinematics.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {
namespace {

std::vector<EffortKernels> AllKernels() {
  std::vector<EffortKernels> all = {BaselineEffortKernels()};
  if (CpuHasAvx2()) all.push_back(Avx2EffortKernels());
  return all;
}

struct Stance {
  Pose X_WR;
  VecX q;
};

std::vector<Stance> RandomStances(const Figure& figure, int count, Random* random) {
  std::vector<Stance> stances;
  for (int i = 0; i < count; ++i) {
    stances.push_back({RandomMovingRoot(random).X_WR(), RandomAngles(figure, random)});
  }
  return stances;
}

PlacedFrames PlaceAll(const Figure& figure, const std::vector<Stance>& stances,
                      const EffortKernels& kernels) {
  PlacedFrames placed(figure, stances.size(), kernels);
  for (const Stance& stance : stances) placed.Add(stance.X_WR, stance.q);
  placed.Finish();
  return placed;
}

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
    if (j >= 0) worst = std::max(worst, (placed.axis(joint) - body.axis).norm());
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
        EXPECT_EQ(placed[i].axis(JointIndex(j)), expected[i].axis(JointIndex(j)));
      }
    }
  }
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
    std::vector<ContactForce> forces, alone;
    const Wrench rest =
        solver.Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &forces);
    ContactForceSolver().Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &alone);
    met += rest.force.norm() < 1e-6;
    for (size_t k = 0; k < forces.size(); ++k) {
      EXPECT_LT((forces[k].force - alone[k].force).norm(), 1e-5) << i << " " << k;
    }
  }
  EXPECT_GT(met, 40);
  EXPECT_LT(met, 160);
}

TEST(ContactForces, HaveTheSameBitsByAllInstructions) {
  for (const EffortKernels& kernels : AllKernels()) {
    ContactForceSolver solver(kernels), expected(BaselineEffortKernels());
    for (const Asked& asked : Sway()) {
      std::vector<ContactForce> forces, same;
      solver.Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &forces);
      expected.Solve(asked.needed, Vec3::Zero(), asked.points, kGroundFriction, &same);
      for (size_t k = 0; k < forces.size(); ++k) EXPECT_EQ(forces[k].force, same[k].force);
    }
  }
}

}  // namespace
}  // namespace hazumi::test
