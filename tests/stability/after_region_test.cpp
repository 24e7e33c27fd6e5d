// The cubic that takes over from a region starts with the rate that the dynamics left. [METHOD 3]

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/figure_builder.h"
#include "tests/support/animations.h"
#include "tests/support/odd_figures.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

// The bar of MirrorArms with a left arm that reaches its stop at 0.5 rad, but for 0.05, at 9 rad/s
// when its region ends at frame 2.
Animation HandedOverNearItsStop(Method method) {
  Animation animation = Still(MirrorArms(0.5, 0.5));
  animation.gravity = 0.0;
  const double frame = 1.0 / 30.0;
  KeysOf(&animation, "left") = {{0, 0.45 - 2.0 * 9.0 * frame, 9.0, Interpolation::kCubic},
                                {30, 0.0, {}, Interpolation::kCubic}};
  AddRegion(&animation, "left", 0, 2, {"left"});
  SetMethod(&animation, method);
  return animation;
}

double Highest(const Animation& animation, const Motion& motion) {
  double highest = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    highest = std::max(highest, frame.q[JointOf(animation, "left").value()]);
  }
  return highest;
}

// What a bake does today: the curve leaves the stops, and nothing is said.
TEST(BothMethods, LetTheCubicAfterARegionOvershootTheStop) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    const Animation animation = HandedOverNearItsStop(method);
    const Motion motion = BakeFinite(animation);
    EXPECT_NEAR(motion.frames[2].q[1], 0.45, 1e-9) << NameOf(method);
    EXPECT_GT(Highest(animation, motion), 1.0) << NameOf(method);
    EXPECT_TRUE(motion.warnings.empty()) << NameOf(method);
  }
}

}  // namespace
}  // namespace hazumi::test
