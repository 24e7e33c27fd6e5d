// How hands and feet are turned while they are moved, and where elbows go.

#include <Eigen/Geometry>

#include "engine/collision/distance.h"
#include "tests/support/random.h"
#include "tests/unit/edit/pose/body_places.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

Json Going(const char* joint, const Vec3& p) {
  return {{"joint", joint}, {"x", p.x()}, {"y", p.y()}, {"z", p.z()}};
}

TEST(ReachTurned, FeetStayFlatUnlessTheyAreLetGo) {
  Session session;
  const BodyPlaces before(&session);
  const Vec3 target = before.PlaceOf("r_ankle") + Vec3(0.2, -0.08, 0.15);
  Do(&session, "pose.reach", Going("r_ankle", target));
  const BodyPlaces flat(&session);
  EXPECT_LE((flat.PlaceOf("r_ankle") - target).norm(), 1e-6);
  EXPECT_LE(TurnBetween(before.TurnOf("r_ankle"), flat.TurnOf("r_ankle")), 1e-6);
  Do(&session, "edit.undo");
  Json let_go = Going("r_ankle", target);
  let_go["keep_turned"] = false;
  Do(&session, "pose.reach", let_go);
  const BodyPlaces turned(&session);
  EXPECT_LE((turned.PlaceOf("r_ankle") - target).norm(), 1e-6);
  EXPECT_GT(TurnBetween(before.TurnOf("r_ankle"), turned.TurnOf("r_ankle")), 0.1);
}

// What no limb ends in is no foot.
TEST(ReachTurned, AHeadTurnsWithWhatCarriesIt) {
  Session session;
  const BodyPlaces before(&session);
  Do(&session, "pose.reach", Going("neck", before.PlaceOf("neck") + Vec3(0.1, 0.0, -0.03)));
  EXPECT_GT(TurnBetween(before.TurnOf("neck"), BodyPlaces(&session).TurnOf("neck")), 0.1);
}

TEST(ReachTurned, HandsStayTurnedWhenThatIsAsked) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 80}});
  const BodyPlaces before(&session);
  const Vec3 target = before.PlaceOf("r_wrist") + Vec3(0.05, -0.06, 0.12);
  Do(&session, "pose.reach", Going("r_wrist", target));
  EXPECT_GT(TurnBetween(before.TurnOf("r_wrist"), BodyPlaces(&session).TurnOf("r_wrist")), 0.1);
  Do(&session, "edit.undo");
  Json keeping = Going("r_wrist", target);
  keeping["keep_turned"] = true;
  Do(&session, "pose.reach", keeping);
  const BodyPlaces kept(&session);
  EXPECT_LE((kept.PlaceOf("r_wrist") - target).norm(), 1e-6);
  EXPECT_LE(TurnBetween(before.TurnOf("r_wrist"), kept.TurnOf("r_wrist")), 1e-6);
}

TEST(ReachTurned, TheRootMovesAboveFlatFeetOrFeetThatRoll) {
  Session session;
  const BodyPlaces before(&session);
  const Vec3 lower = session.FrameNow().value()->X_WR.p + Vec3(0.02, 0.0, -0.04);
  const Json move = {{"x", lower.x()}, {"y", lower.y()}, {"z", lower.z()}};
  Do(&session, "root.move", move);
  const BodyPlaces flat(&session);
  for (const char* foot : {"r_ankle", "l_ankle"}) {
    EXPECT_LE((flat.PlaceOf(foot) - before.PlaceOf(foot)).norm(), 1e-6);
    EXPECT_LE(TurnBetween(before.TurnOf(foot), flat.TurnOf(foot)), 1e-6);
  }
  Do(&session, "edit.undo");
  Json rolling = move;
  rolling["keep_turned"] = false;
  Do(&session, "root.move", rolling);
  EXPECT_GT(TurnBetween(before.TurnOf("r_ankle"), BodyPlaces(&session).TurnOf("r_ankle")), 0.05);
}

// The forearm and the upper arm's far end, against head and chest.
double DeepestInBody(const BodyPlaces& places) {
  const auto capsule = [&](const std::string& name) {
    for (const Link& link : places.figure().links()) {
      if (link.name != name) continue;
      const BodyScratch& body = places.ws().body(link.joint);
      return Capsule{body.p + body.R * link.capsule.a, body.p + body.R * link.capsule.b,
                     link.capsule.radius};
    }
    ADD_FAILURE() << name;
    return Capsule{};
  };
  double least = 1.0;
  for (const char* part : {"head", "chest", "abdomen"}) {
    least = std::min(least, SignedDistance(capsule("r_forearm"), capsule(part)).value);
  }
  return -least;
}

// Of targets in front of the body, pulled there as the mouse pulls: in small steps.
TEST(ReachTurned, NoElbowGoesIntoTheBodyOnTheWayToTargetsInFrontOfIt) {
  Random random(7);
  int reached = 0;
  for (int i = 0; i < 60; ++i) {
    Session session;
    Do(&session, "pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 30}});
    const Vec3 from = BodyPlaces(&session).PlaceOf("r_wrist");
    const Vec3 target(random.Uniform(0.25, 0.5), random.Uniform(-0.5, 0.15),
                      random.Uniform(0.9, 1.7));
    for (int step = 1; step <= 20; ++step) {
      Do(&session, "pose.reach", Going("r_wrist", from + step / 20.0 * (target - from)));
    }
    const BodyPlaces places(&session);
    EXPECT_TRUE(places.IsWithinLimits());
    if ((places.PlaceOf("r_wrist") - target).norm() > 1e-6) continue;
    ++reached;
    EXPECT_LE(DeepestInBody(places), 0.01) << "target " << target.transpose();
  }
  EXPECT_GT(reached, 30);
}

}  // namespace
}  // namespace hazumi::test
