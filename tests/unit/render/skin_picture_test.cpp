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

// Green takes the red out of the texture's upper half, and leaves its lower half green.
TEST_F(SkinPicture, ColorsOfVerticesAreFactors) {
  auto skin = std::make_shared<Skin>(*TubeSkin(kLength, 32, 20));
  SkinMesh& mesh = skin->meshes[0];
  mesh.colors.assign(mesh.positions.size(), Eigen::Vector3f(0.0f, 1.0f, 0.0f));
  const Image image = Draw(SceneOf(RestingTube(ModelOf(skin), kLength)));
  EXPECT_LT(At(image, 68, 30).r, 90);
  EXPECT_FALSE(IsRed(At(image, 68, 30)));
  EXPECT_TRUE(IsGreen(At(image, 68, 66)));
  EXPECT_TRUE(IsGreen(At(image, 60, 30))) << "yellow without its red";
}

// Blue is added to what the light shows; with the texture as a factor only where that is not black.
TEST_F(SkinPicture, EmissionIsAdded) {
  auto skin = std::make_shared<Skin>(*TubeSkin(kLength, 32, 20));
  const Pixel red = At(Draw(SceneOf(RestingTube(ModelOf(skin), kLength))), 68, 30);
  skin->materials[0].emission = {0.0f, 0.0f, 0.8f};
  const Pixel shining = At(Draw(SceneOf(RestingTube(ModelOf(skin), kLength))), 68, 30);
  EXPECT_GT(shining.b, red.b + 100);
  EXPECT_NEAR(shining.r, red.r, 2);
  skin->materials[0].emission = {0.0f, 0.8f, 0.0f};
  skin->materials[0].emission_texture = 0;
  const Image image = Draw(SceneOf(RestingTube(ModelOf(skin), kLength)));
  EXPECT_NEAR(At(image, 68, 30).g, red.g, 30) << "the texture is red there";
  EXPECT_GT(At(image, 68, 66).g, 200) << "green there";
  skin->meshes[0].texture_coordinates.clear();
  EXPECT_GT(At(Draw(SceneOf(RestingTube(ModelOf(skin), kLength))), 68, 30).g, 180)
      << "without places in it there is no texture";
}

// A box of 0.5 m around the origin of the bone "lower", with flat faces; its normals are outward.
std::shared_ptr<Skin> BoxSkin() {
  auto skin = std::make_shared<Skin>(*TubeSkin(kLength, 8, 2));
  skin->materials[0] = {"red", {0.6f, 0.02f, 0.02f, 1.0f}, -1};
  SkinMesh mesh;
  mesh.material = 0;
  mesh.binds.resize(1);
  for (int face = 0; face < 6; ++face) {
    const int k = face / 2, i = (k + 1) % 3, j = (k + 2) % 3;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      Eigen::Vector3f p, n = Eigen::Vector3f::Zero();
      n[k] = face % 2 == 0 ? 1.0f : -1.0f;
      p[k] = n[k], p[i] = float(a), p[j] = float(b);
      mesh.positions.push_back(0.25f * p);
      mesh.normals.push_back(n);
      mesh.bind_indices.push_back({});
      mesh.weights.push_back({1, 0, 0, 0});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  skin->meshes = {mesh};
  return skin;
}

Scene BoxScene(const std::shared_ptr<const Skin>& skin) {
  SkinnedFigure figure = RestingTube(ModelOf(skin), kLength);
  figure.X_WB[0].p = {0, 0, 1};
  return SceneOf(figure);
}

// All the other way around first; then a mirror, which turns them once more.
TEST_F(SkinPicture, ClosedPiecesAreSeenFromOutsideHoweverTheyAreWoundOrMirrored) {
  const auto skin = BoxSkin();
  auto facing = std::make_shared<Skin>(*skin);
  for (size_t i = 0; i < facing->meshes[0].triangles.size(); ++i) {
    auto& t = facing->meshes[0].triangles[i];
    if (i / 2 % 2 == 1) std::swap(t[1], t[2]);
  }
  const auto model = ModelOf(facing);
  ASSERT_EQ(model->parts.size(), 1u);
  EXPECT_EQ(model->parts[0].surface, SkinModel::Surface::kClosed);
  const Image image = Draw(BoxScene(facing));
  const Pixel lit = At(image, 64, 48);
  EXPECT_GT(lit.r, 180);
  for (auto& t : facing->meshes[0].triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(Draw(BoxScene(facing)).rgba, image.rgba);
  facing->meshes[0].binds[0].inverse_bind(1, 1) = -1.0;
  EXPECT_NEAR(At(Draw(BoxScene(facing)), 64, 48).r, lit.r, 1);
}

TEST_F(SkinPicture, ATubeWithoutEndsShowsItsInside) {
  const auto model = ModelOf(TubeSkin(kLength, 32, 20));
  ASSERT_EQ(model->parts.size(), 1u);
  EXPECT_EQ(model->parts[0].surface, SkinModel::Surface::kOpen);
  Scene scene = SceneOf(RestingTube(model, kLength));
  scene.camera.eye = {0.5, 0, 4.0};  // from above, into it
  scene.camera.target = {0, 0, 1.8};
  const Pixel p = At(Draw(scene), 64, 48);
  EXPECT_GT(p.g, p.b + 60);  // where green and yellow meet
}

// The clear right half of the texture lets the background through; alpha that is nowhere clear is
// no hole.
TEST_F(SkinPicture, ClearTexelsAreHoles) {
  auto skin = std::make_shared<Skin>(*TubeSkin(kLength, 32, 20));
  skin->meshes[0].texture_coordinates.clear();
  for (const Eigen::Vector3f& p : skin->meshes[0].positions) {
    skin->meshes[0].texture_coordinates.push_back({p.y() > 0.0f ? 0.75f : 0.25f, 0.5f});
  }
  // A PNG of two pixels, RGBA: green that is opaque and green that is clear.
  skin->textures[0].encoded = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
      0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0xf4,
      0x22, 0x7f, 0x8a, 0x00, 0x00, 0x00, 0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60,
      0x38, 0xc1, 0xf0, 0x1f, 0x88, 0x19, 0x00, 0x0c, 0xd4, 0x02, 0x90, 0x08, 0x92, 0xb0, 0x37,
      0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const Image image = Draw(SceneOf(RestingTube(ModelOf(skin), kLength)));
  EXPECT_TRUE(IsGreen(At(image, 58, 48)));
  EXPECT_FALSE(IsGreen(At(image, 71, 48)));
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
