// Dynamics regions in the dope sheet, with mouse and keys.

#include "tests/ui/dope_sheet/dope_sheet_user.h"

namespace hazumi::test {
namespace {

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
  EXPECT_EQ(user.editor().sheet.bar, (ui::BarId{ui::BarKind::kRegion, arms().identity.id}));
}

TEST_F(DopeSheet, DPaintsARegionOverRowsAndFrames) {
  const ui::DopeSheetLayout layout = Layout();
  const float right_leg = layout.row_rects[8].y + 5.0f, left_leg = layout.row_rects[9].y + 5.0f;
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
  const float right_leg = layout.row_rects[8].y + 5.0f;
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
  user.Click({60.0f, Layout().row_rects[5].y + 5.0f});  // name of the head
  user.MoveTo({X(2), Layout().row_rects[5].y + 5.0f});
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

TEST_F(DopeSheet, HMutesTheRegionThatWasClickedAndLetsItActAgain) {
  const ui::Rect bar = Bar("limb r_shoulder");
  user.Click({bar.x + 0.5f * bar.w, bar.y + 3.0f});
  user.Press('H');
  EXPECT_TRUE(arms().mute);
  EXPECT_FALSE(user.session()
                   .WholeMotion()
                   .value()
                   ->frames[8]
                   .in_region[user.session().figure().FindJoint("r_elbow_flexion")->value()]);
  Bar("limb r_shoulder");  // it is still there
  user.Press('H');
  EXPECT_FALSE(arms().mute);
  EXPECT_EQ(user.num_steps(), 2u);
}

TEST_F(DopeSheet, APaintedRegionKeysItsJointsOnItsFirstFrame) {
  user.editor().Do("region.remove", {{"region", arms().name}});
  const Point from = {X(8), Key("limb r_shoulder", 5).y};
  user.MoveTo(from);
  user.Press('D');
  user.Drag(from, {X(14), from.y});
  ASSERT_EQ(user.project().regions.size(), 1u);
  EXPECT_EQ(arms().first_frame, 8);
  EXPECT_TRUE(FramesOf("r_shoulder_flexion").contains(8.0));
  EXPECT_TRUE(FramesOf("r_elbow_flexion").contains(8.0));
  EXPECT_FALSE(FramesOf("l_elbow_flexion").contains(8.0));
  EXPECT_EQ(user.num_steps(), 2u);
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

TEST_F(DopeSheet, ADoubleClickOpensWhatCanBeDoneWithARegion) {
  const ui::Rect bar = Bar("limb r_shoulder");
  const Point middle = {bar.x + 0.5f * bar.w, bar.y + 3.0f};
  user.Click(middle);
  user.Click(middle);
  // While it is open keys are not the sheet's.
  user.Press('X');
  EXPECT_EQ(user.project().regions.size(), 1u);
  user.Press(ui::kEscape);  // leaves the name
  user.Press(ui::kEscape);  // and the window
  user.Press('X');
  EXPECT_EQ(user.num_steps(), 1u) << user.editor().message.text;
}

class WholeBody : public DopeSheet {
 protected:
  // Paints a region after the end of the holds of the feet.
  const ProjectRegion& Paint(const std::string& first_row, const std::string& last_row) {
    const size_t before = user.project().regions.size();
    const Point from = {X(18), RowOf(first_row)}, to = {X(26), RowOf(last_row)};
    user.MoveTo(from);
    user.Press('D');
    user.Drag(from, to);
    EXPECT_EQ(user.project().regions.size(), before + 1) << user.editor().message.text;
    return user.project().regions.back();
  }
  float RowOf(const std::string& id) {
    const ui::DopeSheetLayout layout = Layout();
    for (size_t i = 0; i < layout.rows.size(); ++i) {
      if (layout.rows[i].id == id) return layout.row_rects[i].y + 5.0f;
    }
    ADD_FAILURE() << "no row " << id;
    return 0.0f;
  }
  bool Turns() { return user.session().animation()->regions.back().root; }
};

TEST_F(WholeBody, RegionOverAllLimbs_TurnsAsItFalls) {
  const ProjectRegion& body = Paint("limb waist", "limb l_hip");
  EXPECT_TRUE(Turns());
  EXPECT_EQ(body.name, "body");
  EXPECT_EQ(body.friction.default_factor, 0.96);
  Bar("root", ui::BarKind::kRegion);
  EXPECT_EQ(user.num_steps(), 1u);
}

TEST_F(WholeBody, PaperMethod_LeavesTheRootToItsKeys) {
  ASSERT_TRUE(user.editor().Do("solver.set", {{"method", "paper"}}));
  ASSERT_TRUE(user.editor().Do("region.set", {{"region", arms().name}, {"method", "paper"}}));
  Paint("limb waist", "limb l_hip");
  EXPECT_FALSE(Turns());
}

TEST_F(WholeBody, RootsRowIsPaintedLikeALimb) {
  EXPECT_EQ(Paint("root", "limb waist").joints.front(), (JointRef{"pelvis", false, {}}));
  EXPECT_TRUE(Turns());
}

TEST_F(WholeBody, BarOfTheRoot_RemovesTheRoot) {
  Paint("limb waist", "limb l_hip");
  const ui::Rect bar = Bar("root", ui::BarKind::kRegion);
  user.Click({bar.x + 0.5f * bar.w, bar.y + 3.0f}, 1);
  user.Wait();
  EXPECT_EQ(user.editor().sheet.bar_row, "root");
  user.editor().Do("region.remove_joints", {{"region", "body"}, {"joints", {"pelvis"}}});
  EXPECT_FALSE(Turns());
  EXPECT_EQ(user.project().regions.back().joints.size(), 7u);
}

}  // namespace
}  // namespace hazumi::test
