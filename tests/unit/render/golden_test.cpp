#include "golden.h"

#include <gtest/gtest.h>

#include "demo_scene.h"
#include "render/pipeline/offscreen.h"

namespace hazumi::render {
namespace {

Image Draw(const Scene& scene, const RendererOptions& options) {
  Result<OffscreenRenderer> renderer = OffscreenRenderer::Create(options);
  Image image(256, 192);
  EXPECT_TRUE(renderer.ok()) << renderer.error().ToString();
  EXPECT_TRUE(renderer.value().Draw(scene, image).ok());
  return image;
}

Scene Plain() {
  Scene scene = MakeDemoScene(4);
  scene.captions.clear();
  return scene;
}

const std::uint8_t* PixelAt(const Image& image, int x, int y) {
  return &image.rgba[(static_cast<size_t>(y) * image.width + x) * 4];
}

// A person stands on the floor and throws a shadow away from the light; the box hides what is
// behind it; the near path is in front of the body, the far part hidden by it.
TEST(GoldenImage, WalkerWithBoxShadowAndPaths) { ExpectMatchesGolden(Draw(Plain(), {}), "walker"); }

// Two ghosts, see-through and without shadows, never showing their own inner parts; captions in
// their corners on dark panels.
TEST(GoldenImage, GhostsAndCaptions) { ExpectMatchesGolden(Draw(MakeGhostScene(4), {}), "ghosts"); }

// Checkers fade into the horizon without shimmering; no samples, no shadow map.
TEST(GoldenImage, CheckerWithoutSamplesOrShadow) {
  Scene scene = Plain();
  scene.ground.look = GroundLook::kChecker;
  ExpectMatchesGolden(Draw(scene, {.samples = 1, .shadow = false}), "checker");
}

TEST(Renderer, ShowsTheColoursOfFloorAndSkyAsGiven) {
  Scene scene;
  scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}};
  scene.ground.floor = scene.ground.pattern = FromHex(0x336699);
  const Image floor = Draw(scene, {});
  EXPECT_NEAR(PixelAt(floor, 128, 96)[0], 0x33, 1);
  EXPECT_NEAR(PixelAt(floor, 128, 96)[2], 0x99, 1);
  scene.camera.target = {0, 0, 9};
  const Image zenith = Draw(scene, {});
  EXPECT_NEAR(PixelAt(zenith, 128, 96)[0], scene.sky.zenith.r * 255.0, 1.0);
}

TEST(Renderer, TopRowIsTheUpperOne) {
  Scene scene;
  scene.ground.visible = false;
  scene.camera = {.eye = {0, -4, 0}, .target = {0, 0, 0}};
  scene.ellipsoids.push_back(Sphere({0, 0, 0.7}, 0.3, FromHex(0xff0000)));
  const Image image = Draw(scene, {});
  EXPECT_GT(PixelAt(image, 128, 42)[0], PixelAt(image, 128, 42)[2] + 60);
  EXPECT_LT(std::abs(PixelAt(image, 128, 150)[0] - PixelAt(image, 128, 150)[2]), 20);
}

TEST(Renderer, TwoAndFourSamplesAreTheSame) {
  EXPECT_EQ(Draw(Plain(), {.samples = 2}).rgba, Draw(Plain(), {.samples = 4}).rgba);
  EXPECT_EQ(Draw(Plain(), {.samples = 0}).rgba, Draw(Plain(), {.samples = 1}).rgba);
}

TEST(Renderer, AnEmptySceneIsNoProblem) {
  Scene scene;
  scene.ground.visible = false;
  Draw(scene, {});
  scene.capsules.push_back({});
  Draw(scene, {});
}

TEST(Renderer, DrawsPicturesOfSeveralSizesInTurn) {
  Result<OffscreenRenderer> renderer = OffscreenRenderer::Create({});
  Image first(64, 48), other(100, 30), again(64, 48);
  for (Image* image : {&first, &other, &again}) {
    EXPECT_TRUE(renderer.value().Draw(Plain(), *image).ok());
  }
  EXPECT_EQ(first.rgba, again.rgba);
}

TEST(ImageComparison, SeesASmallDifference) {
  Image a(64, 64), b(64, 64);
  EXPECT_TRUE(IsCloseEnough(Compare(a, b)));
  b.rgba[0] = 100;
  EXPECT_FALSE(IsCloseEnough(Compare(a, b)));
}

}  // namespace
}  // namespace hazumi::render
