// How a jump that is made takes off and lands: its centre of mass speeds up and slows down as a
// person's can, the body is over the feet, these do not slide, and aimed again at its spot it is
// the same jump.

#include <algorithm>
#include <cmath>

#include "engine/placement/contact.h"
#include "tests/unit/edit/placement/jumps.h"

namespace hazumi::test {
namespace {

using edit::Session;

constexpr double kFps = 30.0;

// Onto the floor, or onto a box so high, so far ahead [m].
struct Spot {
  double x, high;
};

std::vector<Spot> Spots() {
  std::vector<Spot> all;
  for (const double x : {0.05, 0.4, 0.8, 1.2, 1.5, 1.8, 2.2}) all.push_back({x, 0.0});
  for (const double high : {0.2, 0.4, 0.6}) {
    for (const double x : {0.6, 0.93, 1.05, 1.15, 1.37, 1.5}) all.push_back({x, high});
  }
  return all;
}

std::string NameOf(const Spot& spot) {
  return std::to_string(spot.x) + " m ahead, " + std::to_string(spot.high) + " m high";
}

void Jump(const Spot& spot, Session* session) {
  if (spot.high > 0.0) {
    Do(session, "object.add_box",
       {{"name", "box"},
        {"x", spot.x + 0.05},
        {"z", 0.5 * spot.high},
        {"size_x", 0.6},
        {"size_y", 0.8},
        {"size_z", spot.high}});
  }
  Do(session, "jump.add", {{"x", spot.x}, {"y", 0.02}});
}

// Of the centre of mass, from the frame before [m/s].
Vec3 VelocityAt(const Motion& motion, int frame) {
  return kFps * (motion.frames[frame].com - motion.frames[frame - 1].com);
}

TEST(JumpPushes, NowhereIsTheBodyThrownOrBrakedHarderThanAPersonCan) {
  constexpr double kMost = 25.0;  // [m/s^2]
  for (const Spot& spot : Spots()) {
    SCOPED_TRACE(NameOf(spot));
    Session session;
    Jump(spot, &session);
    const Motion motion = JumpMotion(&session);
    for (int f = 2; f <= PhasesOf(session).end; ++f) {
      const Vec3 a = kFps * (VelocityAt(motion, f) - VelocityAt(motion, f - 1));
      EXPECT_LE(a.head<2>().norm(), kMost) << "frame " << f;
    }
  }
}

TEST(JumpPushes, ForwardItSpeedsUpToTheFlightsSpeedAndOnlySlowsDownAfterTheLanding) {
  constexpr double kSways = 0.15, kSlack = 0.15;  // [m/s]
  constexpr int kCrouch = 13;                     // a frame after it rests there
  for (const Spot& spot : Spots()) {
    if (spot.x < 0.4) continue;
    SCOPED_TRACE(NameOf(spot));
    Session session;
    Jump(spot, &session);
    const Motion motion = JumpMotion(&session);
    const auto v = [&](int f) { return VelocityAt(motion, f).x(); };
    const JumpPhases phases = PhasesOf(session);
    for (int f = kCrouch + 1; f <= phases.landing; ++f) {
      EXPECT_GE(v(f), v(f - 1) - kSlack) << "frame " << f;
    }
    EXPECT_LE(v(phases.landing) - v(phases.take_off), 0.2);
    int f = phases.landing + 1;
    for (; v(f) > kSways; ++f) EXPECT_LE(v(f), v(f - 1) + kSlack) << "frame " << f;
    EXPECT_LE(f, phases.landing + 15);
    // Then it stands up where it is.
    for (; f <= phases.end; ++f) EXPECT_LE(std::abs(v(f)), kSways) << "frame " << f;
  }
}

// Its centre of mass is over the feet in the crouch and where it has come to rest, from the heels
// to the toes.
TEST(JumpPushes, AtRestTheBodyIsOverTheFeet) {
  constexpr double kHeels = 0.18, kToes = 0.03;  // behind and ahead of the toes' joints [m]
  for (const Spot& spot : Spots()) {
    SCOPED_TRACE(NameOf(spot));
    Session session;
    Jump(spot, &session);
    const Motion motion = JumpMotion(&session);
    const JumpPhases phases = PhasesOf(session);
    const auto ahead = [&](int f) {
      return motion.frames[f].com.x() - ToesIn(motion.frames[f], &session).x();
    };
    for (int f = 0; f <= 13; ++f) {
      EXPECT_GE(ahead(f), -kHeels) << "frame " << f;
      EXPECT_LE(ahead(f), kToes) << "frame " << f;
    }
    for (int f = phases.landing + 15; f <= phases.end; ++f) {
      EXPECT_GE(ahead(f), -kHeels) << "frame " << f;
      EXPECT_LE(ahead(f), kToes) << "frame " << f;
    }
  }
}

TEST(JumpPushes, TheFeetLeaveTheGroundWithoutSlidingOverItOrIntoIt) {
  constexpr double kDeep = 0.001, kSlide = 0.05;  // [m]
  for (const Spot& spot : Spots()) {
    SCOPED_TRACE(NameOf(spot));
    Session session;
    Jump(spot, &session);
    const Motion motion = JumpMotion(&session);
    for (const MotionFrame& frame : motion.frames) {
      const DynamicsWorkspace ws = Placed(frame, &session);
      EXPECT_GE(Clearance(session.figure(), session.animation()->scene, ws), -kDeep)
          << "frame " << frame.frame;
    }
    const int left = PhasesOf(session).take_off;
    const Vec3 slid =
        ToesIn(motion.frames[left + 1], &session) - ToesIn(motion.frames[left], &session);
    EXPECT_LE(slid.head<2>().norm(), kSlide);
  }
}

TEST(JumpPushes, AimedAtItsSpotAgainItIsTheSameJump) {
  for (const Spot& spot : Spots()) {
    SCOPED_TRACE(NameOf(spot));
    Session session;
    Jump(spot, &session);
    const Motion first = JumpMotion(&session);
    const JumpPhases before = PhasesOf(session);
    Do(&session, "time.frame", {{"frame", before.landing}});
    Do(&session, "jump.aim", {{"x", spot.x}, {"y", 0.02}});
    const JumpPhases now = PhasesOf(session);
    EXPECT_EQ(now.take_off, before.take_off);
    EXPECT_EQ(now.landing, before.landing);
    ASSERT_EQ(now.end, before.end);
    const Motion again = JumpMotion(&session);
    for (int f = 0; f <= now.end; ++f) {
      EXPECT_LE((again.frames[f].com - first.frames[f].com).norm(), 1e-5) << "frame " << f;
      EXPECT_LE((again.frames[f].q - first.frames[f].q).cwiseAbs().maxCoeff(), 1e-4) << f;
    }
  }
}

TEST(JumpPushes, AHeightAtWhichTheLegsCannotStopItIsRefusedWithTheRemedy) {
  Session session;
  EXPECT_NE(Refused(&session, "jump.add", {{"x", 3.5}, {"height", 0.15}})
                .ToString()
                .find("give a greater height, or a nearer spot"),
            std::string::npos);
}

}  // namespace
}  // namespace hazumi::test
