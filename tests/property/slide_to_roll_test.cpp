// Random cylinders, capsules and spheres that slide on a plane until they roll, against the
// analytic solution. With u the velocity of the contact point, friction decelerates by mu g against
// u until u is 0:
//   v' = -mu g u / |u|,   w' = (m r / I) mu g (n x u) / |u|,   u' = -mu g (1 + m r^2 / I) u / |u|
// Each body first falls by `drop`. The friction impulse of its impact equals the impulse of
// friction over the time of the fall.
//
// No angle of a thousand cases may be off by more than 0.01 degrees, nor by more than its own error
// estimate. Errors of positions count as the angle of rolling that far. HAZUMI_CASES and
// HAZUMI_FIRST_CASE as everywhere; `ctest -C Slow -L slow -R slide -V` runs a thousand.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/bake/bake.h"
#include "engine/figure/figure_builder.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/from_environment.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr double kTolerance = 0.01;  // [deg]
constexpr int kStart = 10, kEnd = 70;

struct Roller {
  // Half the length of the axis, along y [m]; inertia about the axis.
  double radius, half, mass, inertia;
  double friction;  // coefficient against the plane
  double drop;      // [m]
  double fps;
  Vec3 v, w;  // start of the region; w along y [m/s, rad/s]
};

Roller RandomRoller(uint64_t seed) {
  Random random(seed);
  Roller roller;
  const bool is_sphere = random.Chance(0.3);
  roller.radius = random.LogUniform(0.03, 0.4);
  roller.half = is_sphere ? 0.0 : random.Uniform(0.1, 0.6);
  roller.mass = random.LogUniform(0.3, 30.0);
  roller.inertia = random.Uniform(0.2, 1.0) * roller.mass * roller.radius * roller.radius;
  roller.friction = random.LogUniform(0.02, 1.2);
  roller.drop = random.LogUniform(1e-7, 1e-4);
  roller.fps = random.Chance(0.5) ? 30.0 : 60.0;
  roller.v = random.Uniform(-3.0, 3.0) * Vec3::UnitX();
  if (is_sphere) roller.v.y() = random.Uniform(-3.0, 3.0);
  roller.w = random.Uniform(-20.0, 20.0) * Vec3::UnitY();
  return roller;
}

// State of the body in the air and on the plane.
struct Rolling {
  Vec3 p = Vec3::Zero(), v, w;
};

class Analytic {
 public:
  explicit Analytic(const Roller& roller) : roller_(roller) {}

  Rolling At(double t) const {
    const double falls = std::sqrt(2.0 * roller_.drop / kG);
    Rolling at = {Vec3::Zero(), roller_.v, roller_.w};
    if (t < falls) {
      at.p = t * at.v - 0.5 * kG * t * t * Vec3::UnitZ();
      return at;
    }
    at.p = falls * at.v - roller_.drop * Vec3::UnitZ();
    Slow(falls, /*moves=*/false, &at);
    const double slides = std::min(t - falls, StopsAfter(at));
    Slow(slides, /*moves=*/true, &at);
    at.p += (t - falls - slides) * at.v;
    return at;
  }

 private:
  double gain() const { return roller_.mass * roller_.radius / roller_.inertia; }
  Vec3 SlipOf(const Rolling& at) const { return at.v - roller_.radius * at.w.cross(Vec3::UnitZ()); }
  double StopsAfter(const Rolling& at) const {
    return SlipOf(at).norm() / (roller_.friction * kG * (1.0 + roller_.radius * gain()));
  }
  // Applies friction for that many seconds, or until the body rolls.
  void Slow(double seconds, bool moves, Rolling* at) const {
    const Vec3 slip = SlipOf(*at);
    if (slip.norm() == 0.0) return;
    const double s = std::min(seconds, StopsAfter(*at));
    const Vec3 a = -roller_.friction * kG * slip.normalized();
    if (moves) at->p += s * at->v + 0.5 * s * s * a;
    at->v += s * a;
    at->w -= s * gain() * Vec3::UnitZ().cross(a);
  }

  Roller roller_;
};

Figure FigureOf(const Roller& roller) {
  FigureSpec spec;
  spec.name = "roller";
  spec.root_name = "roller";
  LinkSpec link;
  link.name = "roller";
  link.from = -roller.half * Vec3::UnitY();
  link.to = roller.half * Vec3::UnitY();
  link.radius = roller.radius;
  link.mass = roller.mass;
  link.com = Vec3::Zero();
  const double across = roller.half > 0.0
                            ? roller.inertia + roller.mass * roller.half * roller.half / 3.0
                            : roller.inertia;
  link.inertia = Vec3(across, roller.inertia, across).asDiagonal();
  spec.root_links = {link};
  JointSpec tip;  // joint that a placement by gravity needs
  tip.name = "tip";
  tip.parent = "roller";
  tip.hinges = {{"", Vec3::UnitX(), 0.0, 0.0, 0.0}};
  spec.joints = {tip};
  return BuildFigure(spec).value();
}

// Animation with keys up to the region, which takes over their velocities.
Animation AnimationOf(const Roller& roller) {
  Animation animation = Still(FigureOf(roller));
  animation.rate = {static_cast<int>(roller.fps), 1};
  animation.last_frame = kEnd;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = kTolerance * kDegree;
  const double before = kStart / roller.fps;
  const auto keys = [&](double end, double rate) {
    return Keys{{0.0, end - before * rate, rate}, {static_cast<double>(kStart), end, rate}};
  };
  animation.root_keys[kRootX] = keys(0.0, roller.v.x());
  animation.root_keys[kRootY] = keys(0.0, roller.v.y());
  animation.root_keys[kRootZ] = keys(roller.radius + roller.drop, 0.0);
  animation.root_keys[kRootAngleY] = keys(0.0, roller.w.y());
  AddFloor(&animation);
  animation.scene[0].friction = roller.friction * roller.friction / SceneObject::kFriction;
  AddGravity(&animation, kStart, kEnd);
  DynamicsRegion& region = AddRegion(&animation, "all", kStart, kEnd, {});
  region.method = Method::kExact;
  region.root = true;
  region.touches_scene = true;
  return animation;
}

// Largest error over all frames [deg], of positions and of rotations about y where the axis stays
// along y.
double WorstError(const Roller& roller, const Motion& motion) {
  const Analytic analytic(roller);
  const Vec3 start(0.0, 0.0, roller.radius + roller.drop);
  double worst = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    if (frame.frame < kStart) continue;
    const double t = (frame.frame - kStart) / roller.fps;
    const Rolling at = analytic.At(t);
    worst = std::max(worst, (frame.X_WR.p - start - at.p).norm() / roller.radius);
    if (roller.half == 0.0) continue;
    // Rotation from the impulse of friction, which acts on v and w.
    const double gain = roller.mass * roller.radius / roller.inertia;
    const double turn = roller.w.y() * t + gain * (roller.v.x() * t - at.p.x());
    const Mat3 R = Eigen::AngleAxisd(turn, Vec3::UnitY()).toRotationMatrix();
    worst = std::max(worst, Eigen::AngleAxisd(R.transpose() * frame.X_WR.R).angle());
  }
  return worst / kDegree;
}

TEST(SlideToRoll, FollowsTheAnalyticSolution) {
  double worst = 0.0, worst_unexplained = 0.0;
  const RandomCases cases(1, 40);
  for (const int seed : cases) {
    const Roller roller = RandomRoller(static_cast<uint64_t>(seed));
    BakeOptions options;
    options.energy = true;
    const Motion motion = BakeOrFail(AnimationOf(roller), options);
    ASSERT_EQ(motion.regions.size(), 1);
    const RegionReport& report = motion.regions[0];
    const double error = WorstError(roller, motion), estimate = report.error_estimate / kDegree;
    EXPECT_LE(error, std::max(kTolerance, estimate)) << "HAZUMI_FIRST_CASE=" << seed;
    worst = std::max(worst, error);
    ASSERT_TRUE(report.energy) << seed;
    const double turned = report.energy->kinetic_start + report.energy->potential_start;
    const double unexplained = std::abs(report.energy->residual()) / turned;
    EXPECT_LE(unexplained, 1e-6) << "HAZUMI_FIRST_CASE=" << seed;
    worst_unexplained = std::max(worst_unexplained, unexplained);
  }
  std::printf("%d cases: worst %.3g deg, unexplained %.3g of the energy\n", cases.count(), worst,
              worst_unexplained);
}

}  // namespace
}  // namespace hazumi::test
