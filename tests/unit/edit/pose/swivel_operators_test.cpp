#include <Eigen/Geometry>

#include "engine/spatial/degrees.h"
#include "tests/unit/edit/pose/body_places.h"

namespace hazumi::test {
namespace {

using edit::Session;

TEST(Swivel, LeadsTheElbowRoundTheLineAndLeavesTheHandAsItIs) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "r_shoulder_flexion"}, {"to", 40}});
  Do(&session, "pose.rotate", {{"joint", "r_shoulder_abduction"}, {"to", 20}});
  Do(&session, "pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 70}});
  for (const double by : {5.0, -12.0, 30.0}) {
    const BodyPlaces before(&session);
    Do(&session, "pose.swivel", {{"joint", "r_wrist"}, {"angle", by}});
    const BodyPlaces after(&session);
    const Vec3 line = (before.PlaceOf("r_wrist") - before.PlaceOf("r_shoulder")).normalized();
    const Vec3 elbow = before.PlaceOf("r_shoulder") +
                       Eigen::AngleAxisd(by * kDegree, line) *
                           (before.PlaceOf("r_elbow") - before.PlaceOf("r_shoulder"));
    EXPECT_LE((after.PlaceOf("r_elbow") - elbow).norm(), 1e-6) << by;
    EXPECT_LE((after.PlaceOf("r_wrist") - before.PlaceOf("r_wrist")).norm(), 1e-6) << by;
    EXPECT_LE(TurnBetween(before.TurnOf("r_wrist"), after.TurnOf("r_wrist")), 1e-6) << by;
    EXPECT_TRUE(after.IsWithinLimits());
  }
}

// Asked for more than the hip turns, it goes as far as that does; the foot stays.
TEST(Swivel, StopsAtTheLimitsOfTheFirstJoint) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "l_hip_flexion"}, {"to", 60}});
  Do(&session, "pose.rotate", {{"joint", "l_knee"}, {"to", 80}});
  const BodyPlaces before(&session);
  Do(&session, "pose.swivel", {{"joint", "l_ankle"}, {"angle", 170}});
  const BodyPlaces after(&session);
  EXPECT_TRUE(after.IsWithinLimits());
  EXPECT_LE((after.PlaceOf("l_ankle") - before.PlaceOf("l_ankle")).norm(), 1e-5);
  EXPECT_GT((after.PlaceOf("l_knee") - before.PlaceOf("l_knee")).norm(), 0.1);
  EXPECT_EQ(session.document().num_steps(), 3u);
}

TEST(Swivel, SaysWhatIsWrong) {
  Session session;
  EXPECT_EQ(Refused(&session, "pose.swivel", {{"joint", "r_elbow"}, {"angle", 5}}).ToString(),
            "pose.swivel.joint: no limb of two joints carries \"r_elbow\"; name a hand or a foot");
  Do(&session, "joint.lock", {{"joints", {"r_shoulder"}}});
  EXPECT_EQ(Refused(&session, "pose.swivel", {{"joint", "r_wrist"}, {"angle", 5}}).ToString(),
            "pose.swivel.joint: \"r_shoulder\" cannot turn the limb that way: a limit, a lock or a "
            "region is in the way, or it has too few hinges");
}

}  // namespace
}  // namespace hazumi::test
