#include "engine/region/paper_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr double kStep = 1.0 / 30.0;

// A step of a made-up system with limits close by.
struct Step {
  explicit Step(uint64_t seed, int size = 0) : random(seed) {
    const int n = size > 0 ? size : random.Integer(1, 12);
    const MatX root = Eigen::Map<const MatX>(random.Vector(n * n, 1.0).data(), n, n);
    M = root * root.transpose() + 0.2 * MatX::Identity(n, n);
    b = random.Vector(n, 30.0);
    q = random.Vector(n, 0.5);
    qd = random.Vector(n, 10.0);
    friction = VecX::Constant(n, 0.75) + random.Vector(n, 0.25);
    lower = q - VecX::Constant(n, 0.2) + random.Vector(n, 0.19);
    upper = q + VecX::Constant(n, 0.2) + random.Vector(n, 0.19);
  }

  PaperStepInput Input() const { return {&M, &b, friction, lower, upper}; }

  Random random;
  MatX M;
  VecX b, q, qd, friction, lower, upper;
};

// Two joints that feel each other.
Step Pair() {
  Step step(1, 2);
  step.M << 1.0, 0.5, 0.5, 1.0;
  step.b.setZero();
  step.q.setZero();
  step.qd.setZero();
  step.friction.setOnes();
  step.lower.setConstant(-1.0);
  step.upper.setConstant(1.0);
  return step;
}

PaperStepStatus Advance(const Step& step, PaperStep* paper, VecX* q, VecX* qd) {
  *q = step.q;
  *qd = step.qd;
  return paper->Advance(step.Input(), kStep, q, qd);
}

// The accelerations that the step must have used, by (5)-(7).
VecX UsedAccelerations(const Step& s, const PaperStep& paper, const VecX& q, const VecX& qd) {
  VecX qdd(s.q.size());
  for (int i = 0; i < qdd.size(); ++i) {
    const double rate = paper.corrected()[i] ? (q[i] - s.q[i]) / kStep : qd[i] / s.friction[i];
    qdd[i] = (rate - s.qd[i]) / kStep;
  }
  return qdd;
}

TEST(PaperStep, EndsWithEveryJointInsideItsLimits) {
  int corrections = 0;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    const Step step(seed);
    PaperStep paper(static_cast<int>(step.q.size()));
    VecX q, qd;
    ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk) << "seed " << seed;
    for (int i = 0; i < q.size(); ++i) {
      EXPECT_GE(q[i], step.lower[i]) << "seed " << seed << " joint " << i;
      EXPECT_LE(q[i], step.upper[i]) << "seed " << seed << " joint " << i;
      corrections += paper.corrected()[i];
    }
  }
  EXPECT_GT(corrections, 300);
}

TEST(PaperStep, CorrectedJointsLieOnALimitAndCarryTheRateThatTookThemThere) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    const Step step(seed);
    PaperStep paper(static_cast<int>(step.q.size()));
    VecX q, qd;
    ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk) << "seed " << seed;
    for (int i = 0; i < q.size(); ++i) {
      if (!paper.corrected()[i]) continue;
      EXPECT_TRUE(q[i] == step.lower[i] || q[i] == step.upper[i]) << "seed " << seed;
      EXPECT_NEAR(qd[i], (q[i] - step.q[i]) / kStep, 1e-10) << "seed " << seed << " joint " << i;
    }
  }
}

TEST(PaperStep, TheOtherJointsFeelNoTorqueAndGetTheirFrictionOnce) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    const Step step(seed);
    PaperStep paper(static_cast<int>(step.q.size()));
    VecX q, qd;
    ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk) << "seed " << seed;
    const VecX torque = step.M * UsedAccelerations(step, paper, q, qd) + step.b;
    for (int i = 0; i < q.size(); ++i) {
      if (paper.corrected()[i]) continue;
      EXPECT_NEAR(torque[i], 0.0, 1e-9) << "seed " << seed << " joint " << i;
      EXPECT_NEAR(q[i], step.q[i] + qd[i] * kStep, 1e-14) << "seed " << seed << " joint " << i;
    }
  }
}

TEST(PaperStep, SolvesAtMostOnceMoreThanItCorrects) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    const Step step(seed);
    PaperStep paper(static_cast<int>(step.q.size()));
    VecX q, qd;
    ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk) << "seed " << seed;
    const auto count = std::count(paper.corrected().begin(), paper.corrected().end(), 1);
    EXPECT_LE(paper.solves(), 1 + count) << "seed " << seed;
    EXPECT_EQ(paper.solves() > 1, count > 0) << "seed " << seed;
  }
}

TEST(PaperStep, CorrectsAJointThatOnlyLeavesWhenAnotherIsCorrected) {
  Step step = Pair();
  step.qd << 6.0, 0.5;  // alone, joint 0 would pass its limit and joint 1 stay inside
  step.upper << 0.1, 0.0333334;
  PaperStep paper(2);
  VecX q, qd;
  ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk);
  EXPECT_EQ(paper.solves(), 3);
  EXPECT_EQ(q, step.upper);
}

// The joints are coupled so that stopping joint 1 would by itself hold joint 0 back. Joint 0 was
// set to its limit in the same pass, and the paper's step never lets go: its limit pulls.
TEST(PaperStep, KeepsACorrectedJointOnItsLimitThoughTheLimitHasToPull) {
  Step step = Pair();
  step.M << 1.0, -0.5, -0.5, 1.0;
  step.qd << 4.0, 20.0;
  step.upper << 0.1, 0.1;
  PaperStep paper(2);
  VecX q, qd;
  ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk);
  EXPECT_EQ(q, step.upper);
  EXPECT_GT((step.M * UsedAccelerations(step, paper, q, qd))[0], 0.0) << "the limit must pull";
}

TEST(PaperStep, BringsAJointThatStartsOutsideToTheNearerLimit) {
  Step step = Pair();
  step.q << 1.5, -0.9;
  step.lower << -1.0, -0.4;
  PaperStep paper(2);
  VecX q, qd;
  ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk);
  EXPECT_EQ(q, Eigen::Vector2d(1.0, -0.4));
  EXPECT_NEAR(qd[0], -0.5 / kStep, 1e-12);
}

TEST(PaperStep, FrictionZeroFreezesAndFrictionOneDoesNothing) {
  Step step = Pair();
  step.M.setIdentity();
  step.qd << 3.0, 3.0;
  step.b << -6.0, -6.0;
  step.friction << 0.0, 1.0;
  PaperStep paper(2);
  VecX q, qd;
  ASSERT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kOk);
  EXPECT_EQ(q[0], 0.0);
  EXPECT_EQ(qd[0], 0.0);
  EXPECT_NEAR(qd[1], 3.0 + 6.0 * kStep, 1e-14);
}

TEST(FrictionOfStep, ComposesToTheFactorOfAFrame) {
  EXPECT_DOUBLE_EQ(FrictionOfStep(0.8, 1.0 / 30.0), 0.8);
  EXPECT_DOUBLE_EQ(std::pow(FrictionOfStep(0.4, 1.0 / 300.0), 10), 0.4);
  EXPECT_EQ(FrictionOfStep(0.0, 1.0 / 300.0), 0.0);
  EXPECT_EQ(FrictionOfStep(1.0, 1.0 / 300.0), 1.0);
}

TEST(PaperStep, NamesTheSingularRowAndLeavesTheStateAlone) {
  Step step = Pair();
  step.M << 1.0, 0.0, 0.0, 0.0;
  step.qd << 1.0, 2.0;
  PaperStep paper(2);
  VecX q, qd;
  EXPECT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kSingular);
  EXPECT_EQ(paper.failed_joint(), 1);
  EXPECT_EQ(q, step.q);
  EXPECT_EQ(qd, step.qd);
}

TEST(PaperStep, ReportsAnExplosionAndLeavesTheStateAlone) {
  for (const double bias : {1e12, 1e300}) {
    Step step = Pair();
    step.M.setIdentity();
    step.b << 0.0, bias;
    PaperStep paper(2);
    VecX q, qd;
    EXPECT_EQ(Advance(step, &paper, &q, &qd), PaperStepStatus::kNotFinite) << bias;
    EXPECT_EQ(paper.failed_joint(), 1) << bias;
    EXPECT_EQ(q, step.q) << bias;
    EXPECT_EQ(qd, step.qd) << bias;
  }
}

}  // namespace
}  // namespace hazumi::test
