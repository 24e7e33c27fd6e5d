// Refinement of exact regions whose error estimate exceeds the tolerance.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/spatial/degrees.h"
#include "tests/unit/bake/constraint_cases.h"

namespace hazumi::test {
namespace {

// Three rods that swing from level and meet their limits. The tolerance needs finer steps, the
// first of which do not help.
Animation SwingingChain() {
  Animation animation = Chain();
  animation.last_frame = animation.regions[0].last_frame = 120;
  animation.solver.tolerance = 1e-3 * kDegree;
  return animation;
}

bool IsRefined(const Animation& animation) {
  BakeOptions coarse;
  coarse.refine = false;
  return BakeOrFail(animation, coarse).frames.back().q != BakeOrFail(animation).frames.back().q;
}

TEST(Refinement, OutputRate_DoesNotChangeTheMotion) {
  const Animation animation = SwingingChain();
  ASSERT_TRUE(IsRefined(animation));
  const Motion at_30 = BakeOrFail(animation);
  for (const int rate : {24, 60, 7}) {
    BakeOptions options;
    options.output_rate = FrameRate{rate, 1};
    const Motion other = BakeOrFail(animation, options);
    for (int second = 0; second <= 4; ++second) {
      EXPECT_EQ(at_30.frames[static_cast<size_t>(30 * second)].q,
                other.frames[static_cast<size_t>(rate * second)].q)
          << rate << " per second, after " << second << " s";
    }
    EXPECT_EQ(other.regions[0].error_estimate, at_30.regions[0].error_estimate);
  }
}

TEST(Refinement, FinerStepsThatDoNotHelpAtFirst_AreMadeFinerOnce) {
  const Motion motion = BakeOrFail(SwingingChain());
  EXPECT_LE(motion.regions[0].error_estimate, motion.regions[0].tolerance);
  EXPECT_TRUE(motion.warnings.empty());
}

TEST(Refinement, TwoRegionsSolvedTogether_BothMeetTheirTolerances) {
  Animation animation = SwingingChain();
  animation.regions[0].joints = {JointIndex(0), JointIndex(1)};
  animation.regions[0].friction = {1.0, 1.0};
  DynamicsRegion second = animation.regions[0];
  second.name = "end";
  second.joints = {JointIndex(2)};
  second.friction = {1.0};
  second.tolerance = 1e-5 * kDegree;
  animation.regions.push_back(second);
  const Motion motion = BakeOrFail(animation);
  for (const RegionReport& report : motion.regions) {
    EXPECT_LE(report.error_estimate, report.tolerance) << report.name;
  }
  EXPECT_TRUE(motion.warnings.empty());
}

// Work that runs out in a finer solution leaves the coarser one, which is whole.
TEST(Refinement, WorkThatRunsOutInAFinerSolution_LeavesTheCoarserOne) {
  const Animation animation = SwingingChain();
  BakeOptions coarse;
  coarse.refine = false;
  const Motion whole = BakeOrFail(animation, coarse);
  BakeOptions bounded;
  bounded.most_work =
      1.5 * whole.regions[0].evaluations * static_cast<double>(whole.regions[0].bodies);
  const Motion motion = BakeOrFail(animation, bounded);
  ASSERT_EQ(motion.frames.size(), whole.frames.size());
  for (size_t i = 0; i < whole.frames.size(); ++i) EXPECT_EQ(motion.frames[i].q, whole.frames[i].q);
}

}  // namespace
}  // namespace hazumi::test
