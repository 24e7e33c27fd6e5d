// Limbs that are aimed go round what stands in between.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>

#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/aims/aims.h"
#include "tests/unit/makers/aim_scene.h"

namespace hazumi::test {
namespace {

using makers::MadeAim;

// Largest depth of the links beyond a joint in a box, in a state of the figure [m].
double DepthIn(const Box& box, const char* joint, const Figure& figure, const Pose& X_WR,
               const VecX& q) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, q, &ws);
  const JointIndex first = figure.group(*figure.FindGroup(joint)).first;
  double depth = -1.0;
  for (const Link& link : figure.links()) {
    if (!link.joint.is_valid() || !figure.IsBeyond(link.joint, first)) continue;
    const BodyScratch& body = ws.body(link.joint);
    const Capsule now = {body.p + body.R * link.capsule.a, body.p + body.R * link.capsule.b,
                         link.capsule.radius};
    depth = std::max(depth, -SignedDistance(now, box).value);
  }
  return depth;
}

// Points behind a box that stands where the arm goes without it.
TEST(Aim, APalmReachesPointsBehindABox) {
  constexpr int kPoints = 10;
  constexpr double kFree = 0.03;  // around the box as it begins and ends [m]
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  const Figure& figure = scene.figure();
  const Motion swing = MotionOf(scene.project);
  std::mt19937 random(7);
  const JointIndex wrist = *figure.FindJoint("r_wrist_deviation");
  const Vec3 palm(0.0, 0.0, -0.09);
  DynamicsWorkspace ws(figure);
  const auto palm_in = [&](const MotionFrame& frame, const VecX& q) {
    ComputePositions(figure, frame.X_WR, q, &ws);
    return Vec3(ws.body(wrist).p + ws.body(wrist).R * palm);
  };
  int points = 0, tries = 0;
  std::vector<double> times;
  while (points < kPoints && ++tries < 500) {
    const std::vector<double> angles = scene.RandomPose(&random);
    MotionFrame frame = At(15, swing);
    for (size_t k = 0; k < angles.size(); ++k) {
      frame.q[scene.hinges()[k].value()] = angles[k] * kDegree;
    }
    const Vec3 place = palm_in(frame, frame.q);
    Project project = scene.WithPoint("r_wrist", palm, place);
    const Result<MadeAim> free = makers::MakeAim("touch", project, nullptr);
    if (!free.ok()) continue;
    const Motion motion = MotionOf(free.value().project);
    const MotionFrame &start = At(5, motion), &middle = At(11, motion), &end = At(15, motion);
    const Box box = {{Mat3::Identity(), palm_in(middle, middle.before.q)}, Vec3(0.07, 0.07, 0.07)};
    if (DepthIn(box, "r_shoulder", figure, start.X_WR, start.after.q) > -kFree ||
        DepthIn(box, "r_shoulder", figure, end.X_WR, end.before.q) > -kFree) {
      continue;
    }
    // Nor where the trunk carries the shoulder.
    bool is_free = true;
    for (int f = 5; f <= 15; ++f) {
      ComputePositions(figure, At(f, motion).X_WR, At(f, motion).q, &ws);
      const Vec3 shoulder = ws.body(scene.hinges().front()).p;
      is_free &= SignedDistance(Capsule{shoulder, shoulder, 0.1}, box).value > kFree;
    }
    if (!is_free) continue;
    ++points;
    ProjectBox shape;
    shape.center_m = box.X_WB.p;
    shape.size_m = 2.0 * box.half_size;
    ProjectSceneObject object;
    object.name = "box";
    object.shape = shape;
    project.scene.objects.push_back(object);
    const auto before = std::chrono::steady_clock::now();
    const Result<MadeAim> made = makers::MakeAim("touch", project, nullptr);
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before)
            .count());
    ASSERT_TRUE(made.ok()) << made.error().ToString();
    const Motion round = MotionOf(made.value().project);
    double deep = -1.0;
    for (int f = 5; f <= 15; ++f) {
      const MotionFrame& at = At(f, round);
      deep = std::max(
          deep, DepthIn(box, "r_shoulder", figure, at.X_WR, f > 5 ? at.before.q : at.after.q));
    }
    const MotionFrame& there = At(15, round);
    const double off = (palm_in(there, there.before.q) - place).norm();
    EXPECT_LE(off, 0.005) << points;
    EXPECT_LE(deep, 5e-4) << points;
  }
  EXPECT_EQ(points, kPoints);
  std::sort(times.begin(), times.end());
  std::printf("%zu aims behind a box: median %.1f ms, longest %.1f ms\n", times.size(),
              times[times.size() / 2], times.back());
}

}  // namespace
}  // namespace hazumi::test
