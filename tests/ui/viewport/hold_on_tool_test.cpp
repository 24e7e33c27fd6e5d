// A hand takes hold of what is clicked.

#include "tests/ui/viewport/objects.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/viewport/figure.h"

namespace hazumi::test {
namespace {

class HoldOn : public Objects {
 protected:
  HoldOn() {
    AddBar(0.45);
    Do("time.frame", {{"frame", 5}});
    Do("select.joints", {{"joints", {"r_wrist"}}});
  }

  // Takes the tool in hand.
  void Take() {
    ASSERT_TRUE(user.editor().Invoke("tool.hold_on").ok());
    user.Wait(1);
  }
  const ProjectConstraint& Last() { return user.project().constraints.back(); }
  ui::Point MarkOf(const char* joint) {
    const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
    return InWindow(figure.CenterOf(*figure.figure().FindGroup(joint)));
  }
  const std::string& said() { return user.editor().message.text; }

  const Vec3 on_bar{0.425, -0.55, 1.25};
};

TEST_F(HoldOn, OfABarWhereItIsClickedInOneStep) {
  const size_t steps = user.num_steps();
  const std::string before = user.text();
  Take();
  user.MoveTo(InWindow(on_bar));
  ASSERT_TRUE(user.editor().viewport.aimed);
  EXPECT_EQ(user.editor().viewport.aimed->text, "bar");
  EXPECT_TRUE(user.editor().viewport.aimed->from);
  EXPECT_NE(user.editor().tool_hint().find("Click what r_wrist is to hold on to"),
            std::string::npos);
  EXPECT_EQ(user.text(), before);
  user.Click(InWindow(on_bar));
  EXPECT_FALSE(user.editor().has_tool());
  ASSERT_EQ(user.project().constraints.size(), 1u);
  EXPECT_EQ(Last().a.joint, "r_wrist");
  EXPECT_EQ(Last().b.object, "bar");
  EXPECT_NEAR(Last().b.offset_m.y(), -0.35, 0.1);
  EXPECT_EQ(Last().first_frame, 5);
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_EQ(user.editor().sheet.bar, (ui::BarId{ui::BarKind::kConstraint, Last().identity.id}));
  // No region moves the hand yet.
  EXPECT_NE(said().find("once a dynamics region moves"), std::string::npos) << said();
  EXPECT_FALSE(user.session().selected_joints().empty());
  user.Press('Z', ui::kLeftControl);
  EXPECT_EQ(user.text(), before);
}

TEST_F(HoldOn, OfAnotherJoint) {
  Do("region.add", {{"name", "arm"}, {"first", 0}, {"last", 30}, {"joints", {"r_shoulder+"}}});
  Take();
  user.Click(MarkOf("l_wrist"));
  ASSERT_EQ(user.project().constraints.size(), 1u) << said();
  EXPECT_EQ(Last().kind, ConstraintKind::kPoint);
  EXPECT_EQ(Last().b.joint, "l_wrist");
  EXPECT_EQ(Last().arrive_frames, 5);
  EXPECT_EQ(said(), "r_wrist holds on to l_wrist.");
}

TEST_F(HoldOn, OfTheGroundAndOfABallInTheOtherHand) {
  Do("held.add_ball", {{"joint", "l_wrist"}, {"radius", 0.2}});
  Do("select.joints", {{"joints", {"r_wrist"}}});
  Take();
  const Vec3 spot(0.6, -0.6, 0.0);
  user.Click(InWindow(spot));
  ASSERT_EQ(user.project().constraints.size(), 1u) << said();
  EXPECT_EQ(Last().b.object, "floor");
  EXPECT_LT((Last().b.offset_m - spot).norm(), 0.05);
  Take();
  user.Click(InWindow(BallNow() + Vec3(0.05, 0.0, -0.13)));
  ASSERT_EQ(user.project().constraints.size(), 2u) << said();
  EXPECT_EQ(Last().b.object, "ball");
  EXPECT_NEAR(Last().b.offset_m.norm(), 0.2, 1e-6);
}

// The tool stays in hand after a click that finds nothing or is refused, until Escape.
TEST_F(HoldOn, EscapeLeavesAllAsItWas) {
  Do("held.add_ball", {{"joint", "r_wrist"}, {"radius", 0.2}});
  Do("select.joints", {{"joints", {"r_wrist"}}});
  const std::string before = user.text();
  Take();
  user.Click(MarkOf("r_wrist"));
  EXPECT_TRUE(user.editor().has_tool());
  user.Click(InWindow(BallNow() + Vec3(0.05, 0.0, -0.13)));
  ASSERT_TRUE(user.editor().has_tool());
  ASSERT_TRUE(user.editor().viewport.aimed);
  EXPECT_TRUE(user.editor().viewport.aimed->is_trouble);
  user.Press(ui::kEscape);
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_FALSE(user.editor().viewport.aimed);
  EXPECT_EQ(user.text(), before);
}

TEST_F(HoldOn, NeedsAJoint) {
  Do("select.joints", {{"joints", edit::Json::array()}});
  EXPECT_FALSE(user.editor().Invoke("tool.hold_on").ok());
  EXPECT_FALSE(user.editor().has_tool());
}

}  // namespace
}  // namespace hazumi::test
