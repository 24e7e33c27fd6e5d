#include "engine/spatial/jet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "engine/spatial/pose.h"

namespace hazumi {
namespace {

using Function = std::function<double(double)>;
using JetFunction = std::function<Jet(const Jet&)>;

// Central differences at h and h/2, extrapolated: error of order h^4.
double Derivative(const Function& f, double t, double h) {
  const auto central = [&](double step) { return (f(t + step) - f(t - step)) / (2.0 * step); };
  return (4.0 * central(0.5 * h) - central(h)) / 3.0;
}

double SecondDerivative(const Function& f, double t, double h) {
  const auto central = [&](double step) {
    return (f(t + step) - 2.0 * f(t) + f(t - step)) / (step * step);
  };
  return (4.0 * central(0.5 * h) - central(h)) / 3.0;
}

void ExpectDifferentiates(const JetFunction& f) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> time(-2.0, 2.0);
  const Function value = [&](double t) { return f(Jet(t)).v; };
  for (int i = 0; i < 20; ++i) {
    const double t = time(random);
    const Jet jet = f(Jet(t, 1.0, 0.0));
    EXPECT_NEAR(jet.d, Derivative(value, t, 1e-3), 1e-9) << "t = " << t;
    EXPECT_NEAR(jet.dd, SecondDerivative(value, t, 1e-2), 1e-7) << "t = " << t;
  }
}

TEST(Jet, DifferentiatesSumsAndProducts) {
  ExpectDifferentiates([](const Jet& t) { return t * t * t - 2.0 * t + t * (3.0 - t); });
  ExpectDifferentiates([](const Jet& t) { return -(t + 1.0) * (t - 2.0) * t; });
}

TEST(Jet, DifferentiatesSineAndCosineOfFunctions) {
  ExpectDifferentiates([](const Jet& t) { return sin(t * t + 0.3); });
  ExpectDifferentiates([](const Jet& t) { return cos(t * t - t) * sin(2.0 * t); });
  ExpectDifferentiates([](const Jet& t) { return sin(cos(t) * t); });
}

TEST(Jet, MultipliesWithItselfInPlace) {
  Jet x(3.0, 2.0, 1.0);
  x *= x;
  EXPECT_EQ(x, Jet(9.0, 12.0, 2.0 * 4.0 + 2.0 * 3.0));
}

TEST(Jet, DifferentiatesRotationMatrices) {
  const Vec3 axis = Vec3(1.0, -2.0, 0.5).normalized();
  for (int entry = 0; entry < 9; ++entry) {
    ExpectDifferentiates([&](const Jet& t) {
      const Jet angle = t * t * 0.5 + t;
      const Mat3Of<Jet> R = AxisRotation<Jet>(axis, sin(angle), cos(angle));
      return (R * R.transpose() * R)(entry / 3, entry % 3);
    });
  }
}

}  // namespace
}  // namespace hazumi
