// Landings where one thing touches an edge, a thin plate, or two things at once; and a start inside
// the floor.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/animations.h"
#include "tests/support/released.h"
#include "tests/support/stick_figures.h"

namespace hazumi::test {
namespace {

// The root falls from `height` with velocity `vz`.
Animation Falling(Figure figure, double height, double vz, Method method) {
  Animation animation = Still(std::move(figure));
  animation.root_keys[kRootZ] = {{0, height, vz, Interpolation::kCubic}};
  AddGravity(&animation, 0, 30);
  SetMethod(&animation, method);
  return animation;
}

double FallTime(double way) { return std::sqrt(2.0 * way / kG); }

// The one landing of a motion after which the root keeps its place.
MotionEvent OnlyLanding(const Motion& motion) {
  const auto landings = EventsOf(motion, EventKind::kLanding);
  EXPECT_EQ(landings.size(), 1u);
  EXPECT_TRUE(EventsOf(motion, EventKind::kTakeOff).empty());
  if (landings.size() != 1) return {};
  for (size_t f = landings[0].frame; f < motion.frames.size(); ++f) {
    EXPECT_LE((motion.frames[f].X_WR.p - motion.frames.back().X_WR.p).norm(), 1e-9) << f;
    EXPECT_LE(motion.frames[f].after.root_v.norm(), 1e-9) << f;
  }
  return landings[0];
}

// The sole's sphere of 0.05 m comes down 0.03 m beside the edge: it touches 0.04 m above it.
TEST(BothMethods, LandOnTheEdgeOfABox) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = Falling(Pogo(), 1.0, 0.0, method);
    Box box;
    box.X_WB.p = Vec3(-0.53, 0.0, -0.5);
    box.half_size = Vec3::Constant(0.5);
    animation.scene.push_back({"box", box, ""});
    const Motion motion = BakeFinite(animation);
    EXPECT_NEAR(OnlyLanding(motion).time, FallTime(0.46), 1e-6) << NameOf(method);
    EXPECT_NEAR(motion.frames.back().X_WR.p.z(), 0.54, 1e-6) << NameOf(method);
  }
}

// At 100 m/s the sole goes 3.3 m a frame.
TEST(Exact, LandsOnAThinPlateHoweverFast) {
  Animation animation = Falling(Pogo(), 1.5, -100.0, Method::kExact);
  Box plate;
  plate.half_size = Vec3(0.5, 0.5, 0.0005);
  animation.scene.push_back({"plate", plate, ""});
  const MotionEvent landing = OnlyLanding(BakeFinite(animation));
  const double way = 1.5 - 0.5505;
  EXPECT_NEAR(landing.time, (std::sqrt(1e4 + 2.0 * kG * way) - 100.0) / kG, 1e-8);
}

// It stands where it is, as if the floor were there.
TEST(BothMethods, StandWhereTheyStartAMillimetreInsideTheFloor) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = Falling(Pogo(), 0.549, 0.0, method);
    AddFloor(&animation);
    const Motion motion = BakeFinite(animation);
    for (const MotionFrame& frame : motion.frames) {
      EXPECT_NEAR(frame.X_WR.p.z(), 0.549, 1e-9) << NameOf(method) << " frame " << frame.frame;
    }
    EXPECT_TRUE(EventsOf(motion, EventKind::kTakeOff).empty()) << NameOf(method);
  }
}

// The same with a knee that gives way above it.
TEST(BothMethods, KeepAFootThatStartsInsideTheFloorWhileTheKneeGivesWay) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = Falling(TwoLinks(), 0.849, 0.0, method);
    KeysOf(&animation, "knee") = {{0, 0.1, {}, Interpolation::kCubic}};
    AddFloor(&animation);
    animation.root_keys[kRootZ][0].value = 0.449 + 0.4 * std::cos(0.1);
    AddRegion(&animation, "knee", 0, 6, {"knee"}, 0.8);
    SetMethod(&animation, method);
    KeyTheRest(&animation);
    const Motion motion = BakeFinite(animation);
    for (int f = 0; f <= 6; ++f) {
      EXPECT_NEAR(OriginOf(animation, motion.frames[f], "foot").z(), 0.049, 1e-9)
          << NameOf(method) << " frame " << f;
    }
  }
}

// Pelvis 0.95 m above the soles. One foot becomes the pin; the other touches as well.
TEST(BothMethods, LandOnTwoFeetAtOnce) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = Falling(Human(), 1.25, 0.0, method);
    AddFloor(&animation);
    const Motion motion = BakeFinite(animation);
    EXPECT_NEAR(OnlyLanding(motion).time, FallTime(0.30), 1e-6) << NameOf(method);
    EXPECT_NEAR(motion.frames.back().X_WR.p.z(), 0.95, 1e-6) << NameOf(method);
  }
}

// Falls with both legs free. Nothing turns the legs before the landing, since all of the figure
// falls alike.
TEST(BothMethods, FigureWithFreeLegs_FallsStraightAndLandsInAFewEvents) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = Falling(Human(), 1.15, 0.0, method);
    AddFloor(&animation);
    AddRegion(&animation, "legs", 0, 15, {"r_hip", "l_hip"}, 0.5);
    SetMethod(&animation, method);
    KeyTheRest(&animation);
    const Motion motion = BakeFinite(animation);
    const auto landings = EventsOf(motion, EventKind::kLanding);
    ASSERT_GE(landings.size(), 1u) << NameOf(method);
    EXPECT_NEAR(landings[0].time, FallTime(0.20), 1e-6) << NameOf(method);
    for (int f = 0; f < landings[0].frame; ++f) {
      EXPECT_LE((motion.frames[f].q - motion.frames[0].q).norm(), 1e-9) << NameOf(method) << f;
    }
    EXPECT_LE(motion.events.size(), 40u) << NameOf(method);
  }
}

}  // namespace
}  // namespace hazumi::test
