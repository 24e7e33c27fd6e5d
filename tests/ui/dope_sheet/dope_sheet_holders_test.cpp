// Who holds an object, as bars of its row, and its keys.

#include "tests/ui/dope_sheet/dope_sheet_user.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/viewport/actions.h"

namespace hazumi::test {
namespace {

using ui::BarKind;

// The ball of the throw, which is let go on frame 10 or so.
class DopeSheetHolders : public DopeSheet {
 protected:
  const ProjectHeldObject& ball() { return user.project().held_objects[0]; }
  ui::Rect Holder(int nth = 0) { return Bar(Row(), BarKind::kHolder, nth); }
  std::string Row() { return "held " + ball().name; }
  Point EndOf(const ui::Rect& bar) { return {bar.right() - 2.0f, bar.y + 4.0f}; }
  float Frames(double count) { return X(count) - X(0); }
  void Pass(const char* joint, int frame) {
    ASSERT_TRUE(user.editor().Do("held.pass",
                                 {{"object", ball().name}, {"joint", joint}, {"frame", frame}}));
    user.Wait(1);
  }
};

TEST_F(DopeSheetHolders, TheReleaseIsTheBarsEndAndIsDragged) {
  const int before = *ball().release_frame;
  EXPECT_NEAR(Holder().right(), X(before), 0.5f);
  const size_t steps = user.num_steps();
  const Point end = EndOf(Holder());
  user.Drag(end, {end.x - Frames(2), end.y});
  EXPECT_EQ(ball().release_frame, before - 2);
  EXPECT_EQ(user.num_steps(), steps + 1);
}

TEST_F(DopeSheetHolders, WhereItChangesHandsOneBorderIsDragged) {
  Pass("l_wrist", 3);
  const int last = *ball().holders[0].last_frame;
  EXPECT_NEAR(Holder(1).x, X(3), 0.5f);
  const Point end = EndOf(Holder(0));
  user.Drag(end, {end.x + Frames(2), end.y});
  EXPECT_EQ(ball().release_frame, 5);
  EXPECT_EQ(ball().holders[0].first_frame, 5);
  EXPECT_EQ(ball().holders[0].last_frame, last);
}

TEST_F(DopeSheetHolders, XRemovesTheHolderThatWasClicked) {
  Pass("l_wrist", 5);
  user.Click({Holder(1).x + 0.5f * Holder(1).w, Holder(1).y + 4.0f});
  user.Press('X');
  EXPECT_TRUE(ball().holders.empty());
}

TEST_F(DopeSheetHolders, ItsNameSelectsIt) {
  const ui::DopeSheetLayout layout = Layout();
  for (size_t row = 0; row < layout.rows.size(); ++row) {
    if (layout.rows[row].id != Row()) continue;
    user.Click({layout.frame.names.x + 60.0f, layout.row_rects[row].y + 8.0f});
  }
  EXPECT_EQ(ui::NameOfSelectedObject(user.editor()), ball().name);
}

TEST_F(DopeSheetHolders, KeysOfItsPositionAreMovedLikeOthers) {
  user.editor().Do("time.frame", {{"frame", 20}});
  ASSERT_TRUE(user.editor().Do("held.key", {{"object", ball().name}}));
  user.Wait(1);
  const Point key = Key(Row(), 20);
  user.Drag(key, {key.x + Frames(3), key.y});
  for (const ProjectCurve& curve : ball().position.curves) {
    ASSERT_EQ(curve.keys.size(), 1u);
    EXPECT_EQ(curve.keys[0].frame, 23.0);
  }
}

}  // namespace
}  // namespace hazumi::test
