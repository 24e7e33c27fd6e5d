// The dope sheet as it is used, with mouse and keys.

#include "tests/ui/dope_sheet/dope_sheet_user.h"

namespace hazumi::test {
namespace {

TEST_F(DopeSheet, EscapeLeavesTheDocumentAsItWas) {
  const std::string before = user.text();
  const ui::Rect bar = Bar("limb r_shoulder");
  user.Pull({bar.x, bar.y + 3.0f}, {X(10), bar.y + 3.0f});
  EXPECT_EQ(arms().first_frame, 10);
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_EQ(user.text(), before);
  EXPECT_EQ(user.num_steps(), 0u);
}

TEST_F(DopeSheet, GAndANumberMovesKeysByExactlyThat) {
  user.Click(Key("limb r_hip", 15));
  const std::set<double> before = FramesOf("r_knee");
  ASSERT_TRUE(before.contains(15));
  const std::set<double> others = FramesOf("l_knee");
  user.Press('G');
  user.MoveTo({X(28), 400.0f});
  user.Press('2');
  user.Press(ui::kEnter);
  EXPECT_FALSE(user.editor().has_tool());
  std::set<double> expected = before;
  expected.erase(15);
  expected.insert(17);
  EXPECT_EQ(FramesOf("r_knee"), expected);
  EXPECT_EQ(FramesOf("l_knee"), others);
  EXPECT_EQ(user.num_steps(), 1u);
}

TEST_F(DopeSheet, GCancelledLeavesTheDocumentAsItWas) {
  const std::string before = user.text();
  user.Click(Key("limb r_hip", 15));
  user.Press('G');
  user.MoveTo({X(9), 400.0f});
  EXPECT_NE(user.text(), before);
  user.Click({X(9), 400.0f}, 1);
  EXPECT_EQ(user.text(), before);
  EXPECT_EQ(user.num_steps(), 0u);
}

TEST_F(DopeSheet, KeysAreDraggedDirectly) {
  const Point key = Key("limb r_hip", 15);
  user.Drag(key, {key.x + X(2) - X(0), key.y});
  EXPECT_TRUE(FramesOf("r_knee").contains(17));
  EXPECT_FALSE(FramesOf("r_knee").contains(15));
  EXPECT_EQ(user.num_steps(), 1u);
}

TEST_F(DopeSheet, ScalesAboutThePlayhead) {
  user.Press(ui::kLeft, ui::kLeftShift);  // to frame 0
  user.Click(Key("limb r_hip", 15));
  user.Press('S');
  user.Press('2');
  user.Press(ui::kEnter);
  EXPECT_TRUE(FramesOf("r_knee").contains(30));
  EXPECT_FALSE(FramesOf("r_knee").contains(15));
}

TEST_F(DopeSheet, DuplicatesAndDeletes) {
  user.Click(Key("limb r_hip", 15));
  const std::set<double> before = FramesOf("r_knee");
  user.Press('D', ui::kLeftShift);
  user.Press('2');
  user.Press(ui::kEnter);
  std::set<double> expected = before;
  expected.insert(17);
  EXPECT_EQ(FramesOf("r_knee"), expected);
  user.Press('X');  // the copies are selected
  EXPECT_EQ(FramesOf("r_knee"), before);
}

TEST_F(DopeSheet, ABoxSelectsWhatIsInIt) {
  const Point key = Key("limb r_hip", 15);
  user.Drag({key.x - 9.0f, key.y - 10.0f}, {key.x + 9.0f, key.y + 8.0f});
  const KeySelection& keys = user.session().selected_keys();
  EXPECT_TRUE(Contains(keys, "r_knee", 15));
  EXPECT_FALSE(Contains(keys, "l_knee", 15));
  for (const auto& [curve, frames] : keys) EXPECT_EQ(frames, std::set<double>{15}) << curve;
  user.Click({X(20), key.y});
  EXPECT_TRUE(user.session().selected_keys().empty());
}

TEST_F(DopeSheet, ScrubbingSetsTheFrame) {
  const float y = Layout().frame.ruler.y + 8.0f;
  user.Drag({X(3), y}, {X(12) + 1.0f, y});
  EXPECT_EQ(user.session().frame(), 12.0);
  user.Pull({X(12), y}, {X(20), y});
  EXPECT_EQ(user.session().frame(), 20.0);
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_EQ(user.session().frame(), 12.0);
  EXPECT_EQ(user.num_steps(), 0u);
}

TEST_F(DopeSheet, NamesSelectJointsAndArrowsOpenRows) {
  const ui::Rect row = Layout().row_rects[6];
  user.Click({70.0f, row.y + 5.0f});
  EXPECT_EQ(user.session().selected_joints().size(), 7u);
  EXPECT_TRUE(user.session().selected_joints().contains("r_wrist_flexion"));
  const size_t num_rows = Layout().rows.size();
  user.Click({9.0f, row.y + 5.0f});
  EXPECT_EQ(Layout().rows.size(), num_rows + 3);
}

TEST_F(DopeSheet, AltClickSelectsAColumn) {
  const Point key = Key("limb r_hip", 15);
  user.ClickWith(ui::kLeftAlt, key);
  EXPECT_TRUE(Contains(user.session().selected_keys(), "l_knee", 15));
  user.Press('A', ui::kLeftAlt);
  EXPECT_TRUE(user.session().selected_keys().empty());
  user.ClickWith(ui::kLeftShift, key);
  EXPECT_TRUE(Contains(user.session().selected_keys(), "r_knee", 15));
  EXPECT_FALSE(Contains(user.session().selected_keys(), "l_knee", 15));
  user.ClickWith(ui::kLeftShift, Key("limb l_hip", 15));
  EXPECT_TRUE(Contains(user.session().selected_keys(), "r_knee", 15));
  EXPECT_TRUE(Contains(user.session().selected_keys(), "l_knee", 15));
}

TEST_F(DopeSheet, BracketsSelectBeforeAndAfterThePlayhead) {
  user.editor().Do("time.frame", {{"frame", 10}});
  user.MoveTo({X(20), 400.0f});
  user.Press(ui::kLeftBracket);
  for (const auto& [curve, frames] : user.session().selected_keys()) {
    EXPECT_LE(*frames.rbegin(), 10.0) << curve;
  }
  user.Press(ui::kRightBracket);
  ASSERT_FALSE(user.session().selected_keys().empty());
  for (const auto& [curve, frames] : user.session().selected_keys()) {
    EXPECT_GE(*frames.begin(), 10.0) << curve;
  }
}

TEST_F(DopeSheet, CtrlWheelZoomsAtTheMouseAndTheWheelScrolls) {
  const float before = X(20);
  user.MoveTo({before, 400.0f});
  user.TurnWith(ui::kLeftControl, 3.0f);
  const double seen = user.editor().sheet.last - user.editor().sheet.first;
  EXPECT_LT(seen, 25.0);
  EXPECT_NEAR(X(20), before, 2.0);
  user.editor().sheet.open = {"limb r_shoulder", "limb l_shoulder", "limb r_hip", "limb l_hip"};
  user.Turn(-2.0f);
  EXPECT_GT(user.editor().sheet.scroll_px, 0.0);
}

TEST_F(DopeSheet, EscClosesAChoiceAndKeysCountAgain) {
  user.MoveTo({X(20), 400.0f});
  user.Press('A');
  user.Press('T');
  user.Wait(3);
  user.Press(ui::kRight);
  EXPECT_EQ(user.session().frame(), 0.0);
  user.Press(ui::kEscape);
  user.Press(ui::kRight);
  EXPECT_EQ(user.session().frame(), 1.0);
}

TEST_F(DopeSheet, PDragsThePreviewRangeThatIsPlayed) {
  user.MoveTo({X(4), 400.0f});
  user.Press('P');
  user.Drag({X(4), 400.0f}, {X(9), 400.0f});
  ASSERT_TRUE(user.project().preview);
  EXPECT_EQ(user.project().preview->first, 4);
  EXPECT_EQ(user.project().preview->last, 9);
  EXPECT_EQ(user.num_steps(), 1u);
  user.Press(ui::kSpace);
  for (int i = 0; i < 24; ++i) {
    user.Wait(1);
    EXPECT_GE(user.session().frame(), 4.0);
    EXPECT_LE(user.session().frame(), 9.0);
  }
}

TEST_F(DopeSheet, MarkersAreRenamedByADoubleClickOrF2AndRemovedByTheirMenu) {
  user.session().set_frame(8.0);
  ASSERT_TRUE(user.editor().Do("marker.add"));
  user.Wait();
  const ui::Rect band = Layout().frame.markers;
  const Point sign = {X(8.0), band.y + 0.5f * band.h};
  const auto type = [&](const char* name) {
    user.Wait(3);
    user.Type(name);
    user.Press(ui::kEnter);
    user.Wait();
  };
  user.Click(sign);
  user.Click(sign);
  type("swing");
  EXPECT_EQ(user.project().markers[0].name, "swing");
  user.Click({X(8.0) + 20.0f, sign.y});  // its name stands for it
  user.Click({X(8.0) + 20.0f, sign.y});
  type("throw");
  EXPECT_EQ(user.project().markers[0].name, "throw");
  user.MoveTo({X(12.0), band.bottom() + 30.0f});
  user.Press(ui::kF2);
  type("let go");
  EXPECT_EQ(user.project().markers[0].name, "let go");
  EXPECT_EQ(user.project().markers[0].frame, 8);
  user.Click(sign, 1);
  user.Wait(3);
  constexpr float kLine = 18.0f;  // of its entries [px]
  user.Click({sign.x + 30.0f, sign.y + 3.6f * kLine});
  EXPECT_TRUE(user.project().markers.empty());
}

TEST_F(DopeSheet, MarkersCanBeDragged) {
  user.MoveTo({X(20), 400.0f});
  user.editor().Do("time.frame", {{"frame", 11}});
  user.Press('M');
  ASSERT_EQ(user.project().markers.size(), 1u);
  const ui::Rect band = Layout().frame.markers;
  user.Drag({X(11), band.y + 8.0f}, {X(16), band.y + 8.0f});
  EXPECT_EQ(user.project().markers[0].frame, 16);
  EXPECT_EQ(user.num_steps(), 2u);
}

TEST_F(DopeSheet, HomeShowsAllFrames) {
  user.editor().sheet.first = 100.0;
  user.editor().sheet.last = 110.0;
  user.MoveTo({400.0f, 400.0f});
  user.Press(ui::kHome);
  EXPECT_LT(user.editor().sheet.first, 0.0);
  EXPECT_GT(user.editor().sheet.last, 30.0);
}

}  // namespace
}  // namespace hazumi::test
