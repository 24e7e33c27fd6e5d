// The integrator by itself, against closed forms and a published orbit.

#include "engine/region/exact/dop853.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hazumi::test {
namespace {

// y1' = y1 cos t, y2' = y2 (1 - y2):  y1 = e^(sin t), y2 = 1 / (1 + 3 e^-t)
struct Smooth {
  static constexpr int kSize = 2;
  static void Field(double t, const double* y, double* dy) {
    dy[0] = y[0] * std::cos(t);
    dy[1] = y[1] * (1.0 - y[1]);
  }
  static std::array<double, 2> At(double t) {
    return {std::exp(std::sin(t)), 1.0 / (1.0 + 3.0 * std::exp(-t))};
  }
  static double ErrorAt(double t, const double* y) {
    const auto exact = At(t);
    return std::max(std::abs(y[0] - exact[0]), std::abs(y[1] - exact[1]));
  }
  static constexpr double kScale[2] = {1.0, 1.0};
};

Dop853 StartedAt(double t) {
  Dop853 step;
  step.Resize(Smooth::kSize);
  step.Start(t, Smooth::At(t).data(), Smooth::Field);
  return step;
}

// One step of h seconds, accepted; returns its error estimate.
double Take(double h, Dop853* step) {
  const double error = step->Try(h, Smooth::kScale, Smooth::Field);
  step->Accept(Smooth::Field);
  return error;
}

// By which power of h something grows that is `coarse` for h and `fine` for h / 2.
double Order(double coarse, double fine) { return std::log2(coarse / fine); }

double GlobalError(int steps) {
  constexpr double kEnd = 4.0;
  Dop853 step = StartedAt(0.0);
  for (int i = 0; i < steps; ++i) Take(kEnd / steps, &step);
  return Smooth::ErrorAt(kEnd, step.y());
}

// Either way: minus infinity is no small error.
TEST(Dop853, WhatIsNotFiniteIsNoSmallError) {
  for (const double bad : {HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    const auto field = [&](double t, const double* y, double* dy) {
      Smooth::Field(t, y, dy);
      if (t > 0.0) dy[1] = bad;
    };
    for (const bool is_short : {false, true}) {
      Dop853 step = StartedAt(0.0);
      const double error = is_short ? step.TryShort(0.1, Smooth::kScale, field)
                                    : step.Try(0.1, Smooth::kScale, field);
      EXPECT_FALSE(error <= 1.0) << bad << (is_short ? " short" : "");
    }
  }
}

// A step that blows up, such as a stiff one that is far too long, has errors whose squares are no
// numbers any more; one of the two formulas earlier than the other.
TEST(Dop853, TakesNoHugeErrorForASmallOne) {
  for (double exponent = 100.0; exponent < 308.0; exponent += 0.25) {
    const double size = std::pow(10.0, exponent);
    const auto field = [&](double t, const double* y, double* dy) {
      std::copy_n(y, Smooth::kSize, dy);
      dy[0] = size * std::pow(t, 7.0);
    };
    Dop853 step;
    step.Resize(Smooth::kSize);
    step.Start(0.0, Smooth::At(0.0).data(), field);
    EXPECT_FALSE(step.Try(1.0, Smooth::kScale, field) <= 1.0) << size;
  }
}

// Any multiple of the error that the step tells, in the component that it is largest of.
TEST(Dop853, AddsItsEstimatedError) {
  for (const double h : {0.2, 0.5, 1.0}) {
    Dop853 plain = StartedAt(0.3), worse = StartedAt(0.3);
    const double error = Take(h, &plain);
    worse.Try(h, Smooth::kScale, Smooth::Field);
    worse.AddError(5.0);
    worse.Accept(Smooth::Field);
    double apart = 0.0;
    for (int i = 0; i < Smooth::kSize; ++i) {
      apart = std::max(apart, std::abs(worse.y()[i] - plain.y()[i]));
    }
    ASSERT_GT(error, 1e-13);
    EXPECT_NEAR(apart / error, 5.0, 1e-2) << h;
    worse.MakeDense(Smooth::Field);
    double end[Smooth::kSize];
    worse.At(0.3 + h, end);
    EXPECT_NEAR(end[0], worse.y()[0], 1e-14);
  }
}

TEST(Dop853, ConvergesWithOrderEight) {
  EXPECT_NEAR(Order(GlobalError(8), GlobalError(16)), 8.0, 0.5);
  EXPECT_NEAR(Order(GlobalError(12), GlobalError(24)), 8.0, 0.5);
}

// The worst of one step of h seconds from many places.
struct OneStep {
  explicit OneStep(double h) {
    for (int i = 0; i < 60; ++i) Look(0.1 * i, h);
  }
  void Look(double start, double h) {
    Dop853 step = StartedAt(start);
    estimate = std::max(estimate, Take(h, &step));
    end = std::max(end, Smooth::ErrorAt(start + h, step.y()));
    step.MakeDense(Smooth::Field);
    for (int i = 1; i < 16; ++i) {
      const double t = start + h * i / 16.0;
      double y[2];
      step.At(t, y);
      inside = std::max(inside, Smooth::ErrorAt(t, y));
    }
  }
  double end = 0.0, inside = 0.0, estimate = 0.0;
};

// A formula of order p is off by h^(p + 1) in one step.
TEST(Dop853, InterpolatesWithOrderSevenInsideAStepOfOrderEight) {
  const OneStep coarse(0.4), fine(0.2);
  EXPECT_NEAR(Order(coarse.inside, fine.inside), 8.0, 0.3);
  EXPECT_NEAR(Order(coarse.end, fine.end), 9.0, 0.6);
}

// Steps of order 5 by themselves: the same with order 4 inside, and an estimate of order 4.
struct ShortStep {
  explicit ShortStep(double h) {
    for (int i = 0; i < 60; ++i) {
      const double start = 0.1 * i;
      Dop853 step = StartedAt(start);
      int evaluations = 0;
      const auto field = [&](double t, const double* y, double* dy) {
        ++evaluations;
        Smooth::Field(t, y, dy);
      };
      estimate = std::max(estimate, step.TryShort(h, Smooth::kScale, field));
      step.Accept(field);
      step.MakeDense(field);
      EXPECT_EQ(evaluations, 6);
      end = std::max(end, Smooth::ErrorAt(start + h, step.y()));
      for (int k = 1; k < 16; ++k) {
        double y[2];
        step.At(start + h * k / 16.0, y);
        inside = std::max(inside, Smooth::ErrorAt(start + h * k / 16.0, y));
      }
    }
  }
  double end = 0.0, inside = 0.0, estimate = 0.0;
};

TEST(Dop853, TakesShortStepsOfOrderFiveInHalfTheEvaluations) {
  const ShortStep coarse(0.2), fine(0.1);
  EXPECT_NEAR(Order(coarse.end, fine.end), 6.0, 0.5);
  EXPECT_NEAR(Order(coarse.inside, fine.inside), 5.0, 0.5);
  EXPECT_NEAR(Order(coarse.estimate, fine.estimate), 5.0, 0.5);
  EXPECT_GT(fine.estimate, fine.end);
}

TEST(Dop853, GoesOnFromAShortStepWithOneOfOrderEight) {
  Dop853 step = StartedAt(0.0);
  step.TryShort(0.01, Smooth::kScale, Smooth::Field);
  step.Accept(Smooth::Field);
  EXPECT_LT(step.TryShort(5.0, Smooth::kScale, Smooth::Field), 1e9);  // and is not taken
  Take(0.2, &step);
  EXPECT_LT(Smooth::ErrorAt(0.21, step.y()), 1e-9);
}

// The estimate h e5^2 / sqrt(e5^2 + e3^2 / 100), e5 and e3 going with h^5 and h^3, goes with h^8.
TEST(Dop853, EstimatesAnErrorThatGoesWithThePowerOfEightAndIsWorseThanTheStepsOwn) {
  const OneStep coarse(0.4), fine(0.2);
  EXPECT_NEAR(Order(coarse.estimate, fine.estimate), 8.0, 1.0);
  for (const double h : {0.1, 0.2, 0.4, 0.8, 1.6}) {
    const OneStep step(h);
    EXPECT_GT(step.estimate, step.end) << h;
    EXPECT_LT(step.estimate, 1e3 * step.end) << h;
  }
}

TEST(Dop853, MeasuresItsErrorInUnitsOfTheScaleOfTheWorstComponent) {
  Dop853 step = StartedAt(0.3);
  const double both[2] = {1e-6, 1e-6}, half[2] = {5e-7, 5e-7}, no_first[2] = {1e9, 1e-6},
               no_second[2] = {1e-6, 1e9};
  const double error = step.Try(0.5, both, Smooth::Field);
  EXPECT_NEAR(step.Try(0.5, half, Smooth::Field), 2.0 * error, 1e-9 * error);
  const double second = step.Try(0.5, no_first, Smooth::Field);
  EXPECT_EQ(step.worst_component(), 1);
  const double first = step.Try(0.5, no_second, Smooth::Field);
  EXPECT_EQ(step.worst_component(), 0);
  EXPECT_LT(second, first);
  EXPECT_NEAR(error, first, 0.2 * first);
}

TEST(Dop853, NeverTakesAnErrorThatIsNoNumberForAGoodOne) {
  Dop853 step = StartedAt(0.0);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto field = [&](double t, const double* y, double* dy) {
      Smooth::Field(t, y, dy);
      if (t > 0.1) dy[1] = bad;
    };
    EXPECT_FALSE(step.Try(0.5, Smooth::kScale, field) <= 1.0);
    EXPECT_EQ(step.worst_component(), 1);
  }
}

TEST(Dop853, FindsNoErrorInAMotionThatStandsStill) {
  const auto still = [](double, const double*, double* dy) { dy[0] = dy[1] = 0.0; };
  Dop853 step;
  step.Resize(2);
  const double y[2] = {3.0, -4.0}, scale[2] = {1e-15, 1e-15};
  step.Start(1.0, y, still);
  EXPECT_EQ(step.Try(0.5, scale, still), 0.0);
  step.Accept(still);
  EXPECT_EQ(step.y()[0], 3.0);
  EXPECT_EQ(step.y()[1], -4.0);
}

TEST(Dop853, TriesAsOftenAsItIsAskedAndMovesOnOnlyWhenAStepIsAccepted) {
  Dop853 step = StartedAt(0.3);
  const auto start = Smooth::At(0.3);
  const double once = step.Try(0.4, Smooth::kScale, Smooth::Field);
  step.Try(2.0, Smooth::kScale, Smooth::Field);
  EXPECT_EQ(step.end_time(), 0.3);
  EXPECT_EQ(step.y()[0], start[0]);
  EXPECT_EQ(step.Try(0.4, Smooth::kScale, Smooth::Field), once);
  step.Accept(Smooth::Field);
  EXPECT_EQ(step.start_time(), 0.3);
  EXPECT_EQ(step.end_time(), 0.7);
  EXPECT_EQ(step.start_y()[0], start[0]);
  EXPECT_LE(Smooth::ErrorAt(0.7, step.y()), 1e-9);
  double dy[2];
  Smooth::Field(0.7, step.y(), dy);
  EXPECT_EQ(step.end_derivative()[0], dy[0]);
  EXPECT_EQ(step.end_derivative()[1], dy[1]);
  Smooth::Field(0.3, start.data(), dy);
  EXPECT_EQ(step.start_derivative()[0], dy[0]);
}

TEST(Dop853, EvaluatesTwelveTimesAStepAndThreeTimesMoreForItsInside) {
  int count = 0;
  const auto field = [&](double t, const double* y, double* dy) {
    ++count;
    Smooth::Field(t, y, dy);
  };
  Dop853 step;
  step.Resize(2);
  step.Start(0.0, Smooth::At(0.0).data(), field);
  EXPECT_EQ(count, 1);
  step.Try(0.1, Smooth::kScale, field);
  step.Accept(field);
  EXPECT_EQ(count, 13);
  step.MakeDense(field);
  EXPECT_EQ(count, 16);
  step.MakeDense(field);
  EXPECT_EQ(count, 16);
}

TEST(Dop853, JoinsTheInsidesOfItsStepsWithOneValueAndOneRate) {
  Dop853 step = StartedAt(0.0);
  const double d = 1e-5;
  for (int i = 0; i < 6; ++i) {
    Take(0.5 + 0.1 * i, &step);
    step.MakeDense(Smooth::Field);
    for (const bool is_start : {true, false}) {
      const double t = is_start ? step.start_time() : step.end_time();
      const double* y = is_start ? step.start_y() : step.y();
      const double* rate = is_start ? step.start_derivative() : step.end_derivative();
      double at[2], before[2], after[2];
      step.At(t, at);
      step.At(t - d, before);
      step.At(t + d, after);
      for (int c = 0; c < 2; ++c) {
        EXPECT_NEAR(at[c], y[c], 1e-14);
        EXPECT_NEAR((after[c] - before[c]) / (2.0 * d), rate[c], 1e-9);
      }
    }
  }
}

// The Arenstorf orbit: a small body about earth and moon, which closes after one period.
// [Hairer, Norsett, Wanner 1993, II.0, (0.1), (0.2)]
struct Orbit {
  static constexpr double kMoon = 0.012277471, kEarth = 1.0 - kMoon;
  static constexpr double kPeriod = 17.0652165601579625588917206249;
  static constexpr double kStart[4] = {0.994, 0.0, 0.0, -2.00158510637908252240537862224};

  static void Field(double, const double* y, double* dy) {
    const double to_earth = std::pow(std::hypot(y[0] + kMoon, y[1]), 3.0);
    const double to_moon = std::pow(std::hypot(y[0] - kEarth, y[1]), 3.0);
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] =
        y[0] + 2.0 * y[3] - kEarth * (y[0] + kMoon) / to_earth - kMoon * (y[0] - kEarth) / to_moon;
    dy[3] = y[1] - 2.0 * y[2] - kEarth * y[1] / to_earth - kMoon * y[1] / to_moon;
  }

  explicit Orbit(double tolerance) {
    const double scale[4] = {tolerance, tolerance, tolerance, tolerance};
    step.Resize(4);
    step.Start(0.0, kStart, Field);
    for (double h = 1e-3; step.end_time() < kPeriod;) {
      const double error = step.Try(std::min(h, kPeriod - step.end_time()), scale, Field);
      h *= std::min(3.0, 0.9 * std::pow(std::max(error, 1e-10), -0.125));
      if (!(error <= 1.0)) continue;
      step.Accept(Field);
      step.MakeDense(Field);
      Look();
    }
  }
  void Look() {
    for (; next <= 8 && 2.0 * next <= step.end_time(); ++next) {
      double y[4];
      step.At(2.0 * next, y);
      seen.push_back({y[0], y[1]});
    }
  }

  Dop853 step;
  int next = 1;
  std::vector<std::array<double, 2>> seen;  // at t = 2, 4, ... 16
};

TEST(Dop853, ClosesTheArenstorfOrbit) {
  const Orbit orbit(1e-13);
  EXPECT_NEAR(orbit.step.y()[0], Orbit::kStart[0], 1e-8);
  EXPECT_NEAR(orbit.step.y()[1], Orbit::kStart[1], 1e-8);
}

// As the book's program for DOPRI5 prints it, whose own error is some 1e-6 by then.
TEST(Dop853, PassesWhereTheArenstorfOrbitIsPublishedToPass) {
  constexpr double kPublished[8][2] = {
      {-0.5798781411, 0.6090775251},  {-0.1983335270, 1.137638086},  {-0.4735743943, 0.2239068118},
      {-1.174553350, -0.2759466982},  {-0.8398073466, 0.4468302268}, {0.01314712468, -0.8385751499},
      {-0.6031129504, -0.9912598031}, {0.2427110999, -0.3899948833}};
  const Orbit orbit(1e-12);
  ASSERT_EQ(orbit.seen.size(), 8u);
  for (int i = 0; i < 8; ++i) {
    EXPECT_NEAR(orbit.seen[i][0], kPublished[i][0], 1e-5) << i;
    EXPECT_NEAR(orbit.seen[i][1], kPublished[i][1], 1e-5) << i;
  }
}

TEST(Dop853, DoesTheSameBitsAgain) {
  const Orbit once(1e-10), again(1e-10);
  EXPECT_EQ(once.seen, again.seen);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(once.step.y()[c], again.step.y()[c]);
}

}  // namespace
}  // namespace hazumi::test
