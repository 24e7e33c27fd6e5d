#include "ui/panels/playback.h"

#include <gtest/gtest.h>

namespace hazumi::test {
namespace {

using ui::Playback;

TEST(Playback, ShowsTheFrameThatBelongsToTheTime) {
  Playback playback;
  playback.Start(100.0, 5, 0, 9, 30.0);
  EXPECT_EQ(playback.FrameAt(100.0), 5);
  EXPECT_EQ(playback.FrameAt(100.0 + 0.9 / 30.0), 5);
  EXPECT_EQ(playback.FrameAt(100.0 + 1.1 / 30.0), 6);
  EXPECT_NEAR(playback.NextFrameTime(100.0 + 1.1 / 30.0), 100.0 + 2.0 / 30.0, 1e-9);
}

TEST(Playback, BeginsAgainAfterTheLastFrame) {
  Playback playback;
  playback.Start(0.0, 8, 2, 9, 10.0);
  EXPECT_EQ(playback.FrameAt(0.15), 9);
  EXPECT_EQ(playback.FrameAt(0.25), 2);
  EXPECT_EQ(playback.FrameAt(0.25 + 0.8), 2);
}

TEST(Playback, TellsHowManyFramesItReallyShowed) {
  Playback playback;
  playback.Start(0.0, 0, 0, 99, 30.0);
  for (int i = 0; i <= 30; ++i) playback.CountFrame(i / 15.0, playback.FrameAt(i / 15.0));
  EXPECT_NEAR(playback.shown_rate(), 15.0, 1.0);
  EXPECT_NEAR(playback.dropped(), 30, 1);
}

TEST(Playback, AFrameDrawnTwiceIsOneFrame) {
  Playback playback;
  playback.Start(0.0, 0, 0, 99, 30.0);
  for (int i = 0; i <= 120; ++i) playback.CountFrame(i / 60.0, playback.FrameAt(i / 60.0));
  EXPECT_NEAR(playback.shown_rate(), 30.0, 1.0);
  EXPECT_EQ(playback.dropped(), 0);
}

}  // namespace
}  // namespace hazumi::test
