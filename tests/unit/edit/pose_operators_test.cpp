#include "engine/dynamics/kinematics.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

double AngleOf(Session* session, const std::string& hinge) {
  const Result<double> angle = session->ValueNow(hinge);
  EXPECT_TRUE(angle.ok());
  return angle.ok() ? angle.value() : 0.0;
}

TEST(PoseOperators, RotateKeepsToTheLimits) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "r_knee"}, {"by", 500}});
  const Joint& knee = session.figure().joint(*session.figure().FindJoint("r_knee"));
  EXPECT_NEAR(AngleOf(&session, "r_knee"), knee.upper * 57.29577951308232, 1e-9);
  Do(&session, "pose.rotate", {{"joint", "r_knee"}, {"to", 20}});
  EXPECT_NEAR(AngleOf(&session, "r_knee"), 20.0, 1e-12);
}

TEST(PoseOperators, ClearGoesBackToRest) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "r_knee"}, {"to", 20}});
  Do(&session, "pose.rotate", {{"joint", "l_knee"}, {"to", 30}});
  Do(&session, "select.joints", {{"joints", {"r_knee"}}});
  Do(&session, "pose.clear");
  EXPECT_EQ(AngleOf(&session, "r_knee"), 0.0);
  EXPECT_NEAR(AngleOf(&session, "l_knee"), 30.0, 1e-12);
}

TEST(PoseOperators, PasteBringsThePoseToAnotherFrame) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 70}});
  Do(&session, "pose.copy");
  Do(&session, "time.frame", {{"frame", 20}});
  Do(&session, "pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 10}});
  Do(&session, "pose.paste");
  EXPECT_NEAR(AngleOf(&session, "r_elbow_flexion"), 70.0, 1e-9);
}

// Every joint comes to lie at the mirror image of where its other side was.
TEST(PoseOperators, PasteFlippedIsTheMirrorImage) {
  Session session;
  const Figure& figure = session.figure();
  double angle = 3.0;
  for (const Joint& joint : figure.joints()) {
    Do(&session, "pose.rotate", {{"joint", joint.name}, {"to", angle = 25.0 - 1.3 * angle}});
    if (std::abs(angle) > 40.0) angle = 7.0;
  }
  const auto positions = [&] {
    const MotionFrame& frame = session.MotionTo(0).value()->frames[0];
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, Pose(), frame.q, &ws);
    std::map<std::string, Vec3> of;
    for (const Joint& joint : figure.joints())
      of[joint.name] = ws.body(*figure.FindJoint(joint.name)).p;
    return of;
  };
  const auto before = positions();
  Do(&session, "pose.copy");
  Do(&session, "pose.paste", {{"flipped", true}});
  const auto after = positions();
  for (const auto& [name, p] : before) {
    std::string other = name;
    if (name.starts_with("l_") || name.starts_with("r_")) other[0] = name[0] == 'l' ? 'r' : 'l';
    EXPECT_LE((after.at(other) - Vec3(p.x(), -p.y(), p.z())).norm(), 1e-9) << name;
  }
}

}  // namespace
}  // namespace hazumi::test
