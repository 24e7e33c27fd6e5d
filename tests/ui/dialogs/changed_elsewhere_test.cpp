#include <fstream>

#include "tests/ui/dialogs/fixture.h"

namespace hazumi::ui {
namespace {

// A project of its own file, changed here, and there by another program.
class ChangedElsewhere : public Dialogs {
 protected:
  void SetUp() override {
    Dialogs::SetUp();
    Save();
    ChangeBoth();
  }
  void ChangeBoth() {
    Change();
    std::ofstream(path(), std::ios::app) << "\n";
  }
  void Save() { ASSERT_TRUE(editor_.Do("file.save", {{"path", path()}})); }
  std::string path() const { return File("a.kfa"); }
  size_t num_steps() const { return editor_.session().document().num_steps(); }
  bool ends_with_line() const {
    std::ifstream file(path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return text.ends_with("\n\n");
  }
};

TEST_F(ChangedElsewhere, SavingAsksAndCanBeCancelled) {
  Press({'S', true});
  ASSERT_EQ(modal(), Modal::kChangedElsewhere);
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_FALSE(is_saved());
  EXPECT_TRUE(ends_with_line());
}

TEST_F(ChangedElsewhere, KKeepsMineAndTTakesTheirs) {
  for (const char key : {'K', 'T'}) {
    if (key == 'T') ChangeBoth();
    Press({'S', true});
    Press({key});
    EXPECT_EQ(modal(), Modal::kNone) << key;
    EXPECT_TRUE(is_saved()) << key;
    EXPECT_EQ(num_steps(), key == 'K' ? 1u : 0u);
    EXPECT_EQ(ends_with_line(), key == 'T');
  }
}

TEST_F(ChangedElsewhere, EnterSavesAsAndBothAreKept) {
  Press({'S', true});
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kFiles);
  Type(File("mine"));
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone) << editor_.dialogs.files.error;
  EXPECT_TRUE(fs::exists(File("mine.kfa")));
  EXPECT_TRUE(ends_with_line());
}

// From the question about unsaved changes too, and what was asked for comes after the answer.
TEST_F(ChangedElsewhere, LeavingGoesOnAfterTheAnswer) {
  Press({'Q', true});
  ASSERT_EQ(modal(), Modal::kUnsaved);
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kChangedElsewhere);
  EXPECT_FALSE(editor_.wants_to_quit);
  Press({'K'});
  EXPECT_TRUE(editor_.wants_to_quit);
  EXPECT_FALSE(ends_with_line());
}

TEST_F(ChangedElsewhere, SavingAsOverItsOwnFileAsksToo) {
  Press({'S', true, true});
  Press({kEnter});
  EXPECT_TRUE(editor_.dialogs.files.asks_overwrite);
  EXPECT_TRUE(ends_with_line());
  editor_.dialogs.files.purpose->take(&editor_);
  EXPECT_TRUE(is_saved());
}

}  // namespace
}  // namespace hazumi::ui
