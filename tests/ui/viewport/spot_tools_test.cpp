// A jump and a throw onto the spot under the mouse.

#include "tests/ui/viewport/objects.h"
#include "ui/panels/forms/parameter_form.h"
#include "ui/panels/problems/problems.h"
#include "ui/panels/viewport/goal_marks.h"

namespace hazumi::test {
namespace {

TEST_F(Objects, JPutsAJumpOntoTheBoxUnderTheMouseInOneStep) {
  Do("object.add_box",
     {{"name", "box"}, {"x", 1.2}, {"z", 0.2}, {"size_x", 0.8}, {"size_y", 0.8}, {"size_z", 0.4}});
  const size_t steps = user.num_steps();
  user.MoveTo(InWindow(Vec3(0.4, 0.0, 0.0)));
  user.Press('J');
  user.MoveTo(InWindow(Vec3(1.2, 0.0, 0.4)));
  EXPECT_EQ(user.project().placements.size(), 3u) << user.editor().message.text;
  user.Click(InWindow(Vec3(1.2, 0.0, 0.4)));
  EXPECT_EQ(user.num_steps(), steps + 1);
  const Result<const Motion*> motion = user.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  EXPECT_GT(motion.value()->frames.back().X_WR.p.z(), 1.2);
  EXPECT_NEAR(motion.value()->frames.back().X_WR.p.x(), 1.2, 0.2);
}

TEST_F(Objects, EscapeTakesTheJumpBack) {
  const std::string before = user.text();
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  user.Press('J');
  user.MoveTo(InWindow(Vec3(0.8, 0.0, 0.0)));
  EXPECT_NE(user.text(), before);
  user.Press(ui::kEscape);
  EXPECT_EQ(user.text(), before);
}

// The arms swing from a wind-up, and let go.
class Throwing : public Objects {
 protected:
  Throwing() {
    Do("time.range", {{"first", 0}, {"last", 30}});
    Do("held.add_ball", {{"joint", "r_wrist"}, {"release", 10}});
    Do("key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 2}, {"value", -40}});
    Do("region.add", {{"name", "arm"}, {"first", 2}, {"last", 14}, {"joints", {"r_shoulder+"}}});
    Do("object.add_box", {{"name", "table"}, {"x", 1.2}, {"z", 0.25}, {"size_z", 0.5}});
  }
};

TEST_F(Throwing, TThrowsTheBallOntoTheSpotUnderTheMouseInOneStep) {
  const Vec3 spot(1.2, -0.3, 0.5);
  const size_t steps = user.num_steps();
  user.MoveTo(InWindow(spot));
  user.Press('T');
  user.MoveTo(InWindow(spot));
  user.Click(InWindow(spot));
  EXPECT_EQ(user.num_steps(), steps + 1) << user.editor().message.text;
  const Result<const Motion*> motion = user.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  EXPECT_LE((motion.value()->frames.back().objects[0].X_WO.p - spot).head<2>().norm(), 0.03);
}

// A hand on a box in frame 12: the joint, the frame, the tool, the spot.
TEST_F(Objects, AHandReachesTheSpotUnderTheMouseInTheFrameShown) {
  Do("object.add_box", {{"name", "button"},
                        {"x", 0.45},
                        {"y", -0.25},
                        {"z", 1.0},
                        {"size_x", 0.2},
                        {"size_y", 0.2},
                        {"size_z", 0.2}});
  Do("select.joints", {{"joints", {"r_wrist"}}});
  Do("time.frame", {{"frame", 12}});
  const Vec3 spot(0.4, -0.25, 1.1);
  const size_t steps = user.num_steps();
  Do("tool.aim", edit::Json::object());
  user.MoveTo(InWindow(spot));
  user.MoveTo(InWindow(spot));
  user.Click(InWindow(spot));
  EXPECT_EQ(user.num_steps(), steps + 1) << user.editor().message.text;
  ASSERT_EQ(user.project().goals.size(), 1u);
  EXPECT_TRUE(user.editor().message.text.starts_with("Arrives")) << user.editor().message.text;
  EXPECT_LT((user.project().goals[0].position_m - spot).norm(), 0.05);
}

// The ring of the spot is dragged, and the throw follows; Escape or undo brings it back.
TEST_F(Objects, TheSpotOfAThrowIsDragged) {
  Do("held.add_ball", {{"joint", "r_wrist"}});
  Do("throw.add", {{"object", "ball"}, {"x", 0.9}, {"y", 0.5}});
  Do("time.frame", {{"frame", user.project().goals[0].frame}});
  const size_t steps = user.num_steps();
  const std::string before = user.text();
  const Vec3 from = user.project().goals[0].position_m, to(1.1, 0.8, from.z());
  user.MoveTo(InWindow(from));
  user.Drag(InWindow(from), InWindow(to));
  EXPECT_EQ(user.num_steps(), steps + 1);
  const Vec3 place = user.project().goals[0].position_m;
  EXPECT_LT((place - to).norm(), 0.15);
  const Result<const Motion*> motion = user.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  EXPECT_LE((motion.value()->frames.back().objects[0].X_WO.p - place).norm(), 1e-6);
  Do("edit.undo", edit::Json::object());
  EXPECT_EQ(user.text(), before);
}

// The top of an arc stays under the mouse, wherever the hand lets go for it.
TEST_F(Objects, TheTopOfAnArcIsDragged) {
  Do("held.add_ball", {{"joint", "r_wrist"}});
  Do("throw.add", {{"object", "ball"}, {"x", 1.2}, {"y", 0.3}, {"height", 0.3}});
  Do("time.frame", {{"frame", user.project().goals[0].frame + 3}});
  const auto top = [&] {
    const auto marks = ui::GoalMarksNow(&user.editor(), *ui::PoseNow(&user.session()));
    return marks.at(0).top.value();
  };
  const Vec3 from = top(), to = from + Vec3(0.0, 0.0, 0.15);
  user.Drag(InWindow(from), InWindow(to));
  EXPECT_NEAR(top().z(), to.z(), 0.03);
  EXPECT_TRUE(user.project().goals[0].height_m);
}

TEST_F(Throwing, SChangesTheStyle) {
  const Vec3 spot(1.2, -0.3, 0.5);
  user.MoveTo(InWindow(spot));
  user.Press('T');
  user.MoveTo(InWindow(spot));
  user.Press('S');
  user.Click(InWindow(spot));
  ASSERT_EQ(user.project().goals.size(), 1u);
  EXPECT_EQ(user.project().goals[0].style, ThrowStyle::kOverarm);
}

// From nothing but a ball in a hand.
TEST_F(Objects, TMakesAThrowOfWhatAHandHolds) {
  Do("held.add_ball", {{"joint", "r_wrist"}});
  const Vec3 spot(0.9, 0.5, 0.0);
  const size_t steps = user.num_steps();
  user.MoveTo(InWindow(spot));
  user.Press('T');
  user.MoveTo(InWindow(spot));
  user.Click(InWindow(spot));
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_EQ(user.project().regions.size(), 1u);
  EXPECT_NE(user.editor().message.text.find("it comes down in frame"), std::string::npos);
  EXPECT_FALSE(user.editor().viewport.aimed);
  const Result<const Motion*> motion = user.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  EXPECT_LE((motion.value()->frames.back().objects[0].X_WO.p - spot).head<2>().norm(), 0.03);
}

// The tool stays in hand, and another spot can be pointed at.
TEST_F(Objects, AClickOnASpotThatCannotBeThrownToEndsNothing) {
  Do("held.add_ball", {{"joint", "r_wrist"}});
  // It does not only stand.
  Do("key.set", {{"curve", "root.x"}, {"frame", 0}, {"value", 0}});
  Do("key.set", {{"curve", "root.x"}, {"frame", 10}, {"value", 0.1}});
  const std::string before = user.text();
  const Vec3 behind(-0.8, -0.2, 0.0), spot(0.9, 0.5, 0.0);
  user.MoveTo(InWindow(behind));
  user.Press('T');
  user.MoveTo(InWindow(behind));
  user.Click(InWindow(behind));
  ASSERT_TRUE(user.editor().has_tool());
  EXPECT_EQ(user.text(), before);
  EXPECT_TRUE(user.editor().viewport.aimed && user.editor().viewport.aimed->is_trouble);
  const auto says = [&](const char* text) {
    return user.editor().viewport.aimed->text.find(text) != std::string::npos;
  };
  EXPECT_TRUE(says("Nothing is done yet")) << user.editor().viewport.aimed->text;
  user.Press('S', ui::kLeftControl);
  EXPECT_TRUE(says("First click to confirm")) << user.editor().viewport.aimed->text;
  user.MoveTo(InWindow(spot));
  user.Click(InWindow(spot));
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_EQ(user.project().regions.size(), 1u);
}

TEST_F(Throwing, EscapeTakesItBack) {
  const std::string before = user.text();
  user.MoveTo(InWindow(Vec3(1.2, -0.3, 0.5)));
  user.Press('T');
  user.MoveTo(InWindow(Vec3(1.2, -0.2, 0.5)));
  user.MoveTo(InWindow(Vec3(1.2, -0.2, 0.5)));  // it rests
  EXPECT_NE(user.text(), before);
  user.Press(ui::kEscape);
  EXPECT_EQ(user.text(), before);
}

TEST_F(Objects, NothingToThrowIsSaid) {
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  user.Press('T');
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_NE(user.editor().message.text.find("click a wrist, then Scene > Add ball"),
            std::string::npos);
}

TEST_F(Objects, WhatLiesOnTheFloorIsGivenToAHandFirst) {
  Do("held.add_ball", edit::Json::object());
  const Vec3 spot(0.9, 0.5, 0.0);
  user.MoveTo(InWindow(spot));
  user.Press('T');
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_NE(user.editor().message.text.find("click a wrist, then Scene > Pass on"),
            std::string::npos)
      << user.editor().message.text;
  // As it says.
  Do("select.joints", {{"joints", {"r_wrist"}}});
  const ui::FormState form = ui::MakeForm("held.pass", ui::Json::object(), &user.session());
  Do("held.pass", ui::ValuesOf(form).value());
  user.Press('T');
  EXPECT_TRUE(user.editor().has_tool()) << user.editor().message.text;
  user.MoveTo(InWindow(spot));
  user.Click(InWindow(spot));
  EXPECT_EQ(user.project().regions.size(), 1u);
}

TEST_F(Objects, JAimsTheJumpThereIsAgain) {
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  user.Press('J');
  user.Click(InWindow(Vec3(0.6, 0.0, 0.0)));
  const size_t steps = user.num_steps();
  const Vec3 spot(0.9, 0.3, 0.0);
  user.Press('J');
  user.MoveTo(InWindow(spot));
  user.Click(InWindow(spot));
  EXPECT_EQ(user.num_steps(), steps + 1) << user.editor().message.text;
  EXPECT_EQ(user.project().placements.size(), 3u);
  EXPECT_NE(user.editor().message.text.find("Takes off in frame"), std::string::npos);
  const Result<const Motion*> motion = user.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  EXPECT_NEAR(motion.value()->frames.back().X_WR.p.y(), 0.3, 0.05);
}

TEST_F(Objects, AJumpOntoABoxThatWasRaisedIsPutRightByOneClick) {
  Do("object.add_box",
     {{"name", "box"}, {"x", 1.2}, {"z", 0.2}, {"size_x", 0.8}, {"size_y", 0.8}, {"size_z", 0.4}});
  Do("jump.add", {{"x", 1.15}, {"y", 0.0}});
  EXPECT_TRUE(ui::ProblemsOf(&user.editor()).empty());
  Do("object.set", {{"object", "box"}, {"z", 0.3}, {"size_z", 0.6}});
  const std::vector<ui::Problem> problems = ui::ProblemsOf(&user.editor());
  const ui::Cure* cure = nullptr;
  for (const ui::Problem& problem : problems) {
    for (const ui::Cure& each : problem.cures) {
      if (each.operator_id == "jump.aim") cure = &each;
    }
  }
  ASSERT_TRUE(cure);
  ASSERT_TRUE(Apply(*cure, &user.editor())) << user.editor().message.text;
  user.Wait(20);  // what is watched meanwhile is found later
  for (const ui::Problem& problem : ui::ProblemsOf(&user.editor())) ADD_FAILURE() << problem.text;
}

TEST_F(Objects, JOnTheSideOfABoxLandsOnTopOfIt) {
  Do("object.add_box",
     {{"name", "box"}, {"x", 1.2}, {"z", 0.2}, {"size_x", 0.8}, {"size_y", 0.8}, {"size_z", 0.4}});
  user.MoveTo(InWindow(Vec3(0.4, 0.0, 0.0)));
  user.Press('J');
  const Vec3 front(0.8, -0.1, 0.2);
  user.MoveTo(InWindow(front));
  ASSERT_TRUE(user.editor().viewport.aimed);
  EXPECT_NEAR(user.editor().viewport.aimed->at.z(), 0.4, 1e-6);
}

TEST_F(Objects, AJumpThatFewPeopleCanDoIsSaid) {
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  user.Press('J');
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  EXPECT_FALSE(user.editor().viewport.aimed->is_trouble) << user.editor().viewport.aimed->text;
  for (const int key : {int{'0'}, int{'.'}, int{'9'}}) user.Press(key);
  EXPECT_TRUE(user.editor().viewport.aimed->is_trouble);
  EXPECT_NE(user.editor().viewport.aimed->text.find("Few people"), std::string::npos);
}

TEST_F(Objects, AHeightOfADigitAfterANoughtIsThatDigit) {
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  user.Press('J');
  for (const int key : {int{'0'}, int{'1'}}) user.Press(key);
  EXPECT_NE(user.editor().tool_hint().find(": 1|"), std::string::npos) << user.editor().tool_hint();
}

// The first throw is done, and the ball is in the hand again.
TEST_F(Objects, TMakesASecondThrowOfWhatWasThrownBefore) {
  Do("held.add_ball", {{"joint", "r_wrist"}});
  Do("throw.add", {{"object", "ball"}, {"x", 1.5}, {"y", -0.3}});
  const int last = user.project().frames.last;
  Do("time.range", {{"first", 0}, {"last", last + 100}});
  Do("time.frame", {{"frame", last + 10}});
  Do("select.joints", {{"joints", {"r_wrist"}}});
  Do("held.pass", {{"object", "ball"}, {"joint", "r_wrist"}});
  Do("select.object", {{"object", "ball"}});
  const Vec3 spot(0.9, 0.2, 0.0);
  user.MoveTo(InWindow(spot));
  user.Press('T');
  user.MoveTo(InWindow(spot));
  user.Click(InWindow(spot));
  EXPECT_EQ(user.project().regions.size(), 2u) << user.editor().message.text;
  // Until it is taken again it lies where it came down.
  const Result<const Motion*> motion = user.session().WholeMotion();
  ASSERT_TRUE(motion.ok());
  const auto at = [&](int f) { return motion.value()->frames[f].objects[0].X_WO.p; };
  EXPECT_LE((at(last + 9) - at(last)).norm(), 1e-9);
}

TEST_F(Objects, AThrowThatIsAimedBehindTheFigureIsSaid) {
  Do("held.add_ball", {{"joint", "r_wrist"}});
  Do("throw.add", {{"object", "ball"}, {"x", 1.5}, {"y", -0.3}});
  Do("select.object", {{"object", "ball"}});
  const Vec3 behind(-0.6, -0.2, 0.0);
  user.MoveTo(InWindow(behind));
  user.Press('T');
  user.MoveTo(InWindow(behind));
  user.MoveTo(InWindow(behind));
  ASSERT_TRUE(user.editor().viewport.aimed);
  EXPECT_TRUE(user.editor().viewport.aimed->is_trouble) << user.editor().viewport.aimed->text;
}

// The card of first steps lies on the floor that is pointed at.
TEST_F(Objects, TheFirstStepsMakeRoomForATool) {
  Do("help.first_steps", {{"on", true}});
  const ui::Rect& card = user.editor().dialogs.first_steps_card;
  const ui::Point on_it = {card.x + 0.5f * card.w, card.y + 0.5f * card.h};
  const size_t boxes = user.project().scene.objects.size();
  ASSERT_TRUE(user.editor().Invoke("tool.add_box").ok());
  user.Click(on_it);
  EXPECT_EQ(user.project().scene.objects.size(), boxes + 1);
  // Without a tool a click on its cross closes it, and does nothing else.
  user.Wait();
  const std::string before = user.text();
  user.Click({card.right() - 12.0f, card.y + 11.0f});
  EXPECT_FALSE(user.editor().dialogs.shows_first_steps);
  EXPECT_EQ(user.text(), before);
}

}  // namespace
}  // namespace hazumi::test
