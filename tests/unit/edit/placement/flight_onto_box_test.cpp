// A figure that stands before a box and by its keys goes up onto it, given to gravity.

#include <algorithm>
#include <cmath>

#include "engine/bake/bake.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

constexpr int kStands = 10, kLands = 24;
constexpr double kFrame = 1.0 / 30.0;  // [s]

void Key(Session* session, const char* curve, int frame, double value) {
  Do(session, "key.set", {{"curve", curve}, {"frame", frame}, {"value", value}});
}

// The box is 0.3 m high; the root goes up by `rise`.
void KeyOntoBox(double rise, Session* session) {
  Do(session, "object.add_box",
     {{"name", "box"}, {"x", 1.1}, {"z", 0.15}, {"size_x", 0.8}, {"size_y", 1.0}, {"size_z", 0.3}});
  Key(session, "root.x", kStands, 0.1);
  Key(session, "root.x", kLands, 1.1);
  Key(session, "root.z", kStands, 0.902);
  Key(session, "root.z", kLands, 0.902 + rise);
}

Motion MotionOf(Session* session, int fps = 30) {
  const Result<const Motion*> whole = session->WholeMotion();
  EXPECT_TRUE(whole.ok());
  if (fps == 30) return *whole.value();
  BakeOptions options;
  options.output_rate = FrameRate{fps, 1};
  return Bake(*session->animation(), options).value();
}

double ClearanceIn(const MotionFrame& frame, Session* session) {
  const Animation& animation = *session->animation();
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
  return NearestContact(*animation.figure, animation.scene, ws)->clearance;
}

// The largest distance of the CoM from the parabola through its places on the first and the last
// frame [m].
double OffArc(const Motion& motion) {
  const Vec3 from = motion.frames[kStands].com, to = motion.frames[kLands].com;
  const double duration = (kLands - kStands) * kFrame;
  double off = 0.0;
  for (int i = kStands; i <= kLands; ++i) {
    const double t = (i - kStands) * kFrame;
    Vec3 com = from + (to - from) * (t / duration);
    com.z() += 0.5 * 9.81 * t * (duration - t);
    off = std::max(off, (motion.frames[i].com - com).norm());
  }
  return off;
}

class OntoBox : public testing::TestWithParam<const char*> {};

TEST_P(OntoBox, ItFliesAndLandsWhereTheKeysHaveIt) {
  Session session;
  KeyOntoBox(0.3, &session);
  Do(&session, "solver.set", {{"method", GetParam()}});
  const Motion keyed = MotionOf(&session);
  Do(&session, "placement.flight", {{"first", kStands}, {"last", kLands}});
  const Motion flown = MotionOf(&session);
  EXPECT_LT(OffArc(flown), 1e-4);
  for (int i = 0; i <= 30; ++i) {
    if (i > kStands && i < kLands) continue;
    EXPECT_LT((flown.frames[i].com - keyed.frames[i].com).norm(), 1e-3) << i;
  }
  EXPECT_TRUE(flown.placement_jumps.empty());
  EXPECT_TRUE(flown.warnings.empty());
}

INSTANTIATE_TEST_SUITE_P(ByEachMethod, OntoBox, testing::Values("exact", "paper"));

// Also between the frames of the project.
TEST(FlightOntoBox, NothingJumpsAndNothingDipsIntoTheGround) {
  Session session;
  KeyOntoBox(0.3, &session);
  Do(&session, "placement.flight", {{"first", kStands}, {"last", kLands}});
  const Motion motion = MotionOf(&session, 240);
  const double fastest = 3.8;  // of the flight [m/s]
  for (size_t i = 1; i < motion.frames.size(); ++i) {
    const Vec3 step = motion.frames[i].X_WR.p - motion.frames[i - 1].X_WR.p;
    EXPECT_LT(step.norm(), fastest / 240.0 + 0.002) << i;
    EXPECT_GT(ClearanceIn(motion.frames[i], &session), -0.003) << i;
  }
}

TEST(FlightOntoBox, TheFramesInTheAirAloneMayBeNamedAsWell) {
  Session session;
  KeyOntoBox(0.3, &session);
  const Motion keyed = MotionOf(&session);
  Do(&session, "placement.flight", {{"first", kStands + 1}, {"last", kLands}});
  const Motion flown = MotionOf(&session);
  EXPECT_LT((flown.frames[kLands].com - keyed.frames[kLands].com).norm(), 1e-3);
  EXPECT_GT(flown.frames[17].com.z(), keyed.frames[17].com.z() + 0.1);
}

TEST(FlightOntoBox, AFewCentimetresAboveTheBoxItEndsInTheAir) {
  Session session;
  KeyOntoBox(0.33, &session);
  const Motion keyed = MotionOf(&session);
  Do(&session, "placement.flight", {{"first", kStands}, {"last", kLands}});
  const Motion flown = MotionOf(&session);
  EXPECT_LT(OffArc(flown), 1e-4);
  EXPECT_LT((flown.frames[kLands].com - keyed.frames[kLands].com).norm(), 1e-3);
}

TEST(FlightOntoBox, ACentimetreInsideTheBoxItStaysOnIt) {
  Session session;
  KeyOntoBox(0.29, &session);
  const Motion keyed = MotionOf(&session);
  Do(&session, "placement.flight", {{"first", kStands}, {"last", kLands}});
  const Motion flown = MotionOf(&session);
  EXPECT_LT((flown.frames[kLands].com - keyed.frames[kLands].com).norm(), 0.02);
}

TEST(FlightOntoBox, DeeperInTheBoxItIsRefusedWithTheDepth) {
  Session session;
  KeyOntoBox(0.18, &session);
  const std::string error =
      Refused(&session, "placement.flight", {{"first", kStands}, {"last", kLands}}).ToString();
  EXPECT_NE(error.find(" cm inside \"box\" at F24: key the root so much higher there"),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("is 12"), std::string::npos) << error;
}

TEST(FlightOntoBox, WhatIsInTheWayIsNamed) {
  Session session;
  KeyOntoBox(0.3, &session);
  Do(&session, "object.add_box",
     {{"name", "wall"}, {"x", 0.6}, {"z", 1.0}, {"size_x", 0.05}, {"size_z", 2.0}});
  const std::string error =
      Refused(&session, "placement.flight", {{"first", kStands}, {"last", kLands}}).ToString();
  EXPECT_NE(error.find("meets \"wall\" at F"), std::string::npos) << error;
  EXPECT_NE(error.find(" cm from where the keys have it at F24"), std::string::npos) << error;
}

TEST(FlightOntoBox, WhoCannotGetOffTheGroundIsTold) {
  Session session;
  KeyOntoBox(0.3, &session);
  Key(&session, "root.z", kStands, 0.302);  // 60 cm deep
  const std::string error =
      Refused(&session, "placement.flight", {{"first", kStands}, {"last", kLands}}).ToString();
  EXPECT_NE(error.find("it does not get off the ground"), std::string::npos) << error;
}

// Gravity alone does not make a stiff figure jump. What then happens at its end is reported.
TEST(FlightOntoBox, APlainPlacementByGravityReportsTheWayItLeaves) {
  for (const char* method : {"exact", "paper"}) {
    Session session;
    KeyOntoBox(0.3, &session);
    Key(&session, "root.x", kLands + 1, 1.1);
    Do(&session, "solver.set", {{"method", method}});
    Do(&session, "placement.set", {{"kind", "gravity"}, {"first", kStands}, {"last", kLands}});
    const Motion motion = MotionOf(&session);
    const auto jump =
        std::find_if(motion.placement_jumps.begin(), motion.placement_jumps.end(),
                     [](const PlacementJump& j) { return j.frame == kLands && j.distance > 0.0; });
    ASSERT_NE(jump, motion.placement_jumps.end()) << method;
    EXPECT_EQ(jump->placement, 0);
    EXPECT_NEAR(jump->distance, 1.0, 1e-3);  // along x, where there is a key to go to
    EXPECT_NEAR(jump->seconds, kFrame, 1e-9);
    EXPECT_GE(motion.warnings.size(), motion.placement_jumps.size());
  }
}

}  // namespace
}  // namespace hazumi::test
