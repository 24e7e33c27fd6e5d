// The properties in an editor without a display: fields are dragged and typed into.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/project/project_writer.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/text/number_text.h"
#include "ui/panels/viewport/tools/drag_tool.h"
#include "ui/panels/window/panels.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::test {
namespace {

using namespace ui;

class Properties : public ::testing::Test {
 protected:
  static constexpr int kWidth = 640, kHeight = 480, kTall = 1600;

  void SetUp() override {
    editor_.settings.shares.side = 0.4;
    editor_.settings.shares.outliner = 0.1;
    auto shell = OffscreenShell::Create(&editor_, {kWidth, kHeight});
    ASSERT_TRUE(shell.ok()) << shell.error().ToString();
    shell_ = std::move(shell).value();
    // The arm swings down.
    Do("key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 90}});
    Do("region.add", {{"name", "arm"}, {"joints", {"r_shoulder+"}}, {"first", 0}, {"last", 20}});
    shell_->Frame();
  }

  void Do(const std::string& id, const Json& parameters) {
    ASSERT_TRUE(editor_.Do(id, parameters)) << editor_.message.text;
  }

  // So that no panel has to be scrolled.
  void MakeTall() {
    shell_.reset();
    auto shell = OffscreenShell::Create(&editor_, {kWidth, kTall});
    ASSERT_TRUE(shell.ok()) << shell.error().ToString();
    shell_ = std::move(shell).value();
  }

  // Of the panel: its middle column has the fields.
  Rect Content(float height = kHeight) const {
    return LayOutWindow({0.0f, 0.0f, kWidth, height}, editor_.settings.shares, 1.0).properties;
  }
  void MoveTo(float x, float y) {
    shell_->MoveMouse(x, y);
    shell_->Frame();
  }
  void Button(bool is_down) {
    shell_->PressButton(0, is_down);
    shell_->Frame();
  }

  // Drags what is under a point until `is_done`; then the button is still down. False if nothing
  // there does it.
  template <typename Condition>
  bool DragAt(float x, float y, float by, Condition is_done) {
    MoveTo(x, y);
    Button(true);
    MoveTo(x + 0.5f * by, y);
    MoveTo(x + by, y);
    return is_done();
  }

  double Wrist(int frame) {
    const auto motion = editor_.session().MotionTo(frame);
    EXPECT_TRUE(motion.ok());
    const JointIndex j = *editor_.session().figure().FindJoint("r_shoulder_flexion");
    return motion.value()->frames[frame].q[j.value()];
  }

  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

// Names that begin alike, or are taken, lead to no other region.
TEST_F(Properties, TheChosenRegionStaysItWhenItIsRenamed) {
  Do("region.add", {{"name", "other"}, {"joints", {"l_shoulder+"}}, {"first", 0}, {"last", 20}});
  Do("region.add", {{"name", "arms"}, {"joints", {"neck"}}, {"first", 0}, {"last", 20}});
  const auto names = [&] {
    const Project& project = editor_.session().project();
    const size_t shown = *ShownRegion(project, editor_.side.region, 0.0);
    const std::optional<BarRef> bar = ChosenBar(project, editor_.sheet);
    return std::pair(project.regions[shown].name, project.regions.at(bar->index).name);
  };
  ChooseBar(&editor_, {BarKind::kRegion, 1});
  EXPECT_EQ(names(), std::pair(std::string("other"), std::string("other")));
  Do("region.set", {{"region", "other"}, {"name", "arm"}});
  EXPECT_EQ(names(), std::pair(std::string("arm 2"), std::string("arm 2")));
  Do("region.remove", {{"region", "arm"}});
  EXPECT_EQ(names(), std::pair(std::string("arm 2"), std::string("arm 2")));
}

// Of each kind, with and without what may be left out.
TEST_F(Properties, ConstraintsHaveARowForEachField) {
  editor_.side.section = Section::kScene;
  Do("time.frame", {{"frame", 10}});
  for (const char* kind : {"point", "weld", "distance"}) {
    Do("constraint.add", {{"kind", kind}, {"a_joint", "r_wrist"}});
  }
  Do("constraint.set", {{"constraint", "weld"}, {"arrive", 3}, {"break_force", 10}});
  ASSERT_EQ(editor_.session().project().constraints.size(), 3u);
  for (const ProjectConstraint& constraint : editor_.session().project().constraints) {
    editor_.viewport.selected_object = constraint.identity.id;
    shell_->Frame();
    shell_->Frame();
    EXPECT_EQ(editor_.side.shown_object, constraint.identity.id);
  }
}

TEST_F(Properties, DraggingTheFrictionIsOneStepAndTheSwingFollows) {
  MakeTall();
  editor_.side.section = Section::kRegion;
  shell_->Frame();
  shell_->Frame();
  const size_t steps = editor_.session().document().num_steps();
  const auto label = editor_.session().document().undo_label();
  const double factor = editor_.session().project().regions[0].friction.default_factor;
  const auto friction = [&] {
    return editor_.session().project().regions[0].friction.default_factor;
  };
  // Down the panel to the field; what else is there is taken back.
  const Rect content = Content(kTall);
  const float x = content.x + 0.85f * content.w;
  bool found = false;
  for (float y = content.y + 8.0f; y < content.bottom() && !found; y += 8.0f) {
    found = DragAt(x, y, -30.0f, [&] { return friction() != factor; });
    if (found) break;
    Button(false);
    if (editor_.session().document().undo_label() != label) Do("edit.undo", Json::object());
    editor_.side.section = Section::kRegion;
  }
  ASSERT_TRUE(found);
  const double halfway = friction(), swing = Wrist(15);
  EXPECT_LT(halfway, factor);
  const Point mouse = {x - 60.0f, 0.0f};
  MoveTo(mouse.x, content.y + content.h * 0.5f);
  EXPECT_LT(friction(), halfway);
  EXPECT_NE(Wrist(15), swing);  // while the button is down
  Button(false);
  EXPECT_EQ(editor_.session().document().num_steps(), steps + 1);
  Do("edit.undo", Json::object());
  EXPECT_EQ(friction(), factor);
}

// Whatever else is clicked on the way down the panel is taken back.
TEST_F(Properties, ARegionTouchesTheSceneByATick) {
  MakeTall();
  editor_.side.section = Section::kRegion;
  shell_->Frame();
  shell_->Frame();
  const std::string before = WriteProject(editor_.session().project());
  const auto touches = [&] { return editor_.session().project().regions[0].contacts.scene; };
  const Rect content = Content(kTall);
  for (float y = content.y + 8.0f; y < content.bottom() && !touches(); y += 10.0f) {
    for (float x = 0.3f; x < 0.8f && !touches(); x += 0.07f) {
      MoveTo(content.x + x * content.w, y);
      Button(true);
      Button(false);
      shell_->Frame();
      if (touches() || WriteProject(editor_.session().project()) == before) continue;
      Do("edit.undo", Json::object());
      editor_.side.section = Section::kRegion;
    }
  }
  EXPECT_TRUE(touches());
  EXPECT_EQ(editor_.session().document().undo_label(), "Change region");
}

TEST_F(Properties, TheFrictionOfAnObjectIsDragged) {
  editor_.side.section = Section::kScene;
  editor_.viewport.selected_object = editor_.session().project().scene.objects[0].identity.id;
  MakeTall();
  shell_->Frame();
  shell_->Frame();
  const std::string before = WriteProject(editor_.session().project());
  const auto friction = [&] {
    return editor_.session().project().scene.objects[0].friction_coefficient;
  };
  const Rect content = Content(kTall);
  bool found = false;
  for (float y = content.y + 8.0f; y < content.bottom() && !found; y += 8.0f) {
    found = DragAt(content.x + 0.7f * content.w, y, -24.0f, [&] { return friction() < 0.8; });
    Button(false);
    if (found || WriteProject(editor_.session().project()) == before) continue;
    Do("edit.undo", Json::object());
    editor_.side.section = Section::kScene;
  }
  ASSERT_TRUE(found);
  EXPECT_GE(friction(), 0.0);
}

// What a region leaves out is shown as it is used, and can be set there.
TEST_F(Properties, ARegionTakesAStepOfItsOwnWhereItsMethodHasSteps) {
  MakeTall();
  Do("region.set", {{"region", "arm"}, {"method", "paper"}});
  editor_.side.section = Section::kRegion;
  shell_->Frame();
  shell_->Frame();
  const std::string before = WriteProject(editor_.session().project());
  const auto step = [&] { return editor_.session().project().regions[0].step_s; };
  // Up the panel from below its fields: above the step there is a list, which a click opens.
  const Rect content = Content(kTall);
  bool found = false;
  for (float y = content.y + 440.0f; y > content.y && !found; y -= 8.0f) {
    found = DragAt(content.x + 0.7f * content.w, y, -24.0f, [&] { return step().has_value(); });
    Button(false);
    if (!found && WriteProject(editor_.session().project()) != before) {
      Do("edit.undo", Json::object());
    }
  }
  ASSERT_TRUE(found);
  EXPECT_LT(*step(), kDefaultStep);
  EXPECT_GT(*step(), 0.5 * kDefaultStep);
  EXPECT_FALSE(editor_.session().project().regions[0].tolerance_deg);
}

TEST_F(Properties, ARefusedLimitLeavesTheDocumentAndSaysWhy) {
  Do("select.joints", {{"joints", {"r_knee"}}});
  const std::string before = WriteProject(editor_.session().project());
  EXPECT_FALSE(editor_.Do("figure.joint_limits", {{"joint", "r_knee"}, {"lower", 500.0}}));
  shell_->Frame();
  EXPECT_EQ(WriteProject(editor_.session().project()), before);
  EXPECT_TRUE(editor_.message.is_error);
  EXPECT_NE(editor_.message.text.find("lower"), std::string::npos) << editor_.message.text;
}

TEST_F(Properties, ATypedAngleIsKeyedWhenItIsConfirmed) {
  Do("select.joints", {{"joints", {"l_elbow"}}});
  shell_->Frame();
  shell_->Frame();
  const size_t steps = editor_.session().document().num_steps();
  const Rect content = Content();
  const float x = content.x + 0.7f * content.w, y = content.y + 38.0f;
  MoveTo(x, y);
  for (int i = 0; i < 2; ++i) {
    Button(true);
    Button(false);
  }
  shell_->Type("42");
  shell_->Frame();
  EXPECT_EQ(editor_.session().document().num_steps(), steps);  // not before
  shell_->PressKey(kEnter, true);
  shell_->Frame();
  shell_->PressKey(kEnter, false);
  shell_->Frame();
  EXPECT_EQ(editor_.session().document().num_steps(), steps + 1);
  EXPECT_NEAR(editor_.session().ValueNow("l_elbow_flexion").value(), 42.0, 1e-6);
  EXPECT_EQ(editor_.message.text, "");
}

TEST_F(Properties, AnAngleBeyondItsLimitIsSaidUntilOneIsTaken) {
  Do("select.joints", {{"joints", {"l_elbow"}}});
  shell_->Frame();
  shell_->Frame();
  const auto type = [&](const char* number) {
    const Rect content = Content();
    MoveTo(content.x + 0.7f * content.w, content.y + 38.0f);
    for (int i = 0; i < 2; ++i) {
      Button(true);
      Button(false);
    }
    shell_->Type(number);
    shell_->Frame();
    shell_->PressKey(kEnter, true);
    shell_->Frame();
    shell_->PressKey(kEnter, false);
    for (int i = 0; i < 40; ++i) shell_->Frame();  // no double click with what comes next
  };
  type("170");
  EXPECT_EQ(editor_.message.text,
            "l_elbow_flexion: 170\u00b0 is beyond its limit, 150\u00b0 is set");
  EXPECT_NEAR(editor_.session().ValueNow("l_elbow_flexion").value(), 150.0, 1e-6);
  type("20");
  EXPECT_NEAR(editor_.session().ValueNow("l_elbow_flexion").value(), 20.0, 1e-6);
  EXPECT_EQ(editor_.message.text, "");
}

TEST(NumberText, NeverShowsMinusZero) {
  EXPECT_FALSE(std::signbit(WithoutMinusZero(-0.0, 1)));
  EXPECT_FALSE(std::signbit(WithoutMinusZero(-0.049, 1)));
  EXPECT_EQ(WithoutMinusZero(-0.051, 1), -0.051);
  EXPECT_EQ(WithoutMinusZero(-0.4, 0), 0.0);
  EXPECT_EQ(Signed(-0.04, 1), "+0.0");
}

}  // namespace
}  // namespace hazumi::test
