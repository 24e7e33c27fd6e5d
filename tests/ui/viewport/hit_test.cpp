#include "ui/panels/viewport/hit_test.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "ui/panels/viewport/gizmo.h"

namespace hazumi::ui {
namespace {

constexpr Rect kHitRect = {0.0f, 0.0f, 640.0f, 480.0f};

class ViewportHitTest : public testing::Test {
 protected:
  ViewportHitTest()
      : figure_(PoseNow(&session_).value()), view_(CameraOf(OrbitCamera()), kHitRect) {}

  GroupIndex Joint(const char* name) { return session_.figure().FindGroup(name).value(); }
  ViewportHit At(const Vec3& p) {
    return HitTest(view_, *view_.ToWindow(p), figure_, solids_, 1.0);
  }

  edit::Session session_;
  PosedFigure figure_;
  View view_;
  std::vector<Solid> solids_;
};

TEST_F(ViewportHitTest, EveryMarkIsItsJoint) {
  for (const char* name : {"r_wrist", "l_knee", "neck", "r_elbow"}) {
    const ViewportHit hit = At(figure_.CenterOf(Joint(name)));
    EXPECT_TRUE(hit.is_marker);
    EXPECT_EQ(hit.joint, Joint(name)) << name;
  }
}

TEST_F(ViewportHitTest, ABodyIsOfTheJointThatMovesIt) {
  const Vec3 thigh = 0.5 * (figure_.CenterOf(Joint("r_hip")) + figure_.CenterOf(Joint("r_knee")));
  const ViewportHit hit = At(thigh);
  EXPECT_FALSE(hit.is_marker);
  EXPECT_EQ(hit.joint, Joint("r_hip"));
}

TEST_F(ViewportHitTest, WhatIsNearerCovers) {
  const Vec3 thigh = 0.5 * (figure_.CenterOf(Joint("r_hip")) + figure_.CenterOf(Joint("r_knee")));
  const Vec3 before = thigh + 0.5 * view_.ToViewer(thigh);
  solids_ = {{ItemId(7), "box", Box{{Mat3::Identity(), before}, Vec3::Constant(0.1)}}};
  EXPECT_EQ(At(thigh).object, ItemId(7));
  std::get<Box>(solids_[0].shape).X_WB.p = thigh - 0.5 * view_.ToViewer(thigh);
  EXPECT_EQ(At(thigh).joint, Joint("r_hip"));
}

TEST_F(ViewportHitTest, BesideTheFigureThereIsNothing) {
  EXPECT_FALSE(HitTest(view_, {5.0f, 5.0f}, figure_, solids_, 1.0).is_anything());
}

TEST(ViewportRay, EntersWhereTheSurfaceIs) {
  const Ray ray = {Vec3(-3.0, 0.0, 0.0), Vec3::UnitX()};
  Look look;
  look.from = Vec3(0.0, 0.0, -1.0);
  look.to = Vec3(0.0, 0.0, 1.0);
  look.radius_from = look.radius_to = 0.5;
  EXPECT_NEAR(Enter(ray, look, {}).value(), 2.5, 1e-12);
  look.shape = Look::Shape::kEllipsoid;
  look.half_axes = Vec3(0.25, 1.0, 1.0);
  EXPECT_NEAR(Enter(ray, look, {}).value(), 2.75, 1e-12);
  look.center.y() = 1.1;
  EXPECT_FALSE(Enter(ray, look, {}).has_value());
  EXPECT_NEAR(Enter(ray, Box{{}, Vec3(0.5, 1.0, 1.0)}).value(), 2.5, 1e-12);
  EXPECT_FALSE(Enter(ray, Box{{Mat3::Identity(), Vec3(0, 3, 0)}, Vec3::Ones()}).has_value());
}

TEST_F(ViewportHitTest, RingsOfAJointAreHitWhereTheyAre) {
  session_.set_selected_joints({"r_elbow_flexion", "r_elbow_pronation"});
  const Gizmo gizmo = GizmoOf(view_, session_, figure_, "", true, 1.0).value();
  ASSERT_EQ(gizmo.rings.size(), 2u);
  for (const GizmoRing& ring : gizmo.rings) {
    double t = 0.0;  // the point nearest to the viewer
    for (double s = 0.0; s < 6.28; s += 0.05) {
      if (ring.At(s).dot(view_.back()) > ring.At(t).dot(view_.back())) t = s;
    }
    const auto hit = GizmoAt(view_, *view_.ToWindow(ring.At(t)), gizmo, 1.0);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->hinge, ring.hinge);
  }
}

TEST_F(ViewportHitTest, TheArcPutsTheLimbWhereTheHingeTurnsIt) {
  session_.set_selected_joints({"r_elbow_flexion"});
  const LimitArc before = GizmoOf(view_, session_, figure_, "", true, 1.0)->arc.value();
  ASSERT_TRUE(session_.Run("pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 90}}).ok());
  const PosedFigure bent = PoseNow(&session_).value();
  const Vec3 limb = bent.LimbOf(session_.figure().FindGroup("r_elbow").value());
  const Vec3 shown = (before.At(1.57079632679489661923) - before.center).normalized();
  EXPECT_GT(shown.dot(limb), 0.98);
}

TEST_F(ViewportHitTest, HandsAndFeetAreHandles) {
  std::set<std::string> names;
  for (const GroupIndex g : HandleJoints(session_.figure())) {
    names.insert(session_.figure().group(g).name);
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"l_wrist", "r_wrist", "l_ankle", "r_ankle", "l_toe", "r_toe"}));
}

}  // namespace
}  // namespace hazumi::ui
