// What animators do daily, by mouse and keys, where the tests of single panels and operators show
// only a part of it: see daily_features.md.

#include <algorithm>

#include "engine/spatial/degrees.h"
#include "tests/ui/user.h"
#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/gizmo.h"

namespace hazumi::test {
namespace {

using ui::Point;

// Before a large viewport, the mouse in a corner of it.
class DailyWork : public testing::Test {
 protected:
  explicit DailyWork(const std::string& example = "") : user(example, {900, 700}) {
    user.editor().settings.shares.bottom = 0.3;
    user.editor().viewport.overlays.shadow = false;
    user.Wait(3);
    user.MoveTo(Corner());
  }

  Point Corner() {
    const ui::Rect rect = user.editor().viewport.rect;
    return {rect.x + 0.3f * rect.w, rect.y + 0.9f * rect.h};
  }
  ui::View view() {
    const ui::ViewportState& state = user.editor().viewport;
    return ui::ViewOf(state, user.project(), state.rect);
  }
  ui::OrbitCamera& camera() { return user.editor().viewport.camera; }
  void Do(const std::string& id, const edit::Json& parameters) {
    ASSERT_TRUE(user.editor().Do(id, parameters)) << user.editor().message.text;
    user.Wait(1);
  }
  double Angle(const char* hinge) { return user.session().ValueNow(hinge).value(); }
  const Joint& JointOf(const char* hinge) {
    const Figure& figure = user.session().figure();
    return figure.joint(*figure.FindJoint(hinge));
  }
  std::vector<ProjectKey> KeysOf(const char* hinge) {
    for (const auto& curve : user.project().joints) {
      if (curve.name == hinge) return curve.value.keys;
    }
    return {};
  }

  User user;
};

class DailyThrow : public DailyWork {
 protected:
  DailyThrow() : DailyWork("throw.kfa") {}

  Point MarkOf(const char* joint) {
    const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
    return *view().ToWindow(figure.CenterOf(*figure.figure().FindGroup(joint)));
  }
  const std::vector<ui::PathTicks>& paths() { return user.editor().viewport.shown->ticks; }
};

bool IsSame(const std::vector<ui::PathTicks>& a, const std::vector<ui::PathTicks>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.points == y.points; });
}

TEST_F(DailyWork, TheArcOfTheLimitsIsSeenAndPullingItsEndSetsTheLimit) {
  Do("view.side", {{"side", "right"}});
  Do("select.joints", {{"joints", {"r_elbow_flexion"}}});
  const auto with_arc = user.picture();
  user.editor().viewport.overlays.limits = false;
  user.Wait(1);
  EXPECT_NE(user.picture(), with_arc);
  user.editor().viewport.overlays.limits = true;
  user.Wait(1);
  EXPECT_EQ(user.picture(), with_arc);

  const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
  const ui::LimitArc arc =
      ui::GizmoOf(view(), user.session(), figure, "", true, 1.0).value().arc.value();
  const size_t steps = user.num_steps();
  user.Drag(*view().ToWindow(arc.At(arc.upper)), *view().ToWindow(arc.At(arc.upper - 0.5)));
  for (const char* side : {"r_elbow_flexion", "l_elbow_flexion"}) {
    EXPECT_NEAR(JointOf(side).upper, arc.upper - 0.5, 2.0 * kDegree) << side;
    EXPECT_EQ(JointOf(side).lower, arc.lower) << side;
  }
  EXPECT_EQ(user.num_steps(), steps + 1);
}

TEST_F(DailyWork, APoseIsCopiedPastedAndPastedFlippedByKeys) {
  Do("pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 70}});
  user.Press('C', ui::kLeftControl);
  Do("time.frame", {{"frame", 10}});
  Do("pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 20}});
  user.Press('V', ui::kLeftControl);
  EXPECT_NEAR(Angle("r_elbow_flexion"), 70.0, 1e-9);
  EXPECT_NEAR(Angle("l_elbow_flexion"), 0.0, 1e-9);
  Do("time.frame", {{"frame", 20}});
  user.PressWithShift('V', ui::kLeftControl);
  EXPECT_NEAR(Angle("r_elbow_flexion"), 0.0, 1e-9);
  EXPECT_NEAR(Angle("l_elbow_flexion"), 70.0, 1e-9);
}

TEST_F(DailyWork, IKeysTheSelectedJointsAndAltITakesTheKeysAway) {
  Do("select.joints", {{"joints", {"r_knee"}}});
  Do("time.frame", {{"frame", 12}});
  user.Press('I');
  ASSERT_EQ(KeysOf("r_knee").size(), 1u);
  EXPECT_EQ(KeysOf("r_knee")[0].frame, 12.0);
  EXPECT_TRUE(KeysOf("l_knee").empty());
  user.Press('I', ui::kLeftAlt);
  EXPECT_TRUE(KeysOf("r_knee").empty());
}

TEST_F(DailyWork, WhatIsPosedIsKeyedOnItsFrameAndNothingElseIs) {
  Do("time.frame", {{"frame", 7}});
  Do("select.joints", {{"joints", {"r_elbow_flexion"}}});
  for (const int key : {int{'R'}, int{'X'}, int{'4'}, int{'5'}, int{ui::kEnter}}) user.Press(key);
  ASSERT_EQ(user.project().joints.size(), 1u);
  ASSERT_EQ(KeysOf("r_elbow_flexion").size(), 1u);
  EXPECT_EQ(KeysOf("r_elbow_flexion")[0].frame, 7.0);
  EXPECT_NEAR(KeysOf("r_elbow_flexion")[0].value, 45.0, 1e-9);
}

TEST_F(DailyWork, TheMotionBetweenTwoKeysIsAsTheFirstOneSays) {
  Do("key.set", {{"curve", "r_knee"}, {"frame", 0}, {"value", 0}});
  Do("key.set", {{"curve", "r_knee"}, {"frame", 10}, {"value", 60}});
  Do("keys.select", {{"curves", {"r_knee"}}, {"frames", {0}}});
  Do("time.frame", {{"frame", 2}});
  const double cubic = Angle("r_knee");
  Do("keys.interpolation", {{"interpolation", "linear"}});
  EXPECT_NEAR(Angle("r_knee"), 12.0, 1e-9);
  Do("keys.interpolation", {{"interpolation", "hold"}});
  EXPECT_NEAR(Angle("r_knee"), 0.0, 1e-9);
  Do("keys.interpolation", {{"interpolation", "cubic"}});
  EXPECT_EQ(Angle("r_knee"), cubic);
  EXPECT_LT(cubic, 11.0);  // from rest
}

TEST_F(DailyWork, TheWheelZoomsAndTheMiddleButtonOrbitsAndWithShiftPans) {
  const ui::OrbitCamera start = camera();
  user.Turn(2.0f);
  EXPECT_NEAR(camera().distance, 0.81 * start.distance, 1e-6);
  const Point from = Corner(), to = {from.x + 60.0f, from.y - 30.0f};
  user.Drag(from, to, 2);
  EXPECT_NE(camera().azimuth, start.azimuth);
  EXPECT_NE(camera().elevation, start.elevation);
  EXPECT_EQ(camera().target, start.target);
  const ui::OrbitCamera turned = camera();
  const Point seen = *view().ToWindow(turned.target);
  user.DragWith(ui::kLeftShift, from, to, 2);
  EXPECT_EQ(camera().azimuth, turned.azimuth);
  EXPECT_EQ(camera().distance, turned.distance);
  const Point moved = *view().ToWindow(turned.target);
  EXPECT_NEAR(moved.x - seen.x, 60.0, 0.5);
  EXPECT_NEAR(moved.y - seen.y, -30.0, 0.5);
}

TEST_F(DailyWork, TheNumpadShowsTheSides) {
  const std::vector<std::tuple<int, int, const char*>> sides = {
      {ui::kPad1, ui::kNoKey, "Front"},
      {ui::kPad3, ui::kNoKey, "Right"},
      {ui::kPad7, ui::kNoKey, "Top"},
      {ui::kPad1, ui::kLeftControl, "Back"},
      {ui::kPad3, ui::kLeftControl, "Left"}};
  for (const auto& [key, modifier, name] : sides) {
    user.Press(key, modifier);
    ASSERT_NE(ui::SideOf(camera()), nullptr) << name;
    EXPECT_STREQ(ui::SideOf(camera()), name);
  }
}

TEST_F(DailyThrow, PathsFollowAHandThatIsPulledBeforeTheButtonIsLetGo) {
  Do("time.frame", {{"frame", 0}});
  const std::vector<ui::PathTicks> before = paths();
  ASSERT_FALSE(before.empty());
  const Point hand = MarkOf("r_wrist");
  user.Pull(hand, {hand.x + 30.0f, hand.y - 30.0f});
  ASSERT_TRUE(user.editor().has_tool());
  const std::vector<ui::PathTicks> pulled = paths();
  EXPECT_FALSE(IsSame(pulled, before));
  user.Hold(0, false);
  user.Wait(1);
  EXPECT_TRUE(IsSame(paths(), pulled));
  user.Press('Z', ui::kLeftControl);
  user.Wait(1);
  EXPECT_TRUE(IsSame(paths(), before));
}

}  // namespace
}  // namespace hazumi::test
