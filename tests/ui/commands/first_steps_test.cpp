#include "ui/panels/commands/first_steps.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/ui/user.h"
#include "ui/panels/forms/parameter_form.h"
#include "ui/panels/outliner/limbs.h"
#include "ui/panels/problems/problems.h"

namespace hazumi::ui {
namespace {

std::vector<std::string> HingesOfLimb(const std::string& name, const Figure& figure) {
  std::vector<std::string> names;
  for (const Limb& limb : LimbsOf(figure)) {
    if (limb.name != name) continue;
    for (const GroupIndex joint : limb.joints) {
      for (const JointIndex j : HingesOf(figure, joint)) names.push_back(figure.joint(j).name);
    }
  }
  return names;
}

using Ticks = std::array<bool, kNumFirstSteps>;

// To the letter, with what the forms suggest where the card says nothing.
TEST(FirstSteps, DoingWhatTheCardSaysTicksItAndMakesAThrowWithoutProblems) {
  test::User user;
  Editor& editor = user.editor();
  const auto ticks = [&] { return editor.dialogs.first_steps.ticks(); };
  const auto turn = [&](double frame, double flexion) {
    ASSERT_TRUE(editor.Do("time.frame", {{"frame", frame}}));
    ASSERT_TRUE(editor.Do("pose.rotate", {{"joint", "r_shoulder_flexion"}, {"to", flexion}}));
  };
  const auto fill_in = [&](const char* id, std::map<std::string, std::string> texts) {
    FormState form = MakeForm(id, Json::object(), &editor.session());
    for (FormField& field : form.fields) {
      if (texts.contains(field.info.name)) field.text = texts[field.info.name];
    }
    const Result<Json> values = ValuesOf(form);
    ASSERT_TRUE(values.ok());
    ASSERT_TRUE(editor.Do(id, values.value())) << editor.message.text;
  };
  EXPECT_EQ(ticks(), Ticks{});
  turn(0.0, -40.0);
  EXPECT_EQ(ticks(), (Ticks{true}));
  turn(30.0, 0.0);
  EXPECT_EQ(ticks(), (Ticks{true}));
  turn(5.0, 60.0);
  EXPECT_EQ(ticks(), (Ticks{true, true}));
  ASSERT_TRUE(editor.Do("time.frame", {{"frame", 30}}));
  const std::vector<std::string> arm = HingesOfLimb("Right arm", editor.session().figure());
  ASSERT_GT(arm.size(), 4u);
  ASSERT_TRUE(editor.Do("select.joints", {{"joints", arm}}));
  ASSERT_TRUE(editor.Do("key.insert"));
  fill_in("region.add", {{"first", "5"}, {"last", "15"}});
  EXPECT_EQ(ticks(), (Ticks{true, true, true}));
  fill_in("placement.set", {{"kind", "pinned"}, {"first", "0"}, {"last", "30"}, {"pin", "l_toe"}});
  ASSERT_TRUE(editor.Do("time.play"));
  EXPECT_TRUE(editor.dialogs.first_steps.all());
  ASSERT_TRUE(editor.Do("time.play"));

  // The elbow, which no key moves, is thrown.
  const Result<const Motion*> motion = editor.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  const int elbow = editor.session().figure().FindJoint("r_elbow_flexion")->value();
  EXPECT_GT(std::abs(motion.value()->frames[12].q[elbow] - motion.value()->frames[5].q[elbow]),
            0.1);
  user.Wait(30);
  for (const Problem& problem : ProblemsOf(&editor)) ADD_FAILURE() << problem.text;
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
