#include "render/mesh/picture_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/pipeline/offscreen.h"

namespace hazumi::render {
namespace {

constexpr PictureSize kSmall{64, 48};

std::vector<PictureArea> RandomAreas(std::mt19937* random, int count) {
  std::vector<PictureArea> areas;
  for (int i = 0; i < count; ++i) {
    const auto draw = [&](int below) { return static_cast<int>((*random)() % unsigned(below)); };
    const int left = draw(kSmall.width), bottom = draw(kSmall.height);
    areas.push_back({left, bottom, left + draw(kSmall.width - left + 1),
                     bottom + draw(kSmall.height - bottom + 1)});
  }
  return areas;
}

int TimesHeld(const std::vector<PictureArea>& areas, int x, int y) {
  int times = 0;
  for (const PictureArea& a : areas) {
    times += x >= a.left && x < a.right && y >= a.bottom && y < a.top;
  }
  return times;
}

TEST(PictureArea, MergedAndAroundHoldEachPixelOnce) {
  std::mt19937 random(3);
  for (int run = 0; run < 200; ++run) {
    const std::vector<PictureArea> areas = RandomAreas(&random, run % 9);
    const std::vector<PictureArea> merged = Merged(areas);
    EXPECT_LE(merged.size(), 3u);
    const std::vector<PictureArea> around = AreasAround(merged, kSmall);
    for (int y = 0; y < kSmall.height; ++y) {
      for (int x = 0; x < kSmall.width; ++x) {
        const int inside = TimesHeld(merged, x, y);
        ASSERT_EQ(inside + TimesHeld(around, x, y), 1) << "run " << run;
        ASSERT_TRUE(inside == 1 || TimesHeld(areas, x, y) == 0) << "run " << run;
      }
    }
  }
}

TEST(PictureArea, FarSolidsStayApart) {
  const std::vector<PictureArea> apart{{0, 0, 4, 4}, {40, 30, 44, 34}};
  EXPECT_EQ(Merged(apart), apart);
}

Scene SceneOf(const Camera& camera) {
  Scene scene;
  scene.camera = camera;
  scene.ground.visible = false;
  scene.sky.zenith = scene.sky.horizon;
  return scene;
}

// Every pixel that differs from the empty picture lies in the areas.
void ExpectHeld(const Scene& scene, OffscreenRenderer* renderer) {
  Image empty(160, 120), seen(160, 120);
  ASSERT_TRUE(renderer->Draw(SceneOf(scene.camera), empty).ok());
  ASSERT_TRUE(renderer->Draw(scene, seen).ok());
  const PictureSize size{160, 120};
  const std::vector<PictureArea> areas = Merged(AreasOfEdges(scene, Projector(scene.camera, size)));
  size_t differing = 0;
  for (int row = 0; row < size.height; ++row) {
    for (int x = 0; x < size.width; ++x) {
      const size_t at = 4 * (static_cast<size_t>(row) * 160 + static_cast<size_t>(x));
      const bool differs = !std::equal(&seen.rgba[at], &seen.rgba[at + 3], &empty.rgba[at]);
      differing += differs;
      ASSERT_TRUE(!differs || TimesHeld(areas, x, size.height - 1 - row) == 1) << x << " " << row;
    }
  }
  EXPECT_GT(differing, 50u);
}

TEST(AreasOfEdges, HoldWhatIsSeenOfEachKindOfSolid) {
  Result<OffscreenRenderer> renderer = OffscreenRenderer::Create({.shadow = false});
  ASSERT_TRUE(renderer.ok());
  Scene scene = SceneOf({.eye = {5, 1, 2}, .target = {0, 0, 1}, .vertical_fov_deg = 40.0});
  const SrgbColor red{1, 0, 0, 1}, ghost{0, 0, 1, 0.4f};
  scene.capsules.push_back({{0, 0, 0}, {0, 0.4, 0.9}, 0.2, 0.05, red});
  ExpectHeld(scene, &renderer.value());
  scene.ellipsoids.push_back(Sphere({0, -1.5, 1.6}, 0.2, ghost));
  ExpectHeld(scene, &renderer.value());
  scene.boxes.push_back({{Mat3::Identity(), {1, 1.5, 0.2}}, {0.5, 0.2, 0.1}, 0.01, red});
  ExpectHeld(scene, &renderer.value());
  scene.boxes.push_back({{Mat3::Identity(), {5, 1, 2}}, {0.5, 0.5, 0.5}, 0.01, red});
  ExpectHeld(scene, &renderer.value());  // around the viewer
}

TEST(PictureBounds, CountsThePixelsOfAMetreWhereItIsNearest) {
  const Camera camera{.eye = {4, 0, 0}, .target = {0, 0, 0}, .vertical_fov_deg = 90.0};
  PictureBounds bounds(Projector(camera, {200, 100}));
  bounds.Include(Eigen::Vector3f(0, 0, 0));
  EXPECT_NEAR(bounds.pixels_per_m(), 100 / 8.0, 1e-4);  // 8 m high at 4 m
  bounds.Include(Eigen::Vector3f(2, 0, 0));
  EXPECT_NEAR(bounds.pixels_per_m(), 100 / 4.0, 1e-4);
  bounds.Include(Eigen::Vector3f(5, 0, 0));
  EXPECT_TRUE(std::isinf(bounds.pixels_per_m()));
  EXPECT_EQ(bounds.area(), (PictureArea{0, 0, 200, 100}));
}

}  // namespace
}  // namespace hazumi::render
