// Regions that are made in the window touch the scene, and their bars show it.

#include "tests/ui/dope_sheet/dope_sheet_user.h"
#include "ui/panels/dope_sheet/bars.h"

namespace hazumi::test {
namespace {

class TouchingBars : public DopeSheet {
 protected:
  bool IsMarked(const std::string& row) {
    const ui::DopeSheetLayout layout = Layout();
    for (const ui::RowBar& bar : layout.bars) {
      const bool is_region = bar.ref.kind == ui::BarKind::kRegion;
      if (is_region && layout.rows[bar.row].id == row) return bar.touches;
    }
    ADD_FAILURE() << "no bar on " << row;
    return false;
  }
  void Set(const edit::Json& change) {
    edit::Json parameters = {{"region", arms().name}};
    parameters.update(change);
    ASSERT_TRUE(user.editor().Do("region.set", parameters)) << user.editor().message.text;
    user.Wait(1);
  }
  std::string Details() { return ui::DetailsOf(user.project(), {ui::BarKind::kRegion, 0}); }
  const ProjectRegion& PaintOnALeg() {
    const float leg = Layout().row_rects[8].y + 5.0f;
    user.MoveTo({X(18), leg});
    user.Press('D');
    user.Drag({X(18), leg}, {X(26), leg});
    EXPECT_EQ(user.project().regions.size(), 2u) << user.editor().message.text;
    return user.project().regions.back();
  }
};

TEST_F(TouchingBars, AreMarkedOnEachRowUnlessTheyAreMuted) {
  EXPECT_FALSE(IsMarked("limb r_shoulder"));
  EXPECT_EQ(Details(), "");
  Set({{"contacts", true}});
  EXPECT_TRUE(IsMarked("limb r_shoulder"));
  EXPECT_TRUE(IsMarked("limb l_shoulder"));
  EXPECT_EQ(Details(), "What it moves stays out of the scene's planes and boxes.");
  Set({{"contacts_self", true}});
  EXPECT_EQ(Details(),
            "What it moves stays out of the scene's planes and boxes.\n"
            "What it moves stays out of the own body.");
  Set({{"contacts", false}});
  EXPECT_TRUE(IsMarked("limb r_shoulder"));
  EXPECT_EQ(Details(), "What it moves stays out of the own body.");
  Set({{"mute", true}});
  EXPECT_FALSE(IsMarked("limb r_shoulder"));
  EXPECT_EQ(Details(), "Muted: its joints follow their keys.");
}

TEST_F(TouchingBars, APaintedRegionTouchesTheScene) { EXPECT_TRUE(PaintOnALeg().contacts.scene); }

TEST_F(TouchingBars, APaintedRegionOfThePapersMethodTouchesNothing) {
  ASSERT_TRUE(user.editor().Do("solver.set", {{"method", "paper"}}));
  Set({{"method", "paper"}});
  user.Wait(1);
  EXPECT_FALSE(PaintOnALeg().contacts.scene);
}

TEST_F(TouchingBars, ARegionOfTheSelectedJointsTouchesTheScene) {
  user.editor().Do("select.joints", {{"joints", {"neck"}}});
  user.MoveTo({X(18), Layout().row_rects[8].y + 5.0f});
  user.Press('D');
  user.Press(ui::kEnter);
  ASSERT_EQ(user.project().regions.size(), 2u) << user.editor().message.text;
  EXPECT_TRUE(user.project().regions.back().contacts.scene);
}

}  // namespace
}  // namespace hazumi::test
