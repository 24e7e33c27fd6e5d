#include <Eigen/Geometry>

#include "engine/dynamics/kinematics.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

Pose RootOf(Session* session) { return session->FrameNow().value()->X_WR; }

// Of the body that a joint sits on, with the joint's origin for its own.
Pose PoseBefore(Session* session, const char* joint) {
  const MotionFrame& now = *session->FrameNow().value();
  const Figure& figure = session->figure();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  const JointIndex first = figure.group(*figure.FindGroup(joint)).first;
  return {ws.body(figure.joint(first).parent).R, ws.body(first).p};
}

Pose BodyOf(Session* session, const char* joint) {
  const MotionFrame& now = *session->FrameNow().value();
  const Figure& figure = session->figure();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  const BodyScratch& body = ws.body(figure.group(*figure.FindGroup(joint)).last());
  return {body.R, body.p};
}

Json MoveTo(const Vec3& p, bool feet_stay = true) {
  return {{"x", p.x()}, {"y", p.y()}, {"z", p.z()}, {"feet_stay", feet_stay}};
}

Json Turn(const Vec3& axis, double by) {
  return {{"x", axis.x()}, {"y", axis.y()}, {"z", axis.z()}, {"by", by}};
}

void ExpectSamePlace(const Pose& a, const Pose& b, double metres, double radians) {
  EXPECT_LE((a.p - b.p).norm(), metres);
  EXPECT_LE(Eigen::AngleAxisd(Mat3(a.R * b.R.transpose())).angle(), radians);
}

TEST(RootOperators, ThePelvisGoesDownAndTheFeetStay) {
  Session session;
  const Pose left = PoseBefore(&session, "l_toe"), right = PoseBefore(&session, "r_toe");
  const Vec3 to = RootOf(&session).p + Vec3(0.0, 0.02, -0.04);
  Do(&session, "root.move", MoveTo(to));
  EXPECT_LE((RootOf(&session).p - to).norm(), 1e-9);
  ExpectSamePlace(PoseBefore(&session, "l_toe"), left, 1e-6, 1e-5);
  ExpectSamePlace(PoseBefore(&session, "r_toe"), right, 1e-6, 1e-5);
  EXPECT_GT(session.ValueNow("l_knee").value(), 15.0);
  EXPECT_EQ(session.document().num_steps(), 1u);
}

TEST(RootOperators, FartherDownTheHeelsRiseAndTheToesStayOnTheGround) {
  Session session;
  const Pose before = PoseBefore(&session, "l_toe"), toes = BodyOf(&session, "l_toe");
  Do(&session, "root.move", MoveTo(RootOf(&session).p - Vec3(0.0, 0.0, 0.3)));
  const Pose after = PoseBefore(&session, "l_toe");
  EXPECT_LE((after.p - before.p).norm(), 1e-6);
  EXPECT_GT(Eigen::AngleAxisd(Mat3(after.R * before.R.transpose())).angle(), 5.0 * kDegree);
  ExpectSamePlace(BodyOf(&session, "l_toe"), toes, 1e-6, 0.5 * kDegree);
}

TEST(RootOperators, TheWholeFigureMovesWhereFeetNeedNotStay) {
  Session session;
  const Vec3 foot = PoseBefore(&session, "l_toe").p, by(0.4, 0.1, 0.2);
  Do(&session, "root.move", MoveTo(RootOf(&session).p + by, false));
  EXPECT_LE((PoseBefore(&session, "l_toe").p - foot - by).norm(), 1e-9);
  EXPECT_TRUE(session.project().joints.empty());
}

TEST(RootOperators, APinnedFootStaysAndTheRootComesToWhereItIsWanted) {
  Session session;
  Do(&session, "placement.set", {{"kind", "pinned"}, {"pin", "l_toe"}, {"first", 0}, {"last", 30}});
  Do(&session, "key.insert");
  Do(&session, "time.frame", {{"frame", 10}});
  const Vec3 pin = PoseBefore(&session, "l_toe").p;
  const Vec3 to = RootOf(&session).p + Vec3(0.02, 0.0, -0.15);
  Do(&session, "root.move", MoveTo(to));
  EXPECT_LE((RootOf(&session).p - to).norm(), 1e-6);
  EXPECT_LE((PoseBefore(&session, "l_toe").p - pin).norm(), 1e-9);
  const Error error = Refused(&session, "root.move", MoveTo(to, false));
  EXPECT_NE(error.message.find("\"l_toe\" is pinned"), std::string::npos) << error.ToString();
}

TEST(RootOperators, InFlightTheTakeOffSaysWhereItIs) {
  Session session;
  Do(&session, "root.move", MoveTo(Vec3(0.0, 0.0, 1.6), false));
  Do(&session, "placement.set", {{"kind", "gravity"}, {"first", 0}, {"last", 30}});
  Do(&session, "time.frame", {{"frame", 5}});
  const Error error = Refused(&session, "root.move", MoveTo(Vec3(0.0, 0.0, 1.0)));
  EXPECT_NE(error.message.find("in flight"), std::string::npos) << error.ToString();
}

TEST(RootOperators, TurnsAboutAnyAxisWithoutWholeTurns) {
  Session session;
  Do(&session, "key.set", {{"curve", "root.angle_z"}, {"frame", 0}, {"value", 350.0}});
  const Vec3 axis = Vec3(0.3, -0.5, 0.8).normalized();
  const Mat3 before = RootOf(&session).R;
  Do(&session, "root.turn", Turn(axis, 25.0));
  const Mat3 wanted = Eigen::AngleAxisd(25.0 * kDegree, axis) * before;
  EXPECT_TRUE(RootOf(&session).R.isApprox(wanted, 1e-9));
  EXPECT_NEAR(session.ValueNow("root.angle_z").value(), 370.0, 15.0);
}

TEST(RootOperators, TurnsThroughThePoseWhereTwoOfItsAnglesAreOne) {
  Session session;
  for (int i = 0; i < 12; ++i) {
    const Mat3 wanted = Eigen::AngleAxisd(15.0 * kDegree, Vec3::UnitY()) * RootOf(&session).R;
    Do(&session, "root.turn", Turn(Vec3::UnitY(), 15.0));
    EXPECT_TRUE(RootOf(&session).R.isApprox(wanted, 1e-7)) << i;
  }
}

TEST(RootOperators, AboveFeetThatStayThePelvisTilts) {
  Session session;
  Do(&session, "root.move", MoveTo(RootOf(&session).p - Vec3(0.0, 0.0, 0.05)));
  const Pose left = PoseBefore(&session, "l_toe");
  Json parameters = Turn(Vec3::UnitY(), 10.0);
  parameters["feet_stay"] = true;
  Do(&session, "root.turn", parameters);
  ExpectSamePlace(PoseBefore(&session, "l_toe"), left, 1e-6, 1e-5);
}

TEST(RootOperators, LockedRootStays) {
  Session session;
  Do(&session, "joint.lock", {{"joints", {session.figure().root_name()}}});
  Refused(&session, "root.move", MoveTo(Vec3(0.0, 0.0, 1.0), false));
  Refused(&session, "root.turn", Turn(Vec3::UnitZ(), 10.0));
}

TEST(RootOperators, NoAxisIsRefused) {
  Session session;
  EXPECT_EQ(Refused(&session, "root.turn", Turn(Vec3::Zero(), 10.0)).ToString(),
            "root.turn.x: x, y and z are all 0: they give no axis");
}

TEST(RootOperators, ASelectedRootIsKeyedCopiedAndMirrored) {
  Session session;
  Do(&session, "root.move", MoveTo(Vec3(0.2, 0.3, 1.0), false));
  Do(&session, "root.turn", Turn(Vec3::UnitZ(), 40.0));
  Do(&session, "select.joints", {{"joints", {session.figure().root_name()}}});
  Do(&session, "pose.copy");
  Do(&session, "time.frame", {{"frame", 12}});
  Do(&session, "pose.paste", {{"flipped", true}});
  EXPECT_EQ(session.ValueNow("root.x").value(), 0.2);
  EXPECT_EQ(session.ValueNow("root.y").value(), -0.3);
  EXPECT_NEAR(session.ValueNow("root.angle_z").value(), -40.0, 1e-9);
  Do(&session, "time.frame", {{"frame", 20}});
  Do(&session, "key.insert");
  for (const ProjectCurve& curve : session.project().root.curves) {
    EXPECT_EQ(curve.keys.back().frame, 20.0);
  }
  Do(&session, "pose.clear");
  EXPECT_EQ(session.ValueNow("root.angle_z").value(), 0.0);
  EXPECT_EQ(session.ValueNow("root.y").value(), -0.3);
}

TEST(RootOperators, TheFigureIsPutOnTheGroundFromAboveAndFromInside) {
  Session session;
  const double standing = RootOf(&session).p.z();
  for (const double z : {standing + 0.4, standing - 0.3}) {
    Do(&session, "root.move", MoveTo({0.1, 0.2, z}, false));
    Do(&session, "root.to_ground");
    EXPECT_LE((RootOf(&session).p - Vec3(0.1, 0.2, standing)).norm(), 2e-6);
  }
  Do(&session, "placement.set", {{"kind", "pinned"}, {"pin", "l_toe"}, {"first", 0}, {"last", 9}});
  Do(&session, "time.frame", {{"frame", 5}});
  EXPECT_EQ(Refused(&session, "root.to_ground", Json::object()).ToString(),
            "root.to_ground: a pin or gravity says where the figure is in this frame; end its span "
            "before, or go to its first frame");
}

TEST(RootOperators, AboveHeldFeetStraightKneesBendTheWayTheyCan) {
  Session session;
  Do(&session, "key.insert");
  for (const char* toe : {"l_toe", "r_toe"}) {
    Do(&session, "hold.add", {{"joint", toe}, {"orientation", true}, {"first", 0}, {"last", 30}});
  }
  Do(&session, "time.frame", {{"frame", 10}});
  Do(&session, "root.move", MoveTo(RootOf(&session).p - Vec3(0.0, 0.0, 0.25)));
  double before = 0.0;
  for (int frame = 1; frame <= 10; ++frame) {
    Do(&session, "time.frame", {{"frame", frame}});
    const double knee = session.ValueNow("l_knee").value();
    EXPECT_GT(knee, before) << frame;
    EXPECT_NEAR(session.ValueNow("r_knee").value(), knee, 1e-6) << frame;
    before = knee;
  }
}

}  // namespace
}  // namespace hazumi::test
