// Runs of least acceleration and least jerk: what they minimise, how they join, and that they go on
// from any key with the same bits.

#include "engine/timeline/spline_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/timeline/curve_track.h"

namespace hazumi {
namespace {

constexpr FrameRate kFrameRate{30, 1};
constexpr Interpolation kOfAcceleration = Interpolation::kLeastAcceleration;
constexpr Interpolation kOfJerk = Interpolation::kLeastJerk;

Keys KeysOfRun(Interpolation kind) {
  Keys keys;
  const double frames[] = {0, 7, 12, 30, 33, 50}, values[] = {0.3, 1.2, -0.4, 0.1, 0.9, -1.0};
  for (int i = 0; i < 6; ++i) keys.push_back({frames[i], values[i], {}, kind});
  return keys;
}

// Derivatives of a track at a frame by its interval's polynomial: a difference within the interval.
double ThirdDerivative(CurveTrack* track, double frame, double h) {
  return (track->At(frame + h).acceleration - track->At(frame - h).acceleration) /
         (2.0 * kFrameRate.SecondsAt(h));
}

// Least acceleration is the natural cubic: C2, no acceleration at its ends.
TEST(SplineRun, OfLeastAccelerationIsTheNaturalCubic) {
  const Keys keys = KeysOfRun(kOfAcceleration);
  CurveTrack track(&keys, kFrameRate, 0.0, {});
  EXPECT_NEAR(track.At(0.0).acceleration, 0.0, 1e-9);
  EXPECT_NEAR(track.Before(50.0).acceleration, 0.0, 1e-9);
  for (size_t i = 1; i + 1 < keys.size(); ++i) {
    const CurveSample before = track.Before(keys[i].frame), after = track.At(keys[i].frame);
    EXPECT_NEAR(before.value, keys[i].value, 1e-12);
    EXPECT_NEAR(before.rate, after.rate, 1e-10);
    EXPECT_NEAR(before.acceleration, after.acceleration, 1e-7);
  }
}

// Least jerk is the quintic spline with free ends: C4, third and fourth derivative 0 at its ends.
TEST(SplineRun, OfLeastJerkHasFourSmoothDerivatives) {
  const Keys keys = KeysOfRun(kOfJerk);
  CurveTrack track(&keys, kFrameRate, 0.0, {});
  constexpr double h = 0.25;
  const auto jerk = [&](double frame) { return ThirdDerivative(&track, frame, h); };
  const auto size = std::abs(jerk(20.0)) + 1.0;
  for (size_t i = 1; i + 1 < keys.size(); ++i) {
    const double f = keys[i].frame;
    const CurveSample before = track.Before(f), after = track.At(f);
    EXPECT_NEAR(before.rate, after.rate, 1e-9);
    EXPECT_NEAR(before.acceleration, after.acceleration, 1e-7 * size);
    // A quintic's third derivative is a parabola: continued from either side to the key it is the
    // same, and so is its slope.
    const auto at_key = [&](double side) {
      const double a = jerk(f + side), b = jerk(f + 2.0 * side), c = jerk(f + 3.0 * side);
      return std::pair(3.0 * a - 3.0 * b + c, (-2.5 * a + 4.0 * b - 1.5 * c) / side);
    };
    const auto left = at_key(-0.5), right = at_key(0.5);
    EXPECT_NEAR(left.first, right.first, 0.02 * size) << f;
    EXPECT_NEAR(left.second, right.second, 0.2 * size) << f;
  }
}

// Integral of a squared derivative, by Simpson's rule within each interval.
double CostOf(const Keys& keys, bool jerk) {
  CurveTrack track(&keys, kFrameRate, 0.0, {});
  double sum = 0.0;
  for (size_t i = 0; i + 1 < keys.size(); ++i) {
    constexpr int kParts = 400;
    const double from = keys[i].frame, part = (keys[i + 1].frame - from) / kParts;
    for (int k = 0; k < kParts; ++k) {
      const double f = from + (k + 0.5) * part;
      const double value = jerk ? ThirdDerivative(&track, f, 0.4 * part) : track.At(f).acceleration;
      sum += value * value * kFrameRate.SecondsAt(part);
    }
  }
  return sum;
}

TEST(SplineRun, CostsLessThanAnyOtherRatesAtItsKeys) {
  Keys keys = KeysOfRun(kOfAcceleration);
  const double least = CostOf(keys, false);
  CurveTrack track(&keys, kFrameRate, 0.0, {});
  Keys stated = keys;
  for (Key& key : stated) key.rate = track.At(key.frame).rate;
  stated.back().rate = track.Before(stated.back().frame).rate;
  EXPECT_NEAR(CostOf(stated, false), least, 1e-6 * least);
  for (Key& key : stated) {
    for (const double by : {-0.3, 0.3}) {
      *key.rate += by;
      EXPECT_GT(CostOf(stated, false), least);
      *key.rate -= by;
    }
  }
  EXPECT_LT(CostOf(KeysOfRun(kOfJerk), true), CostOf(KeysOfRun(kOfAcceleration), true));
}

TEST(SplineRun, ThroughTwoKeysIsStraight) {
  for (const Interpolation kind : {kOfAcceleration, kOfJerk}) {
    const Keys keys = {{3.0, 1.0, {}, kind}, {9.0, 4.0, {}, kind}};
    CurveTrack track(&keys, kFrameRate, 0.0, {});
    EXPECT_NEAR(track.At(5.0).value, 2.0, 1e-9);
    EXPECT_NEAR(track.At(5.0).acceleration, 0.0, 1e-6);
  }
}

TEST(SplineRun, TakesStatedRatesAndTheTangentsOfItsNeighbours) {
  for (const Interpolation kind : {kOfAcceleration, kOfJerk}) {
    Keys keys = KeysOfRun(kind);
    keys[0].interpolation = Interpolation::kCubic;
    keys[2].rate = 5.0;
    keys[4].interpolation = Interpolation::kCubic;
    CurveTrack track(&keys, kFrameRate, 0.0, {});
    EXPECT_NEAR(track.Before(keys[2].frame).rate, 5.0, 1e-9);
    EXPECT_NEAR(track.At(keys[2].frame).rate, 5.0, 1e-9);
    for (const size_t i : {size_t{1}, size_t{4}}) {
      EXPECT_NEAR(track.Before(keys[i].frame).rate, track.At(keys[i].frame).rate, 1e-9) << i;
    }
  }
}

TEST(SplineRun, GoesOnFromAnyKeyWithTheSameBits) {
  for (const Interpolation kind : {kOfAcceleration, kOfJerk}) {
    const Keys keys = KeysOfRun(kind);
    CurveTrack whole(&keys, kFrameRate, 0.0, {});
    for (const double frame : {3.0, 9.0, 15.0, 31.0}) {
      CurveTrack again(&keys, kFrameRate, 0.0, {});
      again.Restart(whole.PieceAt(frame));
      for (double f = frame; f < 55.0; f += 0.7) {
        EXPECT_EQ(again.At(f).value, whole.At(f).value) << frame << " " << f;
        EXPECT_EQ(again.At(f).rate, whole.At(f).rate) << frame << " " << f;
      }
    }
  }
}

// A key that is added on the curve changes nothing: what is left is as good as before.
TEST(SplineRun, KeepsItsShapeWhereAKeyIsAddedOnIt) {
  for (const Interpolation kind : {kOfAcceleration, kOfJerk}) {
    Keys keys = KeysOfRun(kind);
    CurveTrack before(&keys, kFrameRate, 0.0, {});
    Keys more = keys;
    more.insert(more.begin() + 3, {20.0, before.At(20.0).value, {}, kind});
    CurveTrack after(&more, kFrameRate, 0.0, {});
    for (double f = 0.0; f < 50.0; f += 1.3) {
      EXPECT_NEAR(after.At(f).value, before.At(f).value, 1e-8) << f;
    }
  }
}

TEST(SplineRun, EndsFreeWhereSomethingTakesOver) {
  const Keys keys = KeysOfRun(kOfAcceleration);
  CurveTrack track(&keys, kFrameRate, 0.0, {12.0});
  EXPECT_NEAR(track.Before(12.0).acceleration, 0.0, 1e-9);
  track.Resume(20.0, 0.5, 1.0);
  EXPECT_NEAR(track.At(20.0).rate, 1.0, 1e-12);
  EXPECT_NEAR(track.Before(30.0).rate, track.At(30.0).rate, 1e-9);
}

}  // namespace
}  // namespace hazumi
