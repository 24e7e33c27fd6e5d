#include <map>
#include <set>

#include "engine/dynamics/kinematics.h"
#include "engine/figure/pose_mirror.h"
#include "engine/project/figure_file.h"
#include "tests/support/capture_skeletons.h"
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

// A figure with the names and hinges of a capture, that faces some way.
Session CaptureSession(double degrees) {
  Project project;
  project.frames = {0, 30, {}};
  FigureSpec& spec = project.figure.spec;
  spec =
      CaptureSpec(Eigen::AngleAxisd(degrees / 57.29577951308232, Vec3::UnitZ()).toRotationMatrix());
  project.figure.embedded_json = FigureText(spec);
  Session session;
  session.Replace(project, "");
  return session;
}

void KeyAtRandom(Session* session, uint64_t seed) {
  Random random(seed);
  for (const Joint& joint : session->figure().joints()) {
    Do(session, "pose.rotate", {{"joint", joint.name}, {"to", random.Uniform(-120.0, 120.0)}});
  }
  Do(session, "root.move", {{"x", 0.3}, {"y", -0.2}, {"z", 1.1}, {"feet_stay", false}});
  Do(session, "root.turn", {{"x", 0.2}, {"y", 1.0}, {"z", -0.4}, {"by", 50.0}});
}

// Where all joints are in the world, by name.
std::map<std::string, Vec3> PositionsOf(Session* session) {
  const Figure& figure = session->figure();
  const MotionFrame& frame = *session->FrameNow().value();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  std::map<std::string, Vec3> of;
  for (const JointGroup& joint : figure.groups()) of[joint.name] = ws.body(joint.last()).p;
  return of;
}

// 30 degrees: no hinge of one side is one of the other's; all are found from their joints.
TEST(PoseOperators, PasteFlippedIsTheMirrorImageOfAnyFigure) {
  for (const double degrees : {0.0, 90.0, 30.0}) {
    Session session = CaptureSession(degrees);
    const FigureSides sides(session.figure());
    const Vec3 n = sides.normal();
    KeyAtRandom(&session, 7);
    const auto before = PositionsOf(&session);
    Do(&session, "select.all");
    Do(&session, "pose.copy");
    Do(&session, "time.frame", {{"frame", 12}});
    Do(&session, "pose.paste", {{"flipped", true}});
    const auto after = PositionsOf(&session);
    for (const auto& [name, p] : before) {
      const std::string other = sides.OtherSideOf(name, session.figure());
      EXPECT_LE((after.at(other) - (p - 2.0 * n.dot(p) * n)).norm(), 1e-8)
          << name << " at " << degrees;
    }
  }
}

TEST(PoseOperators, PasteFlippedOfOneArmLeavesTheOtherJointsAlone) {
  Session session = CaptureSession(0.0);
  Do(&session, "pose.rotate", {{"joint", "LeftArm_x"}, {"to", 30}});
  Do(&session, "pose.rotate", {{"joint", "LeftArm_y"}, {"to", 20}});
  Do(&session, "pose.rotate", {{"joint", "Spine_x"}, {"to", 10}});
  Do(&session, "select.joints", {{"joints", {"LeftArm"}}});
  Do(&session, "pose.copy");
  Do(&session, "pose.paste", {{"flipped", true}});
  EXPECT_EQ(AngleOf(&session, "RightArm_x"), -30.0);
  EXPECT_EQ(AngleOf(&session, "RightArm_y"), 20.0);
  EXPECT_NEAR(AngleOf(&session, "Spine_x"), 10.0, 1e-12);
  EXPECT_NEAR(AngleOf(&session, "LeftArm_x"), 30.0, 1e-12);
}

TEST(PoseOperators, MirrorSelectionKnowsTheNamesOfCaptures) {
  Session session = CaptureSession(0.0);
  Do(&session, "select.joints", {{"joints", {"LeftForeArm_x", "RHipJoint_z", "Spine_y", "Hips"}}});
  Do(&session, "select.mirror");
  EXPECT_EQ(session.selected_joints(),
            (std::set<std::string>{"Hips", "LHipJoint_z", "RightForeArm_x", "Spine_y"}));
}

}  // namespace
}  // namespace hazumi::test
