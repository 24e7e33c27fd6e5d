#include "render/motion/reference_film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "render/pipeline/offscreen.h"
#include "tests/support/temporary_folder.h"

namespace hazumi::render {
namespace {

// Two pictures in red, two in blue, at 10 a second.
class ReferenceFilmTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "ffmpeg is not installed";
    }
    const std::string video = folder_ / "take.mp4";
    const std::string make =
        "ffmpeg -loglevel error -f lavfi -i \"color=black:s=64x48:r=10:d=0.4,format=rgb24,"
        "geq=r='if(lt(N,2),255,0)':g=0:b='if(lt(N,2),0,255)'\" -pix_fmt yuv444p " +
        video;
    ASSERT_EQ(std::system(make.c_str()), 0);
    auto film = ReferenceFilm::Load(video, {20, 1}, {10, 1}, {});
    ASSERT_TRUE(film.ok()) << film.error().ToString();
    film_ = std::move(film).value();
    reference_.file = video;
    reference_.opacity = 1.0;
  }

  // Seen from -y; the ground is at z = 0.
  Scene SceneAt(int frame) {
    Scene scene;
    scene.camera = {.eye = {0, -5, 1}, .target = {0, 0, 1}, .vertical_fov_deg = 40.0};
    const Result<Done> added = film_.AddTo(reference_, frame, &scene);
    EXPECT_TRUE(added.ok());
    return scene;
  }
  Image Draw(const Scene& scene) {
    Result<OffscreenRenderer> renderer = OffscreenRenderer::Create({});
    Image image(128, 96);
    EXPECT_TRUE(renderer.value().Draw(scene, image).ok());
    return image;
  }

  const test::TemporaryFolder folder_;
  ProjectReference reference_;
  ReferenceFilm film_;
};

bool IsRed(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (size_t(y) * image.width + x)];
  return p[0] > 200 && p[1] < 60 && p[2] < 60;
}
bool IsBlue(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (size_t(y) * image.width + x)];
  return p[2] > 200 && p[1] < 60 && p[0] < 60;
}

TEST_F(ReferenceFilmTest, ShowsThePictureOfTheFrameBehindTheScene) {
  reference_.start_frame = 1;  // of 10 a second: the second of 20
  EXPECT_TRUE(SceneAt(1).pictures.empty());
  EXPECT_TRUE(SceneAt(10).pictures.empty());
  Scene scene = SceneAt(3);
  scene.capsules.push_back({{0, 0, 0.5}, {0, 0, 1.5}, 0.3, 0.3, {0.5f, 0.5f, 0.5f}});
  const Image image = Draw(scene);
  for (const int x : {2, 125}) {
    for (const int y : {2, 93}) EXPECT_TRUE(IsRed(image, x, y)) << x << " " << y;
  }
  EXPECT_FALSE(IsRed(image, 64, 48));  // the figure is before it
  EXPECT_TRUE(IsBlue(Draw(SceneAt(7)), 64, 20));
  reference_.mute = true;
  EXPECT_TRUE(SceneAt(3).pictures.empty());
}

TEST_F(ReferenceFilmTest, APlaneStandsInTheSceneAndIsHiddenByWhatIsBeforeIt) {
  reference_.view = ReferenceView::kPlane;
  reference_.center_m = {0, 1, 1};
  reference_.height_m = 2.0;
  Scene scene = SceneAt(0);
  const Image alone = Draw(scene);
  EXPECT_TRUE(IsRed(alone, 64, 48));
  EXPECT_FALSE(IsRed(alone, 4, 48));  // it ends
  scene.capsules.push_back({{0, 0, 0.5}, {0, 0, 1.5}, 0.3, 0.3, {0.5f, 0.5f, 0.5f}});
  EXPECT_FALSE(IsRed(Draw(scene), 64, 48));
  scene.capsules.front() = {{0, 2, 0.5}, {0, 2, 1.5}, 0.3, 0.3, {0.5f, 0.5f, 0.5f}};  // behind it
  EXPECT_TRUE(IsRed(Draw(scene), 64, 48));
  reference_.turn_deg = 90.0;  // edge on
  EXPECT_FALSE(IsRed(Draw(SceneAt(0)), 72, 48));
}

TEST_F(ReferenceFilmTest, ChangesNothingBesideIt) {
  reference_.view = ReferenceView::kPlane;
  reference_.center_m = {0, 40, 1};
  reference_.height_m = 0.01;
  Scene scene = SceneAt(0);
  scene.capsules.push_back({{0, 0, 0.1}, {0, 0, 1.5}, 0.3, 0.3, {0.5f, 0.5f, 0.5f}});
  const Image with = Draw(scene);
  scene.pictures.clear();
  const Image without = Draw(scene);
  int num_other = 0;
  for (size_t i = 0; i < with.rgba.size(); i += 4) {
    num_other += !std::equal(&with.rgba[i], &with.rgba[i] + 3, &without.rgba[i]);
  }
  EXPECT_LE(num_other, 1);
}

}  // namespace
}  // namespace hazumi::render
