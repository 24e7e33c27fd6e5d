// A clip at another frame rate is the same motion.

#include "engine/exchange/character/resampled.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hazumi::test {
namespace {

// Along x with 2 m/s and about z with 0.9 rad/s, at rest in scale.
Clip Steady(double rate, int num_frames) {
  Clip clip{"steady", 1.0 / rate, num_frames, {}};
  BoneTrack& track = clip.tracks.emplace_back();
  for (int frame = 0; frame < num_frames; ++frame) {
    const double t = frame / rate;
    track.translations.push_back(Vec3(2.0 * t, 0.0, 1.0));
    track.rotations.emplace_back(Eigen::AngleAxisd(0.9 * t, Vec3::UnitZ()));
    track.angles.push_back(Vec3(0.9 * t, 0.0, 0.0));
  }
  return clip;
}

TEST(Resample, SteadyMotionIsTheSameAtAnyRate) {
  for (const double rate : {12.0, 23.976, 25.0, 30.0, 72.0, 144.0}) {
    SCOPED_TRACE(rate);
    Clip clip = Steady(30.0, 61);
    Resample(rate, &clip);
    const BoneTrack& track = clip.tracks[0];
    EXPECT_NEAR((clip.num_frames - 1) * clip.seconds_per_frame, 2.0, 1.0 / rate);
    EXPECT_GE((clip.num_frames - 1) * clip.seconds_per_frame, 2.0 - 0.03 / rate);
    ASSERT_EQ(track.translations.size(), static_cast<size_t>(clip.num_frames));
    ASSERT_EQ(track.rotations.size(), track.translations.size());
    EXPECT_TRUE(track.scales.empty());
    for (size_t f = 0; f < track.translations.size(); ++f) {
      const double t = std::min(static_cast<double>(f) / rate, 2.0);
      EXPECT_NEAR(track.translations[f].x(), 2.0 * t, 1e-12);
      EXPECT_NEAR(track.rotations[f].angularDistance(
                      Eigen::Quaterniond(Eigen::AngleAxisd(0.9 * t, Vec3::UnitZ()))),
                  0.0, 1e-7);
    }
  }
}

TEST(Resample, TheSameRateChangesNothing) {
  Clip clip = Steady(30.0, 61);
  Resample(30.0, &clip);
  EXPECT_EQ(clip.num_frames, 61);
  EXPECT_EQ(clip.tracks[0].angles.size(), 61u);
}

TEST(Resample, AClipOfOneFrameStaysOne) {
  Clip clip = Steady(30.0, 1);
  Resample(72.0, &clip);
  EXPECT_EQ(clip.num_frames, 1);
  EXPECT_EQ(clip.tracks[0].rotations.size(), 1u);
}

}  // namespace
}  // namespace hazumi::test
