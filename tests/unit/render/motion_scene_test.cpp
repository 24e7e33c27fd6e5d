#include "render/motion/motion_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  overlays.ghosts = EveryNth(10, 31);  // frames 0, 10, 20, 30
  const size_t links = animation.figure->links().size();
  EXPECT_EQ(SceneOf(animation, 10, overlays).capsules.size(), links * 4);
  EXPECT_EQ(SceneOf(animation, 11, overlays).capsules.size(), links * 5);
}

TEST(MotionScene, GhostsTellBeforeFromAfterByTheirColours) {
  const Animation animation = Still(test::TwoLinks());
  const size_t links = animation.figure->links().size();
  const Scene scene = SceneOf(animation, 10, {.ghosts = {0, 20}, .tells_ghosts = true});
  ASSERT_EQ(scene.capsules.size(), links * 3);
  const SrgbColor before = scene.capsules[links].color, after = scene.capsules[2 * links].color;
  EXPECT_GT(before.b, before.r + 0.1f);
  EXPECT_GT(after.r, after.b + 0.1f);
}

TEST(MotionScene, TheKeyedGhostIsThereWhereARegionMovesAwayFromTheKeys) {
  Animation animation = Still(test::TwoLinks());
  test::AddRegion(&animation, "shank", 5, 15, {"knee"});
  test::KeyTheRest(&animation);
  const JointIndex knee = *animation.figure->FindJoint("knee");
  animation.joint_keys[knee.value()] = {{0.0, 0.8, 0.0}, {30.0, 0.8, 0.0}};
  const size_t links = animation.figure->links().size();
  const Overlays overlays{.keyed_ghost = true};
  EXPECT_EQ(SceneOf(animation, 4, overlays).capsules.size(), links);
  const Scene scene = SceneOf(animation, 12, overlays);
  ASSERT_GT(scene.capsules.size(), links);
  EXPECT_LT(scene.capsules.size(), 2 * links);  // what is above the knee is where it is
  Animation keyed = animation;
  keyed.regions.clear();
  const Scene expected = SceneOf(keyed, 12);
  EXPECT_LT((scene.capsules.back().b - expected.capsules.back().b).norm(), 1e-9);
  EXPECT_LT(scene.capsules.back().color.a, 0.5f);
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

// A skin of one triangle on each body of the figure, bound by the bones' names.
FigureSkin SkinOn(const Figure& figure) {
  const auto skin = std::make_shared<Skin>();
  SkinMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0, 0.1f}};
  mesh.normals.assign(3, Eigen::Vector3f::UnitY());
  mesh.weights.assign(3, {1.0f, 0.0f, 0.0f, 0.0f});
  mesh.bind_indices.resize(3);
  mesh.triangles = {{0, 1, 2}};
  skin->bones.push_back(figure.root_name());
  for (const Joint& joint : figure.joints()) skin->bones.push_back(joint.name);
  for (size_t i = 0; i < skin->bones.size(); ++i) {
    mesh.binds.resize(1);
    mesh.binds[0].bone = static_cast<int>(i);
    skin->meshes.push_back(mesh);
  }
  SkinCache cache;
  const Result<FigureSkin> result = cache.On(figure, skin);
  EXPECT_TRUE(result.ok());
  return result.value();
}

Scene SkinnedSceneOf(const Animation& animation, int frame, const Overlays& overlays) {
  const Motion motion = BakeOrFail(animation);
  return MotionScene(animation, motion, motion, {}, overlays, SkinOn(*animation.figure)).At(frame);
}

TEST(MotionScene, DrawsTheSkinInsteadOfTheLinksOrAroundThem) {
  const Animation animation = Still(test::TwoLinks());
  const size_t links = animation.figure->links().size();
  const Scene skin = SkinnedSceneOf(animation, 0, {});
  ASSERT_EQ(skin.skins.size(), 1u);
  EXPECT_TRUE(skin.capsules.empty());
  EXPECT_EQ(skin.skins[0].alpha, 1.0f);
  const Scene bare = SkinnedSceneOf(animation, 0, {.look = FigureLook::kLinks});
  EXPECT_TRUE(bare.skins.empty());
  EXPECT_EQ(bare.capsules.size(), links);
  const Scene both = SkinnedSceneOf(animation, 0, {.look = FigureLook::kLinksInSkin});
  EXPECT_LT(both.skins[0].alpha, 1.0f);
  EXPECT_EQ(both.capsules.size(), links);
}

TEST(MotionScene, TheSkinsBonesAreTheBodies) {
  const Animation animation = Still(test::TwoLinks());
  const Motion motion = BakeOrFail(animation);
  const Scene scene = SkinnedSceneOf(animation, 3, {.bones = true});
  const SkinnedFigure& skin = scene.skins[0];
  ASSERT_EQ(skin.X_WB.size(), size_t(animation.figure->num_joints()) + 1);
  EXPECT_EQ(skin.X_WB[0], motion.frames[3].X_WR);
  // The line to a joint ends where its bone is.
  const Vec3 last = skin.X_WB.back().p;
  const bool found = std::any_of(scene.polylines.begin(), scene.polylines.end(),
                                 [&](const Polyline& line) { return line.points[0] == last; });
  EXPECT_TRUE(found);
}

TEST(MotionScene, SkinsOfGhostsAreSeeThroughAndRegionsTintTheSkin) {
  Animation animation = Still(test::TwoLinks());
  test::AddRegion(&animation, "shank", 5, 15, {"knee"});
  test::KeyTheRest(&animation);
  const Scene scene = SkinnedSceneOf(animation, 10, {.ghosts = {0, 20}, .region_tint = true});
  ASSERT_EQ(scene.skins.size(), 3u);  // frames 10, 0, 20
  EXPECT_LT(scene.skins[1].alpha, 0.5f);
  const JointIndex knee = *animation.figure->FindJoint("knee");
  EXPECT_GT(scene.skins[0].tints[knee.value() + 1].a, 0.0f);
  EXPECT_EQ(scene.skins[0].tints[0].a, 0.0f);
  EXPECT_EQ(scene.skins[1].tints[knee.value() + 1].a, 0.0f);
}

TEST(FigureSkin, NamesABoneThatTheFigureDoesNotHave) {
  const Animation animation = Still(test::TwoLinks());
  const auto skin = std::make_shared<Skin>();
  skin->bones = {"tail"};
  SkinCache cache;
  const Result<FigureSkin> result = cache.On(*animation.figure, skin);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("\"tail\""), std::string::npos);
}

TEST(FigureSkin, SaysOnceWhatItCouldNotRead) {
  const Animation animation = Still(test::TwoLinks());
  const auto skin = std::make_shared<Skin>();
  skin->textures = {{"face.png", {1, 2, 3}}};
  SkinCache cache;
  ASSERT_TRUE(cache.On(*animation.figure, skin).ok());
  const std::vector<Warning> warnings = cache.TakeWarnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].place, "textures[0] face.png");
  EXPECT_NE(warnings[0].message.find("neither a PNG nor a JPEG"), std::string::npos);
  ASSERT_TRUE(cache.On(*animation.figure, skin).ok());
  EXPECT_TRUE(cache.TakeWarnings().empty());
}

TEST(FigureSkin, IsMadeReadyOnceForASkin) {
  const Animation animation = Still(test::TwoLinks());
  const auto skin = std::make_shared<Skin>();
  SkinCache cache;
  const auto first = cache.On(*animation.figure, skin).value().model;
  EXPECT_EQ(cache.On(*animation.figure, skin).value().model, first);
  EXPECT_NE(cache.On(*animation.figure, std::make_shared<Skin>()).value().model, first);
  EXPECT_FALSE(cache.On(*animation.figure, nullptr).value());
}

TEST(MotionScene, MarksTheCentreOfMassAndWhatIsBelowIt) {
  // 3 kg at the root; 0.4 m below it a knee, 2 kg at 0.2 m and 1 kg at 0.4 m from that.
  Animation animation = Still(test::TwoLinks());
  test::KeysOf(&animation, "knee") = {{0, 0.7, {}, Interpolation::kCubic}};
  test::AddFloor(&animation, -1.0);
  Overlays overlays;
  overlays.paths = true;
  const Vec3 com(-0.8 * std::sin(0.7) / 6.0, 0.0, (-1.2 - 0.8 * std::cos(0.7)) / 6.0);
  const Scene scene = SceneOf(animation, 0, overlays);
  const auto marker = [&](MarkerShape shape) {
    const auto found = std::find_if(scene.markers.begin(), scene.markers.end(),
                                    [&](const Marker& m) { return m.shape == shape; });
    return found == scene.markers.end() ? Vec3(Vec3::Constant(1e9)) : found->center;
  };
  EXPECT_LE((marker(MarkerShape::kCenterOfMass) - com).norm(), 1e-9);
  EXPECT_LE((marker(MarkerShape::kCross) - Vec3(com.x(), com.y(), -1.0)).norm(), 0.01);
}

constexpr auto IsRed = [](const auto& mark) { return mark.color.r > 0.9f && mark.color.g < 0.1f; };

// A red ball of 10 cm, let go on frame 2 of 30.
Animation LetGo() {
  Animation animation = Still(test::TwoLinks());
  animation.last_frame = animation.first_frame + 30;
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{0.1};
  ball.mass = 0.1;
  ball.color = "#ff0000";
  ball.holders.push_back({animation.figure->joint(JointIndex(0)).group, Vec3::Zero()});
  ball.holders[0].last_frame = animation.first_frame + 2;
  animation.held_objects.push_back(ball);
  return animation;
}

// Let go at rest, half a metre above the floor: 0.32 s, of 1 s.
TEST(MotionScene, FollowsWhatIsLetGoToTheFloor) {
  Animation animation = LetGo();
  Overlays overlays;
  overlays.paths = true;
  const Vec3 start = BakeOrFail(animation).frames[0].objects[0].X_WO.p;
  test::AddFloor(&animation, start.z() - 0.6);
  const Scene scene = SceneOf(animation, 0, overlays);
  const auto path = std::find_if(scene.polylines.begin(), scene.polylines.end(), IsRed);
  ASSERT_NE(path, scene.polylines.end());
  EXPECT_LE((path->points.front() - start).norm(), 1e-9);
  EXPECT_LE((path->points.back() - (start - 0.5 * Vec3::UnitZ())).norm(), 1e-9);
  EXPECT_NEAR(static_cast<double>(path->points.size()), 30.0 * std::sqrt(2.0 * 0.5 / 9.81) + 1,
              1.0);
  const auto mark = std::find_if(scene.markers.begin(), scene.markers.end(), IsRed);
  ASSERT_NE(mark, scene.markers.end());
  EXPECT_LE((mark->center - (start - 0.6 * Vec3::UnitZ())).norm(), 0.01);
}

// It passes a centimetre beyond the edge of a box, over which it was in the frame before, and down
// onto one that it was not over.
TEST(MotionScene, MarksALandingOnWhatIsBelowTheLanding) {
  Animation animation = LetGo();
  Overlays overlays;
  overlays.paths = true;
  const Vec3 start = BakeOrFail(animation).frames[0].objects[0].X_WO.p;
  Keys moved = {{0, 0.0, 3.0, Interpolation::kLinear}, {30, 3.0, 3.0, Interpolation::kLinear}};
  animation.root_keys[kRootX] = moved;
  const Motion motion = BakeOrFail(animation);
  const auto at = [&](int frame) { return motion.frames[frame].objects[0].X_WO.p; };
  test::AddFloor(&animation, start.z() - 1.0);
  const auto box = [&](double x_first, double x_last, double top) {
    const Vec3 half_size(0.5 * (x_last - x_first), 0.5, 0.05);
    const Vec3 center(0.5 * (x_first + x_last), start.y(), top - 0.05);
    animation.scene.push_back({"box", Box{{Mat3::Identity(), center}, half_size}, "#808080"});
  };
  const auto landing = [&] {
    const Scene scene = SceneOf(animation, 0, overlays);
    const auto mark = std::find_if(scene.markers.begin(), scene.markers.end(), IsRed);
    return mark == scene.markers.end() ? Vec3(Vec3::Constant(1e9)) : mark->center;
  };
  // Its underside passes this height half way between frames 8 and 9.
  const double top = 0.5 * (at(8).z() + at(9).z()) - 0.1, x = 0.5 * (at(8).x() + at(9).x());
  box(at(8).x() - 0.1, x - 0.01, top);
  EXPECT_NEAR(landing().z(), start.z() - 1.0, 0.01);
  animation.scene.pop_back();
  box(x - 0.01, at(9).x() + 0.1, top);
  EXPECT_NEAR(landing().z(), top, 0.01);
  EXPECT_NEAR(landing().x(), x, 0.01);
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

TEST(Framing, SeesWhatIsThrownAndTheBoxBesideIt) {
  Animation animation = LetGo();
  animation.root_keys[kRootX] = {{0, 0.0, 3.0, Interpolation::kLinear},
                                 {30, 3.0, 3.0, Interpolation::kLinear}};
  animation.scene.push_back(
      {"box", Box{{Mat3::Identity(), Vec3(4.0, 0.0, -1.0)}, Vec3(0.3, 0.3, 0.3)}, "#808080"});
  animation.scene.push_back(
      {"hill", Box{{Mat3::Identity(), Vec3(90.0, 0.0, 0.0)}, Vec3(50.0, 50.0, 9.0)}, "#808080"});
  const Motion motion = BakeOrFail(animation);
  const Camera camera = FrameMotion(animation, motion, "left", 16.0 / 9.0);
  const Mat4 clip_of_world = ProjectionMatrix(camera, 16.0 / 9.0) * ViewMatrix(camera);
  const auto is_seen = [&](const Vec3& p) {
    const Eigen::Vector4d clip = clip_of_world * p.homogeneous();
    return std::abs(clip.x()) < clip.w() && std::abs(clip.y()) < clip.w();
  };
  EXPECT_TRUE(is_seen(motion.frames.back().objects[0].X_WO.p));
  EXPECT_TRUE(is_seen(Vec3(4.3, 0.3, -1.3)));
  EXPECT_FALSE(is_seen(Vec3(140.0, 0.0, 0.0)));
}

}  // namespace
}  // namespace hazumi::render
