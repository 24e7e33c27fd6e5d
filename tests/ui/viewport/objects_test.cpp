// Boxes and held objects in the viewport, with mouse and keys.

#include "tests/ui/viewport/objects.h"

#include <cmath>

#include "engine/spatial/degrees.h"

namespace hazumi::test {
namespace {

TEST_F(Objects, ABallOnTheGroundIsClickedAndDraggedToWhereItIsKeyed) {
  Do("held.add_ball", {{"radius", 0.15}});
  const Vec3 before = BallNow();
  user.Click(InWindow(before));
  EXPECT_EQ(Selected(), "ball");
  EXPECT_EQ(user.editor().side.section, ui::Section::kScene);
  const size_t steps = user.num_steps();
  const ui::Point from = InWindow(before);
  user.Drag(from, {from.x + 60.0f, from.y});
  EXPECT_EQ(user.num_steps(), steps + 1);
  const ui::Point now = InWindow(BallNow());
  EXPECT_NEAR(now.x, from.x + 60.0f, 2.0f);
  EXPECT_NEAR(now.y, from.y, 2.0f);
}

TEST_F(Objects, InAHandItsOffsetIsDraggedAndTheHandStays) {
  Do("held.add_ball", {{"radius", 0.12}, {"joint", "r_wrist"}});
  Do("select.object", {{"object", "ball"}});
  const Vec3 before = BallNow(), offset = user.project().held_objects[0].offset_m;
  const size_t num_curves = user.project().joints.size();
  user.MoveTo(InWindow(before));
  for (const int key : {int{'G'}, int{'X'}, int{'.'}, int{'1'}, int{ui::kEnter}}) user.Press(key);
  EXPECT_LE((BallNow() - before - Vec3(0.1, 0.0, 0.0)).norm(), 1e-6);
  EXPECT_NEAR((user.project().held_objects[0].offset_m - offset).norm(), 0.1, 1e-6);
  EXPECT_EQ(user.project().joints.size(), num_curves);
}

class TurnedObject : public Objects {
 protected:
  TurnedObject() {
    Do("held.add_box", {{"joint", "r_wrist"}, {"size_x", 0.4}, {"release", 20}});
    Do("select.object", {{"object", "box"}});
    before = Turn();
    steps = user.num_steps();
  }
  Mat3 Turn() { return user.session().ShownFrame().value()->objects[0].X_WO.R; }
  Mat3 By() { return Turn() * before.transpose(); }
  static Mat3 About(const Vec3& axis, double degrees) {
    return Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix();
  }

  Mat3 before;
  size_t steps = 0;
};

TEST_F(TurnedObject, RAndTypedDegreesTurnItAboutAnAxisOfTheWorldInOneStep) {
  ASSERT_EQ(Selected(), "box");
  const size_t num_curves = user.project().joints.size();
  user.MoveTo(InWindow(BallNow()));
  for (const int key : {int{'R'}, int{'Z'}, int{'3'}, int{'0'}, int{ui::kEnter}}) user.Press(key);
  EXPECT_LE((By() - About(Vec3::UnitZ(), 30.0)).norm(), 1e-8);
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_EQ(user.project().joints.size(), num_curves);
  user.Press('Z', ui::kLeftControl);
  EXPECT_EQ(Turn(), before);
}

TEST_F(TurnedObject, TheMouseTurnsItAboutTheLineOfSight) {
  const ui::Point at = InWindow(BallNow());
  user.MoveTo({at.x + 100.0f, at.y});
  user.Press('R');
  // A quarter counter-clockwise on the screen, whose y points down.
  for (const float angle : {0.4f, 0.8f, 1.2f, 1.5707964f}) {
    user.MoveTo({at.x + 100.0f * std::cos(angle), at.y - 100.0f * std::sin(angle)});
  }
  const ui::ViewportState& state = user.editor().viewport;
  const Vec3 to_viewer = ui::ViewOf(state, user.project(), state.rect).ToViewer(BallNow());
  EXPECT_LE((By() - About(to_viewer, 90.0)).norm(), 0.02);
  user.Click({at.x, at.y - 100.0f});
  EXPECT_EQ(user.num_steps(), steps + 1);
}

TEST_F(TurnedObject, EscapeTurnsItBack) {
  user.MoveTo(InWindow(BallNow()));
  for (const int key : {int{'R'}, int{'X'}, int{'9'}}) user.Press(key);
  EXPECT_NE(Turn(), before);
  user.Press(ui::kEscape);
  EXPECT_EQ(Turn(), before);
  EXPECT_EQ(user.num_steps(), steps);
}

TEST_F(TurnedObject, InTheAirItIsNotTurnedAndThatIsSaid) {
  Do("time.frame", {{"frame", 25}});
  user.MoveTo(InWindow(BallNow()));
  user.Press('R');
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_NE(user.editor().message.text.find("nobody has it in this frame"), std::string::npos);
}

TEST_F(Objects, WhatIsAddedIsSelectedInPlaceOfJoints) {
  Do("select.joints", {{"joints", {"r_wrist"}}});
  Do("held.add_ball", edit::Json::object());
  EXPECT_EQ(Selected(), "ball");
  EXPECT_TRUE(user.session().selected_joints().empty());
  Do("object.add_box", {{"name", "crate"}});
  EXPECT_EQ(Selected(), "crate");
}

TEST_F(Objects, WhatIsNotSelectedIsNotDragged) {
  Do("held.add_ball", {{"radius", 0.15}});
  Do("select.joints", {{"joints", {"r_wrist"}}});
  const Vec3 before = BallNow();
  const ui::Point from = InWindow(before);
  user.Drag(from, {from.x + 60.0f, from.y});
  EXPECT_EQ(BallNow(), before);
}

TEST_F(Objects, XTakesTheSelectedOneAway) {
  Do("held.add_ball", {{"radius", 0.15}});
  user.Click(InWindow(BallNow()));
  user.Press('X');
  EXPECT_TRUE(user.project().held_objects.empty());
  EXPECT_EQ(Selected(), "");
}

TEST_F(Objects, ShiftDPutsACopyWhereTheMouseGoesInOneStep) {
  Do("object.add_box", {{"name", "crate"}, {"x", 1.2}, {"z", 0.25}});
  Do("select.object", {{"object", "crate"}});
  const std::string before = user.text();
  const size_t steps = user.num_steps();
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  user.Press('D', ui::kLeftShift);
  ASSERT_TRUE(user.editor().has_tool());
  EXPECT_EQ(user.text(), before);
  user.MoveTo(InWindow(Vec3(0.6, 0.4, 0.0)));
  user.Press(ui::kEscape);
  EXPECT_EQ(user.text(), before);
  EXPECT_EQ(Selected(), "crate");
  user.Press('D', ui::kLeftShift);
  EXPECT_EQ(user.editor().tool_hint().rfind("Move crate 2: ", 0), 0u) << user.editor().tool_hint();
  for (const int key : {int{'X'}, int{'1'}, int{ui::kEnter}}) user.Press(key);
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_EQ(Selected(), "crate 2");
  const auto& objects = user.project().scene.objects;
  const auto center = [&](size_t i) { return std::get<ProjectBox>(objects[i].shape).center_m; };
  const size_t last = objects.size() - 1;
  EXPECT_LE((center(last) - center(last - 1) - Vec3(1.0, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_NE(objects[last].identity.id, objects[last - 1].identity.id);
}

TEST_F(Objects, ABoxThatIsMovedStaysOnTheGround) {
  Do("object.add_box", {{"name", "crate"}, {"x", 1.2}, {"z", 0.5}});
  Do("select.object", {{"object", "crate"}});
  const Vec3 middle(1.2, 0.0, 0.5), to(0.9, 0.6, 0.5);
  user.MoveTo(InWindow(middle));
  user.Press('G');
  user.MoveTo(InWindow(to));
  user.Click(InWindow(to));
  const auto& box = std::get<ProjectBox>(user.project().scene.objects.back().shape);
  EXPECT_LE((box.center_m - to).norm(), 0.02) << box.center_m.transpose();
  EXPECT_EQ(box.center_m.z(), 0.5);
}

TEST_F(Objects, ShiftDWithNothingToCopySaysSo) {
  Do("select.none", edit::Json::object());
  user.MoveTo(InWindow(Vec3(0.6, 0.0, 0.0)));
  user.Press('D', ui::kLeftShift);
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_NE(user.editor().message.text.find("click on a box"), std::string::npos);
}

TEST_F(Objects, ABoxIsDrawnByItsBaseAndThenItsHeight) {
  const Vec3 corner(0.6, -0.5, 0.0), opposite(1.2, 0.3, 0.0);
  const size_t steps = user.num_steps();
  ASSERT_TRUE(user.editor().Invoke("tool.add_box").ok());
  user.Drag(InWindow(corner), InWindow(opposite));
  const ui::Point top = InWindow(opposite + Vec3(0.0, 0.0, 0.4));
  user.MoveTo(top);
  user.Click(top);
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_EQ(Selected(), "box");
  const auto& box = std::get<ProjectBox>(user.project().scene.objects.back().shape);
  EXPECT_LE((box.size_m - Vec3(0.6, 0.8, 0.4)).cwiseAbs().maxCoeff(), 0.04);
  EXPECT_LE((box.center_m - Vec3(0.9, -0.1, 0.2)).cwiseAbs().maxCoeff(), 0.04);
}

const ProjectBox& LastBox(User& user) {
  return std::get<ProjectBox>(user.project().scene.objects.back().shape);
}

TEST_F(Objects, TheEdgesOfABoxAreTypedWithTabBetweenThem) {
  const size_t steps = user.num_steps();
  ASSERT_TRUE(user.editor().Invoke("tool.add_box").ok());
  const Vec3 spot(1.2, 0.2, 0.0);
  user.MoveTo(InWindow(spot));
  for (const char* edge : {"0.4", "0.6", "0.3"}) {
    for (const char* key = edge; *key; ++key) user.Press(*key);
    if (std::string(edge) != "0.3") user.Press(ui::kTab);
  }
  EXPECT_NE(user.editor().tool_hint().find("0.4| x 0.6| x 0.3| m"), std::string::npos)
      << user.editor().tool_hint();
  user.Press(ui::kEnter);
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_EQ(LastBox(user).size_m, Vec3(0.4, 0.6, 0.3));
  EXPECT_LE((LastBox(user).center_m - spot - Vec3(0.0, 0.0, 0.15)).cwiseAbs().maxCoeff(), 0.04);
}

TEST_F(Objects, OnceItsBaseIsDrawnTheHeightOfABoxIsTyped) {
  ASSERT_TRUE(user.editor().Invoke("tool.add_box").ok());
  const Vec3 corner(0.6, -0.5, 0.0), opposite(1.2, 0.3, 0.0);
  user.Drag(InWindow(corner), InWindow(opposite));
  for (const int key : {int{'0'}, int{'.'}, int{'7'}, int{ui::kEnter}}) user.Press(key);
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_EQ(LastBox(user).size_m.z(), 0.7);
  EXPECT_LE((LastBox(user).size_m - Vec3(0.6, 0.8, 0.7)).cwiseAbs().maxCoeff(), 0.04);
  EXPECT_LE((LastBox(user).center_m - Vec3(0.9, -0.1, 0.35)).cwiseAbs().maxCoeff(), 0.04);
}

TEST_F(Objects, EscapeTakesATypedBoxBack) {
  const std::string before = user.text();
  ASSERT_TRUE(user.editor().Invoke("tool.add_box").ok());
  user.MoveTo(InWindow(Vec3(1.2, 0.2, 0.0)));
  for (const int key : {int{'1'}, int{ui::kTab}, int{'2'}}) user.Press(key);
  EXPECT_NE(user.text(), before);
  user.Press(ui::kEscape);
  EXPECT_EQ(user.text(), before);
}

TEST_F(Objects, WithCtrlTheBaseOfABoxGoesInStepsOfFiveCentimetres) {
  ASSERT_TRUE(user.editor().Invoke("tool.add_box").ok());
  user.DragWith(ui::kLeftControl, InWindow(Vec3(0.6, -0.5, 0.0)), InWindow(Vec3(1.2, 0.5, 0.0)));
  user.Press(ui::kEnter);
  EXPECT_LE((LastBox(user).size_m.head<2>() - Eigen::Vector2d(0.6, 1.0)).norm(), 1e-9);
  EXPECT_LE((LastBox(user).center_m.head<2>() - Eigen::Vector2d(0.9, 0.0)).norm(), 1e-9)
      << LastBox(user).center_m.transpose();
}

TEST_F(Objects, AClickPutsABoxOfHalfAMetreOntoAnother) {
  Do("object.add_box", {{"name", "table"}, {"x", 1.2}, {"z", 0.2}, {"size_z", 0.4}});
  ASSERT_TRUE(user.editor().Invoke("tool.add_box").ok());
  const Vec3 spot(1.2, 0.0, 0.4);
  user.Click(InWindow(spot));
  EXPECT_FALSE(user.editor().has_tool());
  const auto& box = std::get<ProjectBox>(user.project().scene.objects.back().shape);
  EXPECT_EQ(box.size_m, Vec3(0.5, 0.5, 0.5));
  EXPECT_LE((box.center_m - spot - Vec3(0.0, 0.0, 0.25)).cwiseAbs().maxCoeff(), 0.04);
}

}  // namespace
}  // namespace hazumi::test
