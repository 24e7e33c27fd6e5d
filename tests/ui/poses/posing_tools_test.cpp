// Breakdown, swivel, live mirror and the choice of hinges, by mouse and keys.

#include "tests/ui/user.h"
#include "ui/panels/commands/menus.h"
#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/swivel_handle.h"

namespace hazumi::test {
namespace {

using edit::Json;

class PosingTools : public ::testing::Test {
 protected:
  void Do(const std::string& id, const Json& parameters = Json::object()) {
    EXPECT_TRUE(user.editor().Do(id, parameters)) << user.editor().message.text;
  }
  double Angle(const char* hinge) { return user.session().ValueNow(hinge).value(); }
  ui::View view() {
    return ui::ViewOf(user.editor().viewport, user.project(), user.editor().viewport.rect);
  }
  Vec3 PlaceOf(const char* joint) {
    const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
    return figure.CenterOf(*figure.figure().FindGroup(joint));
  }
  ui::Point MarkOf(const char* joint) { return *view().ToWindow(PlaceOf(joint)); }
  // The middle of the viewport, where the keys of posing count.
  ui::Point Middle() {
    const ui::Rect rect = user.editor().viewport.rect;
    return {rect.x + 0.5f * rect.w, rect.y + 0.5f * rect.h};
  }
  void KeyKnee() {
    for (const auto& [frame, angle] : {std::pair(0, 20), std::pair(20, 60)}) {
      Do("key.set", {{"curve", "r_knee"}, {"frame", frame}, {"value", angle}});
    }
    Do("select.joints", {{"joints", {"r_knee"}}});
    Do("time.frame", {{"frame", 10}});
  }

  User user;
};

TEST_F(PosingTools, ShiftEBlendsBetweenTheKeysWithTheMouseInOneStep) {
  KeyKnee();
  const size_t steps = user.num_steps();
  const ui::Point middle = Middle();
  user.MoveTo(middle);
  user.Press('E', ui::kLeftShift);
  EXPECT_TRUE(user.editor().has_tool());
  EXPECT_NE(user.editor().tool_hint().find("50 %"), std::string::npos);
  user.MoveTo({middle.x + 50.0f, middle.y});
  EXPECT_NEAR(Angle("r_knee"), 50.0, 1e-6);  // 75 %
  user.MoveTo({middle.x + 180.0f, middle.y});
  EXPECT_NEAR(Angle("r_knee"), 60.0, 1e-6);  // no farther than the key
  user.Press('E');
  user.MoveTo({middle.x + 181.0f, middle.y});
  EXPECT_GT(Angle("r_knee"), 70.0);  // with overshoot it goes on
  user.Press(ui::kEnter);
  EXPECT_EQ(user.num_steps(), steps + 1);
  Do("edit.undo");
  EXPECT_NEAR(Angle("r_knee"), 40.0, 1.0);
}

TEST_F(PosingTools, PercentAreTypedAndEscTakesTheBreakdownBack) {
  KeyKnee();
  const std::string before = user.text();
  user.MoveTo(Middle());
  user.Press('E', ui::kLeftShift);
  user.Press('2');
  user.Press('5');
  EXPECT_NEAR(Angle("r_knee"), 30.0, 1e-9);
  user.Press(ui::kEscape);
  EXPECT_TRUE(user.text() == before);
}

TEST_F(PosingTools, AltERelaxesThePose) {
  KeyKnee();
  Do("key.set", {{"curve", "r_knee"}, {"frame", 10}, {"value", 100}});
  user.MoveTo(Middle());
  user.Press('E', ui::kLeftAlt);
  user.Press('5');
  user.Press('0');
  user.Press(ui::kEnter);
  EXPECT_NEAR(Angle("r_knee"), 70.0, 1e-9);  // half the way to 40
}

TEST_F(PosingTools, TheElbowsHandleGoesRoundTheLineFromShoulderToWrist) {
  Do("pose.rotate", {{"joint", "r_shoulder_flexion"}, {"to", 60}});
  Do("pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 80}});
  Do("view.side", {{"side", "front"}});
  user.Wait();
  const Vec3 wrist = PlaceOf("r_wrist"), elbow = PlaceOf("r_elbow");
  // Without the wrist selected the elbow has none.
  for (const char* other : {"r_elbow", "r_shoulder", "neck", "r_toe"}) {
    Do("select.joints", {{"joints", {other}}});
    EXPECT_FALSE(ui::SwivelHandleOf(user.session(), ui::PoseNow(&user.session()).value())) << other;
  }
  Do("select.joints", {{"joints", {"r_wrist"}}});
  user.Wait();
  const size_t steps = user.num_steps();
  const ui::Point from = MarkOf("r_elbow");
  user.Drag(from, {from.x - 40.0f, from.y - 20.0f});
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_GT((PlaceOf("r_elbow") - elbow).norm(), 0.03);
  EXPECT_LT(MarkOf("r_elbow").x, from.x - 5.0f);  // to where it was pulled
  EXPECT_LE((PlaceOf("r_wrist") - wrist).norm(), 1e-6);
  EXPECT_TRUE(user.session().selected_joints().contains("r_wrist_flexion"));
  user.Click(MarkOf("r_elbow"));  // a click still selects it
  EXPECT_TRUE(user.session().selected_joints().contains("r_elbow_flexion"));
}

TEST_F(PosingTools, WithTheLiveMirrorToolsPoseBothSidesInOneStep) {
  Do("pose.live_mirror");
  Do("select.joints", {{"joints", {"r_elbow_flexion"}}});
  user.MoveTo(Middle());
  for (const int key : {int{'R'}, int{'4'}, int{'5'}, int{ui::kEnter}}) user.Press(key);
  EXPECT_EQ(Angle("r_elbow_flexion"), 45.0);
  EXPECT_EQ(Angle("l_elbow_flexion"), 45.0);
  EXPECT_EQ(user.num_steps(), 1u);
  Do("pose.rotate", {{"joint", "r_shoulder_abduction"}, {"to", 60}});
  Do("select.none");
  Do("view.side", {{"side", "front"}});
  user.Wait();
  const ui::Point wrist = MarkOf("r_wrist");
  user.Drag(wrist, {wrist.x + 10.0f, wrist.y - 30.0f});
  EXPECT_EQ(user.num_steps(), 3u);
  const Vec3 right = PlaceOf("r_wrist"), left = PlaceOf("l_wrist");
  EXPECT_LE((left - Vec3(right.x(), -right.y(), right.z())).norm(), 1e-9);
  Do("pose.live_mirror", {{"on", false}});
  Do("pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 10}});
  EXPECT_NE(Angle("l_elbow_flexion"), 10.0);
}

TEST_F(PosingTools, RTurnsTheHingeWhoseLimitsAreShownAndRAgainTheNext) {
  Do("select.joints", {{"joints", {"r_shoulder"}}});
  const auto turn = [&](int times) {
    user.MoveTo(Middle());
    for (int i = 0; i < times; ++i) user.Press('R');
    EXPECT_NE(user.editor().tool_hint().find(user.editor().viewport.active_hinge),
              std::string::npos);
    for (const int key : {int{'3'}, int{'0'}, int{ui::kEnter}}) user.Press(key);
  };
  for (const char* side : {"front", "right", "top"}) {  // wherever one looks from
    Do("view.side", {{"side", side}});
    user.editor().viewport.active_hinge.clear();
    turn(1);
    EXPECT_EQ(Angle("r_shoulder_flexion"), 30.0) << side;
    EXPECT_EQ(user.num_steps(), 1u);
    Do("edit.undo");
  }
  user.editor().viewport.active_hinge.clear();
  turn(3);
  EXPECT_EQ(Angle("r_shoulder_abduction"), 30.0);
  EXPECT_EQ(Angle("r_shoulder_flexion"), 0.0);
  turn(1);  // the one that was turned last
  EXPECT_EQ(Angle("r_shoulder_abduction"), 60.0);
  turn(2);
  EXPECT_EQ(Angle("r_shoulder_flexion"), 30.0);  // after the last the first
}

TEST_F(PosingTools, AFootStaysFlatWhileItIsPulledUntilFLetsItGo) {
  const auto pitch = [&] {
    const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
    const JointGroup& ankle = figure.figure().group(*figure.figure().FindGroup("r_ankle"));
    return figure.PoseOf(ankle.last()).R(0, 2);
  };
  Do("select.joints", {{"joints", {"r_ankle"}}});
  const auto lift = [&](bool lets_go) {
    user.MoveTo(Middle());
    user.Press('G');
    if (lets_go) user.Press('F');
    for (const int key : {int{'Z'}, int{ui::kPeriod}, int{'0'}, int{'3'}, int{ui::kEnter}}) {
      user.Press(key);
    }
  };
  lift(false);
  EXPECT_NEAR(pitch(), 0.0, 1e-5);
  Do("edit.undo");
  lift(true);
  EXPECT_GT(std::abs(pitch()), 0.02);
}

TEST_F(PosingTools, TheMenuHasSelectionSetsOnceThereAreSome) {
  const auto entries = ui::FlatMenus();
  EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), [](const ui::MenuEntry& entry) {
    return std::string(entry.id) == "select.set";
  }));
  EXPECT_FALSE(ui::CanDo(user.editor(), "select.set"));
  Do("select.joints", {{"joints", {"r_shoulder", "r_elbow"}}});
  const std::set<std::string> arm = user.session().selected_joints();
  Do("select.save_set", {{"name", "arm"}});
  EXPECT_TRUE(ui::CanDo(user.editor(), "select.set"));
  Do("select.none");
  Do("select.set", {{"name", "arm"}});
  EXPECT_EQ(user.session().selected_joints(), arm);
}

}  // namespace
}  // namespace hazumi::test
