#include "render/motion/motion_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/motion/framing.h"
#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"

namespace hazumi::render {
namespace {

using test::BakeOrFail;
using test::Still;

Scene SceneOf(const Animation& animation, int frame, const Overlays& overlays = {}) {
  const Motion motion = BakeOrFail(animation);
  const Camera camera = FrameMotion(animation, motion, "three-quarter", 16.0 / 9.0);
  return MotionScene(animation, motion, motion, camera, overlays).At(frame);
}

TEST(MotionScene, DrawsLinksWithoutLooksAsTheirCapsules) {
  const Animation animation = Still(test::TwoLinks());
  const Scene scene = SceneOf(animation, 0);
  EXPECT_EQ(scene.capsules.size(), animation.figure->links().size());
  EXPECT_FALSE(scene.ground.visible);
}

TEST(MotionScene, ALevelPlaneIsTheGround) {
  Animation animation = Still(test::Pogo());
  test::AddFloor(&animation, -0.7);
  const Scene scene = SceneOf(animation, 0);
  EXPECT_TRUE(scene.ground.visible);
  EXPECT_DOUBLE_EQ(scene.ground.height, -0.7);
}

TEST(MotionScene, GhostsAreTheFigureAtEveryNthOtherFrame) {
  const Animation animation = Still(test::TwoLinks());
  Overlays overlays;
  overlays.ghost_every = 10;  // frames 0, 10, 20, 30
  const size_t links = animation.figure->links().size();
  EXPECT_EQ(SceneOf(animation, 10, overlays).capsules.size(), links * 4);
  EXPECT_EQ(SceneOf(animation, 11, overlays).capsules.size(), links * 5);
}

TEST(MotionScene, TintsTheJointsOfARegionOnly) {
  Animation animation = Still(test::TwoLinks());
  test::AddRegion(&animation, "shank", 5, 15, {"knee"});
  test::KeyTheRest(&animation);
  Overlays overlays;
  overlays.region_tint = true;
  const Scene before = SceneOf(animation, 4, overlays), in = SceneOf(animation, 5, overlays);
  size_t changed = 0;
  for (size_t i = 0; i < in.capsules.size(); ++i) {
    changed += !(in.capsules[i].color == before.capsules[i].color);
  }
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, in.capsules.size());
}

TEST(MotionScene, MarksTheCentreOfMassAndWhatIsBelowIt) {
  Animation animation = Still(test::Pogo());
  test::AddFloor(&animation, -0.7);
  Overlays overlays;
  overlays.paths = true;
  const Vec3 com = BakeOrFail(animation).frames[0].com;
  const Scene scene = SceneOf(animation, 0, overlays);
  const auto marker = [&](MarkerShape shape) {
    const auto found = std::find_if(scene.markers.begin(), scene.markers.end(),
                                    [&](const Marker& m) { return m.shape == shape; });
    return found == scene.markers.end() ? Vec3(Vec3::Constant(1e9)) : found->center;
  };
  EXPECT_EQ(marker(MarkerShape::kCenterOfMass), com);
  EXPECT_LE((marker(MarkerShape::kCross) - Vec3(com.x(), com.y(), -0.7)).norm(), 0.01);
}

TEST(Framing, SeesTheWholeMotionFromEverySide) {
  const Animation animation = Still(test::Human());
  const Motion motion = BakeOrFail(animation);
  for (const char* side : {"front", "back", "left", "right", "top", "three-quarter"}) {
    const Camera camera = FrameMotion(animation, motion, side, 16.0 / 9.0);
    const Mat4 clip_of_world = ProjectionMatrix(camera, 16.0 / 9.0) * ViewMatrix(camera);
    for (const MotionFrame& frame : motion.frames) {
      const Eigen::Vector4d clip = clip_of_world * frame.com.homogeneous();
      EXPECT_LT(std::abs(clip.x()), clip.w()) << side;
      EXPECT_LT(std::abs(clip.y()), clip.w()) << side;
    }
  }
}

}  // namespace
}  // namespace hazumi::render
