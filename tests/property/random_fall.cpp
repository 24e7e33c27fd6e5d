#include "tests/property/random_fall.h"

#include <algorithm>
#include <string>

#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "tests/property/random_region.h"
#include "tests/support/animations.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

namespace {

constexpr int kFallFrames = 150;

SceneObject BoxAt(const Vec3& center, const Vec3& size, const Mat3& R = Mat3::Identity()) {
  SceneObject object;
  object.shape = Box{{R, center}, 0.5 * size};
  return object;
}

// The top step is at x < 0; they go down towards +x.
void AddStairs(Animation* animation) {
  constexpr int kSteps = 8;
  constexpr double kRise = 0.17, kRun = 0.28, kWidth = 6.0, kTop = 3.0;
  for (int i = 0; i < kSteps; ++i) {
    const double height = kRise * (kSteps - i), run = i == 0 ? kTop : kRun;
    const double x = i == 0 ? -0.5 * kTop : kRun * (i - 0.5);
    animation->scene.push_back(BoxAt({x, 0.0, 0.5 * height}, {run, kWidth, height}));
  }
}

void AddBoxes(Random* random, Animation* animation) {
  for (int i = random->Integer(1, 5); i > 0; --i) {
    const Vec3 size(random->Uniform(0.1, 1.0), random->Uniform(0.1, 1.0),
                    random->Uniform(0.1, 0.8));
    const Mat3 R = random->Chance(0.5) ? Mat3(random->Rotation()) : Mat3(Mat3::Identity());
    animation->scene.push_back(BoxAt(random->Vector3(0.8).cwiseProduct(Vec3(1, 1, 0.5)), size, R));
  }
}

void AddTerrain(Terrain terrain, Random* random, Animation* animation) {
  AddFloor(animation);
  if (terrain == Terrain::kBoxes) AddBoxes(random, animation);
  if (terrain == Terrain::kStairs) AddStairs(animation);
  for (size_t i = 0; i < animation->scene.size(); ++i) {
    animation->scene[i].name = "object " + std::to_string(i);
    const double coefficient = random->Uniform(0.4, 0.9);
    animation->scene[i].friction = coefficient * coefficient / SceneObject::kFriction;
  }
}

void PoseAtRandom(Random* random, Animation* animation) {
  const Figure& figure = *animation->figure;
  const VecX q = RandomAngles(figure, random);
  for (int j = 0; j < figure.num_joints(); ++j) {
    const Joint& joint = figure.joints()[j];
    const double start = std::clamp(0.3 * q[j], 0.9 * joint.lower, 0.9 * joint.upper);
    animation->joint_keys[j] = {{0, start, random->Uniform(-2.0, 2.0), Interpolation::kCubic}};
  }
  for (int i = 0; i < kNumRootCurves; ++i) {
    const double most = i < 3 ? 1.0 : 3.0;
    const double value = i < 3 ? 0.0 : random->Uniform(-1.5, 1.5);
    animation->root_keys[i] = {{0, value, random->Uniform(-most, most), Interpolation::kCubic}};
  }
}

// Where its keys place it.
MotionFrame FirstFrameOf(Animation animation) {
  animation.regions.clear();
  animation.placements.clear();
  animation.held_objects.clear();
  animation.last_frame = 1;
  return BakeOrFail(animation).frames.front();
}

// So high that it has this much room.
void Lift(double room, Animation* animation) {
  constexpr double kHigh = 20.0;
  animation->root_keys[2][0].value = kHigh;
  const MotionFrame frame = FirstFrameOf(*animation);
  DynamicsWorkspace ws(*animation->figure);
  double down = 0.0;
  for (const double step : {1.0, 0.1, 0.01}) {
    for (;; down += step) {
      Pose X = frame.X_WR;
      X.p.z() -= down + step;
      ComputePositions(*animation->figure, X, frame.q, &ws);
      if (Clearance(*animation->figure, animation->scene, ws) < room) break;
    }
  }
  animation->root_keys[2][0].value = kHigh - down;
}

// Above the figure, out of it and of the scene.
Vec3 PlaceBeside(const Animation& animation, const MotionFrame& frame, const DynamicsWorkspace& ws,
                 double radius, Random* random) {
  for (;;) {
    const Vec3 beside = random->Vector3(0.5);
    const Vec3 above = beside + random->Uniform(1.0, 2.5) * Vec3::UnitZ();
    const Vec3 place = frame.X_WR.p + above;
    const Capsule ball = {place, place, radius};
    const auto touches = [&](const auto& shape) {
      return SignedDistance(ball, shape).value <= 0.0;
    };
    const auto& links = animation.figure->links();
    const auto& scene = animation.scene;
    if (std::none_of(links.begin(), links.end(),
                     [&](const Link& link) { return touches(InWorld(link, ws)); }) &&
        std::none_of(scene.begin(), scene.end(),
                     [&](const SceneObject& object) { return touches(object.shape); })) {
      return place;
    }
  }
}

}  // namespace

Animation RandomFall(uint64_t seed, Terrain terrain) {
  Random random(seed);
  Animation animation = Still(RandomFigure(/*has_limits=*/true, &random));
  animation.solver.method = Method::kExact;
  animation.gravity = kG;
  animation.last_frame = kFallFrames;
  AddGravity(&animation, 0, kFallFrames);
  AddTerrain(terrain, &random, &animation);
  PoseAtRandom(&random, &animation);
  Lift(random.Uniform(0.02, 0.6), &animation);
  DynamicsRegion region;
  region.name = "all";
  region.method = Method::kExact;
  region.last_frame = kFallFrames;
  region.root = true;
  region.touches_scene = true;
  for (int j = 0; j < animation.figure->num_joints(); ++j) region.joints.emplace_back(j);
  region.friction.assign(region.joints.size(), 0.8);
  animation.regions.push_back(region);
  return animation;
}

void DropBalls(uint64_t seed, Animation* animation) {
  Random random(seed);
  const MotionFrame frame = FirstFrameOf(*animation);
  const GroupIndex hand(0);  // that lets them go, far away
  DynamicsWorkspace ws(*animation->figure);
  ComputePositions(*animation->figure, frame.X_WR, frame.q, &ws);
  const BodyScratch& body = ws.body(animation->figure->group(hand).last());
  for (int i = random.Integer(1, 4); i > 0; --i) {
    HeldObject ball;
    ball.name = "ball " + std::to_string(i);
    const double radius = random.Uniform(0.03, 0.2);
    ball.shape = SphereShape{radius};
    ball.mass = std::pow(10.0, random.Uniform(-1.0, 0.7));
    ball.touches_scene = true;
    ball.restitution = std::max(0.0, random.Uniform(-0.4, 0.8));
    ball.friction = random.Uniform(0.2, 1.0);
    const Vec3 place = PlaceBeside(*animation, frame, ws, radius, &random);
    const Vec3 offset = body.R.transpose() * (place - body.p);
    ball.holders = {{hand, offset, Holder::kFromTheStart, 0}};
    animation->held_objects.push_back(ball);
  }
}

}  // namespace hazumi::test
