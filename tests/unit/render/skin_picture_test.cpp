#include <gtest/gtest.h>

#include <cmath>

#include "render/pipeline/offscreen.h"
#include "tube.h"

namespace hazumi::render {
namespace {

constexpr double kLength = 2.0;

std::shared_ptr<const SkinModel> ModelOf(std::shared_ptr<const Skin> skin) {
  return MakeSkinModel(std::move(skin)).value();
}

// A tube of 2 m, 5 m off, 36 px a metre. Seen from +x: on the right (y > 0) red above, green below;
// yellow on the left.
Scene SceneOf(const SkinnedFigure& figure) {
  Scene scene;
  scene.camera = {.eye = {5, 0, 1}, .target = {0, 0, 1}, .vertical_fov_deg = 30.0};
  scene.to_light = {1, 0.2, 0.5};
  scene.ground.visible = false;
  scene.skins.push_back(figure);
  return scene;
}

class SkinPicture : public testing::Test {
 protected:
  SkinPicture() : renderer_(OffscreenRenderer::Create({})) {}

  Image Draw(const Scene& scene) {
    Image image(128, 96);
    EXPECT_TRUE(renderer_.value().Draw(scene, image).ok());
    return image;
  }

  Result<OffscreenRenderer> renderer_;
};

struct Pixel {
  int r, g, b;
};

Pixel At(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (size_t(y) * image.width + x)];
  return {p[0], p[1], p[2]};
}

bool IsRed(const Pixel& p) { return p.r > p.g + 60 && p.r > p.b + 60; }
bool IsGreen(const Pixel& p) { return p.g > p.r + 60 && p.g > p.b + 60; }
bool IsYellow(const Pixel& p) { return p.r > p.b + 60 && p.g > p.b + 60; }

// Pixels that the skin covers: the background has hardly any colour.
int Coverage(const Image& image) {
  int covered = 0;
  for (int i = 0; i < image.width * image.height; ++i) {
    const Pixel p = At(image, i % image.width, i / image.width);
    covered += IsRed(p) || IsGreen(p) || IsYellow(p);
  }
  return covered;
}

TEST_F(SkinPicture, TheTextureIsTheRightWayUpAndRound) {
  const Image image = Draw(SceneOf(RestingTube(ModelOf(TubeSkin(kLength, 32, 20)), kLength)));
  EXPECT_TRUE(IsRed(At(image, 68, 30)));
  EXPECT_TRUE(IsGreen(At(image, 68, 66)));
  EXPECT_TRUE(IsYellow(At(image, 60, 30)));
  EXPECT_TRUE(IsYellow(At(image, 60, 66)));
  EXPECT_FALSE(IsRed(At(image, 90, 30)));
  EXPECT_NEAR(Coverage(image), 18.2 * 73, 80);
}

TEST_F(SkinPicture, FollowsItsBones) {
  SkinnedFigure figure = RestingTube(ModelOf(TubeSkin(kLength, 32, 20)), kLength);
  figure.X_WB[1].R = AxisRotation<double>(Vec3::UnitX(), -1.0, 0.0);  // the top towards +y
  const Image image = Draw(SceneOf(figure));
  EXPECT_TRUE(IsRed(At(image, 92, 53)));
  EXPECT_FALSE(IsRed(At(image, 68, 20)));
  EXPECT_TRUE(IsGreen(At(image, 68, 70)));
}

// One layer is seen from both sides, lit on the side that is seen.
TEST_F(SkinPicture, WindingAndTurnedNormalsDoNotMatter) {
  auto skin = std::make_shared<Skin>(*TubeSkin(kLength, 32, 20));
  const Image right = Draw(SceneOf(RestingTube(ModelOf(skin), kLength)));
  auto turned = std::make_shared<Skin>(*skin);
  for (auto& t : turned->meshes[0].triangles) std::swap(t[1], t[2]);
  const Image other = Draw(SceneOf(RestingTube(ModelOf(turned), kLength)));
  EXPECT_NEAR(At(right, 68, 30).r, At(other, 68, 30).r, 2);
  for (Eigen::Vector3f& n : turned->meshes[0].normals) n = -n;
  const Image inward = Draw(SceneOf(RestingTube(ModelOf(turned), kLength)));
  EXPECT_NEAR(At(right, 68, 66).g, At(inward, 68, 66).g, 8);
}

TEST_F(SkinPicture, GhostsLetTheBackgroundThroughAndTintsShow) {
  SkinnedFigure figure = RestingTube(ModelOf(TubeSkin(kLength, 32, 20)), kLength);
  const Pixel solid = At(Draw(SceneOf(figure)), 68, 30);
  SkinnedFigure ghost = figure;
  ghost.alpha = 0.3f;
  EXPECT_GT(At(Draw(SceneOf(ghost)), 68, 30).b, solid.b + 60);
  figure.tints = {{0, 0, 0, 0}, {0, 0, 1, 0.5f}};
  const Image tinted = Draw(SceneOf(figure));
  EXPECT_GT(At(tinted, 68, 30).b, solid.b + 60);
  EXPECT_TRUE(IsGreen(At(tinted, 68, 66)));
}

// It is darker below the tube than beside it.
TEST_F(SkinPicture, ThrowsAShadowOnTheGround) {
  Scene scene = SceneOf(RestingTube(ModelOf(TubeSkin(kLength, 32, 20)), kLength));
  scene.ground.visible = true;
  scene.ground.floor = scene.ground.pattern;
  scene.to_light = {0, -1, 1};
  scene.camera.eye = {6, 0, 4};
  const Image with = Draw(scene);
  const Image without = Draw([&] {
    Scene empty = scene;
    empty.skins.clear();
    return empty;
  }());
  int darker = 0;
  for (int x = 76; x < 128; ++x) darker += At(with, x, 70).r < At(without, x, 70).r - 20;
  EXPECT_GT(darker, 10);
}

TEST_F(SkinPicture, IsTheSameEveryTimeAndForEverySkinInTurn) {
  const auto first = ModelOf(TubeSkin(kLength, 32, 20));
  const Image once = Draw(SceneOf(RestingTube(first, kLength)));
  for (int i = 0; i < 20; ++i) {
    Draw(SceneOf(RestingTube(ModelOf(TubeSkin(kLength, 8 + i, 4)), kLength)));
  }
  EXPECT_EQ(Draw(SceneOf(RestingTube(first, kLength))).rgba, once.rgba);
}

TEST_F(SkinPicture, TakesDegenerateTrianglesAndUnusedVertices) {
  auto skin = std::make_shared<Skin>(*TubeSkin(kLength, 32, 20));
  const Image clean = Draw(SceneOf(RestingTube(ModelOf(skin), kLength)));
  SkinMesh& mesh = skin->meshes[0];
  auto odd = std::make_shared<Skin>(*skin);
  odd->meshes[0].triangles.push_back({5, 5, 5});
  odd->meshes[0].triangles.push_back({5, 6, 5});
  odd->meshes[0].positions.push_back({500, 500, 500});
  odd->meshes[0].normals.push_back({0, 0, 0});
  odd->meshes[0].texture_coordinates.push_back({0, 0});
  odd->meshes[0].weights.push_back({0, 0, 0, 0});
  odd->meshes[0].bind_indices.push_back({0, 0, 0, 0});
  odd->meshes.push_back({});  // nothing at all
  EXPECT_EQ(Draw(SceneOf(RestingTube(ModelOf(odd), kLength))).rgba, clean.rgba);
  mesh.triangles.clear();
  EXPECT_EQ(Coverage(Draw(SceneOf(RestingTube(ModelOf(skin), kLength)))), 0);
}

}  // namespace
}  // namespace hazumi::render
