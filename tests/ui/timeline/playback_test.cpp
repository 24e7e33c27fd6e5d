#include "ui/panels/timeline/playback.h"

#include <gtest/gtest.h>

namespace hazumi::test {
namespace {

using ui::Playback;

TEST(Playback, ShowsTheFrameThatBelongsToTheTime) {
  Playback playback;
  playback.Start(100.0, 5, 0, 9, 30.0);
  EXPECT_EQ(playback.Advance(100.0), 5);
  EXPECT_EQ(playback.Advance(100.0 + 0.9 / 30.0), 5);
  EXPECT_EQ(playback.Advance(100.0 + 1.1 / 30.0), 6);
  EXPECT_NEAR(playback.NextFrameTime(), 100.0 + 2.0 / 30.0, 1e-9);
}

TEST(Playback, BeginsAgainAfterTheLastFrame) {
  Playback playback;
  playback.Start(0.0, 8, 2, 9, 10.0);
  EXPECT_EQ(playback.Advance(0.15), 9);
  EXPECT_EQ(playback.Advance(0.25), 2);
  EXPECT_EQ(playback.Advance(0.25 + 0.8), 2);
}

TEST(Playback, ALateFrameIsShownAndTheNextOnesCatchUp) {
  Playback playback;
  playback.Start(0.0, 0, 0, 99, 10.0);
  playback.CountFrame(0.1, playback.Advance(0.1));
  EXPECT_EQ(playback.Advance(0.45), 2);  // 4 is due
  EXPECT_NEAR(playback.due(), 0.2, 1e-9);
  playback.CountFrame(0.45, 2);
  EXPECT_LT(playback.NextFrameTime(), 0.45);
  EXPECT_EQ(playback.Advance(0.46), 3);
  EXPECT_EQ(playback.Advance(0.47), 4);
  EXPECT_EQ(playback.Advance(0.48), 4);
  EXPECT_EQ(playback.dropped(), 0);
}

TEST(Playback, WhatIsTooFarBehindIsPassedOver) {
  Playback playback;
  playback.Start(0.0, 0, 0, 99, 10.0);
  playback.CountFrame(0.1, playback.Advance(0.1));
  playback.CountFrame(1.15, playback.Advance(1.15));
  EXPECT_EQ(playback.dropped(), 9);
}

TEST(Playback, TellsHowManyFramesItReallyShowed) {
  Playback playback;
  playback.Start(0.0, 0, 0, 99, 30.0);
  for (int i = 0; i <= 50; ++i) playback.CountFrame(i / 15.0, playback.Advance(i / 15.0));
  EXPECT_NEAR(playback.shown_rate(), 15.0, 1.0);
  EXPECT_NEAR(playback.dropped(), 50, 5);
}

TEST(Playback, AFrameDrawnTwiceIsOneFrame) {
  Playback playback;
  playback.Start(0.0, 0, 0, 99, 30.0);
  for (int i = 0; i <= 120; ++i) playback.CountFrame(i / 60.0, playback.Advance(i / 60.0));
  EXPECT_NEAR(playback.shown_rate(), 30.0, 1.0);
  EXPECT_EQ(playback.dropped(), 0);
}

}  // namespace
}  // namespace hazumi::test
