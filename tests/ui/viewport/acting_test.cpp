// What constraints and forces look like in the viewport.

#include "ui/panels/viewport/acting.h"

#include "tests/ui/viewport/objects.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/viewport/goal_marks.h"

namespace hazumi::test {
namespace {

// A swinging arm whose hand is to arrive at a bar in front of it, between frames 5 and 25.
class Acting : public Objects {
 protected:
  Acting() {
    Do("key.set", {{"curve", "r_elbow_flexion"}, {"frame", 0}, {"value", 60}});
    Do("region.add", {{"name", "arm"}, {"first", 0}, {"last", 30}, {"joints", {"r_shoulder+"}}});
    AddBar(0.35);
    Do("time.frame", {{"frame", 5}});
    Do("constraint.hold_on",
       {{"joint", "r_wrist"}, {"object", "bar"}, {"name", "grip"}, {"last", 25}});
  }

  std::vector<ui::ConstraintMark> Marks(int frame) {
    Do("time.frame", {{"frame", frame}});
    const Motion& motion = *user.session().WholeMotion().value();
    const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
    return ui::ConstraintMarks(*user.session().animation(), motion, figure);
  }
  std::vector<ui::ForceMark> Forces(int frame) {
    Do("time.frame", {{"frame", frame}});
    return ui::ForceMarks(*user.session().animation(), *ui::PoseNow(&user.session()));
  }
  Vec3 Wrist() {
    const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
    return figure.CenterOf(*figure.figure().FindGroup("r_wrist"));
  }
  std::string Said(const ui::ConstraintMark& mark) { return ui::TextOf(mark, user.project()); }
};

TEST_F(Acting, AConstraintIsOpenUntilItsGapIsClosedAndThenPulls) {
  EXPECT_TRUE(Marks(4).empty());
  const std::vector<ui::ConstraintMark> first = Marks(5);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_TRUE(first[0].is_open());
  EXPECT_GT(first[0].gap, 0.05);
  EXPECT_NEAR(first[0].gap, (first[0].a - first[0].b).norm(), 1e-12);
  EXPECT_LT((first[0].a - Wrist()).norm(), 1e-9);
  EXPECT_NE(Said(first[0]).find("cm apart"), std::string::npos) << Said(first[0]);
  const std::vector<ui::ConstraintMark> closed = Marks(20);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_FALSE(closed[0].is_open()) << closed[0].gap;
  EXPECT_GT(closed[0].force, 1.0);
  EXPECT_TRUE(Said(closed[0]).starts_with("grip: ") && Said(closed[0]).ends_with(" N"));
  EXPECT_TRUE(Marks(25).empty());
}

TEST_F(Acting, AGoalIsSeenInTheSecondBeforeIt) {
  Do("goal.add", {{"kind", "point"},
                  {"name", "bell"},
                  {"frame", 20},
                  {"joint", "r_wrist"},
                  {"position_x", 0.4},
                  {"position_y", -0.2},
                  {"position_z", 1.1}});
  const auto marks = [&](int frame) {
    Do("time.frame", {{"frame", frame}});
    return ui::GoalMarks(user.project(), *ui::PoseNow(&user.session()));
  };
  EXPECT_TRUE(marks(21).empty());
  const std::vector<ui::GoalMark> before = marks(16), there = marks(20);
  ASSERT_EQ(before.size(), 1u);
  EXPECT_LT((before[0].place - Vec3(0.4, -0.2, 1.1)).norm(), 1e-12);
  EXPECT_EQ(ui::TextOf(before[0], user.project()), "bell: in 4 frames");
  EXPECT_LT((there[0].point - Wrist()).norm(), 1e-9);
  EXPECT_TRUE(ui::TextOf(there[0], user.project()).ends_with(" cm off"));
}

TEST_F(Acting, ABrokenConstraintSaysSo) {
  Do("constraint.set", {{"constraint", "grip"}, {"break_force", 1.0}});
  const std::vector<ui::ConstraintMark> marks = Marks(20);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_TRUE(marks[0].is_broken);
  EXPECT_EQ(Said(marks[0]), "grip: broken");
}

TEST_F(Acting, ADistanceIsClosedAtItsLength) {
  Do("constraint.add", {{"kind", "distance"},
                        {"name", "rope"},
                        {"a_joint", "l_wrist"},
                        {"b_joint", "neck"},
                        {"first", 5},
                        {"last", 30}});
  const std::vector<ui::ConstraintMark> marks = Marks(5);
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_GT((marks[1].a - marks[1].b).norm(), 0.1);
  EXPECT_FALSE(marks[1].is_open());
}

TEST_F(Acting, ForcesAreArrowsInTheirFrames) {
  Do("force.add", {{"kind", "wind"}, {"velocity_x", 5.0}, {"first", 3}, {"last", 10}});
  Do("force.add", {{"kind", "push"},
                   {"joint", "r_wrist"},
                   {"impulse_x", 0.0},
                   {"impulse_z", 4.0},
                   {"frame", 12}});
  Do("force.add", {{"kind", "attract"},
                   {"joint", "r_elbow"},
                   {"to_x", 1.0},
                   {"pull", 30.0},
                   {"first", 20},
                   {"last", 30}});
  EXPECT_TRUE(Forces(2).empty());
  const std::vector<ui::ForceMark> wind = Forces(3);
  ASSERT_EQ(wind.size(), 1u);
  EXPECT_GT((wind[0].to - wind[0].from).x(), 0.0);
  EXPECT_EQ(ui::TextOf(wind[0]), "5.0 m/s");
  EXPECT_TRUE(Forces(11).empty());
  const std::vector<ui::ForceMark> push = Forces(12);
  ASSERT_EQ(push.size(), 1u);
  EXPECT_LT((push[0].to - Wrist()).norm(), 1e-9);
  EXPECT_EQ(ui::TextOf(push[0]), "4 N s");
  EXPECT_TRUE(Forces(13).empty());
  // On the last frame of all what ends there is seen.
  const std::vector<ui::ForceMark> pull = Forces(30);
  ASSERT_EQ(pull.size(), 1u);
  EXPECT_EQ(pull[0].to.x(), 1.0);
  EXPECT_LE(pull[0].strength, 30.0);
}

TEST_F(Acting, TheyAreHiddenByTheirSwitchAndSaidUnderTheMouse) {
  const std::vector<ui::ConstraintMark> marks = Marks(6);
  ASSERT_EQ(marks.size(), 1u);
  const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
  const ui::ViewportState& state = user.editor().viewport;
  const ui::View view = ui::ViewOf(state, user.project(), state.rect);
  const ui::Point middle = InWindow(0.5 * (marks[0].a + marks[0].b));
  const auto said = [&] { return ui::ActingAt(&user.editor(), view, figure, middle); };
  EXPECT_EQ(said(), Said(marks[0]));
  const std::vector<uint8_t> shown = user.picture();
  Do("view.overlay", {{"name", "forces"}, {"on", false}});
  user.Wait();
  EXPECT_EQ(said(), "");
  EXPECT_NE(user.picture(), shown);
}

TEST_F(Acting, AClickOnItsLineChoosesItsBarAndLeavesTheSelection) {
  const std::vector<ui::ConstraintMark> marks = Marks(6);
  Do("select.joints", {{"joints", {"l_knee"}}});
  const std::set<std::string> selected = user.session().selected_joints();
  user.Click(InWindow(marks[0].a + 0.6 * (marks[0].b - marks[0].a)));
  const ItemId id = user.project().constraints[0].identity.id;
  EXPECT_EQ(user.editor().sheet.bar, (ui::BarId{ui::BarKind::kConstraint, id}));
  EXPECT_EQ(user.session().selected_joints(), selected);
}

TEST_F(Acting, ForcesSayTheirNameUnderTheMouse) {
  Do("force.add", {{"kind", "wind"}, {"name", "gale"}, {"velocity_x", -20.0}});
  const std::vector<ui::ForceMark> wind = Forces(3);
  ASSERT_EQ(wind.size(), 1u);
  const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
  const ui::ViewportState& state = user.editor().viewport;
  const ui::View view = ui::ViewOf(state, user.project(), state.rect);
  const ui::Point middle = InWindow(0.5 * (wind[0].from + wind[0].to));
  EXPECT_EQ(ui::ActingAt(&user.editor(), view, figure, middle), "gale: 20.0 m/s");
}

TEST_F(Acting, TheChosenOneIsHighlighted) {
  Marks(6);
  user.Wait();
  const std::vector<uint8_t> plain = user.picture();
  const ui::BarRef bar = {ui::BarKind::kConstraint, 0};
  ui::ChooseBar(&user.editor(), bar);
  user.Wait();
  EXPECT_NE(user.picture(), plain);
}

}  // namespace
}  // namespace hazumi::test
