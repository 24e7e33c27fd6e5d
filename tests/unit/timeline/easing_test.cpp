#include <gtest/gtest.h>

#include <cmath>

#include "engine/timeline/curve_track.h"
#include "engine/timeline/interval.h"

namespace hazumi {
namespace {

constexpr Interpolation kKinds[] = {Interpolation::kSine,        Interpolation::kQuintic,
                                    Interpolation::kExponential, Interpolation::kBack,
                                    Interpolation::kBounce,      Interpolation::kElastic};
constexpr Easing kEasings[] = {Easing::kIn, Easing::kOut, Easing::kInOut};

template <typename Check>
void ForEachWay(Check check) {
  for (const Interpolation kind : kKinds) {
    for (const Easing easing : kEasings) {
      SCOPED_TRACE(std::to_string(static_cast<int>(kind)) + " " +
                   std::to_string(static_cast<int>(easing)));
      check(kind, easing);
    }
  }
}

TEST(Easing, LeadsFromNoughtToOneWithoutAJump) {
  ForEachWay([](Interpolation kind, Easing easing) {
    EXPECT_EQ(Ease(kind, easing, 0.0).value, 0.0);
    EXPECT_EQ(Ease(kind, easing, 1.0).value, 1.0);
    EXPECT_NEAR(Ease(kind, easing, 1e-9).value, 0.0, 1e-6);
    EXPECT_NEAR(Ease(kind, easing, 1.0 - 1e-9).value, 1.0, 1e-6);
    for (double u = 0.0; u < 1.0; u = SmoothUntil(kind, easing, u)) {
      EXPECT_NEAR(Ease(kind, easing, u - 1e-10).value, Ease(kind, easing, u + 1e-10).value, 1e-7);
    }
  });
}

// Central differences inside smooth stretches.
TEST(Easing, DerivativesAreThoseOfTheValue) {
  constexpr double h = 1e-5;
  ForEachWay([](Interpolation kind, Easing easing) {
    for (int i = 1; i < 400; ++i) {
      const double u = i / 400.0 + 1.3e-4;
      if (SmoothUntil(kind, easing, u - h) < u + h) continue;
      const Eased at = Ease(kind, easing, u);
      const double before = Ease(kind, easing, u - h).value,
                   after = Ease(kind, easing, u + h).value;
      EXPECT_NEAR(at.slope, (after - before) / (2.0 * h), 1e-5) << u;
      EXPECT_NEAR(at.curvature, (after - 2.0 * at.value + before) / (h * h), 2e-3) << u;
    }
  });
}

TEST(Easing, SlowInMeansSlowBeginningAndOutIsItsMirror) {
  ForEachWay([](Interpolation kind, Easing) {
    for (const double u : {0.1, 0.3, 0.5, 0.77, 0.9}) {
      const Eased in = Ease(kind, Easing::kIn, u), out = Ease(kind, Easing::kOut, 1.0 - u);
      EXPECT_NEAR(in.value, 1.0 - out.value, 1e-12) << u;
    }
    EXPECT_LT(std::abs(Ease(kind, Easing::kIn, 0.25).value), 0.25);
  });
}

// It touches the end at 1/2.75, 2/2.75 and 2.5/2.75 of the way.
TEST(Easing, ABounceTouchesTheGroundFourTimes) {
  int touches = 0;
  double u = 0.0;
  while (u < 1.0) {
    u = SmoothUntil(Interpolation::kBounce, Easing::kOut, u);
    EXPECT_NEAR(Ease(Interpolation::kBounce, Easing::kOut, u).value, 1.0, 1e-12) << u;
    ++touches;
  }
  EXPECT_EQ(touches, 4);
}

TEST(Interval, AnEasedOneMeetsBothValues) {
  ForEachWay([](Interpolation kind, Easing easing) {
    const Interval interval = Interval::Eased(0.3, -1.7, 0.4, kind, easing);
    EXPECT_EQ(interval.At(0.0).value, 0.3);
    EXPECT_EQ(interval.At(0.4).value, -1.7);
    constexpr double s = 0.231, h = 1e-6;
    const double slope = (interval.At(s + h).value - interval.At(s - h).value) / (2.0 * h);
    EXPECT_NEAR(interval.At(s).rate, slope, 1e-5);
  });
}

TEST(Interval, TangentsOfAThirdAreTheCubic) {
  constexpr double kThird = 1.0 / 3.0;
  const Interval cubic = Interval::Cubic(0.2, 1.5, -0.9, 3.0, 0.7);
  const Interval weighted = Interval::Weighted(0.2, 1.5, kThird, -0.9, 3.0, kThird, 0.7);
  for (double s = 0.0; s <= 0.7; s += 0.07) {
    EXPECT_NEAR(weighted.At(s).value, cubic.At(s).value, 1e-13);
    EXPECT_NEAR(weighted.At(s).rate, cubic.At(s).rate, 1e-11);
    EXPECT_NEAR(weighted.At(s).acceleration, cubic.At(s).acceleration, 1e-9);
  }
}

TEST(Interval, LongAndShortTangentsKeepBothValuesAndRates) {
  for (const double a : {0.05, 0.3, 0.9}) {
    for (const double b : {0.05, 0.6, 0.9}) {
      const Interval interval = Interval::Weighted(0.2, 1.5, a, -0.9, 3.0, b, 0.7);
      EXPECT_NEAR(interval.At(0.0).value, 0.2, 1e-14);
      EXPECT_NEAR(interval.At(0.7).value, -0.9, 1e-14);
      EXPECT_NEAR(interval.At(0.0).rate, 1.5, 1e-12);
      EXPECT_NEAR(interval.At(0.7).rate, 3.0, 1e-12);
      for (double s = 0.05; s < 0.7; s += 0.05) {
        constexpr double h = 1e-6;
        const double slope = (interval.At(s + h).value - interval.At(s - h).value) / (2.0 * h);
        EXPECT_NEAR(interval.At(s).rate, slope, 1e-4 * (1.0 + std::abs(slope)));
        const double bend = (interval.At(s + h).rate - interval.At(s - h).rate) / (2.0 * h);
        EXPECT_NEAR(interval.At(s).acceleration, bend, 1e-4 * (1.0 + std::abs(bend)));
      }
    }
  }
}

Key At(double frame, double value) {
  Key key;
  key.frame = frame;
  key.value = value;
  return key;
}

TEST(CurveTrack, ABrokenKeyArrivesWithOneRateAndLeavesWithAnother) {
  Keys keys = {At(0.0, 0.0), At(10.0, 1.0), At(20.0, 0.0)};
  keys[1].rate_in = 4.0;
  keys[1].rate = -2.0;
  CurveTrack track(&keys, {30, 1}, 0.0, {});
  EXPECT_NEAR(track.Before(10.0).rate, 4.0, 1e-12);
  EXPECT_NEAR(track.At(10.0).rate, -2.0, 1e-12);
  EXPECT_NEAR(track.Before(10.0).value, track.At(10.0).value, 1e-14);
}

// The cubic after an eased interval goes on as fast as that ended.
TEST(CurveTrack, GoesOnFromAnEasedIntervalWithTheRateItEndsWith) {
  Keys keys = {At(0.0, 0.0), At(10.0, 1.0), At(20.0, 5.0)};
  keys[0].interpolation = Interpolation::kSine;
  keys[0].easing = Easing::kIn;
  CurveTrack track(&keys, {30, 1}, 0.0, {});
  const double end = 0.5 * std::acos(-1.0) / (10.0 / 30.0);
  EXPECT_NEAR(track.Before(10.0).rate, end, 1e-12);
  EXPECT_NEAR(track.At(10.0).rate, end, 1e-12);
}

// A region that has let go knows nothing of the tangents' lengths.
TEST(CurveTrack, LengthsCountBetweenTwoKeysAlone) {
  Keys keys = {At(0.0, 0.0), At(10.0, 1.0), At(20.0, 0.0)};
  keys[2].length_in = 0.8;
  CurveTrack track(&keys, {30, 1}, 0.0, {});
  EXPECT_FALSE(track.PieceAt(12.0).interval.is_polynomial());
  track.Resume(11.0, 1.0, 2.0);
  EXPECT_TRUE(track.PieceAt(12.0).interval.is_polynomial());
}

}  // namespace
}  // namespace hazumi
