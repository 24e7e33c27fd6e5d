#include "engine/dynamics/kinematics.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

const ProjectConstraint& Last(const Session& session) {
  return session.project().constraints.back();
}

// With a region that moves the right arm, in whose middle the session is.
void AddSwing(Session* session) {
  Do(session, "region.add", {{"joints", {"r_shoulder+"}}, {"first", 0}, {"last", 30}});
  Do(session, "time.frame", {{"frame", 12}});
}
void Select(Session* session, const Json& joints) {
  Do(session, "select.joints", {{"joints", joints}});
}

// Where an end of the last constraint is in the current frame.
Pose PoseOf(bool is_b, Session* session) {
  const Constraint& constraint = session->animation()->constraints.back();
  const ConstraintEnd& end = is_b ? constraint.b : constraint.a;
  const Pose own = {end.rotation, end.offset};
  if (end.is_in_world) return own;
  const MotionFrame& now = *session->FrameNow().value();
  if (!end.joint) return now.X_WR * own;
  const Figure& figure = session->figure();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  const BodyScratch& body = ws.body(figure.group(*end.joint).last());
  return Pose{body.R, body.p} * own;
}
double Gap(Session* session) { return (PoseOf(false, session).p - PoseOf(true, session).p).norm(); }

TEST(ConstraintOperators, APointStaysWhereTheSelectedJointIs) {
  Session session;
  AddSwing(&session);
  Select(&session, {"r_wrist"});
  Do(&session, "constraint.add", {{"kind", "point"}});
  const ProjectConstraint& point = Last(session);
  EXPECT_EQ(point.name, "point");
  EXPECT_EQ(point.a.joint, "r_wrist");
  EXPECT_EQ(point.b.joint + point.b.object, "");
  EXPECT_EQ(point.first_frame, 12);
  EXPECT_EQ(point.last_frame, session.project().frames.last);
  EXPECT_EQ(point.arrive_frames, std::nullopt);
  EXPECT_TRUE(point.identity.id.is_valid());
  EXPECT_LT(Gap(&session), 1e-8);
}

TEST(ConstraintOperators, AWeldKeepsTwoJointsAsTheyAre) {
  Session session;
  AddSwing(&session);
  Select(&session, {"r_wrist", "l_wrist"});
  Do(&session, "constraint.add", {{"kind", "weld"}});
  EXPECT_NE(Last(session).a.joint, Last(session).b.joint);
  EXPECT_EQ(Last(session).b.joint.substr(1), "_wrist");
  EXPECT_LT(Gap(&session), 1e-8);
  const Mat3 turn = PoseOf(false, &session).R.transpose() * PoseOf(true, &session).R;
  EXPECT_LT((turn - Mat3::Identity()).norm(), 1e-8);
}

TEST(ConstraintOperators, ADistanceIsWhatItIsNow) {
  Session session;
  AddSwing(&session);
  Select(&session, {"r_wrist", "l_wrist"});
  Do(&session, "constraint.add", {{"kind", "distance"}});
  EXPECT_NEAR(Last(session).length_m, Gap(&session), 1e-8);
  EXPECT_GT(Last(session).length_m, 0.1);
  // From nothing it hangs as far above as it is long.
  Select(&session, {"r_wrist"});
  Do(&session, "constraint.add", {{"kind", "distance"}, {"length", 0.5}, {"name", "rope"}});
  EXPECT_NEAR(PoseOf(true, &session).p.z() - PoseOf(false, &session).p.z(), 0.5, 1e-8);
  EXPECT_NEAR(Gap(&session), 0.5, 1e-8);
}

TEST(ConstraintOperators, AHandTakesHoldOfTheNearestPointOfABox) {
  Session session;
  AddSwing(&session);
  Do(&session, "object.add_box",
     {{"name", "bar"},
      {"x", 0.4},
      {"z", 1.3},
      {"size_x", 0.1},
      {"size_y", 2},
      {"size_z", 0.1},
      {"angle_z", 20}});
  Select(&session, {"r_wrist"});
  Do(&session, "constraint.hold_on", {{"object", "bar"}, {"last", 25}});
  const ProjectConstraint& hold = Last(session);
  EXPECT_EQ(hold.kind, ConstraintKind::kPoint);
  EXPECT_EQ(hold.a.joint, "r_wrist");
  EXPECT_EQ(hold.b.object, "bar");
  EXPECT_EQ(hold.arrive_frames, 5);
  EXPECT_EQ(hold.last_frame, 25);
  const Vec3 shares = hold.b.offset_m.cwiseAbs().cwiseQuotient(Vec3(0.05, 1.0, 0.05));
  EXPECT_NEAR(shares.maxCoeff(), 1.0, 1e-6);
  Do(&session, "constraint.hold_on", {{"object", "bar"}, {"arrive", 9}});
  EXPECT_EQ(Last(session).arrive_frames, 9);
  EXPECT_EQ(Last(session).name, "point 2");
}

TEST(ConstraintOperators, AHandTakesHoldWhereItIsSaid) {
  Session session;
  AddSwing(&session);
  Do(&session, "object.add_box",
     {{"name", "bar"}, {"x", 0.4}, {"z", 1.3}, {"size_x", 0.1}, {"size_y", 2}, {"size_z", 0.1}});
  Select(&session, {"r_wrist"});
  Do(&session, "constraint.hold_on", {{"object", "bar"}, {"x", 0.4}, {"y", 0.5}, {"z", 1.5}});
  EXPECT_LT((Last(session).b.offset_m - Vec3(0.0, 0.5, 0.05)).norm(), 1e-8);
}

// Of a ball and a box that the other hand holds.
TEST(ConstraintOperators, AHandTakesHoldOfWhatTheOtherOneHolds) {
  Session session;
  AddSwing(&session);
  Do(&session, "held.add_ball", {{"name", "ball"}, {"joint", "l_wrist"}, {"radius", 0.11}});
  Do(&session, "held.add_box",
     {{"name", "stick"}, {"joint", "l_wrist"}, {"size_x", 0.1}, {"size_y", 0.8}, {"size_z", 0.1}});
  Select(&session, {"r_wrist"});
  Do(&session, "constraint.hold_on", {{"object", "ball"}});
  EXPECT_NEAR(Last(session).b.offset_m.norm(), 0.11, 1e-8);
  EXPECT_GT(Gap(&session), 0.05);
  Do(&session, "constraint.hold_on", {{"object", "stick"}});
  const Vec3 shares = Last(session).b.offset_m.cwiseAbs().cwiseQuotient(Vec3(0.05, 0.4, 0.05));
  EXPECT_NEAR(shares.maxCoeff(), 1.0, 1e-6);
  // The hand that has it holds on to it already.
  Select(&session, {"l_wrist"});
  Refused(&session, "constraint.hold_on", {{"object", "ball"}});
  Refused(&session, "constraint.hold_on", {{"object", "balls"}});
}

TEST(ConstraintOperators, AnEndThatIsFixedToSomethingElseStaysWhereItIs) {
  Session session;
  AddSwing(&session);
  Do(&session, "object.add_box", {{"name", "bar"}, {"x", 1}, {"angle_z", 20}});
  Select(&session, {"r_wrist"});
  Do(&session, "constraint.add", {{"kind", "weld"}});
  const Pose before = PoseOf(true, &session);
  for (const Json& to :
       {Json{{"b_object", "bar"}}, Json{{"b_joint", "l_wrist"}}, Json{{"b_joint", ""}}}) {
    Json given = {{"constraint", "weld"}};
    given.update(to);
    Do(&session, "constraint.set", given);
    EXPECT_TRUE(Last(session).b.joint.empty() || Last(session).b.object.empty());
    EXPECT_LT((PoseOf(true, &session).p - before.p).norm(), 1e-8) << to.dump();
    EXPECT_LT((PoseOf(true, &session).R - before.R).norm(), 1e-8) << to.dump();
  }
  Do(&session, "constraint.set",
     {{"constraint", "weld"}, {"b_object", "bar"}, {"b_offset_x", 0.5}});
  EXPECT_EQ(Last(session).b.offset_m,
            Vec3(0.5, Last(session).b.offset_m.y(), Last(session).b.offset_m.z()));
}

TEST(ConstraintOperators, AnotherKindGetsWhatItNeeds) {
  Session session;
  AddSwing(&session);
  Select(&session, {"r_wrist", "chest"});
  Do(&session, "constraint.add", {{"kind", "point"}, {"arrive", 6}});
  Do(&session, "constraint.set", {{"constraint", "point"}, {"kind", "distance"}, {"no_gap", true}});
  EXPECT_NEAR(Last(session).length_m, Gap(&session), 1e-8);
  EXPECT_EQ(Last(session).arrive_frames, std::nullopt);
  Do(&session, "constraint.set", {{"constraint", "point"}, {"kind", "weld"}});
  EXPECT_LT(Gap(&session), 1e-8);
}

TEST(ConstraintOperators, BreakUnderWhatTheyAreTold) {
  Session session;
  AddSwing(&session);
  Do(&session, "constraint.add", {{"kind", "point"}, {"a_joint", "r_wrist"}, {"break_force", 900}});
  for (const double impulse : {10.0, 20.0}) {
    Do(&session, "constraint.set",
       {{"constraint", "point"}, {"break_impulse", impulse}, {"drag", "1"}});
  }
  EXPECT_EQ(Last(session).break_force_n, 900.0);
  EXPECT_EQ(Last(session).break_impulse_n_s, 20.0);
  Do(&session, "edit.undo");
  EXPECT_EQ(Last(session).break_impulse_n_s, std::nullopt);
  Do(&session, "constraint.set", {{"constraint", "point"}, {"unbreakable", true}});
  EXPECT_EQ(Last(session).break_force_n, std::nullopt);
  Do(&session, "constraint.remove", {{"constraint", "point"}});
  EXPECT_TRUE(session.project().constraints.empty());
  Do(&session, "edit.undo");
  EXPECT_EQ(session.project().constraints.size(), 1u);
}

TEST(ConstraintOperators, ObjectsAreRenamedInThemAndStayWhileTheyAreNeeded) {
  Session session;
  AddSwing(&session);
  Do(&session, "object.add_box", {{"name", "bar"}, {"x", 0.8}, {"z", 1.2}});
  Do(&session, "held.add_box", {{"joint", "l_wrist"}, {"name", "bar"}});
  EXPECT_EQ(session.project().held_objects[0].name, "bar 2");
  Do(&session, "constraint.add",
     {{"kind", "point"},
      {"a_joint", "r_wrist"},
      {"b_object", "bar"},
      {"b_offset_x", -0.5},
      {"arrive", 5}});
  Do(&session, "constraint.add",
     {{"kind", "point"}, {"a_joint", "r_elbow"}, {"b_object", "bar 2"}, {"arrive", 5}});
  Do(&session, "object.set", {{"object", "bar"}, {"name", "beam"}});
  Do(&session, "held.set", {{"object", "bar 2"}, {"name", "brick"}});
  EXPECT_EQ(session.project().constraints[0].b.object, "beam");
  EXPECT_EQ(session.project().constraints[1].b.object, "brick");
  EXPECT_EQ(Refused(&session, "object.remove", {{"object", "beam"}}).ToString(),
            "object.remove.object: the constraint \"point\" is fixed to it; remove that first, or "
            "fix it to something else");
  EXPECT_EQ(Refused(&session, "held.remove", {{"object", "brick"}}).ToString(),
            "held.remove.object: the constraint \"point 2\" is fixed to it; remove that first, or "
            "fix it to something else");
  EXPECT_EQ(Refused(&session, "held.let_go", {{"object", "brick"}, {"frame", 20}}).place,
            "held.let_go.constraints[1].b");
  Do(&session, "constraint.remove", {{"constraint", "point"}});
  Do(&session, "object.remove", {{"object", "beam"}});
}

TEST(ConstraintOperators, RefuseWhatCannotBe) {
  Session session;
  AddSwing(&session);
  EXPECT_EQ(Refused(&session, "constraint.set", {{"constraint", "grip"}, {"arrive", 1}}).ToString(),
            "constraint.set.constraint: there is no \"grip\"; there are none");
  EXPECT_EQ(Refused(&session, "constraint.hold_on", {{"object", "floor"}}).ToString(),
            "constraint.hold_on.joint: is missing, and no joint is selected");
  Refused(&session, "constraint.add", {{"kind", "point"}, {"a_joint", "nose"}});
  Refused(&session, "constraint.add", {{"kind", "point"}, {"a_object", "floor"}});
  Refused(&session, "constraint.add",
          {{"kind", "point"}, {"a_joint", "r_wrist"}, {"b_joint", "r_wrist"}});
  Refused(&session, "constraint.add",
          {{"kind", "point"}, {"a_joint", "r_wrist"}, {"a_object", "floor"}});
  Refused(&session, "constraint.add", {{"kind", "point"}, {"a_joint", "r_wrist"}, {"arrive", 0}});
  Refused(&session, "constraint.add", {{"kind", "point"}, {"a_joint", "r_wrist"}, {"last", 12}});
}

// As those of a hold, its ends go along where all keys between are moved.
TEST(ConstraintOperators, GoAlongWithTheKeysAboutThem) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 0}, {"value", 10}});
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 20}, {"value", 40}});
  AddSwing(&session);
  Do(&session, "constraint.add",
     {{"kind", "point"}, {"a_joint", "r_wrist"}, {"first", 4}, {"last", 12}, {"arrive", 3}});
  Do(&session, "keys.select_all");
  Do(&session, "keys.move", {{"frames", 5}});
  EXPECT_EQ(Last(session).first_frame, 9);
  EXPECT_EQ(Last(session).last_frame, 17);
}

}  // namespace
}  // namespace hazumi::test
