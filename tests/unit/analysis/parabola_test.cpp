#include "engine/analysis/parabola.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hazumi {
namespace {

constexpr double kFrame = 1.0 / 60.0;

std::vector<Vec3> Flown(int frames, const Vec3& from, const Vec3& v, double gravity) {
  std::vector<Vec3> path;
  for (int i = 0; i < frames; ++i) {
    const double t = i * kFrame;
    path.push_back(from + t * v - 0.5 * gravity * t * t * Vec3::UnitZ());
  }
  return path;
}

TEST(Parabola, IsThatOfAFreeFlight) {
  const Vec3 from(1.0, 2.0, 1.1), v(0.5, -0.25, 2.0);
  const auto path = Flown(40, from, v, 3.7);
  const Parabola fit = FitParabola(path, kFrame, 5, 30);
  EXPECT_NEAR(fit.gravity, 3.7, 1e-9);
  EXPECT_NEAR(fit.apex_time, 2.0 / 3.7, 1e-9);
  EXPECT_NEAR(fit.apex.z(), 1.1 + 2.0 * 2.0 / (2.0 * 3.7), 1e-9);
  EXPECT_LT(fit.rms, 1e-12);
  EXPECT_LT((fit.PositionAt(36 * kFrame) - path[36]).norm(), 1e-9);
  EXPECT_LT((fit.VelocityAt(0.0) - v).norm(), 1e-9);
  const double half = 12.5 * kFrame;
  EXPECT_NEAR(fit.sagitta, 0.5 * 3.7 * half * half, 1e-9);
}

// Of many fits to noise the gravities must scatter as far as the errors say.
TEST(Parabola, StatesTheErrorOfItsGravity) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.002);
  const auto path = Flown(40, Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 3.0), 9.81);
  double square = 0.0, error = 0.0;
  constexpr int kFits = 400;
  for (int k = 0; k < kFits; ++k) {
    auto noisy = path;
    for (Vec3& p : noisy) p.z() += normal(random);
    const Parabola fit = FitParabola(noisy, kFrame, 0, 39);
    square += std::pow(fit.gravity - 9.81, 2) / kFits;
    error += fit.gravity_error / kFits;
  }
  EXPECT_NEAR(error / std::sqrt(square), 1.0, 0.15);
}

TEST(Parabola, OfWhatRisesEverFasterFallsUpwards) {
  EXPECT_NEAR(FitParabola(Flown(20, Vec3::Zero(), Vec3::Zero(), -2.0), kFrame, 0, 19).gravity, -2.0,
              1e-9);
}

}  // namespace
}  // namespace hazumi
