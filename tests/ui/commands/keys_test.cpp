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

}  // namespace
}  // namespace hazumi::test
