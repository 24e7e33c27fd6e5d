#include "tests/unit/edit/keys/keys_of.h"
#include "tests/unit/edit/pose/body_places.h"

namespace hazumi::test {
namespace {

using edit::Session;

double AngleNow(Session* session, const std::string& hinge) {
  return session->ValueNow(hinge).value();
}

TEST(PoseBlend, GoesAShareOfTheWayInOneStep) {
  Session session;
  SetKeys(&session, "r_knee", {{0, 20}});
  const size_t steps = session.document().num_steps();
  Do(&session, "pose.blend",
     {{"curves", {"r_knee", "l_elbow_flexion", "root.z"}},
      {"values", {60, 40, 1.9024}},
      {"share", 0.25}});
  EXPECT_NEAR(AngleNow(&session, "r_knee"), 30.0, 1e-9);
  EXPECT_NEAR(AngleNow(&session, "l_elbow_flexion"), 10.0, 1e-9);
  EXPECT_NEAR(AngleNow(&session, "root.z"), 0.9024 + 0.25, 1e-9);
  EXPECT_EQ(session.document().num_steps(), steps + 1);
  Do(&session, "pose.blend", {{"curves", {"r_knee"}}, {"values", {500}}});
  EXPECT_TRUE(BodyPlaces(&session).IsWithinLimits());
}

TEST(PoseBlend, SaysWhatIsWrong) {
  Session session;
  EXPECT_EQ(
      Refused(&session, "pose.blend", {{"curves", {"r_knee"}}, {"values", {1, 2}}}).ToString(),
      "pose.blend.values: there are 2 for 1 curves; give each one");
  EXPECT_EQ(
      Refused(&session, "pose.blend", {{"curves", {"r_knee"}}, {"values", {1}}, {"share", 1.5}})
          .ToString(),
      "pose.blend.share: must lie from 0 to 1");
}

TEST(Breakdown, IsBetweenTheKeysBeforeAndAfterWhateverIsKeyedOnTheFrame) {
  Session session;
  SetKeys(&session, "r_knee", {{0, 10}, {5, 90}, {10, 50}, {20, 100}});
  SetKeys(&session, "l_knee", {{0, 40}, {30, 60}});
  SetKeys(&session, "r_elbow_flexion", {{0, 40}});  // none after
  Do(&session, "time.frame", {{"frame", 5}});
  for (const double share : {0.0, 0.3, 1.0}) {
    Do(&session, "pose.breakdown", {{"share", share}});
    EXPECT_NEAR(AngleNow(&session, "r_knee"), 10.0 + share * 40.0, 1e-9);
    EXPECT_NEAR(AngleNow(&session, "l_knee"), 40.0 + share * 20.0, 1e-9);
    EXPECT_EQ(KeysOf(session, "r_elbow_flexion").size(), 1u);
  }
  Do(&session, "pose.breakdown", {{"share", 1.5}});  // overshoots
  EXPECT_NEAR(AngleNow(&session, "r_knee"), 70.0, 1e-9);
  Do(&session, "pose.breakdown", {{"share", -1.0}});  // to the limit
  EXPECT_NEAR(AngleNow(&session, "r_knee"), 0.0, 1e-9);
}

TEST(Breakdown, IsOfWhatIsSelected) {
  Session session;
  SetKeys(&session, "r_knee", {{0, 10}, {10, 50}});
  SetKeys(&session, "l_knee", {{0, 40}, {10, 60}});
  Do(&session, "time.frame", {{"frame", 4}});
  Do(&session, "select.joints", {{"joints", {"l_knee"}}});
  Do(&session, "pose.breakdown", {{"share", 0.5}});
  EXPECT_EQ(PointsOf(session, "l_knee"), (Points{{0, 40}, {4, 50}, {10, 60}}));
  EXPECT_EQ(KeysOf(session, "r_knee").size(), 2u);
  Do(&session, "select.joints", {{"joints", {"l_elbow"}}});
  EXPECT_EQ(Refused(&session, "pose.breakdown", {{"share", 0.5}}).ToString(),
            "pose.breakdown: nothing that is posed has a key before this frame and another after "
            "it; key it on both sides, or go between its keys");
}

TEST(RelaxAndPush, GoToTheLineBetweenTheKeysAndAwayFromIt) {
  Session session;
  SetKeys(&session, "r_knee", {{0, 20}, {4, 70}, {16, 60}});  // the line has 30 on frame 4
  Do(&session, "time.frame", {{"frame", 4}});
  Do(&session, "pose.relax", {{"share", 0.25}});
  EXPECT_NEAR(AngleNow(&session, "r_knee"), 60.0, 1e-9);
  Do(&session, "pose.push", {{"share", 0.5}});
  EXPECT_NEAR(AngleNow(&session, "r_knee"), 75.0, 1e-9);
  Do(&session, "pose.relax", {{"share", 1}});
  EXPECT_NEAR(AngleNow(&session, "r_knee"), 30.0, 1e-9);
}

// The other side comes to lie at the mirror image, and what has no other side is posed once.
TEST(PosingBothSides, MakesTheMirrorImageInOneStep) {
  Session session;
  const auto expect_mirrored = [&](const char* right, const char* left) {
    const BodyPlaces places(&session);
    const Vec3 image = places.PlaceOf(right).cwiseProduct(Vec3(1.0, -1.0, 1.0));
    EXPECT_LE((places.PlaceOf(left) - image).norm(), 1e-9) << right;
  };
  Do(&session, "pose.rotate", {{"joint", "r_shoulder_abduction"}, {"to", 50}, {"mirror", true}});
  expect_mirrored("r_wrist", "l_wrist");
  const size_t steps = session.document().num_steps();
  Do(&session, "pose.reach",
     {{"joint", "l_wrist"}, {"x", 0.35}, {"y", 0.3}, {"z", 1.3}, {"mirror", true}});
  EXPECT_EQ(session.document().num_steps(), steps + 1);
  expect_mirrored("r_wrist", "l_wrist");
  Do(&session, "pose.swivel", {{"joint", "l_wrist"}, {"angle", 20}, {"mirror", true}});
  expect_mirrored("r_elbow", "l_elbow");
  Do(&session, "pose.rotate", {{"joint", "chest_rotation"}, {"to", 10}, {"mirror", true}});
  EXPECT_NEAR(AngleNow(&session, "chest_rotation"), 10.0, 1e-9);
}

}  // namespace
}  // namespace hazumi::test
