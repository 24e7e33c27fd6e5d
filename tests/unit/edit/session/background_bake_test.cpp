#include "ui/edit/session/background_bake.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "engine/bake/bake.h"
#include "tests/support/animations.h"
#include "tests/support/long_timeline.h"
#include "tests/support/memory_limit.h"

namespace hazumi::test {
namespace {

using edit::BackgroundBake;

constexpr double kNoPatience = 1e-6;  // [s]

void ExpectSameMotion(const Motion& a, const Motion& b) {
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (size_t i = 0; i < a.frames.size(); ++i) {
    EXPECT_EQ(a.frames[i].q, b.frames[i].q) << i;
    EXPECT_EQ(a.frames[i].X_WR.p, b.frames[i].X_WR.p) << i;
  }
}

void WaitUntilDone(const BackgroundBake& bake) {
  while (bake.is_busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(BackgroundBake, WithoutALimitItIsDoneAtOnce) {
  const Animation animation = LongTimeline(300, 3);
  BackgroundBake bake(animation);
  EXPECT_FALSE(bake.BakeTo(300, std::nullopt));
  EXPECT_FALSE(bake.is_busy());
  ExpectSameMotion(bake.motion(), Bake(animation).value());
}

TEST(BackgroundBake, WhatTakesLongGoesOnBesideAndIsTheSameInTheEnd) {
  const Animation animation = LongTimeline(2000, 20);
  BackgroundBake bake(animation);
  const std::optional<Error> not_yet = bake.BakeTo(2000, kNoPatience);
  ASSERT_TRUE(not_yet);
  EXPECT_EQ(not_yet->code, ErrorCode::kInterrupted);
  WaitUntilDone(bake);
  EXPECT_FALSE(bake.BakeTo(2000, kNoPatience));
  ExpectSameMotion(bake.motion(), Bake(animation).value());
}

TEST(BackgroundBake, MeanwhileTheMotionIsAsItWas) {
  Animation animation = LongTimeline(2000, 20);
  BackgroundBake bake(animation);
  ASSERT_FALSE(bake.BakeTo(2000, std::nullopt));
  const MotionFrame before = bake.motion().frames[1990];
  for (Key& key : KeysOf(&animation, "l_knee")) key.value += 0.1;
  bake.Update(animation);
  ASSERT_TRUE(bake.BakeTo(2000, kNoPatience));
  EXPECT_EQ(bake.motion().frames[1990].X_WR.p, before.X_WR.p);
  EXPECT_EQ(bake.BakeTo(2000, std::nullopt), std::nullopt);
  EXPECT_NE(bake.motion().frames[1990].X_WR.p, before.X_WR.p);
  ExpectSameMotion(bake.motion(), Bake(animation).value());
}

TEST(BackgroundBake, AnEditEndsWhatGoesOnBeside) {
  Animation animation = LongTimeline(2000, 20);
  BackgroundBake bake(animation);
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(bake.BakeTo(2000, kNoPatience)) << i;
    KeysOf(&animation, "l_knee")[0].value += 0.01;
    bake.Update(animation);
    EXPECT_FALSE(bake.is_busy());
  }
  EXPECT_FALSE(bake.BakeTo(2000, std::nullopt));
  ExpectSameMotion(bake.motion(), Bake(animation).value());
}

TEST(BackgroundBake, WhatWasStoppedStaysSoUntilItIsWanted) {
  const Animation animation = LongTimeline(2000, 20);
  BackgroundBake bake(animation);
  ASSERT_TRUE(bake.BakeTo(2000, kNoPatience));
  bake.Stop();
  EXPECT_TRUE(bake.is_stopped());
  const std::optional<Error> stopped = bake.BakeTo(2000, std::nullopt);
  ASSERT_TRUE(stopped);
  EXPECT_NE(stopped->message.find("stopped"), std::string::npos);
  bake.Resume();
  EXPECT_FALSE(bake.BakeTo(2000, std::nullopt));
  ExpectSameMotion(bake.motion(), Bake(animation).value());
}

TEST(BackgroundBake, SaysWhatTakesTooMuchMemoryAndLivesOn) {
  Animation animation = LongTimeline(2000, 20);
  BackgroundBake bake(animation);
  animation.last_frame = 999999;
  bake.Update(animation);
  for (const std::optional<double> patience :
       {std::optional(1e9), std::optional<double>()}) {  // by the thread, and here
    const std::optional<Error> error = bake.BakeTo(0, patience);
    ASSERT_TRUE(error);
    EXPECT_NE(error->message.find("GB of memory"), std::string::npos) << error->message;
    EXPECT_FALSE(bake.is_busy());
  }
  animation = LongTimeline(2000, 20);
  bake.Update(animation);
  EXPECT_FALSE(bake.BakeTo(2000, std::nullopt));
  ExpectSameMotion(bake.motion(), Bake(animation).value());
}

TEST(BackgroundBake, SurvivesThatMemoryRunsOut) {
  if (!CanLimitMemory()) GTEST_SKIP() << "not here: a sanitizer needs terabytes of addresses";
  Animation animation = LongTimeline(2000, 20);
  BackgroundBake bake(animation);
  animation.last_frame = 200000;
  {
    // Enough for the frames' list, which is made here, but not for what is in it, by the thread.
    const MemoryLimit limit(350e6);
    bake.Update(animation);
    const std::optional<Error> error = bake.BakeTo(200000, 1e9);
    ASSERT_TRUE(error);
    EXPECT_NE(error->message.find("not enough memory"), std::string::npos) << error->message;
  }
  animation = LongTimeline(2000, 20);
  bake.Update(animation);
  EXPECT_FALSE(bake.BakeTo(2000, std::nullopt));
  ExpectSameMotion(bake.motion(), Bake(animation).value());
}

}  // namespace
}  // namespace hazumi::test
