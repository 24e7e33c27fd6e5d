#include "ui/panels/viewport/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/panels/viewport/layout.h"

namespace hazumi::ui {
namespace {

constexpr Rect kRect = {40.0f, 30.0f, 640.0f, 400.0f};

View ViewOf(const OrbitCamera& camera) { return View(CameraOf(camera), kRect); }

TEST(ViewportCamera, ARayPassesThroughThePointThatIsSeenThere) {
  for (const bool is_orthographic : {false, true}) {
    OrbitCamera camera;
    camera.is_orthographic = is_orthographic;
    const View view = ViewOf(camera);
    const Vec3 p(0.3, -0.4, 1.2);
    const Point at = view.ToWindow(p).value();
    const Ray ray = view.Through(at);
    EXPECT_LT((p - ray.from).cross(ray.direction).norm(), 1e-4);
  }
}

TEST(ViewportCamera, WhatIsBehindTheViewerIsNowhere) {
  const View view = ViewOf(OrbitCamera());
  EXPECT_FALSE(view.ToWindow(view.eye() + view.back()).has_value());
}

TEST(ViewportCamera, PanKeepsTheTargetPlaneUnderTheMouse) {
  OrbitCamera camera;
  const View before = ViewOf(camera);
  const Vec3 p = camera.target + 0.2 * before.right() - 0.1 * before.up();
  const Point from = before.ToWindow(p).value();
  Pan({37.0f, -21.0f}, kRect.h, &camera);
  const Point to = ViewOf(camera).ToWindow(p).value();
  EXPECT_NEAR(to.x - from.x, 37.0, 0.01);
  EXPECT_NEAR(to.y - from.y, -21.0, 0.01);
}

TEST(ViewportCamera, OrbitKeepsTheTargetInTheMiddleAndTheDistance) {
  OrbitCamera camera;
  Orbit({120.0f, 45.0f}, &camera);
  const View view = ViewOf(camera);
  EXPECT_NEAR((view.eye() - camera.target).norm(), camera.distance, 1e-9);
  const Point middle = view.ToWindow(camera.target).value();
  EXPECT_NEAR(middle.x, kRect.x + 320.0, 0.01);
  EXPECT_NEAR(middle.y, kRect.y + 200.0, 0.01);
}

TEST(ViewportCamera, FromTheFrontTheLeftSideIsOnTheRight) {
  OrbitCamera camera;
  camera.azimuth = camera.elevation = 0.0;
  EXPECT_STREQ(SideOf(camera), "Front");
  const View view = ViewOf(camera);
  EXPECT_GT(view.right().y(), 0.999);  // the figure looks along x; its left is y
  EXPECT_GT(view.up().z(), 0.999);
  camera.elevation = 1.57079632679489661923;
  EXPECT_STREQ(SideOf(camera), "Top");
}

TEST(ViewportCamera, AFramedSphereFillsThePictureAndNoMore) {
  OrbitCamera camera;
  FrameSphere(Vec3(1.0, 2.0, 0.5), 0.8, kRect.w / kRect.h, &camera);
  const View view = ViewOf(camera);
  // The tangent from the eye to the sphere meets the upper edge.
  const double sine = 0.8 / camera.distance;
  const Vec3 touch =
      camera.target + 0.8 * (sine * view.back() + std::sqrt(1 - sine * sine) * view.up());
  EXPECT_NEAR(view.ToWindow(touch)->y, kRect.y, 0.5);
}

TEST(ViewportCamera, TheBorderShowsWhatARenderShows) {
  ProjectCamera camera;
  const BorderedCamera bordered = Bordered(camera, 16.0 / 9.0, kRect);
  EXPECT_NEAR(bordered.border.w / bordered.border.h, 16.0 / 9.0, 1e-3);
  // A point on the upper edge of the render's picture is on the border's upper edge.
  render::Camera render;
  render.eye = camera.eye_m;
  render.target = camera.target_m;
  render.vertical_fov_deg = camera.vertical_fov_deg;
  const View picture(render, {0.0f, 0.0f, 1280.0f, 720.0f});
  const Vec3 p = picture.eye() + 3.0 * picture.Through({640.0f, 0.0f}).direction;
  EXPECT_NEAR(View(bordered.camera, kRect).ToWindow(p)->y, bordered.border.y, 0.05);
}

TEST(ViewportLayout, TogglesStayInsideAndNeverOverlap) {
  const std::vector<float> widths = {50.0f, 60.0f, 55.0f, 70.0f};
  for (const float width : {120.0f, 200.0f, 640.0f}) {
    const Rect viewport = {10.0f, 20.0f, width, 300.0f};
    const std::vector<Rect> rects = LayOutToggles(viewport, widths, 20.0f, 1.0);
    ASSERT_EQ(rects.size(), widths.size());
    for (size_t i = 0; i < rects.size(); ++i) {
      EXPECT_GE(rects[i].x, viewport.x);
      EXPECT_LE(rects[i].right(), viewport.right());
      for (size_t k = 0; k < i; ++k) {
        EXPECT_TRUE(rects[k].right() <= rects[i].x || rects[k].bottom() <= rects[i].y);
      }
    }
  }
}

TEST(ViewportLayout, TheAxisTowardsTheViewerIsDrawnLast) {
  OrbitCamera camera;
  camera.azimuth = 0.0;
  const AxisCross cross = LayOutAxisCross(ViewOf(camera), 1.0);
  EXPECT_EQ(cross.axes[2].axis, 0);
}

}  // namespace
}  // namespace hazumi::ui
