// A flight that keys have, given to gravity.

#include <algorithm>
#include <cmath>

#include "tests/unit/edit/placement/keyed_jump.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

constexpr int kFirst = kJumpTakeOff + 1, kLast = kJumpLanding - 1;

std::vector<MotionFrame> FramesOf(Session* session) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok());
  return motion.value()->frames;
}

// The largest distance of the CoM from a parabola through its first and its last place in the air,
// at the gravity of the scene [m].
double OffParabola(const std::vector<MotionFrame>& frames) {
  const double duration = (kLast - kFirst) / 30.0;
  double off = 0.0;
  for (int i = kFirst; i <= kLast; ++i) {
    const double t = (i - kFirst) / 30.0;
    Vec3 com = frames[kFirst].com + (frames[kLast].com - frames[kFirst].com) * (t / duration);
    com.z() += 0.5 * 9.81 * t * (duration - t);
    off = std::max(off, (frames[i].com - com).norm());
  }
  return off;
}

TEST(FlightOperators, AFlightTakesOffAndLandsWhereTheKeysHaveIt) {
  Session session;
  KeyJump(7.0, &session);
  const std::vector<MotionFrame> keyed = FramesOf(&session);
  EXPECT_GT(OffParabola(keyed), 0.1);
  Do(&session, "placement.flight", {{"first", kFirst}, {"last", kLast}});
  const std::vector<MotionFrame> flown = FramesOf(&session);
  EXPECT_LT(OffParabola(flown), 1e-6);
  for (int i = 0; i <= 30; ++i) {
    EXPECT_EQ(flown[i].q, keyed[i].q) << i;
    if (i > kFirst && i < kLast) continue;
    EXPECT_LT((flown[i].com - keyed[i].com).norm(), 1e-6) << i;
  }
}

class SparseFlight : public testing::TestWithParam<const char*> {};

TEST_P(SparseFlight, DoesNotChangeWhatIsAround) {
  Session session;
  KeyJump(9.0, &session);
  for (const char* curve : {"root.x", "root.z"}) {
    for (int frame = 0; frame <= 30; ++frame) {
      if (frame % 5 == 0 || frame == kJumpTakeOff) continue;
      Do(&session, "key.delete", {{"curve", curve}, {"frame", frame}});
    }
  }
  Do(&session, "keys.select_all");
  Do(&session, "keys.interpolation", {{"interpolation", GetParam()}});
  const std::vector<MotionFrame> keyed = FramesOf(&session);
  Do(&session, "placement.flight", {{"first", kFirst}, {"last", kLast}});
  const std::vector<MotionFrame> flown = FramesOf(&session);
  for (int i = 0; i <= 30; ++i) {
    if (i > kFirst && i < kLast) continue;
    EXPECT_LT((flown[i].com - keyed[i].com).norm(), 1e-3) << i;
  }
  EXPECT_LT(OffParabola(flown), 1e-6);
}

TEST(FlightOperators, AfterAFlightAHeldRootStaysWhereItIsHeld) {
  Session session;
  KeyJump(9.81, &session);
  for (int frame = 21; frame <= 30; ++frame) {
    Do(&session, "key.delete", {{"curve", "root.x"}, {"frame", frame}});
  }
  Do(&session, "key.set",
     {{"curve", "root.x"}, {"frame", 20}, {"value", 0.5}, {"interpolation", "hold"}});
  Do(&session, "key.set", {{"curve", "root.x"}, {"frame", 30}, {"value", 0.9}});
  Do(&session, "placement.flight", {{"first", kFirst}, {"last", kLast}});
  const std::vector<MotionFrame> flown = FramesOf(&session);
  for (int i = kLast + 1; i < 30; ++i) EXPECT_NEAR(flown[i].X_WR.p.x(), 0.5, 1e-9) << i;
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, SparseFlight, testing::Values("cubic", "quadratic", "linear"));

TEST(FlightOperators, ThePapersStepsLandThereToo) {
  Session session;
  KeyJump(9.81, &session);
  Do(&session, "solver.set", {{"method", "paper"}});
  const std::vector<MotionFrame> keyed = FramesOf(&session);
  Do(&session, "placement.flight", {{"first", kFirst}, {"last", kLast}});
  EXPECT_LT((FramesOf(&session)[kLast].com - keyed[kLast].com).norm(), 1e-6);
}

TEST(FlightOperators, IsOneStepThatCanBeUndone) {
  Session session;
  KeyJump(9.81, &session);
  const std::string before = WriteProject(session.project());
  const size_t steps = session.document().num_steps();
  Do(&session, "placement.flight", {{"first", kFirst}, {"last", kLast}});
  EXPECT_EQ(session.document().num_steps(), steps + 1);
  Do(&session, "edit.undo");
  EXPECT_EQ(WriteProject(session.project()), before);
}

TEST(FlightOperators, WhatIsNoFlightOrPlacedAlreadyIsRefused) {
  Session session;
  KeyJump(9.81, &session);
  EXPECT_EQ(Refused(&session, "placement.flight", {{"first", 10}, {"last", 11}}).ToString(),
            "placement.flight.last: a flight has three frames at least, from 0 to 30");
  Refused(&session, "placement.flight", {{"first", -2}, {"last", 11}});
  Refused(&session, "placement.flight", {{"first", 20}, {"last", 31}});
  Do(&session, "placement.set", {{"kind", "gravity"}, {"first", 12}, {"last", 15}});
  EXPECT_EQ(Refused(&session, "placement.flight", {{"first", kFirst}, {"last", kLast}}).ToString(),
            "placement.flight.first: frames 12 to 15 are placed by a pin or by gravity already");
}

}  // namespace
}  // namespace hazumi::test
