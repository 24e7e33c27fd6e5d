#include "ui/panels/window/status_line.h"

#include "tests/ui/dialogs/fixture.h"

namespace hazumi::ui {
namespace {

TEST(StatusBar, LeavesOutWholeKeysOfAHintAndNeverItsValue) {
  const auto width_of = [](const std::string& text) { return static_cast<float>(text.size()); };
  const std::string hint = "Move: 1.0 m   Enter: confirm   Esc: cancel";
  EXPECT_EQ(FittingHint(hint, 100.0f, width_of), hint);
  EXPECT_EQ(FittingHint(hint, 30.0f, width_of), "Move: 1.0 m   Enter: confirm");
  EXPECT_EQ(FittingHint(hint, 5.0f, width_of), "Move: 1.0 m");
  EXPECT_EQ(FittingHint("", 5.0f, width_of), "");
}

TEST_F(Dialogs, TheStatusBarSaysFileFrameAndMemory) {
  EXPECT_EQ(StatusParts(editor_)[0], "Untitled (saved)");
  Change();
  editor_.session().set_frame(12);
  EXPECT_EQ(StatusParts(editor_)[0], "Untitled (not saved)");
  EXPECT_EQ(StatusParts(editor_)[1], "Frame 12 / 30");
  EXPECT_EQ(MemoryText(12'345), "13 kB");
  EXPECT_EQ(MemoryText(3'400'000), "3.4 MB");
}

}  // namespace
}  // namespace hazumi::ui
