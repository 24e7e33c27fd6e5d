// Forms, search and manual by the keyboard, and keys of the editor while a dialog is open.

#include "tests/ui/dialogs/fixture.h"

namespace hazumi::ui {
namespace {

TEST_F(Dialogs, AFormThatIsTallerThanTheWindowKeepsItsButtonsInIt) {
  editor_.settings.scale = 1.5;
  ASSERT_TRUE(RunOrAsk(&editor_, "region.add", Json::object()).ok());
  Frames(4);
  ASSERT_EQ(modal(), Modal::kForm);
  Click(620.0f, 436.0f);
  EXPECT_EQ(modal(), Modal::kNone);
}

TEST_F(Dialogs, TheManualIsScrolledByKeys) {
  Press({kF1});
  ASSERT_EQ(modal(), Modal::kManual);
  Frames(30);  // what is behind it has grown dark
  const auto seen = [&] { return shell_->picture().rgba; };
  const auto beginning = seen();
  Press({kPageDown});
  const auto page = seen();
  EXPECT_TRUE(page != beginning);
  Press({kDown});
  EXPECT_TRUE(seen() != page);
  Press({kUp});
  EXPECT_TRUE(seen() == page);
  Press({kEnd});
  const auto end = seen();
  EXPECT_TRUE(end != page);
  Press({kPageDown});
  EXPECT_TRUE(seen() == end);
  Press({kHome});
  EXPECT_TRUE(seen() == beginning);
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kNone);
}

TEST_F(Dialogs, AltIDeletesTheKeysOfTheFrame) {
  Change();
  Press({'I', false, false, true});
  EXPECT_TRUE(editor_.session().project().joints.at(0).value.keys.empty());
  Press({'I', false, false, true});
  EXPECT_EQ(editor_.message.text, "Delete key (frame): there is no key on frame 0");
}

TEST_F(Dialogs, SearchRunsWhatItFindsAndAsksForWhatItNeeds) {
  Press({kF3});
  ASSERT_EQ(modal(), Modal::kSearch);
  Type("gravity");
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kForm);
  Type("1.62");
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone) << editor_.dialogs.form.error;
  EXPECT_EQ(editor_.session().project().scene.gravity_m_s2, 1.62);
}

TEST_F(Dialogs, TabGoesToTheNextFieldOfAForm) {
  ASSERT_TRUE(RunOrAsk(&editor_, "region.add", {{"joints", {"r_elbow"}}}).ok());
  ASSERT_EQ(modal(), Modal::kForm);
  Frames();
  Type("5");
  Press({kTab});
  Type("9");
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kNone) << editor_.dialogs.form.error;
  const ProjectRegion& region = editor_.session().project().regions.at(0);
  EXPECT_EQ(region.first_frame, 5);
  EXPECT_EQ(region.last_frame, 9);
}

TEST_F(Dialogs, KeysOfTheEditorRestWhileADialogIsOpen) {
  Press({kF1});
  ASSERT_EQ(modal(), Modal::kManual);
  Press({kSpace});
  EXPECT_FALSE(editor_.playback.is_on());
  Press({kEscape});
  Press({kSpace});
  EXPECT_TRUE(editor_.playback.is_on());
}

}  // namespace
}  // namespace hazumi::ui
