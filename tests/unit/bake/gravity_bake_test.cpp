// Gravity and contact in a bake: take-off, flight, landing, and their events.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/bake/incremental_bake.h"
#include "engine/bake/walk/walk_work.h"
#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

using namespace test;  // NOLINT: short names for the builders

// A stiff figure thrown from `height` with velocity (vx, vz) at frame 0.
Animation Thrown(double height, double vx, double vz) {
  Animation animation = Still(Pogo());
  animation.root_keys[kRootX] = {{0, 0.0, vx, kCubic}};
  animation.root_keys[kRootZ] = {{0, height, vz, kCubic}};
  AddFloor(&animation);
  AddGravity(&animation, 0, 30);
  return animation;
}

TEST(GravityBake, StartsInMidAirWithTheVelocityOfTheKeys) {
  const Animation animation = Thrown(5.0, 1.0, 2.0);
  const Motion motion = BakeOrFail(animation);
  const Vec3 start = motion.frames[0].com;
  for (int f = 0; f <= 30; ++f) {
    const double t = f / 30.0;
    const Vec3 expected = start + Vec3(t, 0, 2.0 * t - 0.5 * kG * t * t);
    EXPECT_LE((motion.frames[f].com - expected).norm(), 1e-12) << f;
  }
}

TEST(GravityBake, StartsLaterWithTheVelocityOfTheCurve) {
  Animation animation = Thrown(5.0, 0.0, 0.0);
  animation.placements[0].first_frame = 10;
  animation.root_keys[kRootX] = {
      {0, 0.0, {}, kCubic}, {10, 0.5, 3.0, kCubic}, {20, 0.0, {}, kCubic}};
  const Motion motion = BakeOrFail(animation);
  EXPECT_NEAR(motion.frames[20].X_WR.p.x(), 0.5 + 3.0 / 3.0, 1e-12);
  animation.root_keys[kRootX] = {{0, 0.0, {}, Interpolation::kLinear}, {10, 0.5, {}, kCubic}};
  EXPECT_NEAR(BakeOrFail(animation).frames[20].X_WR.p.x(), 0.5 + 1.5 / 3.0, 1e-12);
  animation.root_keys[kRootX][1].rate = 3.0;
  EXPECT_NEAR(BakeOrFail(animation).frames[20].X_WR.p.x(), 0.5 + 3.0 / 3.0, 1e-12);
}

TEST(GravityBake, ApexAndLandingHaveExactTimesAndTheirFrames) {
  const Motion motion = BakeOrFail(Thrown(1.05, 0.3, 2.0));
  const auto apexes = EventsOf(motion, EventKind::kApex);
  const auto landings = EventsOf(motion, EventKind::kLanding);
  ASSERT_EQ(apexes.size(), 1u);
  ASSERT_EQ(landings.size(), 1u);
  const double apex = 2.0 / kG, landing = (2.0 + std::sqrt(4.0 + kG)) / kG;
  EXPECT_NEAR(apexes[0].time, apex, 1e-12);
  EXPECT_EQ(apexes[0].frame, std::lround(apex * 30.0));
  EXPECT_NEAR(landings[0].time, landing, 1e-9);
  EXPECT_EQ(landings[0].frame, std::ceil(landing * 30.0));
  EXPECT_EQ(landings[0].joint, "foot");
  const int f = landings[0].frame;
  EXPECT_FALSE(motion.frames[f - 1].pinned.has_value());
  EXPECT_TRUE(motion.frames[f].pinned.has_value());
  EXPECT_NEAR(motion.frames[f].X_WR.p.z(), 0.55, 1e-9);
  EXPECT_EQ(motion.frames[f].after.root_v.norm(), 0.0);
}

// A figure that spins fast, and sinks slowly close to the ground, is looked at each microsecond.
TEST(GravityBake, ASearchForLandingsCountsAsWork) {
  const auto work_above = [](double ground) {
    Animation animation = Thrown(0.55 + ground, 0.0, -1e-6);
    animation.last_frame = animation.placements[0].last_frame = 1;
    animation.solver.method = Method::kExact;
    animation.gravity = 1e-9;
    animation.root_keys[kRootAngleZ] = {{0, 0.0, {}, Interpolation::kLinear}, {30, 1e4, {}}};
    IncrementalBake bake(animation);
    EXPECT_FALSE(bake.Finish());
    return bake.work();
  };
  const double far = work_above(5.0);
  EXPECT_GT(far, 0.0);
  EXPECT_GT(work_above(1e-4), 100.0 * far);
  EXPECT_NE(TooMuch({.landings = 1.0}).find("where the figure lands"), std::string::npos);
}

TEST(GravityBake, NothingHappensAfterALanding) {
  for (const double step : {1.0 / 30.0, 1.0 / 300.0}) {
    Animation animation = Thrown(0.8, 0.3, 1.0);
    animation.solver.step = step;
    const Motion motion = BakeOrFail(animation);
    EXPECT_EQ(motion.events.back().kind, EventKind::kLanding);
    EXPECT_LT(motion.events.back().time, 0.5);
  }
}

// TwoLinks stands with a bent knee and stretches: it takes off, flies and lands.
Animation Jump(double step) {
  Animation animation = Still(TwoLinks());
  animation.solver.step = step;
  KeysOf(&animation, "knee") = {{0, 1.6, {}, kCubic}, {6, 0.2, {}, kCubic}, {30, 0.2, {}, kCubic}};
  // The sole's centre is 0.05 m above the floor.
  animation.root_keys[kRootZ] = {{0, 0.45 + 0.4 * std::cos(1.6), {}, kCubic}};
  AddFloor(&animation);
  AddGravity(&animation, 0, 30).pin = GroupOf(animation, "foot");
  animation.placements[0].landing_pin = GroupOf(animation, "foot");
  return animation;
}

TEST(GravityBake, JumpsAndLandsOnce) {
  for (const double step : {1.0 / 30.0, 1.0 / 120.0, 1.0 / 1200.0}) {
    const Motion motion = BakeOrFail(Jump(step));
    std::vector<EventKind> kinds;
    for (const MotionEvent& event : motion.events) kinds.push_back(event.kind);
    EXPECT_EQ(kinds, (std::vector<EventKind>{EventKind::kPinChange, EventKind::kTakeOff,
                                             EventKind::kApex, EventKind::kLanding}))
        << "step " << step;
  }
}

TEST(GravityBake, EventTimesConvergeWithTheStep) {
  const Motion exact = BakeOrFail(Jump(1.0 / 30000.0));
  double last = 1.0;
  for (const double step : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0, 1.0 / 3840.0}) {
    const Motion motion = BakeOrFail(Jump(step));
    ASSERT_EQ(motion.events.size(), exact.events.size());
    double worst = 0.0;
    for (size_t i = 0; i < exact.events.size(); ++i) {
      worst = std::max(worst, std::abs(motion.events[i].time - exact.events[i].time));
    }
    EXPECT_LT(worst, 3.0 * step);
    EXPECT_LT(worst, last);
    last = worst;
  }
}

TEST(GravityBake, TheFrameOfATakeOffOrLandingIsTheFirstAtOrAfterIt) {
  const Motion motion = BakeOrFail(Jump(1.0 / 240.0));
  for (const MotionEvent& event : motion.events) {
    if (event.kind == EventKind::kApex) continue;
    EXPECT_EQ(event.frame, std::ceil(event.time * 30.0 - 1e-9));
  }
}

// The knee swings freely. The impulse at the foot does no work on a motion that keeps the foot
// still, so of all knee rates the one after it is nearest, in kinetic energy, to the motion before.
TEST(GravityBake, ALandingKicksFreeJoints) {
  Animation animation = Jump(1.0 / 240.0);
  animation.root_keys[kRootZ] = {{0, 1.1, {}, kCubic}};
  AddRegion(&animation, "knee", 0, 30, {"knee"});
  animation.regions[0].joints = {JointOf(animation, "knee")};
  animation.regions[0].friction = {1.0};
  const Motion motion = BakeOrFail(animation);
  const auto landings = EventsOf(motion, EventKind::kLanding);
  ASSERT_GE(landings.size(), 1u);
  const MotionFrame& frame = motion.frames[landings[0].frame];
  const double landing_frame = landings[0].time * 30.0;
  EXPECT_LE(landing_frame, landings[0].frame);
  EXPECT_GT(std::abs(frame.after.qd[0]), 0.1);
}

TEST(GravityBake, TheKickIsTheLeastChangeInKineticEnergy) {
  Animation animation = Jump(1.0 / 30.0);
  animation.root_keys[kRootZ] = {{0, 1.1, {}, kCubic}};
  KeysOf(&animation, "knee")[0].value = 0.7;
  AddRegion(&animation, "knee", 0, 30, {"knee"});
  animation.regions[0].joints = {JointOf(animation, "knee")};
  animation.regions[0].friction = {1.0};
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& frame = motion.frames[EventsOf(motion, EventKind::kLanding)[0].frame];
  EXPECT_GT((frame.before.qd - frame.after.qd).norm(), 0.1);
  const Figure& figure = *animation.figure;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  const auto energy = [&](double extra) {
    VecX qd = frame.after.qd - frame.before.qd;
    qd[0] += extra;
    // The foot is at rest after, so before it moves by minus the difference.
    VecX after = frame.after.qd;
    after[0] += extra;
    ComputeVelocities(figure, Vec3::Zero(), Vec3::Zero(), after, &ws);
    const Vec3 root = -ws.body(JointOf(animation, "foot")).v - frame.before.root_v;
    ComputeVelocities(figure, Vec3::Zero(), root, qd, &ws);
    double sum = 0.5 * figure.root_body().mass * root.squaredNorm();
    for (int j = 0; j < figure.num_joints(); ++j) {
      const RigidInertia& body = figure.body(JointIndex(j));
      const BodyScratch& b = ws.bodies[j + 1];
      const Vec3 w = b.R.transpose() * b.w;
      sum += 0.5 * body.mass * (b.v + b.w.cross(b.c)).squaredNorm() + 0.5 * w.dot(body.I_com * w);
    }
    return sum;
  };
  EXPECT_NEAR(energy(1e-3), energy(-1e-3), 1e-9 * energy(0.0));
  EXPECT_GT(energy(1e-3), energy(0.0));
}

TEST(GravityBake, WithoutAnythingToPinIsAnError) {
  FigureSpec spec = {"ball", "root", {}, {}, {}};
  LinkSpec link;
  link.radius = 0.1;
  link.mass = 1.0;
  spec.root_links = {link};
  Animation animation = Still(BuildFigure(spec).value());
  animation.root_keys[kRootZ] = {{0, 1.0, {}, kCubic}};
  AddFloor(&animation);
  AddGravity(&animation, 0, 30);
  EXPECT_EQ(BakeError(animation).place, "placements[0]");
}

}  // namespace
}  // namespace hazumi
