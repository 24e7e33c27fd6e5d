// The viewport as a user has it: mouse, keys, and what becomes of the document.

#include <gtest/gtest.h>

#include "engine/project/project_writer.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/viewport/fixture.h"
#include "ui/panels/commands/keys.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/gizmo.h"

namespace hazumi::ui {
namespace {

// Large enough for nothing to cover rings and menus.
class ViewportTools : public ViewportFixture {
 protected:
  ViewportTools() : ViewportFixture({720, 560}) {}

  void MoveTo(Point p) {
    shell_->MoveMouse(p.x, p.y);
    shell_->Frame();
  }
  void Click(Point p) {
    MoveTo(p);
    Button(true);
    Button(false);
  }
  void Button(bool is_down) {
    shell_->PressButton(0, is_down);
    shell_->Frame();
  }
  void Press(int key) {
    shell_->PressKey(key, true);
    shell_->Frame();
    shell_->PressKey(key, false);
    shell_->Frame();
  }
  double Angle(const char* hinge) { return editor_.session().ValueNow(hinge).value(); }
  std::string Bytes() { return WriteProject(editor_.session().project()); }
  size_t Steps() { return editor_.session().document().num_steps(); }
};

TEST_F(ViewportTools, AClickOnAJointSelectsItsHinges) {
  Click(MarkOf("r_elbow"));
  EXPECT_EQ(editor_.session().selected_joints(),
            (std::set<std::string>{"r_elbow_flexion", "r_elbow_pronation"}));
  shell_->PressKey(kLeftShift, true);
  Click(MarkOf("l_knee"));
  EXPECT_EQ(editor_.session().selected_joints().size(), 3u);
  Click(MarkOf("l_knee"));
  EXPECT_EQ(editor_.session().selected_joints().size(), 2u);
  shell_->PressKey(kLeftShift, false);
  const Rect rect = editor_.viewport.rect;
  Click({rect.x + 4.0f, rect.y + 0.5f * rect.h});
  EXPECT_TRUE(editor_.session().selected_joints().empty());
}

TEST_F(ViewportTools, TypedDegreesAreKeyedExactlyInOneStep) {
  editor_.Do("select.joints", {{"joints", {"r_elbow_flexion"}}});
  const double before = Angle("r_elbow_flexion");
  const size_t steps = Steps();
  MoveTo(MarkOf("r_elbow"));
  for (const int key : {int{'R'}, int{'X'}, int{'4'}, int{'5'}, int{kEnter}}) Press(key);
  EXPECT_FALSE(editor_.has_tool());
  EXPECT_DOUBLE_EQ(Angle("r_elbow_flexion"), before + 45.0);
  EXPECT_EQ(Steps(), steps + 1);
}

TEST_F(ViewportTools, AnAxisChoosesTheHingeNearestToIt) {
  editor_.Do("select.joints", {{"joints", {"r_shoulder"}}});
  MoveTo(MarkOf("r_shoulder"));
  for (const int key : {int{'R'}, int{'Y'}, int{'3'}, int{'0'}, int{kEnter}}) Press(key);
  EXPECT_NEAR(Angle("r_shoulder_flexion"), 30.0, 1e-9);  // its axis is -y
  EXPECT_NEAR(Angle("r_shoulder_abduction"), 0.0, 1e-9);
}

TEST_F(ViewportTools, AnAxisTwiceIsTheJointsOwnHoweverItIsHeld) {
  editor_.Do("pose.rotate", {{"joint", "r_shoulder_abduction"}, {"to", 95.0}});
  editor_.Do("select.joints", {{"joints", {"r_elbow"}}});
  MoveTo(MarkOf("r_elbow"));
  for (const int key : {int{'R'}, int{'Y'}, int{'Y'}, int{'3'}, int{'0'}, int{kEnter}}) Press(key);
  EXPECT_EQ(Angle("r_elbow_flexion"), 30.0);
  EXPECT_EQ(Angle("r_elbow_pronation"), 0.0);
}

TEST_F(ViewportTools, AClickOnTheGizmoSelectsWhatIsBelowAndChangesNothing) {
  editor_.viewport.camera.azimuth = editor_.viewport.camera.elevation = 0.0;
  editor_.Do("select.joints", {{"joints", {"l_shoulder"}}});
  editor_.viewport.active_hinge = "l_shoulder_abduction";
  const Point below = MarkOf("chest");
  const auto gizmo = GizmoOf(view(), editor_.session(), PoseNow(&editor_.session()).value(),
                             "l_shoulder_abduction", true, 1.0);
  ASSERT_TRUE(gizmo && gizmo->arc);
  const Point end = *view().ToWindow(gizmo->arc->At(gizmo->arc->lower));
  const std::string before = Bytes();
  Click({end.x + 5.0f, end.y});  // within reach
  EXPECT_EQ(Bytes(), before);
  Click(below);
  EXPECT_TRUE(editor_.session().selected_joints().contains("chest_rotation"));
}

TEST_F(ViewportTools, CancelLeavesTheDocumentAsItWas) {
  editor_.Do("select.joints", {{"joints", {"r_shoulder"}}});
  const std::string before = Bytes();
  const size_t steps = Steps();
  for (const char first : {'R', 'G'}) {
    MoveTo(MarkOf("r_shoulder"));
    Press(first);
    MoveTo({MarkOf("r_shoulder").x + 40.0f, MarkOf("r_shoulder").y + 60.0f});
    MoveTo({MarkOf("r_shoulder").x - 10.0f, MarkOf("r_shoulder").y + 80.0f});
    EXPECT_TRUE(editor_.has_tool()) << editor_.message.text;
    EXPECT_NE(Bytes(), before) << first;
    Press(kEscape);
    EXPECT_FALSE(editor_.has_tool());
    EXPECT_EQ(Bytes(), before);
    EXPECT_EQ(Steps(), steps);
  }
}

TEST_F(ViewportTools, AHandComesWithTheMouseThatPullsIt) {
  const size_t steps = Steps();
  const Point from = MarkOf("r_wrist");
  MoveTo(from);
  Button(true);
  for (int i = 1; i <= 6; ++i) MoveTo({from.x + 3.0f * i, from.y - 6.0f * i});
  Button(false);
  EXPECT_FALSE(editor_.has_tool());
  const Point to = MarkOf("r_wrist");
  EXPECT_NEAR(to.x, from.x + 18.0, 2.0);
  EXPECT_NEAR(to.y, from.y - 36.0, 2.0);
  EXPECT_EQ(Steps(), steps + 1);
}

TEST_F(ViewportTools, ARingTurnsItsHinge) {
  editor_.Do("select.joints", {{"joints", {"r_elbow_flexion"}}});
  editor_.Do("view.side", {{"side", "right"}});
  editor_.viewport.overlays.limits = false;
  shell_->Frame();
  const PosedFigure figure = PoseNow(&editor_.session()).value();
  const Gizmo gizmo = GizmoOf(view(), editor_.session(), figure, "", false, 1.0).value();
  const GizmoRing& ring = gizmo.rings[0];
  const double before = Angle("r_elbow_flexion");
  MoveTo(*view().ToWindow(ring.At(0.5)));
  Button(true);
  for (int i = 1; i <= 10; ++i) MoveTo(*view().ToWindow(ring.At(0.5 + 0.05 * i)));
  Button(false);
  EXPECT_NEAR(Angle("r_elbow_flexion") - before, 0.5 * 180.0 / 3.14159265358979, 3.0);
}

TEST_F(ViewportTools, ARingTurnsAllSelectedJointsAboutTheHingesNearestToItInOneStep) {
  editor_.Do("select.joints", {{"joints", {"r_elbow", "l_elbow", "r_knee"}}});
  editor_.Do("view.side", {{"side", "right"}});
  editor_.viewport.overlays.limits = false;
  shell_->Frame();
  const PosedFigure figure = PoseNow(&editor_.session()).value();
  const Gizmo gizmo = GizmoOf(view(), editor_.session(), figure, "", false, 1.0).value();
  ASSERT_EQ(gizmo.rings.size(), 3u);
  const GizmoRing& ring = gizmo.rings[1];  // about y, from right to left
  const auto along = [&](const char* hinge) {
    return figure.AxisOf(*figure.figure().FindJoint(hinge)).y() < 0.0 ? -1.0 : 1.0;
  };
  const size_t steps = Steps();
  MoveTo(*view().ToWindow(ring.At(0.5)));
  Button(true);
  for (int i = 1; i <= 10; ++i) MoveTo(*view().ToWindow(ring.At(0.5 - 0.05 * i)));
  Button(false);
  const double turned = -0.5 * 180.0 / 3.14159265358979;
  for (const char* hinge : {"r_elbow_flexion", "l_elbow_flexion"}) {
    EXPECT_NEAR(Angle(hinge), along(hinge) * turned, 3.0) << hinge;
  }
  EXPECT_EQ(Steps(), steps + 1);
  EXPECT_EQ(NameOfSelectedObject(editor_), "");
}

TEST_F(ViewportTools, BThenADragSelectsTheJointsInTheBoxShiftAddsCtrlTakesAway) {
  editor_.Do("view.side", {{"side", "front"}});
  shell_->Frame();
  const auto drag = [&](Point a, Point b, int modifier) {
    MoveTo({a.x - 9.0f, a.y - 9.0f});
    Press('B');
    EXPECT_TRUE(editor_.has_tool());
    if (modifier != kNoKey) shell_->PressKey(modifier, true);
    Button(true);
    MoveTo({b.x + 9.0f, b.y + 9.0f});
    EXPECT_TRUE(editor_.viewport.box.has_value());
    Button(false);
    if (modifier != kNoKey) shell_->PressKey(modifier, false);
    shell_->Frame();
    EXPECT_FALSE(editor_.has_tool());
    EXPECT_FALSE(editor_.viewport.box.has_value());
  };
  const auto has = [&](const char* hinge) {
    return editor_.session().selected_joints().contains(hinge);
  };
  drag(MarkOf("r_knee"), MarkOf("r_ankle"), kNoKey);
  EXPECT_TRUE(has("r_knee"));
  EXPECT_FALSE(has("l_knee"));
  EXPECT_FALSE(has("r_elbow_flexion"));
  drag(MarkOf("l_knee"), MarkOf("l_knee"), kLeftShift);
  EXPECT_TRUE(has("r_knee"));
  EXPECT_TRUE(has("l_knee"));
  drag(MarkOf("r_knee"), MarkOf("r_knee"), kLeftControl);
  EXPECT_FALSE(has("r_knee"));
  EXPECT_TRUE(has("l_knee"));
}

TEST_F(ViewportTools, TheRightButtonOffersWhatCanBeDoneWithTheJointUnderIt) {
  const auto open = [&](Point at) {
    MoveTo(at);
    shell_->PressButton(1, true);
    shell_->Frame();
    shell_->PressButton(1, false);
    for (int i = 0; i < 3; ++i) shell_->Frame();
  };
  const Point elbow = MarkOf("r_elbow");
  open(elbow);
  EXPECT_TRUE(editor_.session().selected_joints().contains("r_elbow_flexion"));
  constexpr float kLine = 18.0f;                     // of its entries [px]
  Click({elbow.x + 40.0f, elbow.y + 1.7f * kLine});  // below the title: insert key
  shell_->Frame();
  EXPECT_EQ(editor_.session().document().undo_label(), "Insert key");
}

TEST_F(ViewportTools, CtrlTurnsInStepsOfFiveDegreesAndAClickConfirms) {
  editor_.Do("select.joints", {{"joints", {"r_elbow_flexion"}}});
  editor_.Do("view.side", {{"side", "right"}});
  shell_->Frame();
  const double before = Angle("r_elbow_flexion");
  const Point pivot = MarkOf("r_elbow");
  MoveTo({pivot.x + 60.0f, pivot.y});
  Press('R');
  shell_->PressKey(kLeftControl, true);
  MoveTo({pivot.x + 55.0f, pivot.y - 24.0f});  // 23.6 degrees
  Button(true);
  Button(false);
  shell_->PressKey(kLeftControl, false);
  EXPECT_FALSE(editor_.has_tool());
  EXPECT_NEAR(Angle("r_elbow_flexion") - before, 25.0, 1e-9);
  EXPECT_EQ(editor_.session().selected_joints().size(), 1u);  // that click was the tool's
}

TEST_F(ViewportTools, PeriodLooksAtTheSelectedJoint) {
  editor_.Do("select.joints", {{"joints", {"l_wrist"}}});
  MoveTo(MarkOf("l_wrist"));
  Press(kPeriod);
  const Rect rect = editor_.viewport.rect;
  EXPECT_NEAR(MarkOf("l_wrist").x, rect.x + 0.5f * rect.w, 0.5);
  EXPECT_NEAR(MarkOf("l_wrist").y, rect.y + 0.5f * rect.h, 0.5);
}

TEST_F(ViewportTools, ABoxIsMovedByTypedMetres) {
  editor_.Do("object.add_box", {{"name", "crate"},
                                {"x", 0.0},
                                {"y", -1.0},
                                {"z", 1.0},
                                {"size_x", 0.4},
                                {"size_y", 0.4},
                                {"size_z", 0.4}});
  Click(*view().ToWindow(Vec3(0.0, -1.0, 1.0)));
  EXPECT_EQ(NameOfSelectedObject(editor_), "crate");
  for (const int key : {int{'G'}, int{'Z'}, int{'2'}, int{kEnter}}) Press(key);
  const ProjectScene& scene = editor_.session().project().scene;
  EXPECT_EQ(std::get<ProjectBox>(scene.objects.back().shape).center_m, Vec3(0.0, -1.0, 3.0));
}

TEST_F(ViewportTools, ABoxIsSelectedUntilJointsAreOrItIsGone) {
  const auto add = [&] {
    ASSERT_TRUE(editor_.Do("object.add_box", {{"name", "crate"}}));
    ASSERT_TRUE(editor_.Do("select.object", {{"object", "crate"}}));
  };
  add();
  ASSERT_TRUE(editor_.Do("pose.rotate", {{"joint", "r_knee"}, {"to", 9}}));
  EXPECT_EQ(NameOfSelectedObject(editor_), "crate");
  ASSERT_TRUE(editor_.Do("select.joints", {{"joints", {"r_knee"}}}));
  EXPECT_EQ(NameOfSelectedObject(editor_), "");
  ASSERT_TRUE(editor_.Do("select.object", {{"object", "crate"}}));
  ASSERT_TRUE(editor_.Do("object.remove", {{"object", "crate"}}));
  EXPECT_EQ(NameOfSelectedObject(editor_), "");
  add();
  const test::TemporaryFolder folder;
  ASSERT_TRUE(editor_.Do("file.save", {{"path", folder / "crate.kfa"}}));
  ASSERT_TRUE(editor_.Do("file.open", {{"path", folder / "crate.kfa"}}));
  EXPECT_EQ(NameOfSelectedObject(editor_), "");
}

TEST_F(ViewportTools, TheRootIsPulledByItsMarkAndTheFeetStay) {
  const Vec3 before = PoseNow(&editor_.session())->frame().X_WR.p;
  const Point foot = MarkOf("l_toe");
  const Point from = *view().ToWindow(before);
  const size_t steps = Steps();
  MoveTo(from);
  Button(true);
  for (int i = 1; i <= 6; ++i) MoveTo({from.x, from.y + 3.0f * i});
  Button(false);
  EXPECT_FALSE(editor_.has_tool());
  EXPECT_EQ(editor_.session().selected_joints(), std::set<std::string>{"pelvis"});
  EXPECT_LT(PoseNow(&editor_.session())->frame().X_WR.p.z(), before.z() - 0.05);
  EXPECT_NEAR(MarkOf("l_toe").x, foot.x, 0.1);
  EXPECT_NEAR(MarkOf("l_toe").y, foot.y, 0.1);
  EXPECT_GT(Angle("l_knee"), 10.0);
  EXPECT_EQ(Steps(), steps + 1);
}

TEST_F(ViewportTools, TypedMetresAndDegreesMoveAndTurnTheRoot) {
  editor_.Do("select.joints", {{"joints", {"pelvis"}}});
  MoveTo(MarkOf("waist"));
  for (const int key : {int{'G'}, int{'X'}, int{'F'}, int{'1'}, int{kEnter}}) Press(key);
  EXPECT_NEAR(Angle("root.x"), 1.0, 1e-9);
  EXPECT_NEAR(Angle("l_knee"), 0.0, 1e-9);  // the feet came along
  for (const int key : {int{'R'}, int{'Z'}, int{'9'}, int{'0'}, int{kEnter}}) Press(key);
  EXPECT_NEAR(Angle("root.angle_z"), 90.0, 1e-9);
  for (const int key : {int{'R'}, int{'X'}, int{'X'}, int{'3'}, int{'0'}, int{kEnter}}) Press(key);
  EXPECT_NEAR(Angle("root.angle_x"), 30.0, 1e-9);
  EXPECT_EQ(Steps(), 3u);
}

TEST_F(ViewportTools, ARingTurnsTheRootByWhatTheMouseShows) {
  editor_.Do("select.joints", {{"joints", {"pelvis"}}});
  editor_.Do("view.side", {{"side", "top"}});
  shell_->Frame();
  const Gizmo gizmo =
      GizmoOf(view(), editor_.session(), PoseNow(&editor_.session()).value(), "", false, 1.0)
          .value();
  const GizmoRing& ring = gizmo.rings[2];
  MoveTo(*view().ToWindow(ring.At(0.3)));
  Button(true);
  for (int i = 1; i <= 10; ++i) MoveTo(*view().ToWindow(ring.At(0.3 + 0.05 * i)));
  Button(false);
  EXPECT_NEAR(Angle("root.angle_z"), 0.5 * 180.0 / 3.14159265358979, 3.0);
}

TEST_F(ViewportTools, ThePictureIsDrawnAgainOnlyWhenItChanges) {
  const long before = editor_.viewport.pictures_drawn;
  MoveTo(MarkOf("r_elbow"));
  for (int i = 0; i < 3; ++i) shell_->Frame();
  EXPECT_EQ(editor_.viewport.pictures_drawn, before);
  editor_.Do("pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 30}});
  shell_->Frame();
  EXPECT_EQ(editor_.viewport.pictures_drawn, before + 1);
  editor_.Do("file.new");
  shell_->Frame();
  EXPECT_EQ(editor_.viewport.pictures_drawn, before + 2);
}

TEST_F(ViewportTools, WithoutACameraOneIsAskedFor) {
  EXPECT_FALSE(editor_.Do("view.camera"));
  EXPECT_FALSE(editor_.viewport.through_project_camera);
  EXPECT_NE(editor_.message.text.find("View > Set camera to the view"), std::string::npos);
}

TEST_F(ViewportTools, TheCameraIsSetToTheView) {
  ASSERT_TRUE(editor_.Do("view.side", {{"side", "left"}}));
  ASSERT_TRUE(editor_.Do("view.set_camera"));
  const render::Camera view = CameraOf(editor_.viewport.camera);
  const std::optional<ProjectCamera>& camera = editor_.session().project().camera;
  ASSERT_TRUE(camera.has_value());
  EXPECT_EQ(camera->eye_m, view.eye);
  EXPECT_EQ(camera->target_m, view.target);
  // All that the viewport shows is in a picture of 16:9.
  const auto half = [](double fov_deg) { return std::tan(0.5 * fov_deg * kDegree); };
  const ui::Rect& rect = editor_.viewport.rect;
  EXPECT_GE(camera->vertical_fov_deg, view.vertical_fov_deg);
  EXPECT_GE(half(camera->vertical_fov_deg) * 16.0 / 9.0,
            half(view.vertical_fov_deg) * rect.w / rect.h - 1e-6);
  // It says so, and its frame is seen.
  EXPECT_NE(editor_.message.text.find("The camera looks from here"), std::string::npos);
  EXPECT_FALSE(editor_.message.is_error);
  EXPECT_TRUE(editor_.viewport.through_project_camera);
  for (int i = 0; i < 3; ++i) shell_->Frame();
  ASSERT_TRUE(editor_.Do("edit.undo"));
  EXPECT_FALSE(editor_.session().project().camera.has_value());
}

TEST_F(ViewportTools, FramingAllFramesTheBoxesToo) {
  ASSERT_TRUE(editor_.Do("object.add_box", {{"name", "far"}, {"x", 6}}));
  ASSERT_TRUE(editor_.Do("view.frame_all"));
  const Rect& rect = editor_.viewport.rect;
  const auto box = View(CameraOf(editor_.viewport.camera), rect).ToWindow(Vec3(6.0, 0.0, 0.0));
  ASSERT_TRUE(box.has_value());
  EXPECT_TRUE(rect.Contains(*box));
}

}  // namespace
}  // namespace hazumi::ui
