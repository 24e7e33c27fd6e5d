#include "engine/timeline/curve_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hazumi {
namespace {

constexpr FrameRate kRate{30, 1};
constexpr Interpolation kHold = Interpolation::kHold;
constexpr Interpolation kLinear = Interpolation::kLinear;
constexpr Interpolation kQuadratic = Interpolation::kQuadratic;
constexpr Interpolation kCubic = Interpolation::kCubic;

CurveTrack Track(const Keys& keys, std::vector<double> takeovers = {}) {
  return CurveTrack(&keys, kRate, 0.25, std::move(takeovers));
}

double Slope(const Key& a, const Key& b) {
  return (b.value - a.value) / kRate.SecondsAt(b.frame - a.frame);
}

void ExpectContinuous(CurveTrack* track, double frame) {
  const CurveSample left = track->Before(frame), right = track->At(frame);
  EXPECT_NEAR(left.value, right.value, 1e-12) << "frame " << frame;
  EXPECT_NEAR(left.rate, right.rate, 1e-11) << "frame " << frame;
}

TEST(CurveTrack, WithoutKeysIsTheDefaultAtRest) {
  const Keys keys;
  CurveTrack track = Track(keys);
  EXPECT_EQ(track.At(-3.0).value, 0.25);
  EXPECT_EQ(track.Before(7.5).value, 0.25);
  EXPECT_EQ(track.At(7.5).rate, 0.0);
}

TEST(CurveTrack, IsConstantBeforeTheFirstAndAfterTheLastKey) {
  const Keys keys = {{2.0, 1.0, 5.0, kCubic}, {4.0, 2.0, 3.0, kCubic}};
  CurveTrack track = Track(keys);
  EXPECT_EQ(track.At(1.5).value, 1.0);
  EXPECT_EQ(track.Before(2.0).rate, 0.0);
  EXPECT_EQ(track.At(2.0).rate, 5.0);
  EXPECT_NEAR(track.Before(4.0).rate, 3.0, 1e-12);
  EXPECT_EQ(track.At(4.0).rate, 0.0);
  EXPECT_EQ(track.At(9.0).value, 2.0);
}

TEST(CurveTrack, FirstKeyWithoutARateStartsAtZero) {
  for (const Interpolation kind : {kQuadratic, kCubic}) {
    const Keys keys = {{3.0, 1.0, {}, kind}, {6.0, 2.0, {}, kCubic}};
    CurveTrack track = Track(keys);
    EXPECT_EQ(track.At(3.0).rate, 0.0);
  }
}

TEST(CurveTrack, ChainOfQuadraticsPassesItsArrivalRateOn) {
  const Keys keys = {{0.0, 0.0, {}, kQuadratic},
                     {4.0, 0.3, {}, kQuadratic},
                     {10.0, -0.2, {}, kQuadratic},
                     {11.5, 0.1, {}, kQuadratic}};
  CurveTrack track = Track(keys);
  double rate = 0.0;
  for (size_t k = 0; k + 1 < keys.size(); ++k) {
    EXPECT_NEAR(track.At(keys[k].frame).rate, rate, 1e-12);
    rate = 2.0 * Slope(keys[k], keys[k + 1]) - rate;
    EXPECT_NEAR(track.Before(keys[k + 1].frame).rate, rate, 1e-12);
  }
}

TEST(CurveTrack, IntervalStartsWithItsLeftKeysRateIfGiven) {
  for (const Interpolation before : {kHold, kLinear, kQuadratic}) {
    for (const Interpolation kind : {kQuadratic, kCubic}) {
      const Keys keys = {{0.0, 0.0, {}, before}, {5.0, 1.0, -2.5, kind}, {9.0, 0.0, {}, kCubic}};
      CurveTrack track = Track(keys);
      EXPECT_EQ(track.At(5.0).rate, -2.5);
    }
  }
}

TEST(CurveTrack, IntervalStartsWithTheRateAtWhichTheOneBeforeEnded) {
  const double slope = 1.0 * 30.0 / 5.0;
  const std::pair<Interpolation, double> cases[] = {
      {kHold, 0.0}, {kLinear, slope}, {kQuadratic, 2.0 * slope}};
  for (const auto& [before, rate] : cases) {
    for (const Interpolation kind : {kQuadratic, kCubic}) {
      const Keys keys = {{0.0, 0.0, {}, before}, {5.0, 1.0, {}, kind}, {9.0, 3.0, {}, kCubic}};
      CurveTrack track = Track(keys);
      EXPECT_NEAR(track.At(5.0).rate, rate, 1e-12);
    }
  }
}

TEST(CurveTrack, HoldStaysUntilTheNextKeyAndJumpsThere) {
  const Keys keys = {{0.0, 0.5, {}, kHold}, {5.0, 1.0, {}, kCubic}};
  CurveTrack track = Track(keys);
  EXPECT_EQ(track.Before(5.0).value, 0.5);
  EXPECT_EQ(track.At(5.0).value, 1.0);
}

TEST(CurveTrack, AutomaticTangentsAreContinuousFlatAtExtremesAndAtTheLastKey) {
  const Keys keys = {{0.0, 0.0, {}, kCubic},
                     {4.0, 1.0, {}, kCubic},
                     {6.0, 1.5, {}, kCubic},
                     {9.0, 0.2, {}, kCubic},
                     {12.0, 0.9, {}, kCubic}};
  CurveTrack track = Track(keys);
  for (const Key& key : keys) ExpectContinuous(&track, key.frame);
  EXPECT_GT(track.At(4.0).rate, 0.0);
  for (const double frame : {6.0, 9.0, 12.0}) EXPECT_NEAR(track.At(frame).rate, 0.0, 1e-12);
}

TEST(CurveTrack, AutomaticTangentsDoNotOvershootTheKeys) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1.0, 1.0), gap(0.3, 4.0);
  Keys keys;
  double frame = 0.0;
  for (int k = 0; k < 100; ++k) keys.push_back({frame += gap(random), value(random), {}, kCubic});
  CurveTrack track = Track(keys);
  for (size_t k = 0; k + 1 < keys.size(); ++k) {
    const auto [low, high] = std::minmax(keys[k].value, keys[k + 1].value);
    for (int s = 0; s <= 20; ++s) {
      const double u = s / 20.0;
      const double v = track.At(keys[k].frame * (1.0 - u) + keys[k + 1].frame * u).value;
      EXPECT_TRUE(low - 1e-12 <= v && v <= high + 1e-12) << "after key " << k;
    }
  }
}

TEST(CurveTrack, CubicArrivesWithTheRightKeysRateIfGiven) {
  const Keys keys = {{0.0, 0.0, {}, kCubic}, {5.0, 1.0, 4.0, kCubic}, {9.0, 0.0, -1.0, kCubic}};
  CurveTrack track = Track(keys);
  EXPECT_NEAR(track.Before(5.0).rate, 4.0, 1e-12);
  EXPECT_NEAR(track.Before(9.0).rate, -1.0, 1e-12);
}

TEST(CurveTrack, KeysMayLieBetweenFrames) {
  const Keys keys = {{0.5, 0.0, {}, kLinear}, {2.75, 1.0, {}, kLinear}, {3.0, 0.0, {}, kLinear}};
  CurveTrack track = Track(keys);
  EXPECT_NEAR(track.At(2.0).value, 1.5 / 2.25, 1e-13);
  EXPECT_NEAR(track.At(2.9).value, 0.4, 1e-12);
  EXPECT_EQ(track.KeyAt(2.0), nullptr);
  EXPECT_EQ(track.KeyAt(2.75), &keys[1]);
}

TEST(CurveTrack, MayBeAskedInAnyOrder) {
  const Keys keys = {{0.0, 0.0, {}, kCubic}, {5.0, 1.0, {}, kQuadratic}, {9.0, 0.5, {}, kCubic}};
  CurveTrack forward = Track(keys), backward = Track(keys);
  std::vector<double> values;
  for (int f = 0; f <= 20; ++f) values.push_back(forward.At(f * 0.5).value);
  for (int f = 20; f >= 0; --f) EXPECT_EQ(backward.At(f * 0.5).value, values[f]);
}

TEST(CurveTrack, ResumesWithACubicFromAngleAndRateWhateverTheKeysKind) {
  for (const Interpolation kind : {kHold, kLinear, kQuadratic, kCubic}) {
    const Keys keys = {{0.0, 0.0, {}, kind}, {5.0, 1.0, 7.0, kind}, {9.0, 3.0, {}, kCubic}};
    CurveTrack track = Track(keys);
    track.Resume(5.0, -0.5, 2.0);
    EXPECT_EQ(track.At(5.0).value, -0.5);
    EXPECT_EQ(track.At(5.0).rate, 2.0);
    EXPECT_NEAR(track.Before(9.0).value, 3.0, 1e-12);
    EXPECT_NEAR(track.Before(9.0).rate, 0.0, 1e-11);
  }
}

TEST(CurveTrack, ResumesWithTheKindOfTheKeyLyingThereIfAsked) {
  const Keys keys = {{0.0, 0.0, {}, kCubic}, {5.0, 1.0, {}, kLinear}, {9.0, 3.0, {}, kCubic}};
  CurveTrack track = Track(keys);
  track.Resume(5.0, -0.5, 2.0, /*as_keyed=*/true);
  EXPECT_NEAR(track.At(5.0).rate, 3.5 * 30.0 / 4.0, 1e-12);
  track.Resume(6.0, -0.5, 2.0, /*as_keyed=*/true);  // no key there: cubic
  EXPECT_EQ(track.At(6.0).rate, 2.0);
}

TEST(CurveTrack, StaysWhereItResumedAfterTheLastKey) {
  const Keys keys = {{0.0, 0.0, {}, kCubic}, {5.0, 1.0, {}, kCubic}};
  CurveTrack track = Track(keys);
  track.Resume(7.0, -0.5, 2.0);
  EXPECT_EQ(track.At(30.0).value, -0.5);
  EXPECT_EQ(track.At(30.0).rate, 0.0);
}

TEST(CurveTrack, ResumingForgetsKeysUpToThereAndWhatWasPlanned) {
  const Keys keys = {{0.0, 0.0, {}, kCubic},
                     {5.0, 1.0, {}, kCubic},
                     {8.0, 2.0, {}, kCubic},
                     {12.0, 0.0, {}, kCubic}};
  CurveTrack track = Track(keys);
  track.At(20.0);
  track.Resume(6.0, 0.1, 0.2);
  EXPECT_EQ(track.At(6.0).value, 0.1);
  EXPECT_NEAR(track.Before(8.0).value, 2.0, 1e-12);
  track.Resume(8.0, 0.3, 0.4);
  EXPECT_EQ(track.At(8.0).value, 0.3);
  EXPECT_NEAR(track.Before(12.0).value, 0.0, 1e-12);
}

TEST(CurveTrack, GoesIntoATakeoverOnAParabola) {
  const Keys keys = {{0.0, 0.0, {}, kCubic}, {5.0, 1.0, {}, kCubic}, {9.0, 0.0, {}, kCubic}};
  CurveTrack track = Track(keys, {5.0});
  EXPECT_NEAR(track.Before(5.0).rate, 2.0 * 30.0 / 5.0, 1e-12);
  EXPECT_NEAR(track.At(2.0).acceleration, track.At(4.0).acceleration, 1e-10);
}

TEST(CurveTrack, KeysBeyondATakeoverDoNotMatter) {
  Keys keys = {{0.0, 0.0, {}, kCubic},
               {5.0, 1.0, {}, kCubic},
               {9.0, 0.5, {}, kCubic},
               {15.0, 0.2, {}, kLinear},
               {20.0, 0.7, {}, kCubic}};
  CurveTrack track = Track(keys, {5.0});
  Keys other = keys;
  other[2].value = 77.0;
  other[3].rate = 5.0;
  other[3].interpolation = kHold;
  CurveTrack changed = Track(other, {5.0});
  for (double f = 0.0; f <= 4.9; f += 0.1) EXPECT_EQ(track.At(f).value, changed.At(f).value);
  track.Resume(15.0, 0.9, -1.0);
  changed.Resume(15.0, 0.9, -1.0);
  for (double f = 15.0; f <= 25.0; f += 0.1) EXPECT_EQ(track.At(f).value, changed.At(f).value);
}

// A key on every frame, with the error of a measurement.
Keys Recording(int frames, double noise) {
  std::mt19937 random(7);
  std::normal_distribution<double> error(0.0, 1.0);
  Keys keys;
  for (int f = 0; f <= frames; ++f) {
    keys.push_back(
        {static_cast<double>(f), std::sin(0.21 * f) + noise * error(random), {}, kCubic});
  }
  return keys;
}

TEST(CurveTrack, GoesIntoATakeoverOfARecordingAtItsCentralDifference) {
  for (const double noise : {0.0, 1e-3}) {
    const Keys keys = Recording(60, noise);
    for (int f = 2; f < 60; ++f) {
      CurveTrack track = Track(keys, {static_cast<double>(f)});
      const double central = 15.0 * (keys[f + 1].value - keys[f - 1].value);
      EXPECT_NEAR(track.Before(f).rate, central, 1e-9) << "frame " << f;
    }
  }
}

// Of a recording only the next key counts, of other keys none.
TEST(CurveTrack, KeysBeyondATakeoverOfARecordingDoNotMatterButForTheNext) {
  const Keys keys = Recording(20, 0.0);
  Keys changed = keys, sparse = keys;
  changed[12].value += 0.5;
  sparse.erase(sparse.begin() + 11);
  CurveTrack track = Track(keys, {10.0}), other = Track(changed, {10.0});
  EXPECT_EQ(track.Before(10.0).rate, other.Before(10.0).rate);
  CurveTrack parabola = Track(sparse, {10.0});
  EXPECT_NEAR(parabola.Before(10.0).rate, 2.0 * Slope(keys[9], keys[10]) - parabola.At(9.0).rate,
              1e-12);
}

TEST(CurveTrack, BlendsIntoItsKeysAndIsThereAsIfNothingHadBeen) {
  const Keys keys = Recording(40, 1e-3);
  for (const double until : {14.0, 13.5, 10.5}) {
    CurveTrack clip = Track(keys), track = Track(keys);
    track.Blend(10.0, 0.2, -3.0, until);
    EXPECT_EQ(track.At(10.0).value, 0.2);
    EXPECT_EQ(track.At(10.0).rate, -3.0);
    const double target = std::ceil(until);
    ExpectContinuous(&track, target);
    EXPECT_EQ(track.PieceAt(10.0).last_frame, target);
    for (double f = target; f <= 42.0; f += 0.25) {
      EXPECT_NEAR(track.At(f).value, clip.At(f).value, 1e-12) << "frame " << f;
      EXPECT_NEAR(track.At(f).rate, clip.At(f).rate, 1e-9) << "frame " << f;
    }
  }
}

TEST(CurveTrack, BlendThatKeysDoNotReachEndsWhereTheyRest) {
  const Keys keys = {{0.0, 0.0, {}, kCubic},
                     {5.0, 1.0, {}, kCubic},
                     {8.0, 2.0, {}, kCubic},
                     {12.0, 3.0, {}, kCubic}};
  CurveTrack track = Track(keys);
  track.Blend(6.0, 0.1, 0.2, 20.0);
  EXPECT_EQ(track.PieceAt(6.0).last_frame, 20.0);
  ExpectContinuous(&track, 20.0);
  EXPECT_EQ(track.At(30.0).value, 3.0);
  track.Blend(14.0, 0.7, 0.2, 20.5);  // begins behind the last key
  EXPECT_EQ(track.At(14.0).value, 0.7);
  ExpectContinuous(&track, 20.5);
  EXPECT_EQ(track.At(30.0).value, 3.0);
  const Keys none;
  CurveTrack still = Track(none);
  still.Blend(3.0, 0.7, 0.2, 5.0);
  ExpectContinuous(&still, 5.0);
  EXPECT_EQ(still.At(9.0).value, 0.25);
}

}  // namespace
}  // namespace hazumi
