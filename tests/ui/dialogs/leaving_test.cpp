// Unsaved changes: who leaves a project is asked.

#include "tests/ui/dialogs/fixture.h"

namespace hazumi::ui {
namespace {

TEST_F(Dialogs, EnterPressesTheButtonThatTabHasLedTo) {
  Change();
  Press({'Q', true});
  Press({kTab});
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_TRUE(editor_.wants_to_quit);  // "Don't save"
}

// What it does is said by its label: no tooltip lies over the buttons beside it.
TEST_F(Dialogs, AButtonWhoseLabelSaysItHasNoTooltip) {
  Change();
  Press({'Q', true});
  ASSERT_EQ(modal(), Modal::kUnsaved);
  Frames(30);  // what is behind it has grown dark
  for (float x = 180.0f; x < 560.0f; x += 40.0f) {
    shell_->MoveMouse(x, 262.0f);
    Frames(2);
    const auto before = shell_->picture().rgba;
    for (int i = 0; i < 12; ++i) shell_->Frame(0.1);
    EXPECT_TRUE(shell_->picture().rgba == before) << x;
  }
}

TEST_F(Dialogs, LeavingAsksAboutUnsavedChangesAndCanBeCancelled) {
  Change();
  Press({'Q', true});
  EXPECT_EQ(modal(), Modal::kUnsaved);
  EXPECT_FALSE(editor_.wants_to_quit);
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_FALSE(editor_.wants_to_quit);
  Press({'Q', true});
  AnswerDiscard(&editor_);
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, DLeavesWithoutSaving) {
  Change();
  Press({'Q', true});
  Press({'D'});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, LeavingAfterSaveWaitsForTheName) {
  Change();
  Press({'Q', true});
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kFiles);
  EXPECT_FALSE(editor_.wants_to_quit);
  Type(File("last"));
  Press({kEnter});
  EXPECT_TRUE(fs::exists(File("last.kfa"))) << editor_.dialogs.files.error;
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, ASavedProjectIsLeftAtOnceAndScriptsAreNotAsked) {
  Change();
  ASSERT_TRUE(editor_.Do("file.new"));
  EXPECT_EQ(modal(), Modal::kNone);
  ASSERT_TRUE(editor_.Do("app.quit"));
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, ADroppedFileIsOpenedAfterTheQuestion) {
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("a.kfa")}}));
  Change();
  ASSERT_TRUE(editor_.Do("app.open", {{"path", File("a.kfa")}}));
  EXPECT_EQ(modal(), Modal::kUnsaved);
  AnswerDiscard(&editor_);
  EXPECT_TRUE(is_saved());
}

TEST_F(Dialogs, TheFirstEntryOfTheFileMenuAsksToo) {
  Change();
  const auto click = [&](float x, float y) {
    shell_->MoveMouse(x, y);
    Frames();
    shell_->PressButton(0, true);
    Frames(1);
    shell_->PressButton(0, false);
    Frames();
  };
  click(20.0f, 10.0f);
  click(40.0f, 38.0f);
  EXPECT_EQ(modal(), Modal::kUnsaved);
}

}  // namespace
}  // namespace hazumi::ui
