// Bakes that end early because they reach the work limit.

#include <gtest/gtest.h>

#include "tests/unit/bake/contact_cases.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::test {
namespace {

TEST(MostWork, BakeThatTakesMore_EndsWithAWarningThatNamesTheFrame) {
  const Animation animation = LooseHuman(60, 1.4, 1.0);
  BakeOptions options;
  options.most_work = 1e5;
  const Motion motion = BakeOrFail(animation, options);
  ASSERT_FALSE(motion.warnings.empty());
  const Warning& last = motion.warnings.back();
  EXPECT_EQ(last.place, "regions[0]");
  ASSERT_TRUE(last.frame.has_value());
  EXPECT_GT(*last.frame, 0);
  EXPECT_LT(*last.frame, 60);
  EXPECT_NE(last.message.find("are not checked"), std::string::npos);
  ASSERT_EQ(motion.frames.size(), static_cast<size_t>(*last.frame) + 1);
  const Motion whole = BakeOrFail(animation);
  EXPECT_TRUE(IsSame(motion.frames.back(), whole.frames[motion.frames.size() - 1]));
}

// Without contacts whole regions are solved at once, unless work is bounded.
TEST(MostWork, BakeWithoutContactsThatTakesMore_EndsWithAWarningThatNamesTheFrame) {
  Animation animation = LooseHuman(60, 1.4, 1.0);
  animation.regions[0].touches_scene = false;
  animation.solver.tolerance = 1e-9;
  BakeOptions options;
  options.most_work = 1e4;
  const Motion motion = BakeOrFail(animation, options);
  ASSERT_FALSE(motion.warnings.empty());
  const Warning& last = motion.warnings.back();
  ASSERT_TRUE(last.frame.has_value());
  EXPECT_LT(*last.frame, 60);
  EXPECT_EQ(motion.frames.size(), static_cast<size_t>(*last.frame) + 1);
}

// Work is counted, not timed: each bake ends in the same frame.
TEST(MostWork, BakeThatEndsEarly_EndsInTheSameFrame) {
  const Animation animation = LooseHuman(60, 1.4, 1.0);
  BakeOptions options;
  options.most_work = 1e5;
  const Motion first = BakeOrFail(animation, options);
  options.threads = 1;
  EXPECT_EQ(first.warnings.back().message, BakeOrFail(animation, options).warnings.back().message);
}

TEST(MostWork, BakeThatTakesLess_IsTheWholeMotion) {
  const Animation animation = LooseHuman(10, 1.4, 1.0);
  BakeOptions options;
  options.most_work = 1e9;
  const Motion bounded = BakeOrFail(animation, options), whole = BakeOrFail(animation);
  ASSERT_EQ(bounded.frames.size(), whole.frames.size());
  EXPECT_TRUE(IsSame(bounded.frames.back(), whole.frames.back()));
  EXPECT_EQ(bounded.warnings.size(), whole.warnings.size());
}

}  // namespace
}  // namespace hazumi::test
