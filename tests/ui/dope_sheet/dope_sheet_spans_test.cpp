// What places the figure, and holds, as bars of the dope sheet, with mouse and keys.

#include "tests/ui/dope_sheet/dope_sheet_user.h"
#include "ui/panels/dope_sheet/bars.h"

namespace hazumi::test {
namespace {

using ui::BarKind;
using ui::BarRef;

// The throw, which is pinned by a toe from frame 5 on, while both toes are held up to there.
class DopeSheetSpans : public DopeSheet {
 protected:
  ui::Rect Span(int nth) { return Bar("placement", BarKind::kPlacement, nth); }
  ui::Rect HoldOf(const std::string& limb) { return Bar("limb " + limb, BarKind::kHold); }
  // Gravity from 15 to 20, between two pins.
  void AddGravity() {
    user.editor().Do("placement.set", {{"kind", "gravity"}, {"first", 15}, {"last", 20}});
    ASSERT_EQ(user.project().placements.size(), 3u) << user.editor().message.text;
    user.editor().Do("edit.end_drag");
    user.Wait(1);
    steps_before = user.num_steps();
  }
  std::vector<int> Frames() {
    std::vector<int> frames;
    for (const ProjectPlacement& span : user.project().placements) {
      frames.insert(frames.end(), {span.first_frame, span.last_frame});
    }
    return frames;
  }
  std::optional<BarRef> Chosen() { return ui::ChosenBar(user.project(), user.editor().sheet); }
  static Point StartOf(const ui::Rect& bar) { return {bar.x + 2.0f, bar.y + 4.0f}; }
  static Point EndOf(const ui::Rect& bar) { return {bar.right() - 2.0f, bar.y + 4.0f}; }
  static Point MiddleOf(const ui::Rect& bar) { return {bar.x + 0.5f * bar.w, bar.y + 4.0f}; }

  size_t steps_before = 0;
};

TEST_F(DopeSheetSpans, NeighboursGiveWayAndComeBackWhenItIsDraggedBack) {
  AddGravity();
  const Point start = StartOf(Span(1));
  user.Pull(start, {X(5), start.y});  // the pin before it is gone
  EXPECT_EQ(Frames(), (std::vector<int>{5, 20, 20, 30}));
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kPlacement, 0}));
  user.MoveTo({X(12), start.y});
  user.Hold(0, false);
  user.Wait(1);
  EXPECT_EQ(Frames(), (std::vector<int>{5, 12, 12, 20, 20, 30}));
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kPlacement, 1}));
  EXPECT_EQ(user.num_steps(), steps_before + 1);
}

TEST_F(DopeSheetSpans, DraggingASpanMovesItWhole) {
  AddGravity();
  const Point middle = MiddleOf(Span(1));
  user.Drag(middle, {middle.x + X(3) - X(0), middle.y});
  EXPECT_EQ(Frames(), (std::vector<int>{5, 15, 18, 23, 23, 30}));
}

TEST_F(DopeSheetSpans, EscapeLeavesEverythingAsItWas) {
  AddGravity();
  const std::string before = user.text();
  const Point start = StartOf(Span(1));
  user.Pull(start, {X(5), start.y});
  EXPECT_NE(user.text(), before);
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_EQ(user.text(), before);
  EXPECT_EQ(user.num_steps(), steps_before);
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kPlacement, 1}));
}

TEST_F(DopeSheetSpans, XDeletesTheSpanThatWasClicked) {
  AddGravity();
  user.Click(MiddleOf(Span(1)));
  user.Press('X');
  EXPECT_EQ(Frames(), (std::vector<int>{5, 15, 20, 30}));
  EXPECT_EQ(Chosen(), std::nullopt);
}

TEST_F(DopeSheetSpans, AHoldIsStretchedOnTheRowOfItsLimb) {
  const Point end = EndOf(HoldOf("r_hip"));
  user.Drag(end, {end.x + X(4) - X(0), end.y});
  EXPECT_EQ(user.project().holds[1].joint, "r_toe");
  EXPECT_EQ(user.project().holds[1].last_frame, 9) << user.editor().message.text;
  EXPECT_EQ(user.num_steps(), 1u);
  user.Press('Z', ui::kLeftControl);
  EXPECT_EQ(user.project().holds[1].last_frame, 5);
}

TEST_F(DopeSheetSpans, TheHintSaysWhyADragIsRefused) {
  const std::string before = user.text();
  const Point end = EndOf(HoldOf("l_hip"));
  user.Pull(end, {end.x + X(4) - X(0), end.y});
  const std::string hint = user.editor().tool_hint();
  EXPECT_NE(hint.find("Stretch hold  held: l_toe  0 - 9"), std::string::npos) << hint;
  EXPECT_NE(hint.find("! \"l_toe\" is pinned"), std::string::npos) << hint;
  user.Hold(0, false);
  EXPECT_EQ(user.text(), before);
  EXPECT_TRUE(user.editor().message.is_error);
}

TEST_F(DopeSheetSpans, TheHintSaysWhyThereIsNoMotionAnyMore) {
  const Point end = EndOf(HoldOf("r_hip"));
  user.Pull(end, {end.x + X(5) - X(0), end.y});
  EXPECT_FALSE(user.session().WholeMotion().ok());  // as the picture asks for it
  user.Pass(0.0);
  const std::string hint = user.editor().tool_hint();
  EXPECT_NE(hint.find("out of reach"), std::string::npos) << hint;
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_TRUE(user.session().WholeMotion().ok());
}

TEST_F(DopeSheetSpans, XDeletesTheHoldThatWasClicked) {
  user.Click(MiddleOf(HoldOf("l_hip")));
  user.Press('X');
  ASSERT_EQ(user.project().holds.size(), 1u);
  EXPECT_EQ(user.project().holds[0].joint, "r_toe");
}

TEST_F(DopeSheetSpans, ADoubleClickOpensWhatCanBeChanged) {
  for (const ui::Rect& bar : {Span(0), HoldOf("l_hip")}) {
    user.Click(MiddleOf(bar));
    user.Click(MiddleOf(bar));
    user.Press('X');  // while it is open keys are not the sheet's
    EXPECT_EQ(user.num_steps(), 0u);
    user.Press(ui::kEscape);
    user.Pass(1.0);  // the next click is no double one
  }
}

TEST_F(DopeSheetSpans, ADragOfAFieldThatIsGivenUpLeavesItsSpanChosen) {
  AddGravity();
  user.Click(MiddleOf(Span(1)));
  user.Click(MiddleOf(Span(1)));  // its fields are shown
  for (const int first : {10, 5}) {
    ASSERT_TRUE(ui::EditChosenBar(&user.editor(), {{"first", first}, {"drag", "a field"}}).ok());
    user.Wait(1);
  }
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kPlacement, 0}));
  user.editor().Do("edit.cancel_drag");
  user.Wait(1);
  EXPECT_EQ(Frames(), (std::vector<int>{5, 15, 15, 20, 20, 30}));
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kPlacement, 1}));
}

TEST_F(DopeSheetSpans, AConstraintIsOnTheRowsOfItsJointsAndIsDraggedThere) {
  user.editor().Do("constraint.add", {{"kind", "distance"},
                                      {"a_joint", "r_wrist"},
                                      {"b_joint", "l_toe"},
                                      {"first", 10},
                                      {"last", 14},
                                      {"arrive", 2}});
  user.editor().Do("edit.end_drag");
  user.Wait(1);
  ASSERT_EQ(user.project().constraints.size(), 1u) << user.editor().message.text;
  EXPECT_GT(Bar("limb l_hip", BarKind::kConstraint).w, 0.0f);
  const auto bar = [&] { return Bar("limb r_shoulder", BarKind::kConstraint); };
  const ProjectConstraint& rod = user.project().constraints[0];
  Point middle = MiddleOf(bar());
  user.Drag(middle, {middle.x + X(2) - X(0), middle.y});
  EXPECT_EQ(rod.first_frame, 12);
  EXPECT_EQ(rod.last_frame, 16);
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kConstraint, 0}));
  EXPECT_EQ(ui::TitleOf(user.project(), *Chosen()), "distance");
  EXPECT_EQ(ui::DetailsOf(user.project(), *Chosen()), "distance: r_wrist - l_toe");
  const Point end = EndOf(bar());
  user.Drag(end, {end.x + X(3) - X(0), end.y});
  EXPECT_EQ(rod.first_frame, 12);
  EXPECT_EQ(rod.last_frame, 19);
  user.editor().Do("sheet.delete");
  EXPECT_TRUE(user.project().constraints.empty());
}

TEST_F(DopeSheetSpans, ASelectedJointIsHeldFromTheCurrentFrameToWhereItIsInTheWay) {
  user.editor().Do("time.frame", {{"frame", 2}});
  user.editor().Do("select.joints", {{"joints", {"l_toe"}}});
  user.editor().Do("hold.remove", {{"index", 0}});
  ASSERT_TRUE(user.editor().Do("span.hold")) << user.editor().message.text;
  const ProjectHold& hold = user.project().holds.back();
  EXPECT_EQ(hold.joint, "l_toe");
  EXPECT_EQ(hold.first_frame, 2);
  EXPECT_EQ(hold.last_frame, 5);  // it is pinned there
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kHold, 1}));
}

TEST_F(DopeSheetSpans, PinAndGravityLeaveLaterSpansAlone) {
  AddGravity();
  user.editor().Do("time.frame", {{"frame", 10}});
  user.editor().Do("select.joints", {{"joints", {"r_toe"}}});
  ASSERT_TRUE(user.editor().Do("span.pin")) << user.editor().message.text;
  EXPECT_EQ(Frames(), (std::vector<int>{5, 10, 10, 15, 15, 20, 20, 30}));
  EXPECT_EQ(user.project().placements[1].pin, "r_toe");
  ASSERT_TRUE(user.editor().Do("span.gravity")) << user.editor().message.text;
  EXPECT_EQ(user.project().placements[1].kind, PlacementKind::kGravity);
  EXPECT_EQ(Chosen(), (BarRef{BarKind::kPlacement, 1}));
}

TEST_F(DopeSheetSpans, WithoutASelectedJointNothingIsPinned) {
  user.editor().Do("select.none");
  EXPECT_FALSE(user.editor().Do("span.pin"));
  EXPECT_EQ(user.editor().message.text, "Select the joint that is to be pinned.");
  EXPECT_EQ(user.num_steps(), 0u);
}

}  // namespace
}  // namespace hazumi::test
