// Regions that hang on joints with eased keys, at frame rates whose frames are no round times.

#include <gtest/gtest.h>

#include <array>

#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

using namespace test;  // NOLINT: short names for the builders

constexpr FrameRate kRates[] = {{30, 1}, {24, 1}, {25, 1}, {30000, 1001}, {24000, 1001}};
// From one to the next time and back, at one of the rates at least, is a little less than it was.
constexpr std::array<double, 4> kKeyFrames[] = {
    {0, 3, 11, 30}, {0, 1, 8, 30}, {0, 4, 15, 30}, {0, 4, 23, 30}};

// The forearm swings on a shoulder that is keyed.
Animation Swing(FrameRate rate, const std::array<double, 4>& frames, Interpolation interpolation,
                Easing easing) {
  Animation animation = Still(Arm());
  animation.rate = rate;
  Keys& keys = KeysOf(&animation, "shoulder_y");
  for (const double frame : frames) {
    Key key{frame, 0.02 * frame, {}, interpolation};
    key.easing = easing;
    keys.push_back(key);
  }
  AddRegion(&animation, "forearm", 0, 30, {"elbow"}, 0.8).method = Method::kExact;
  return animation;
}

TEST(EasedDrive, EndsWhereverRoundingPutsItsKeys) {
  for (const FrameRate& rate : kRates) {
    for (const auto& frames : kKeyFrames) {
      for (const Interpolation kind : {Interpolation::kSine, Interpolation::kBounce}) {
        for (const Easing easing : {Easing::kIn, Easing::kOut, Easing::kInOut}) {
          const Motion motion = BakeOrFail(Swing(rate, frames, kind, easing));
          ASSERT_EQ(motion.frames.size(), 31u);
          for (const MotionFrame& frame : motion.frames) ASSERT_TRUE(frame.q.allFinite());
        }
      }
    }
  }
}

}  // namespace
}  // namespace hazumi
