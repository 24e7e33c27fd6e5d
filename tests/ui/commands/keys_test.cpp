#include <gtest/gtest.h>

#include <set>

#include "ui/edit/operator.h"
#include "ui/panels/commands/actions.h"

namespace hazumi::test {
namespace {

using namespace ui;

TEST(Keys, AreNamedAsMenusShowThem) {
  EXPECT_EQ(NameOf(Chord{'Z', true, true}), "Ctrl+Shift+Z");
  EXPECT_EQ(NameOf(Chord{kPad7, true}), "Ctrl+Pad 7");
  EXPECT_EQ(NameOf(Chord{kF12}), "F12");
  EXPECT_EQ(NameOf(Chord{}), "");
}

TEST(Keys, AreFoundByTheirNames) {
  for (const Shortcut& shortcut : DefaultShortcuts()) {
    EXPECT_EQ(ChordNamed(NameOf(shortcut.chord)), shortcut.chord) << NameOf(shortcut.chord);
  }
  for (const char* none : {"", "Ctrl+", "Hyper+G", "Ctrl+Nothing", "g"}) {
    EXPECT_FALSE(ChordNamed(none)) << none;
  }
}

TEST(Shortcuts, DoSomethingThatThereIsWithParametersThatItTakes) {
  for (const Shortcut& shortcut : AllShortcuts()) {
    const Action* action = FindAction(shortcut.id);
    const edit::Operator* op = edit::FindOperator(shortcut.id);
    ASSERT_TRUE(action || op) << shortcut.id;
    const auto& infos = action ? action->parameters : op->parameters;
    EXPECT_TRUE(edit::Parameters::Check(infos, shortcut.parameters).ok()) << shortcut.id;
  }
}

TEST(Shortcuts, NoKeyDoesTwoThingsInOnePlace) {
  std::set<std::pair<std::string, int>> taken;
  for (const Shortcut& shortcut : AllShortcuts()) {
    const auto key = std::pair(NameOf(shortcut.chord), static_cast<int>(shortcut.place));
    EXPECT_TRUE(taken.insert(key).second) << key.first << " for " << shortcut.id;
  }
}

TEST(Shortcuts, OfAPlaceGoBeforeThoseOfAnyPlace) {
  const Shortcut* undo = FindShortcut({'Z', true}, Place::kViewport);
  ASSERT_TRUE(undo);
  EXPECT_STREQ(undo->id, "edit.undo");
  EXPECT_FALSE(FindShortcut({'Y', true, true, true}, Place::kSheet));
}

// The keymap of these tests' program is left as it was.
class KeymapTest : public testing::Test {
 protected:
  void TearDown() override { editor_.Do("keymap.reset"); }
  Editor editor_;
};

TEST_F(KeymapTest, AKeyDoesWhatItIsGivenAndTheOldOneNothing) {
  ASSERT_TRUE(editor_.Do("keymap.set", {{"place", "viewport"}, {"key", "R"}, {"to", "Ctrl+R"}}));
  EXPECT_FALSE(FindShortcut({'R'}, Place::kViewport));
  ASSERT_TRUE(FindShortcut({'R', true}, Place::kViewport));
  EXPECT_STREQ(FindShortcut({'R', true}, Place::kViewport)->id, "tool.rotate");
  EXPECT_EQ(KeyOf("tool.rotate"), "Ctrl+R");
  EXPECT_STREQ(FindShortcut({'R'}, Place::kSheet)->id, "sheet.open");  // another place
  ASSERT_TRUE(editor_.Do("keymap.set", {{"place", "viewport"}, {"key", "R"}}));
  EXPECT_EQ(KeyOf("tool.rotate"), "R");
  EXPECT_TRUE(editor_.settings.keymap.empty());
}

TEST_F(KeymapTest, WhoHadTheKeyHasNoneAndThatIsSaid) {
  ASSERT_TRUE(editor_.Do("keymap.set", {{"place", "viewport"}, {"key", "R"}, {"to", "G"}}));
  EXPECT_STREQ(FindShortcut({'G'}, Place::kViewport)->id, "tool.rotate");
  EXPECT_EQ(KeyOf("tool.move"), "");
  EXPECT_EQ(editor_.message.text, "Without a key now: Move");
  ASSERT_TRUE(editor_.Do("keymap.set", {{"place", "viewport"}, {"key", "B"}, {"to", ""}}));
  EXPECT_FALSE(FindShortcut({'B'}, Place::kViewport));
  ASSERT_TRUE(editor_.Do("keymap.reset"));
  EXPECT_EQ(KeyOf("tool.move"), "G");
}

TEST_F(KeymapTest, SaysWhatIsWrong) {
  EXPECT_FALSE(editor_.Do("keymap.set", {{"place", "menu"}, {"key", "R"}}));
  EXPECT_FALSE(editor_.Do("keymap.set", {{"place", "viewport"}, {"key", "Ctrl+Alt+R"}}));
  EXPECT_FALSE(editor_.Do("keymap.set", {{"place", "viewport"}, {"key", "R"}, {"to", "Hyper"}}));
  EXPECT_TRUE(editor_.settings.keymap.empty());
}

}  // namespace
}  // namespace hazumi::test
