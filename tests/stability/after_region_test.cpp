// The cubic that takes over from a region starts with the rate that the dynamics left. [METHOD 7.3]

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/figure_builder.h"
#include "tests/support/animations.h"
#include "tests/support/odd_figures.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

// The bar of MirrorArms with a left arm that reaches its limit at 0.5 rad, but for 0.05, at 9 rad/s
// when its region ends at frame 2.
Animation HandedOverNearItsLimit(Method method) {
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

TEST(BothMethods, SayThatTheCubicAfterARegionOvershootsTheLimit) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    const Animation animation = HandedOverNearItsLimit(method);
    const Motion motion = BakeFinite(animation);
    EXPECT_NEAR(motion.frames[2].q[1], 0.45, 1e-9) << NameOf(method);
    EXPECT_GT(Highest(animation, motion), 1.0) << NameOf(method);
    ASSERT_EQ(motion.warnings.size(), 1u) << NameOf(method);
    EXPECT_EQ(motion.warnings[0].place, "regions[0]");
    EXPECT_NE(motion.warnings[0].message.find("\"left\" goes"), std::string::npos);
    EXPECT_NE(motion.warnings[0].message.find("limit_tangents"), std::string::npos);
  }
}

TEST(BothMethods, StayInsideAfterARegionWithLimitedTangents) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = HandedOverNearItsLimit(method);
    animation.regions[0].limit_tangents = true;
    const Motion motion = BakeFinite(animation);
    EXPECT_LE(Highest(animation, motion), 0.5 + 1e-9) << NameOf(method);
    EXPECT_GT(Highest(animation, motion), 0.49) << NameOf(method);
    EXPECT_TRUE(motion.warnings.empty()) << NameOf(method);
  }
}

}  // namespace
}  // namespace hazumi::test
