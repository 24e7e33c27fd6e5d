#include <gtest/gtest.h>

#include "engine/timeline/curve_track.h"

namespace hazumi {
namespace {

const FrameRate kThirty = {30, 1};

TEST(CurveRange, OfOneKeyIsItsValue) {
  const CurveRange range = RangeOf({{7, 2.5, {}}}, kThirty);
  EXPECT_EQ(range.least, 2.5);
  EXPECT_EQ(range.greatest, 2.5);
}

// 3 s^2 - 2 s^3 from 1 to 2 stays between them.
TEST(CurveRange, OfAFlatCubicIsThatOfItsKeys) {
  const CurveRange range = RangeOf({{0, 1.0, 0.0}, {30, 2.0, 0.0}}, kThirty);
  EXPECT_EQ(range.least, 1.0);
  EXPECT_EQ(range.greatest, 2.0);
}

// s (1 - s) (1 - 2 s) has its extremes at (1 -+ 1 / sqrt 3) / 2, of 1 / (6 sqrt 3).
TEST(CurveRange, HasWhatLiesBetweenKeys) {
  const CurveRange range = RangeOf({{0, 0.0, 1.0}, {30, 0.0, 1.0}}, kThirty);
  EXPECT_NEAR(range.greatest, 0.0962250448649376, 1e-12);
  EXPECT_NEAR(range.least, -0.0962250448649376, 1e-12);
  EXPECT_NEAR(range.frame_of_greatest, 30 * 0.21132486540518713, 1e-5);
  EXPECT_NEAR(range.frame_of_least, 30 * 0.7886751345948129, 1e-5);
}

TEST(CurveRange, HasAnEasedCurvesOvershoot) {
  Key key;
  key.interpolation = Interpolation::kBack;  // from 0 on frame 0
  key.easing = Easing::kOut;
  EXPECT_GT(RangeOf({key, {30, 1.0, {}}}, kThirty).greatest, 1.05);
}

}  // namespace
}  // namespace hazumi
