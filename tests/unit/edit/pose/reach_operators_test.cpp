#include "engine/dynamics/kinematics.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

Vec3 PlaceOf(Session* session, const char* joint) {
  const MotionFrame& now = *session->FrameNow().value();
  const Figure& figure = session->figure();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  return ws.body(figure.group(*figure.FindGroup(joint)).first).p;
}

Json To(const char* joint, const Vec3& p) {
  return {{"joint", joint}, {"x", p.x()}, {"y", p.y()}, {"z", p.z()}};
}

TEST(ReachOperators, BringsAHandWhereItIsWanted) {
  Session session;
  Do(&session, "time.frame", {{"frame", 10}});
  const Vec3 target = PlaceOf(&session, "r_wrist") + Vec3(0.25, -0.1, 0.3);
  Do(&session, "pose.reach", To("r_wrist", target));
  EXPECT_LE((PlaceOf(&session, "r_wrist") - target).norm(), 1e-8);
  EXPECT_EQ(session.project().joints.size(), 5u);  // shoulder and elbow
  for (const auto& curve : session.project().joints) {
    EXPECT_EQ(curve.value.keys[0].frame, 10.0) << curve.name;
  }
  Do(&session, "edit.undo");
  EXPECT_TRUE(session.project().joints.empty());
}

TEST(ReachOperators, APointOfTheHandComesThereInsteadOfTheWrist) {
  Session session;
  const Vec3 target(0.3, 0.05, 1.15), palm(0.02, 0.04, -0.08);
  Json parameters = To("l_wrist", target);
  for (int i = 0; i < 3; ++i) parameters[std::string("offset_") + "xyz"[i]] = palm[i];
  Do(&session, "pose.reach", parameters);
  const MotionFrame& now = *session.FrameNow().value();
  const Figure& figure = session.figure();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  const BodyScratch& hand = ws.body(figure.group(*figure.FindGroup("l_wrist")).last());
  EXPECT_LE((hand.p + hand.R * palm - target).norm(), 1e-3);
}

TEST(ReachOperators, DraggingIsOneStep) {
  Session session;
  const Vec3 from = PlaceOf(&session, "l_ankle");
  for (int i = 1; i <= 10; ++i) {
    Json parameters = To("l_ankle", from + Vec3(0.02, 0.0, 0.02) * i);
    parameters["drag"] = "1";
    Do(&session, "pose.reach", parameters);
    EXPECT_LE((PlaceOf(&session, "l_ankle") - from - Vec3(0.02, 0.0, 0.02) * i).norm(), 1e-8);
  }
  EXPECT_EQ(session.document().num_steps(), 1u);
}

TEST(ReachOperators, TheChainMayGoUpToTheRoot) {
  Session session;
  Json parameters = To("r_wrist", Vec3(0.8, -0.2, 1.2));
  Do(&session, "pose.reach", parameters);
  const double limb = (PlaceOf(&session, "r_wrist") - Vec3(0.8, -0.2, 1.2)).norm();
  EXPECT_GT(limb, 0.01);  // out of reach of the arm alone
  parameters["chain"] = 0;
  Do(&session, "pose.reach", parameters);
  EXPECT_LT((PlaceOf(&session, "r_wrist") - Vec3(0.8, -0.2, 1.2)).norm(), limb - 0.01);
  EXPECT_EQ(session.project().joints.size(), 11u);  // chest and waist too
}

TEST(ReachOperators, LeavesToRegionsWhatTheySwing) {
  Session session;
  Do(&session, "region.add", {{"first", 5}, {"last", 15}, {"joints", {"r_elbow"}}});
  Do(&session, "time.frame", {{"frame", 10}});
  Do(&session, "pose.reach", To("r_wrist", Vec3(0.4, -0.3, 1.2)));
  EXPECT_EQ(session.project().joints.size(), 3u);  // the shoulder
  Do(&session, "region.set", {{"region", "region"}, {"joints", {"r_shoulder+"}}});
  EXPECT_EQ(
      Refused(&session, "pose.reach", To("r_wrist", Vec3(0.4, -0.3, 1.2))).ToString(),
      "pose.reach.joint: every joint that moves \"r_wrist\" is swung by a region in this frame, or "
      "locked; end the region before it, or unlock one");
}

TEST(ReachOperators, SaysWhatIsWrong) {
  Session session;
  const auto refused = [&](const Json& parameters) {
    return Refused(&session, "pose.reach", parameters).ToString();
  };
  EXPECT_EQ(refused(To("nose", Vec3::Zero())),
            "pose.reach.joint: the figure has no joint \"nose\"");
  EXPECT_EQ(refused(To("r_hip", Vec3::Zero())),
            "pose.reach.joint: no joint lies between the root and \"r_hip\"; move the root "
            "instead");
  Do(&session, "placement.set", {{"kind", "pinned"}, {"pin", "l_toe"}, {"first", 0}, {"last", 30}});
  EXPECT_EQ(refused(To("l_ankle", Vec3::Zero())),
            "pose.reach.joint: \"l_toe\" is pinned in this frame and the same hinges carry it; "
            "place the figure otherwise");
  Do(&session, "hold.add", {{"joint", "r_ankle"}, {"first", 0}, {"last", 10}});
  EXPECT_EQ(refused(To("r_knee", Vec3::Zero())),
            "pose.reach.joint: \"r_ankle\" is held in this frame; remove the hold");
  Do(&session, "pose.reach", To("r_wrist", Vec3(0.4, -0.3, 1.2)));
}

}  // namespace
}  // namespace hazumi::test
