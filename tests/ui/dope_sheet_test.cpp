// The dope sheet as it is used, with mouse and keys.

#include "tests/ui/user.h"
#include "ui/panels/dope_sheet_layout.h"

namespace hazumi::test {
namespace {

using ui::Point;

class DopeSheet : public testing::Test {
 protected:
  DopeSheet() : user("throw.kfa") {}

  ui::DopeSheetLayout Layout() {
    return ui::LayOutDopeSheet(user.session(), user.editor().sheet, user.editor().sheet.rect, 1.0);
  }
  ui::Rect Bar(const std::string& row) {
    const ui::DopeSheetLayout layout = Layout();
    for (const ui::RowBar& bar : layout.bars) {
      if (layout.rows[bar.row].id == row && bar.is_region) return bar.rect;
    }
    ADD_FAILURE() << "no region on " << row;
    return {};
  }
  Point Key(const std::string& row, double frame) {
    const ui::DopeSheetLayout layout = Layout();
    for (const ui::RowKey& key : layout.keys) {
      if (layout.rows[key.row].id == row && key.frame == frame) return key.at;
    }
    ADD_FAILURE() << "no key on " << row << " at " << frame;
    return {};
  }
  float X(double frame) { return Layout().frame.axis.XOf(frame); }
  const ProjectRegion& arms() { return user.project().regions[0]; }
  std::set<double> FramesOf(const std::string& hinge) {
    std::set<double> frames;
    for (const auto& curve : user.project().joints) {
      if (curve.name != hinge) continue;
      for (const ProjectKey& key : curve.value.keys) frames.insert(key.frame);
    }
    return frames;
  }

  User user;
};

TEST_F(DopeSheet, DraggingARegionsEndIsOneStepAndRebakes) {
  const ui::Rect bar = Bar("limb r_shoulder");
  const Point end = {bar.right() + 1.0f, bar.y + 3.0f};
  const double before = user.session().WholeMotion().value()->frames[18].q[10];
  user.Drag(end, {X(20), end.y});
  EXPECT_EQ(arms().last_frame, 20);
  EXPECT_EQ(arms().first_frame, 5);
  EXPECT_EQ(user.num_steps(), 1u);
  EXPECT_NE(user.session().WholeMotion().value()->frames[18].q[10], before);
  user.Press('Z', ui::kLeftControl);
  EXPECT_EQ(arms().last_frame, 15);
}

TEST_F(DopeSheet, DraggingARegionMovesItWhole) {
  const ui::Rect bar = Bar("limb l_shoulder");
  const Point middle = {bar.x + 0.5f * bar.w, bar.y + 3.0f};
  user.Drag(middle, {middle.x + X(3) - X(0), middle.y});
  EXPECT_EQ(arms().first_frame, 8);
  EXPECT_EQ(arms().last_frame, 18);
  EXPECT_EQ(user.num_steps(), 1u);
  EXPECT_EQ(user.editor().sheet.region, "arms");
}

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
  user.Press('3');
  user.Press(ui::kEnter);
  std::set<double> expected = before;
  expected.insert(18);
  EXPECT_EQ(FramesOf("r_knee"), expected);
  user.Press('X');  // the copies are selected
  EXPECT_EQ(FramesOf("r_knee"), before);
}

TEST_F(DopeSheet, ABoxSelectsWhatIsInIt) {
  const Point key = Key("limb r_hip", 15);
  user.Drag({key.x - 9.0f, key.y - 10.0f}, {key.x + 9.0f, key.y + 8.0f});
  const edit::KeySelection& keys = user.session().selected_keys();
  EXPECT_TRUE(edit::Contains(keys, "r_knee", 15));
  EXPECT_FALSE(edit::Contains(keys, "l_knee", 15));
  for (const auto& [curve, frames] : keys) EXPECT_EQ(frames, std::set<double>{15}) << curve;
  user.Click({X(27), key.y});
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

TEST_F(DopeSheet, DPaintsARegionOverRowsAndFrames) {
  const ui::DopeSheetLayout layout = Layout();
  const float right_leg = layout.row_rects[6].y + 5.0f, left_leg = layout.row_rects[7].y + 5.0f;
  user.MoveTo({X(18), right_leg});
  user.Press('D');
  ASSERT_TRUE(user.editor().has_tool());
  user.Drag({X(18), right_leg}, {X(26), left_leg});
  EXPECT_FALSE(user.editor().has_tool());
  ASSERT_EQ(user.project().regions.size(), 2u) << user.editor().message.text;
  const ProjectRegion& legs = user.project().regions[1];
  EXPECT_EQ(legs.name, "legs");
  EXPECT_EQ(legs.first_frame, 18);
  EXPECT_EQ(legs.last_frame, 26);
  EXPECT_EQ(legs.joints, (std::vector<JointRef>{{"r_hip", true, {}}, {"l_hip", true, {}}}));
  EXPECT_EQ(user.num_steps(), 1u);
}

TEST_F(DopeSheet, APaintedRegionIsThereBeforeTheButtonIsLetGo) {
  const ui::DopeSheetLayout layout = Layout();
  const float right_leg = layout.row_rects[6].y + 5.0f;
  user.MoveTo({X(18), right_leg});
  user.Press('D');
  user.Pull({X(18), right_leg}, {X(26), right_leg});
  ASSERT_EQ(user.project().regions.size(), 2u) << user.editor().message.text;
  EXPECT_EQ(user.project().regions[1].last_frame, 26);
  user.MoveTo({X(22), right_leg});
  ASSERT_EQ(user.project().regions.size(), 2u);
  EXPECT_EQ(user.project().regions[1].last_frame, 22);
  user.MoveTo({X(18), right_leg});  // no frame long
  EXPECT_EQ(user.project().regions.size(), 1u);
  user.MoveTo({X(24), right_leg});
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_EQ(user.project().regions.size(), 1u);
  EXPECT_EQ(user.num_steps(), 0u);
}

TEST_F(DopeSheet, DAndEnterMarksTheSelectedJoints) {
  user.Click({60.0f, Layout().row_rects[3].y + 5.0f});  // the head's name
  user.MoveTo({X(2), Layout().row_rects[3].y + 5.0f});
  user.Press('D');
  user.Press(ui::kEnter);
  ASSERT_EQ(user.project().regions.size(), 2u) << user.editor().message.text;
  EXPECT_EQ(user.project().regions[1].joints.size(), 3u);
  EXPECT_EQ(user.project().regions[1].first_frame, 0);
  EXPECT_EQ(user.project().regions[1].last_frame, 10);
}

TEST_F(DopeSheet, XRemovesTheRegionThatWasClicked) {
  const ui::Rect bar = Bar("limb r_shoulder");
  user.Click({bar.x + 0.5f * bar.w, bar.y + 3.0f});
  user.Press('X');
  EXPECT_TRUE(user.project().regions.empty());
}

TEST_F(DopeSheet, NamesSelectJointsAndArrowsOpenRows) {
  const ui::Rect row = Layout().row_rects[4];
  user.Click({70.0f, row.y + 5.0f});
  EXPECT_EQ(user.session().selected_joints().size(), 7u);
  EXPECT_TRUE(user.session().selected_joints().contains("r_wrist_flexion"));
  const size_t num_rows = Layout().rows.size();
  user.Click({9.0f, row.y + 5.0f});
  EXPECT_EQ(Layout().rows.size(), num_rows + 3);
}

TEST_F(DopeSheet, ARegionStopsWhereAnotherHasItsJoints) {
  user.editor().Do("region.add",
                   {{"name", "late"}, {"first", 18}, {"last", 25}, {"joints", {"r_shoulder+"}}});
  const ui::Rect bar = Bar("limb r_shoulder");
  user.Drag({bar.right() + 1.0f, bar.y + 3.0f}, {X(22), bar.y + 3.0f});
  EXPECT_GE(arms().last_frame, 15);
  EXPECT_LE(arms().last_frame, 18);
  EXPECT_TRUE(user.editor().message.is_error);
  EXPECT_TRUE(user.session().WholeMotion().ok());
}

TEST_F(DopeSheet, AltClickSelectsAColumn) {
  const Point key = Key("limb r_hip", 15);
  user.ClickWith(ui::kLeftAlt, key);
  EXPECT_TRUE(edit::Contains(user.session().selected_keys(), "l_knee", 15));
  user.Press('A', ui::kLeftAlt);
  EXPECT_TRUE(user.session().selected_keys().empty());
  user.ClickWith(ui::kLeftShift, key);
  EXPECT_TRUE(edit::Contains(user.session().selected_keys(), "r_knee", 15));
  EXPECT_FALSE(edit::Contains(user.session().selected_keys(), "l_knee", 15));
  user.ClickWith(ui::kLeftShift, Key("limb l_hip", 15));
  EXPECT_TRUE(edit::Contains(user.session().selected_keys(), "r_knee", 15));
  EXPECT_TRUE(edit::Contains(user.session().selected_keys(), "l_knee", 15));
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

TEST_F(DopeSheet, ADoubleClickOpensWhatCanBeDoneWithARegion) {
  const ui::Rect bar = Bar("limb r_shoulder");
  const Point middle = {bar.x + 0.5f * bar.w, bar.y + 3.0f};
  user.Click(middle);
  user.Click(middle);
  // While it is open keys are not the sheet's.
  user.Press('X');
  EXPECT_EQ(user.project().regions.size(), 1u);
  user.Click({middle.x + 250.0f, middle.y + 60.0f});
  user.Press('X');
  EXPECT_EQ(user.num_steps(), 1u);
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
