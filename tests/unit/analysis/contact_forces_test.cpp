// Forces at contacts against what symmetry and friction say, and against their own optimality; and
// the filter of captures against waves.

#include "engine/analysis/contact_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/analysis/smooth_motion.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr double kMu = 0.8;

ContactPoint At(double x, double y, double weight = 1.0) {
  ContactPoint point;
  point.p = {x, y, 0.0};
  point.weight = weight;
  return point;
}

std::vector<ContactPoint> Square() {
  return {At(0.1, 0.1), At(0.1, -0.1), At(-0.1, 0.1), At(-0.1, -0.1)};
}

struct Solved {
  Wrench rest;
  std::vector<Vec3> forces;
};

Solved Solve(const Wrench& needed, const std::vector<ContactPoint>& points) {
  Solved solved;
  solved.rest = ContactForceSolver().Solve(needed, Vec3::Zero(), points, kMu, &solved.forces);
  return solved;
}

TEST(ContactForces, AreEqualUnderAWeightInTheMiddle) {
  const Solved solved = Solve({Vec3(0, 0, 100), Vec3::Zero()}, Square());
  for (const Vec3& force : solved.forces) {
    EXPECT_NEAR((force - Vec3(0, 0, 25)).norm(), 0.0, 1e-9);
  }
  EXPECT_LT(solved.rest.force.norm(), 1e-9);
}

TEST(ContactForces, GoWithTheWeights) {
  const Solved solved =
      Solve({Vec3(0, 0, 90), Vec3::Zero()}, {At(0, 0, 0.5), At(0, 0, 1.0), At(0, 0, 1e-6)});
  EXPECT_NEAR(solved.forces[0].z(), 30.0, 1e-3);
  EXPECT_NEAR(solved.forces[1].z(), 60.0, 1e-3);
}

TEST(ContactForces, PushAndDoNotPull) {
  const Solved solved = Solve({Vec3(0, 0, -100), Vec3::Zero()}, Square());
  for (const Vec3& force : solved.forces) EXPECT_EQ(force.norm(), 0.0);
  EXPECT_NEAR(solved.rest.force.z(), -100.0, 1e-9);
}

TEST(ContactForces, CarryAWeightAtTheEdgeByTheEdge) {
  const Vec3 p(0.1, 0.0, 0.0), F(0, 0, 100);
  const Solved solved = Solve({F, p.cross(F)}, Square());
  EXPECT_NEAR(solved.forces[0].z() + solved.forces[1].z(), 100.0, 1e-4);
  EXPECT_LT(solved.rest.moment.norm(), 1e-4);
}

TEST(ContactForces, StayInTheirConesAndComeNearest) {
  // One point that is to give n along its normal and t along the ground, t > mu n: the nearest in
  // the cone.
  const Solved solved = Solve({Vec3(100, 0, 50), Vec3::Zero()}, {At(0, 0)});
  const double size = (50.0 + kMu * 100.0) / (1.0 + kMu * kMu);
  EXPECT_NEAR(solved.forces[0].z(), size, 1e-3);
  EXPECT_NEAR(solved.forces[0].x(), kMu * size, 1e-3);
}

TEST(ContactForces, GripForces_HaveAnyDirectionAndNoMoment) {
  ContactPoint grip = At(0.2, 0.0);
  grip.is_grip = true;
  const Vec3 F(30, 0, -100), N = grip.p.cross(F) + Vec3(1, 2, 3);
  const Solved solved = Solve({F, N}, {grip});
  EXPECT_LT((solved.forces[0] - F).norm(), 1e-6);
  EXPECT_LT((solved.rest.moment - Vec3(1, 2, 3)).norm(), 1e-6);
}

// Moment that cannot be supplied: the force would have to act 8 cm beyond the edge.
TEST(ContactForces, ResidualMoment_DoesNotChangeTheForce) {
  const Vec3 F(-5, 0, 100), com(0.13, 0.0, 1.0), edge(0.1, 0.0, 0.0);
  std::vector<Vec3> forces;
  const Wrench rest = ContactForceSolver().Solve({F, Vec3::Zero()}, com, Square(), kMu, &forces);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : forces) sum += force;
  EXPECT_LT((sum - F).norm(), 1e-6);
  EXPECT_LT(rest.force.norm(), 1e-6);
  EXPECT_LT((rest.moment + (edge - com).cross(F)).norm(), 1e-4);
  EXPECT_LT(forces[2].norm() + forces[3].norm(), 1e-6);
}

// No small change of the forces that supplies the same costs less.
TEST(ContactForces, AreTheLeastThatSupplyWhatIsNeeded) {
  Random random(3);
  int inside = 0;
  for (int k = 0; k < 300; ++k) {
    std::vector<ContactPoint> points;
    Eigen::Matrix<double, 6, Eigen::Dynamic> G(6, 24);
    Wrench needed;
    std::vector<Vec3> made;
    for (int i = 0; i < 8; ++i) {
      ContactPoint point = At(random.Uniform(-0.4, 0.4), random.Uniform(-0.4, 0.4));
      point.p.z() = random.Uniform(0.0, 0.3);
      point.weight = random.Uniform(0.05, 1.0);
      points.push_back(point);
      const Vec3 f(random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), 1.0);
      made.push_back(100.0 * f);
      needed.force += made.back();
      needed.moment += point.p.cross(made.back());
    }
    const Solved solved = Solve(needed, points);
    double own = 0.0, other = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3& f = solved.forces[i];
      EXPECT_LE(f.head<2>().norm(), kMu * f.z() * (1 + 1e-9) + 1e-9);
      own += f.squaredNorm() / points[i].weight;
      other += made[i].squaredNorm() / points[i].weight;
    }
    EXPECT_LE(own, other);
    EXPECT_LT(solved.rest.force.norm() + solved.rest.moment.norm(), 1e-5) << k;
    inside += solved.rest.force.norm() < 1e-7;
  }
  EXPECT_GT(inside, 250);
}

TEST(LowPass, LeavesSlowWavesTakesFastOnesAndDelaysNone) {
  constexpr double kDt = 1.0 / 120.0;
  const auto share = [&](double hz) {
    MatX series(1, 1201);
    for (int i = 0; i <= 1200; ++i) series(0, i) = std::sin(2 * std::numbers::pi * hz * i * kDt);
    LowPass(6.0, kDt, &series);
    double sine = 0.0, cosine = 0.0;
    for (int i = 360; i < 840; ++i) {
      sine += series(0, i) * std::sin(2 * std::numbers::pi * hz * i * kDt) / 240.0;
      cosine += series(0, i) * std::cos(2 * std::numbers::pi * hz * i * kDt) / 240.0;
    }
    EXPECT_NEAR(cosine, 0.0, 1e-3) << hz;
    return sine;
  };
  EXPECT_NEAR(share(1.0), 1.0, 0.001);
  EXPECT_NEAR(share(6.0), std::numbers::sqrt2 / 2, 0.01);
  EXPECT_LT(share(20.0), 0.02);
}

TEST(LowPass, LeavesLines) {
  MatX series(2, 50);
  for (int i = 0; i < 50; ++i) series.col(i) << 3.0, 0.1 * i;
  MatX filtered = series;
  LowPass(6.0, 1.0 / 30.0, &filtered);
  EXPECT_LT((filtered - series).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace hazumi::test
