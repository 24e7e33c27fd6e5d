#include "ui/panels/commands/first_steps.h"

#include <gtest/gtest.h>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {
namespace {

using Ticks = std::array<bool, kNumFirstSteps>;

TEST(FirstSteps, DoingWhatTheCardSaysTicksItAndMakesAThrow) {
  Editor editor;
  const auto ticks = [&] { return editor.dialogs.first_steps.ticks(); };
  const auto turn = [&](double flexion) {
    for (const char* side : {"l", "r"}) {
      const std::string joint = std::string(side) + "_shoulder_flexion";
      ASSERT_TRUE(editor.Do("pose.rotate", {{"joint", joint}, {"to", flexion}}));
    }
  };
  EXPECT_EQ(ticks(), Ticks{});
  turn(-40.0);
  EXPECT_EQ(ticks(), (Ticks{true}));
  ASSERT_TRUE(editor.Do("time.frame", {{"frame", 30}}));
  turn(0.0);
  EXPECT_EQ(ticks(), (Ticks{true}));
  ASSERT_TRUE(editor.Do("time.frame", {{"frame", 5}}));
  turn(60.0);
  EXPECT_EQ(ticks(), (Ticks{true, true}));
  ASSERT_TRUE(editor.Do("select.joints", {{"joints", {"l_shoulder", "l_elbow"}}}));
  ASSERT_TRUE(editor.Do("region.add", {{"first", 5}, {"last", 15}}));
  EXPECT_EQ(ticks(), (Ticks{true, true, true}));
  ASSERT_TRUE(editor.Do("placement.set",
                        {{"kind", "pinned"}, {"pin", "l_toe"}, {"first", 0}, {"last", 30}}));
  ASSERT_TRUE(editor.Do("time.play"));
  EXPECT_TRUE(editor.dialogs.first_steps.all());

  // The elbow, which no key moves, is thrown.
  const Result<const Motion*> motion = editor.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  const int elbow = editor.session().figure().FindJoint("l_elbow_flexion")->value();
  EXPECT_GT(std::abs(motion.value()->frames[12].q[elbow] - motion.value()->frames[5].q[elbow]),
            0.1);
}

TEST(FirstSteps, OtherDeedsTickNothing) {
  FirstSteps steps;
  steps = After(steps, {"time.play", edit::Json::object(), 0.0, {}});
  steps = After(steps, {"region.add", {{"joints", {"neck"}}}, 0.0, {"l_elbow_flexion"}});
  steps = After(steps, {"placement.set", {{"kind", "gravity"}}, 0.0, {}});
  EXPECT_EQ(steps.ticks(), Ticks{});
}

TEST(FirstSteps, TwoKeysOnOneFrameAreOnePose) {
  FirstSteps steps;
  steps = After(steps, {"key.insert", edit::Json::object(), 3.0, {}});
  steps = After(steps, {"key.set", {{"frame", 3}}, 8.0, {}});
  EXPECT_EQ(steps.ticks(), (Ticks{true}));
}

TEST(FirstSteps, ADragIsAPoseWhenItIsConfirmed) {
  const ExecutedCommand drag = {"pose.rotate", {{"drag", "turn 1"}}, 5.0, {}};
  const FirstSteps turning = After({}, drag);
  EXPECT_EQ(turning.ticks(), Ticks{});
  EXPECT_EQ(After(turning, {"edit.end_drag", edit::Json::object(), 5.0, {}}).ticks(),
            (Ticks{true}));
  EXPECT_EQ(After(turning, {"edit.cancel_drag", edit::Json::object(), 5.0, {}}).ticks(), Ticks{});
}

TEST(FirstSteps, StayDoneWhenAFileIsOpened) {
  const FirstSteps steps = After({}, {"key.insert", edit::Json::object(), 3.0, {}});
  EXPECT_EQ(After(steps, {"file.open", {{"path", "a.kfa"}}, 0.0, {}}).ticks(), (Ticks{true}));
}

}  // namespace
}  // namespace hazumi::ui
