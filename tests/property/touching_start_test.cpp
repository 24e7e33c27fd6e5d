// Velocity at the start of a region while contacts touch.
//
// Random figures of a few links stand on a plane, with gaps of -0.5 mm to 10 micrometres, and move
// by their keys in any direction. At the start of the region
//   sliding and separating contacts keep their velocity, unless another contact approaches,
//   approaching contacts are stopped by one impact, whose energy loss is booked to contacts.
// The centre of mass keeps its velocity but for friction during the first frame, and the energy
// account closes. A plain ctest runs a few cases; `ctest -C Slow -L slow -R touching -V` runs 500.
// HAZUMI_CASES and HAZUMI_FIRST_CASE as everywhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/bake/bake.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "engine/placement/figure_motion.h"
#include "tests/property/random_fall.h"
#include "tests/support/animations.h"
#include "tests/support/from_environment.h"
#include "tests/support/momentum.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr int kShort = 6;                            // length in frames
constexpr double kGaps[] = {0.0, 1e-7, 1e-6, 1e-5};  // [m]

double ClearanceAt(const Animation& animation, double height) {
  const Figure& figure = *animation.figure;
  DynamicsWorkspace ws(figure);
  VecX q = figure.RestAngles();
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const Keys& keys = animation.joint_keys[static_cast<size_t>(j)];
    if (!keys.empty()) q[j] = keys[0].value;
  }
  FigureMotion motion;
  RootAngles angles{};
  for (int i = 0; i < 3; ++i) {
    const Keys& keys = animation.root_keys[static_cast<size_t>(kRootAngleZ + i)];
    if (!keys.empty()) angles.angle[i] = keys[0].value;
  }
  SetRootOrientation(angles, &motion);
  motion.X_WR.p = Vec3(0.0, 0.0, height);
  ComputePositions(figure, motion.X_WR, q, &ws);
  return Clearance(figure, animation.scene, ws);
}

void SetRoot(RootCurve curve, double value, double rate, Animation* animation) {
  Key key;
  key.frame = 0.0;
  key.value = value;
  key.rate = rate;
  animation->root_keys[curve] = {key};
}

// Falling figure, placed at that gap above the plane, that moves as a whole with v.
Animation Touching(uint64_t seed, double gap, const Vec3& v) {
  Animation animation = RandomFall(seed, Terrain::kPlane);
  animation.last_frame = kShort;
  animation.regions[0].last_frame = kShort;
  for (PlacementSpan& span : animation.placements) span.last_frame = kShort;
  for (Keys& keys : animation.joint_keys) {
    keys.resize(std::min<size_t>(keys.size(), 1));
    for (Key& key : keys) key.rate = 0.0;
  }
  for (int i = 0; i < 3; ++i) {
    Keys& keys = animation.root_keys[static_cast<size_t>(kRootAngleZ + i)];
    keys.resize(std::min<size_t>(keys.size(), 1));
    for (Key& key : keys) key.rate = 0.0;
  }
  SetRoot(kRootX, 0.0, v.x(), &animation);
  SetRoot(kRootY, 0.0, v.y(), &animation);
  const double height = gap - ClearanceAt(animation, 0.0);
  SetRoot(kRootZ, height, v.z(), &animation);
  return animation;
}

struct Tally {
  int cases = 0, failed = 0, stopped = 0, open = 0;
};

void Try(int seed, Tally* tally) {
  Random random(static_cast<uint64_t>(seed) + 77);
  const double gap = kGaps[seed % 4], speed = random.Uniform(0.5, 4.0);
  const double heading = random.Uniform(0.0, 6.28);
  const double up = seed % 3 == 0 ? -random.Uniform(0.1, 1.0) : random.Uniform(0.0, 1.0);
  const Vec3 v(speed * std::cos(heading), speed * std::sin(heading), up);
  const Animation animation = Touching(static_cast<uint64_t>(seed), gap, v);
  BakeOptions options;
  options.energy = true;
  ++tally->cases;
  const Result<Motion> motion = Bake(animation, options);
  if (!motion.ok()) {
    ++tally->failed;
    std::printf("seed %d: %s\n", seed, motion.error().ToString().c_str());
    return;
  }
  const Momentum start = MomentumOf(*animation.figure, motion.value().frames[0].after);
  // Velocity with which the region takes the figure over.
  const Vec3 velocity = start.com_v;
  const EnergyBalance& energy = motion.value().regions[0].energy.value();
  const bool is_taken_over = (velocity - v).norm() <= 1e-9 * (1.0 + v.norm());
  // Friction takes as much as it may of what pushes: the weight, what lands, and falling limbs.
  const Vec3 next = MomentumOf(*animation.figure, motion.value().frames[1].after).com_v;
  const double pushes = std::max(0.0, -v.z()) + 2.0 * kG / 30.0;
  const bool goes_on = (next - v).head<2>().norm() <= 0.9 * pushes;
  const bool is_kept = is_taken_over && goes_on && (up >= 0.0 || energy.impacts < 0.0);
  // Without what potential energy and keys turn over: less than the account is compared with.
  double turned = std::max(energy.kinetic_start, energy.kinetic_end) + std::abs(energy.limits) +
                  std::abs(energy.impacts);
  for (const auto& work : energy.laws) turned += std::abs(work.joules);
  const bool is_open = !(std::abs(energy.residual()) <= 1e-6 * std::max(turned, 1e-6));
  tally->stopped += !is_kept;
  tally->open += is_open;
  if (is_kept && !is_open) return;
  std::printf(
      "seed %d: gap %.1g m, keyed %.3g %.3g %.3g m/s, begins with %.3g %.3g %.3g, "
      "unexplained %.2g J of %.3g\n",
      seed, gap, v.x(), v.y(), v.z(), velocity.x(), velocity.y(), velocity.z(), energy.residual(),
      turned);
}

TEST(TouchingStart, KeepsItsVelocityAndClosesItsAccount) {
  Tally tally;
  for (const int seed : RandomCases(1, 24)) Try(seed, &tally);
  std::printf("%d cases, %d failed, %d do not keep their velocity, %d accounts open\n", tally.cases,
              tally.failed, tally.stopped, tally.open);
  EXPECT_EQ(tally.failed, 0);
  EXPECT_EQ(tally.stopped, 0);
  EXPECT_LE(tally.open, MostOf(tally.cases, 0.01));
}

// Slides without approaching contacts: half a frame later, friction alone has changed the speed.
TEST(TouchingStart, SmallGap_ChangesTheMotionInProportion) {
  for (int seed = 1; seed <= 4; ++seed) {
    Vec3 first = Vec3::Zero();
    for (const double gap : kGaps) {
      const Animation animation = Touching(static_cast<uint64_t>(seed), gap, Vec3(3.0, 0.0, 0.5));
      const Result<Motion> motion = Bake(animation);
      ASSERT_TRUE(motion.ok()) << motion.error().ToString();
      const MotionFrame& frame = motion.value().frames[2];
      const Vec3 com = frame.com - Vec3(0.0, 0.0, gap);
      if (gap == 0.0) first = com;
      EXPECT_LE((com - first).norm(), 1e-6 + 20.0 * gap) << "seed " << seed << ", gap " << gap;
    }
  }
}

}  // namespace
}  // namespace hazumi::test
