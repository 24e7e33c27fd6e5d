#include "engine/media/peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hazumi {
namespace {

TEST(Peaks, AreTheLowestAndTheHighestSampleOfAnyStretch) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> level(-32768, 32767);
  Sound sound{{1000, 1}, {}};
  for (int i = 0; i < 777; ++i) sound.samples.push_back(static_cast<std::int16_t>(level(random)));
  const Peaks peaks(sound);
  EXPECT_EQ(peaks.seconds(), 0.777);
  std::uniform_int_distribution<int> place(0, 776);
  for (int i = 0; i < 1000; ++i) {
    const auto [first, last] = std::minmax({place(random), place(random)});
    const auto [low, high] =
        std::minmax_element(sound.samples.begin() + first, sound.samples.begin() + last + 1);
    // Half a sample inside, so that rounding of the seconds takes in no neighbour.
    const Peaks::Range wanted = {static_cast<float>(*low) / 32768.0f,
                                 static_cast<float>(*high) / 32768.0f};
    EXPECT_EQ(peaks.In((first + 0.5) / 1000.0, (last + 0.5) / 1000.0), wanted)
        << first << " " << last;
  }
}

TEST(Peaks, AreOfTheFirstChannelAndSilentOutsideOfTheSound) {
  const Peaks peaks(Sound{{10, 2}, {16384, -100, -8192, -100}});
  EXPECT_EQ(peaks.seconds(), 0.2);
  EXPECT_EQ(peaks.In(0.0, 0.05), (Peaks::Range{0.5f, 0.5f}));
  EXPECT_EQ(peaks.In(-5.0, 5.0), (Peaks::Range{-0.25f, 0.5f}));
  EXPECT_EQ(peaks.In(-2.0, -1.0), Peaks::Range());
  EXPECT_EQ(peaks.In(0.25, 9.0), Peaks::Range());
  EXPECT_EQ(Peaks(Sound()).In(0.0, 1.0), Peaks::Range());
}

}  // namespace
}  // namespace hazumi
