// What a bake takes of memory: told before it begins, refused where it is too much, survived where
// the machine has not enough.

#include "engine/bake/bake_size.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "engine/bake/incremental_bake.h"
#include "tests/support/animations.h"
#include "tests/support/memory_limit.h"
#include "tests/support/stick_figures.h"

namespace hazumi::test {
namespace {

constexpr double kMegabyte = 1e6;

// The human with both arms swinging through all of so many frames.
Animation Swing(int frames) {
  Animation animation = Still(Human());
  animation.solver.method = Method::kExact;
  animation.last_frame = frames - 1;
  AddRegion(&animation, "arms", 0, frames - 1, {"r_elbow", "l_elbow"}, 0.5).method = Method::kExact;
  return animation;
}

Animation Standing(int frames) {
  Animation animation = Still(Human());
  animation.solver.method = Method::kExact;
  animation.last_frame = frames - 1;
  return animation;
}

// Memory that a process takes at most while it does something [bytes].
double PeakBytes(const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  EXPECT_EQ(status, 0);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

TEST(BakeSize, IsToldWithinATenth) {
  if (!CanLimitMemory()) GTEST_SKIP() << "not here: a sanitizer takes memory of its own";
  const auto peak = [](int frames) {
    return PeakBytes([=] { ASSERT_TRUE(Bake(Standing(frames)).ok()); });
  };
  const int few = 1000, many = 60000;
  const double told = MotionBytes(Standing(many), {30, 1}) - MotionBytes(Standing(few), {30, 1});
  EXPECT_NEAR((peak(many) - peak(few)) / told, 1.0, 0.1);
}

TEST(BakeSize, CountsTheFramesThatABakeGives) {
  const Animation animation = Standing(31);
  for (const FrameRate rate : {FrameRate{30, 1}, FrameRate{30000, 1001}, FrameRate{7, 1}}) {
    BakeOptions options;
    options.output_rate = rate;
    EXPECT_EQ(static_cast<double>(Bake(animation, options).value().frames.size()),
              NumOutputFrames(animation, rate));
  }
}

TEST(Bake, RefusesWhatTakesTooMuchMemoryWithTheNumber) {
  const Result<Motion> motion = Bake(Standing(1000000));
  ASSERT_FALSE(motion.ok());
  EXPECT_EQ(motion.error().code, ErrorCode::kSemantics);
  EXPECT_EQ(motion.error().place, "frames");
  EXPECT_NE(motion.error().message.find("1000000 frames of"), std::string::npos);
  EXPECT_NE(motion.error().message.find("GB of memory; at most 1 GB"), std::string::npos);
  IncrementalBake edited(Standing(1000000));
  ASSERT_TRUE(edited.BakeTo(0));
  EXPECT_EQ(edited.BakeTo(0)->message, motion.error().message);
  edited.Update(Standing(10));
  EXPECT_FALSE(edited.Finish());
  EXPECT_EQ(edited.motion().frames.size(), 10u);
}

TEST(Bake, RefusesTooManyStepsWithTheNumber) {
  Animation animation = Standing(1001);
  animation.solver = {Method::kPaper, 1e-6};
  const Result<Motion> whole = Bake(animation);
  ASSERT_FALSE(whole.ok());
  EXPECT_EQ(whole.error().place, "solver.step_s");
  EXPECT_NE(whole.error().message.find("would take 33334000 steps"), std::string::npos)
      << whole.error().message;
  animation.solver = {Method::kExact};
  DynamicsRegion& region = AddRegion(&animation, "arm", 0, 1000, {"r_elbow"});
  region.method = Method::kPaper;
  region.step = 1e-6;
  const Result<Motion> in_region = Bake(animation);
  ASSERT_FALSE(in_region.ok());
  EXPECT_EQ(in_region.error().place, "regions[0].step_s");
}

TEST(Bake, WithoutFramesTakesNoMemoryThatGrowsWithThem) {
  if (!CanLimitMemory()) GTEST_SKIP() << "not here: a sanitizer takes memory of its own";
  for (const bool energy : {false, true}) {
    const auto peak = [&](const Animation& animation) {
      return PeakBytes([&] {
        BakeOptions options;
        options.keep_frames = false;
        options.energy = energy;
        ASSERT_TRUE(Bake(animation, options).ok());
      });
    };
    EXPECT_LT(peak(Swing(30000)) - peak(Swing(3000)), 3 * kMegabyte) << energy;
  }
}

TEST(Bake, SaysTheSameWithoutFrames) {
  const Animation animation = Swing(9000);
  BakeOptions options;
  options.energy = true;
  const Motion with = Bake(animation, options).value();
  options.keep_frames = false;
  const Motion without = Bake(animation, options).value();
  EXPECT_TRUE(without.frames.empty());
  EXPECT_EQ(without.events.size(), with.events.size());
  EXPECT_EQ(without.warnings.size(), with.warnings.size());
  EXPECT_EQ(without.regions[0].evaluations, with.regions[0].evaluations);
  EXPECT_EQ(without.regions[0].error_estimate, with.regions[0].error_estimate);
  EXPECT_EQ(without.regions[0].energy->residual(), with.regions[0].energy->residual());
}

// Regions are solved ahead in parts of some thousand frames; with energy, step by step.
TEST(Bake, IsTheSameWhateverPartsARegionIsSolvedIn) {
  const Animation animation = Swing(9000);
  BakeOptions options;
  const Motion ahead = Bake(animation, options).value();
  options.energy = true;
  const Motion stepped = Bake(animation, options).value();
  IncrementalBake edited(animation);
  ASSERT_FALSE(edited.Finish());
  ASSERT_EQ(ahead.frames.size(), 9000u);
  EXPECT_EQ(ahead.events.size(), stepped.events.size());
  for (size_t f = 0; f < ahead.frames.size(); ++f) {
    ASSERT_TRUE(IsSame(ahead.frames[f], stepped.frames[f])) << f;
    ASSERT_TRUE(IsSame(ahead.frames[f], edited.motion().frames[f])) << f;
  }
}

TEST(Bake, OutOfMemoryIsAnError) {
  if (!CanLimitMemory()) GTEST_SKIP() << "not here: a sanitizer takes memory of its own";
  const Animation animation = Standing(200000);
  for (const double more : {30.0, 100.0, 200.0, 300.0}) {
    const MemoryLimit limit(more * kMegabyte);
    const Result<Motion> motion = Bake(animation);
    ASSERT_FALSE(motion.ok()) << more;
    EXPECT_EQ(motion.error().code, ErrorCode::kFailed);
    EXPECT_NE(motion.error().message.find("not enough memory"), std::string::npos);
  }
}

}  // namespace
}  // namespace hazumi::test
