// Fills: what they write, what of it stays, and when it is made anew.

#include <cmath>

#include "engine/makers/fills/fills.h"
#include "engine/project/edits/keys.h"
#include "engine/spatial/degrees.h"
#include "engine/timeline/curve_track.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

constexpr const char* kElbow = "r_elbow_flexion";
constexpr const char* kShoulder = "r_shoulder_flexion";

// The right arm in four poses.
void PoseArm(Session* session) {
  const double shoulder[] = {0.0, 60.0, 20.0, 80.0}, elbow[] = {10.0, 80.0, 30.0, 60.0};
  Do(session, "time.range", {{"first", 0}, {"last", 40}});
  for (int i = 0; i < 4; ++i) {
    Do(session, "key.set", {{"curve", kShoulder}, {"frame", 10 * i}, {"value", shoulder[i]}});
    Do(session, "key.set", {{"curve", kElbow}, {"frame", 10 * i}, {"value", elbow[i]}});
  }
}

const ProjectCurve& CurveOf(const Session& session, const std::string& name) {
  for (const auto& joint : session.project().joints) {
    if (joint.name == name) return joint.value;
  }
  static const ProjectCurve none;
  return none;
}

std::vector<ProjectKey> KeysOf(const Session& session, const std::string& curve, bool generated) {
  std::vector<ProjectKey> keys;
  for (const ProjectKey& key : CurveOf(session, curve).keys) {
    if ((key.type == KeyType::kGenerated) == generated) keys.push_back(key);
  }
  return keys;
}

void FillArm(Session* session, Json more = Json::object()) {
  more["joints"] = {"r_shoulder+"};
  Do(session, "fill.add", more);
}

double Measured(const Session& session, const std::string& name) {
  for (const auto& measured : session.outcome().measured) {
    if (measured.name == name) return measured.value;
  }
  return std::nan("");
}

TEST(Fill, WritesKeysBetweenThoseOfTheAnimatorAndLeavesThose) {
  Session session;
  PoseArm(&session);
  const std::vector<ProjectKey> before = KeysOf(session, kElbow, false);
  FillArm(&session);
  EXPECT_EQ(KeysOf(session, kElbow, false), before);
  EXPECT_GE(KeysOf(session, kElbow, true).size(), 3u);
  ASSERT_EQ(session.project().fills.size(), 1u);
  EXPECT_EQ(session.project().fills[0].first_frame, 0);
  EXPECT_EQ(session.project().fills[0].last_frame, 30);
  EXPECT_EQ(session.document().undo_label(), "Fill between keys");
  EXPECT_GT(Measured(session, "moved_cm"), 0.5);
  EXPECT_GT(Measured(session, "torque_before_n_m"), 0.0);
  EXPECT_EQ(Measured(session, "stepped"), 0.0);
  Do(&session, "edit.undo");
  EXPECT_TRUE(KeysOf(session, kElbow, true).empty());
  EXPECT_TRUE(session.project().fills.empty());
}

TEST(Fill, StaysWithinItsToleranceOfTheMotionThatWasFound) {
  Session session;
  PoseArm(&session);
  FillArm(&session, {{"tolerance", 0.001}});
  const Motion fine = *session.WholeMotion().value();
  const size_t many = KeysOf(session, kElbow, true).size();
  Do(&session, "fill.set", {{"fill", "fill"}, {"tolerance", 0.5}});
  const Motion coarse = *session.WholeMotion().value();
  EXPECT_LT(KeysOf(session, kElbow, true).size(), many);
  for (size_t t = 0; t < fine.frames.size(); ++t) {
    EXPECT_LT((fine.frames[t].q - coarse.frames[t].q).cwiseAbs().maxCoeff(), 0.501 * kDegree) << t;
  }
}

TEST(Fill, IsMadeAnewInTheStepThatChangesAKey) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const std::string filled = WriteProject(session.project());
  const std::vector<ProjectKey> before = KeysOf(session, kElbow, true);
  const size_t steps = session.document().num_steps();
  Do(&session, "key.set", {{"curve", kElbow}, {"frame", 10}, {"value", 100}});
  EXPECT_EQ(session.document().num_steps(), steps + 1);
  EXPECT_NE(KeysOf(session, kElbow, true), before);
  Do(&session, "edit.undo");
  EXPECT_EQ(WriteProject(session.project()), filled);
}

TEST(Fill, OfTheSameKeysIsTheSameWhateverCameBefore) {
  Session one, other;
  PoseArm(&one);
  FillArm(&one);
  PoseArm(&other);
  FillArm(&other, {{"snap", 1.0}});
  Do(&other, "key.set", {{"curve", kElbow}, {"frame", 10}, {"value", 100}});
  Do(&other, "fill.set", {{"fill", "fill"}, {"snap", 0.0}});
  Do(&other, "key.set", {{"curve", kElbow}, {"frame", 10}, {"value", 80}});
  EXPECT_EQ(WriteProject(one.project()), WriteProject(other.project()));
}

TEST(Fill, FollowsADragAndEndsWhereTheDragDoes) {
  Session dragged, at_once;
  for (Session* session : {&dragged, &at_once}) {
    PoseArm(session);
    FillArm(session);
    session->set_selected_keys({{kElbow, {10.0}}});
  }
  for (const int by : {1, 2, 3, 2}) {
    Do(&dragged, "keys.move", {{"frames", by}, {"drag", "d"}});
    EXPECT_FALSE(KeysOf(dragged, kElbow, true).empty());
  }
  Do(&at_once, "keys.move", {{"frames", 2}});
  EXPECT_EQ(WriteProject(dragged.project()), WriteProject(at_once.project()));
  const size_t steps = dragged.document().num_steps();
  Do(&dragged, "edit.undo");
  EXPECT_EQ(dragged.document().num_steps(), steps);
  EXPECT_EQ(KeysOf(dragged, kElbow, false)[1].frame, 10.0);
}

TEST(Fill, LeavesAnEditAloneThatChangesNothingItDependsOn) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const std::vector<ProjectKey> before = KeysOf(session, kElbow, true);
  Do(&session, "marker.add", {{"frame", 3}, {"name", "here"}});
  EXPECT_TRUE(session.fill_reports().empty());
  EXPECT_EQ(KeysOf(session, kElbow, true), before);
}

TEST(Fill, GivesAKeyThatIsTouchedToTheAnimator) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const ProjectKey touched = KeysOf(session, kElbow, true)[0];
  Do(&session, "key.set",
     {{"curve", kElbow}, {"frame", touched.frame}, {"value", touched.value + 5.0}});
  const ProjectKey* now = KeyOn(touched.frame, CurveOf(session, kElbow));
  ASSERT_NE(now, nullptr);
  EXPECT_EQ(now->type, KeyType::kKeyframe);
  EXPECT_EQ(KeysOf(session, kElbow, false).size(), 5u);
  EXPECT_FALSE(KeysOf(session, kElbow, true).empty());
}

TEST(Fill, TakesItsKeysAlongWhenItGoesOrLeavesThem) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const size_t all = CurveOf(session, kElbow).keys.size();
  Do(&session, "fill.remove", {{"fill", "fill"}, {"keep", true}});
  EXPECT_EQ(KeysOf(session, kElbow, false).size(), all);
  Do(&session, "edit.undo");
  Do(&session, "fill.remove", {{"fill", "fill"}});
  EXPECT_EQ(CurveOf(session, kElbow).keys.size(), 4u);
}

TEST(Fill, KeepsWithinLimits) {
  Session session;
  PoseArm(&session);
  Do(&session, "figure.joint_limits", {{"joint", kElbow}, {"lower", 10.0}, {"upper", 80.0}});
  FillArm(&session);
  const Motion motion = *session.WholeMotion().value();
  const int j = session.figure().FindJoint(kElbow)->value();
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_GT(frame.q[j], (10.0 - 0.06) * kDegree) << frame.frame;
    EXPECT_LT(frame.q[j], (80.0 + 0.06) * kDegree) << frame.frame;
  }
}

double ValueAt(const Session& session, const std::string& curve, double frame) {
  const Keys keys = ToKeys(CurveOf(session, curve), 1.0);
  return CurveTrack(&keys, {30, 1}, 0.0, {}).At(frame).value;
}

TEST(Fill, TakesTheRatesThatKeysState) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const auto slope = [&](double frame) {
    return 15.0 * (ValueAt(session, kElbow, frame + 1.0) - ValueAt(session, kElbow, frame - 1.0));
  };
  EXPECT_LT(std::abs(slope(10.0)), 75.0);
  Do(&session, "key.set", {{"curve", kElbow}, {"frame", 10}, {"rate", 150}});
  EXPECT_NEAR(slope(10.0), 150.0, 5.0);
}

// As automatic tangents do: without a jump of the rate in the first frame.
TEST(Fill, RestsAtBothEndsUnlessKeysSayOtherwise) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  for (const double frame : {0.0, 29.0}) {
    const double step = ValueAt(session, kElbow, frame + 1.0) - ValueAt(session, kElbow, frame);
    EXPECT_LT(std::abs(step), 3.0) << frame;
  }
  Do(&session, "key.set", {{"curve", kElbow}, {"frame", 0}, {"rate", -90}});
  EXPECT_LT(ValueAt(session, kElbow, 1.0), ValueAt(session, kElbow, 0.0) + 0.5);
}

TEST(Fill, LeavesStepsAndReportsThem) {
  Session session;
  PoseArm(&session);
  session.set_selected_keys({{kElbow, {10.0}}});
  Do(&session, "keys.interpolation", {{"interpolation", "hold"}});
  FillArm(&session);
  EXPECT_GT(Measured(session, "stepped"), 0.0);
  for (const ProjectKey& key : KeysOf(session, kElbow, true)) {
    EXPECT_FALSE(key.frame > 10.0 && key.frame < 20.0) << key.frame;
  }
}

TEST(Fill, KeepsTheWayRoundThatTheCurvesHave) {
  Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 40}});
  for (int i = 0; i < 4; ++i) {
    Do(&session, "key.set", {{"curve", "root.angle_z"}, {"frame", 10 * i}, {"value", 300.0 * i}});
  }
  Do(&session, "fill.add", {{"joints", {"root"}}});
  const Result<const Motion*> motion = session.WholeMotion();
  ASSERT_TRUE(motion.ok());
  double turned = 0.0;
  for (size_t t = 1; t <= 30; ++t) {
    const Mat3 R =
        motion.value()->frames[t - 1].X_WR.R.transpose() * motion.value()->frames[t].X_WR.R;
    turned += std::atan2(R(1, 0), R(0, 0));
  }
  EXPECT_NEAR(turned, 900.0 * kDegree, 1e-6);
}

TEST(Fill, KeepsItsKeysWhenItIsRenamedOrSetToWhatItIs) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const std::vector<ProjectKey> before = KeysOf(session, kElbow, true);
  Do(&session, "fill.set", {{"fill", "fill"}, {"name", "arm"}});
  Do(&session, "fill.set", {{"fill", "arm"}, {"snap", 0.0}});
  EXPECT_EQ(KeysOf(session, kElbow, true), before);
}

TEST(Fill, MakesKeysAnewThatAreDeleted) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const std::vector<ProjectKey> before = KeysOf(session, kElbow, true);
  session.set_selected_keys({{kElbow, {before[0].frame}}});
  Do(&session, "keys.delete");
  EXPECT_EQ(KeysOf(session, kElbow, true), before);
}

TEST(Fill, ScalesWithTheKeysOfItsJoints) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  KeySelection all;
  for (const auto& joint : session.project().joints) {
    for (const ProjectKey& key : joint.value.keys) all[joint.name].insert(key.frame);
  }
  for (const double factor : {0.6, 0.5}) {
    session.set_selected_keys(all);
    Do(&session, "keys.scale", {{"factor", factor}, {"about", 0.0}, {"drag", "d"}});
  }
  EXPECT_EQ(KeysOf(session, kElbow, false).size(), 4u);
  EXPECT_EQ(KeysOf(session, kElbow, false).back().frame, 15.0);
  EXPECT_FALSE(KeysOf(session, kElbow, true).empty());
  EXPECT_EQ(session.project().fills[0].last_frame, 15);
}

TEST(Fill, KeepsThePoseOfABallJointOfWhichOneHingeIsKeyed) {
  Session session;
  PoseArm(&session);
  for (const int frame : {0, 10, 20, 30}) {
    Do(&session, "key.set",
       {{"curve", "r_shoulder_abduction"}, {"frame", frame}, {"value", 2.0 * frame}});
  }
  FillArm(&session);
  const double seen = ValueAt(session, "r_shoulder_abduction", 15.0);
  Do(&session, "key.set",
     {{"curve", kShoulder}, {"frame", 15}, {"value", ValueAt(session, kShoulder, 15.0) + 1.0}});
  EXPECT_NEAR(ValueAt(session, "r_shoulder_abduction", 15.0), seen, 1e-6);
}

TEST(Fill, LeavesAloneWhatACurveDoesBeyondItsOwnKeys) {
  Session session;
  PoseArm(&session);
  Do(&session, "key.set",
     {{"curve", "r_shoulder_abduction"}, {"frame", 0}, {"value", 10}, {"interpolation", "hold"}});
  Do(&session, "key.set", {{"curve", "r_shoulder_abduction"}, {"frame", 38}, {"value", 60}});
  FillArm(&session, {{"first", 0}, {"last", 40}});
  EXPECT_EQ(ValueAt(session, "r_shoulder_abduction", 35.0), 10.0);
  EXPECT_GT(Measured(session, "stepped"), 0.0);
  Do(&session, "fill.set", {{"fill", "fill"}, {"last", 30}});
  EXPECT_EQ(ValueAt(session, "r_shoulder_abduction", 35.0), 10.0);
  EXPECT_GT(Measured(session, "unfilled"), 0.0);
}

TEST(Fill, GivesGeneratedKeysToTheAnimatorWhereNoFillIs) {
  Session session;
  PoseArm(&session);
  session.set_selected_keys({{kElbow, {10.0}}});
  Do(&session, "keys.type", {{"type", "generated"}});
  EXPECT_EQ(KeysOf(session, kElbow, false).size(), 4u);
}

TEST(Fill, KeepsItsOldKeysWhileItCannotBeMadeAndSaysSo) {
  Session session;
  PoseArm(&session);
  FillArm(&session);
  const std::vector<ProjectKey> before = KeysOf(session, kElbow, true);
  Do(&session, "key.set", {{"curve", kElbow}, {"frame", 4.5}, {"value", 30}});
  ASSERT_TRUE(session.fill_error().has_value());
  EXPECT_NE(session.fill_error()->message.find("between frames"), std::string::npos);
  EXPECT_EQ(KeysOf(session, kElbow, true), before);
  Do(&session, "key.delete", {{"curve", kElbow}, {"frame", 4.5}});
  EXPECT_FALSE(session.fill_error().has_value());
  EXPECT_EQ(KeysOf(session, kElbow, true), before);
}

TEST(Fill, RefusesWhatItCannotFill) {
  Session session;
  EXPECT_NE(Refused(&session, "fill.add", {{"joints", {"r_elbow"}}}).message.find("fewer than two"),
            std::string::npos);
  PoseArm(&session);
  FillArm(&session);
  EXPECT_NE(Refused(&session, "fill.add", {{"joints", {"r_elbow"}}}).message.find("too"),
            std::string::npos);
}

}  // namespace
}  // namespace hazumi::test
