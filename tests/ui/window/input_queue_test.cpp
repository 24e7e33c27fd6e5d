// What a user does faster than frames are drawn.

#include <gtest/gtest.h>

#include "tests/ui/viewport/fixture.h"
#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {
namespace {

class FastUser : public ViewportFixture {
 protected:
  // No frame is drawn in between.
  void Tap(int key) {
    shell_->PressKey(key, true);
    shell_->PressKey(key, false);
  }
  void Click(Point p) {
    shell_->MoveMouse(p.x, p.y);
    shell_->PressButton(0, true);
    shell_->PressButton(0, false);
  }
  int DrawAll() {
    int frames = 0;
    do {
      shell_->Frame();
      ++frames;
    } while (shell_->has_input());
    shell_->Frame();
    return frames;
  }
};

TEST_F(FastUser, DigitsCountInTheOrderInWhichTheyWereTyped) {
  editor_.Do("select.joints", {{"joints", {"r_knee"}}});
  const Point at = MarkOf("r_hip");
  shell_->MoveMouse(at.x, at.y);
  for (const int key : {int{'R'}, int{'9'}, int{'5'}, int{kEnter}}) Tap(key);
  DrawAll();
  EXPECT_FALSE(editor_.has_tool());
  EXPECT_NEAR(editor_.session().ValueNow("r_knee").value(), 95.0, 1e-9);
}

TEST_F(FastUser, TheSameDigitTwiceIsTwoDigits) {
  editor_.Do("select.joints", {{"joints", {"r_knee"}}});
  const Point at = MarkOf("r_hip");
  shell_->MoveMouse(at.x, at.y);
  for (const int key : {int{'R'}, int{'1'}, int{'1'}, int{'0'}, int{kEnter}}) Tap(key);
  DrawAll();
  EXPECT_NEAR(editor_.session().ValueNow("r_knee").value(), 110.0, 1e-9);
}

TEST_F(FastUser, AModifierCountsForTheKeyThatItWasHeldWith) {
  editor_.Do("select.joints", {{"joints", {"r_knee"}}});
  editor_.Do("pose.rotate", {{"joint", "r_knee"}, {"to", 30.0}});
  shell_->PressKey(kLeftControl, true);
  Tap('Z');
  shell_->PressKey(kLeftControl, false);
  Tap('I');
  DrawAll();
  EXPECT_NEAR(editor_.session().ValueNow("r_knee").value(), 0.0, 1e-9);
  EXPECT_EQ(editor_.session().document().undo_label(), "Insert key");
}

TEST_F(FastUser, AClickIsWhereTheMouseWasNotWhereItWent) {
  Click(MarkOf("r_elbow"));
  shell_->MoveMouse(3.0f, 3.0f);
  DrawAll();
  EXPECT_TRUE(editor_.session().selected_joints().contains("r_elbow_flexion"));
}

TEST_F(FastUser, ADragGoesToWhereTheButtonWasLetGo) {
  const WindowLayout layout =
      LayOutWindow({0.0f, 0.0f, 520.0f, 380.0f}, editor_.settings.shares, editor_.settings.scale);
  shell_->MoveMouse(layout.viewport.right() + 2.0f, 200.0f);
  shell_->PressButton(0, true);
  shell_->MoveMouse(300.0f, 200.0f);
  shell_->MoveMouse(260.0f, 200.0f);
  shell_->PressButton(0, false);
  DrawAll();
  EXPECT_NEAR(editor_.settings.shares.side, 0.5, 1e-6);
}

TEST_F(FastUser, MovesOfTheMouseDoNotPileUp) {
  for (int i = 0; i < 200; ++i) shell_->MoveMouse(static_cast<float>(i), 50.0f);
  EXPECT_EQ(DrawAll(), 1);
}

TEST_F(FastUser, AKeyRightAfterEnterInAFieldIsAShortcutAgain) {
  const WindowLayout layout =
      LayOutWindow({0.0f, 0.0f, 520.0f, 380.0f}, editor_.settings.shares, editor_.settings.scale);
  Click({layout.outliner.x + 40.0f, layout.outliner.y + 14.0f});
  DrawAll();
  shell_->PressKey('I', true);
  shell_->Type("i");
  shell_->PressKey('I', false);
  DrawAll();
  EXPECT_EQ(editor_.side.search, "i");
  EXPECT_EQ(editor_.session().document().num_steps(), 0u);
  Tap(kEnter);
  Tap('I');
  DrawAll();
  EXPECT_EQ(editor_.session().document().num_steps(), 1u);
  EXPECT_EQ(editor_.side.search, "i");
}

TEST_F(FastUser, AFrameTakesAllLettersThatWereTyped) {
  editor_.Do("app.search");
  for (int i = 0; i < 3; ++i) shell_->Frame();
  for (const char letter : {'p', 'l', 'a', 'y'}) {
    shell_->PressKey(letter - 'a' + 'A', true);
    shell_->Type(std::string(1, letter));
    shell_->PressKey(letter - 'a' + 'A', false);
  }
  EXPECT_EQ(DrawAll(), 1);
  EXPECT_EQ(editor_.dialogs.search.query, "play");
}

// The field that Tab leads to is there two frames later.
TEST_F(FastUser, LettersAfterATabGoIntoTheNextField) {
  ASSERT_TRUE(RunOrAsk(&editor_, "object.add_box", Json::object()).ok());
  for (int i = 0; i < 3; ++i) shell_->Frame();
  Tap(kTab);
  shell_->Type("1");
  Tap(kTab);
  shell_->Type("2");
  Tap(kEnter);
  DrawAll();
  for (int i = 0; i < 3; ++i) shell_->Frame();
  const auto& objects = editor_.session().project().scene.objects;
  ASSERT_EQ(objects.size(), 2u);
  const auto& box = std::get<ProjectBox>(objects.back().shape);
  EXPECT_EQ(box.center_m.head<2>(), Eigen::Vector2d(1.0, 2.0));
}

}  // namespace
}  // namespace hazumi::ui
