#include <set>

#include "engine/project/checks/joint_names.h"
#include "engine/project/figure_file.h"
#include "engine/project/project_writer.h"
#include "tests/unit/edit/sessions.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/regions.h"

namespace hazumi::test {
namespace {

using edit::Session;

// Both arms raised, then let go.
void AddArms(Session* session) {
  for (const char* hinge : {"l_shoulder_flexion", "r_shoulder_flexion"}) {
    Do(session, "key.set", {{"curve", hinge}, {"frame", 0}, {"value", 0}});
    Do(session, "key.set", {{"curve", hinge}, {"frame", 5}, {"value", 70}});
    Do(session, "key.set", {{"curve", hinge}, {"frame", 30}, {"value", 0}});
  }
  Do(session, "region.add",
     {{"name", "arms"},
      {"first", 5},
      {"last", 15},
      {"joints", {"l_shoulder+", "r_shoulder+"}},
      {"friction", 0.8}});
}

TEST(RegionOperators, AddLetsTheJointsSwing) {
  Session session;
  AddArms(&session);
  const Result<const Motion*> motion = session.WholeMotion();
  ASSERT_TRUE(motion.ok());
  EXPECT_EQ(motion.value()->regions[0].islands, (std::vector<int>{7, 7}));
  EXPECT_TRUE(
      motion.value()->frames[10].in_region[session.figure().FindJoint("r_elbow_flexion")->value()]);
}

TEST(RegionOperators, AnEditThatCannotBeAnimatedIsRefused) {
  Session session;
  AddArms(&session);
  const Error overlap =
      Refused(&session, "region.add",
              {{"name", "again"}, {"first", 10}, {"last", 20}, {"joints", {"r_elbow_flexion"}}});
  EXPECT_NE(overlap.message.find("both drive"), std::string::npos) << overlap.message;
  Refused(&session, "region.set", {{"region", "arms"}, {"last", 3}});
  Refused(&session, "region.friction", {{"region", "arms"}, {"factor", 1.5}});
  EXPECT_EQ(Refused(&session, "region.remove", {{"region", "legs"}}).ToString(),
            "region.remove.region: there is no \"legs\"; there is \"arms\"");
}

TEST(RegionOperators, GivenItsOwnNameARegionStaysAsItIs) {
  Session session;
  AddArms(&session);
  const size_t steps = session.document().num_steps();
  Do(&session, "region.set", {{"region", "arms"}, {"name", "arms"}});
  EXPECT_EQ(session.project().regions[0].name, "arms");
  EXPECT_EQ(session.document().num_steps(), steps);
}

TEST(RegionOperators, RegionsKeepTheirIdsWhateverIsDoneToThem) {
  Session session;
  AddArms(&session);
  const auto id = [&](size_t i) { return session.project().regions[i].identity.id; };
  const ItemId arms = id(0);
  ASSERT_TRUE(arms.is_valid());
  Do(&session, "region.split", {{"region", "arms"}, {"frame", 10}});
  const ItemId second = id(1);
  EXPECT_EQ(id(0), arms);
  EXPECT_NE(second, arms);
  Do(&session, "region.set", {{"region", "arms 2"}, {"name", "arms"}});  // is taken
  EXPECT_EQ(id(1), second);
  Do(&session, "region.remove", {{"region", "arms"}});
  EXPECT_EQ(id(0), second);
  Do(&session, "edit.undo");
  EXPECT_EQ(id(0), arms);
  EXPECT_EQ(id(1), second);
}

// At each step of the drag the region is made again.
TEST(RegionOperators, ARegionThatIsDraggedOutHasOneId) {
  Session session;
  std::set<ItemId> ids;
  for (const int last : {8, 9, 10, 9}) {
    Do(&session, "region.add",
       {{"name", "arm"}, {"first", 5}, {"last", last}, {"joints", {"r_shoulder+"}}, {"drag", "d"}});
    ids.insert(session.project().regions.at(0).identity.id);
  }
  EXPECT_EQ(ids.size(), 1u);
}

TEST(RegionOperators, FrictionOfOneJoint) {
  Session session;
  AddArms(&session);
  Do(&session, "region.friction", {{"region", "arms"}, {"factor", 0.4}, {"joint", "r_wrist"}});
  Do(&session, "region.friction", {{"region", "arms"}, {"factor", 0.5}, {"joint", "r_wrist"}});
  const ProjectFriction& friction = session.project().regions[0].friction;
  ASSERT_EQ(friction.joints.size(), 1u);
  EXPECT_EQ(friction.joints[0].value, 0.5);
  EXPECT_EQ(friction.default_factor, 0.8);
  Do(&session, "region.friction", {{"region", "arms"}, {"joint", "r_wrist"}});
  EXPECT_TRUE(session.project().regions[0].friction.joints.empty());
  Refused(&session, "region.friction", {{"region", "arms"}});
}

TEST(RegionOperators, SplitGoesOnAsBefore) {
  Session session;
  AddArms(&session);
  const VecX before = session.WholeMotion().value()->frames[14].q;
  Do(&session, "region.split", {{"region", "arms"}, {"frame", 10}});
  EXPECT_EQ(session.project().regions[1].name, "arms 2");
  const VecX after = session.WholeMotion().value()->frames[14].q;
  EXPECT_LE((after - before).cwiseAbs().maxCoeff(), 2.0 * 0.01 / 57.3);
}

TEST(RegionOperators, ToKeysKeepsTheMotion) {
  Session session;
  AddArms(&session);
  const Motion before = *session.WholeMotion().value();
  Do(&session, "region.to_keys", {{"region", "arms"}});
  EXPECT_TRUE(session.project().regions.empty());
  const Motion& after = *session.WholeMotion().value();
  for (size_t f = 0; f < before.frames.size(); ++f) {
    EXPECT_LE((after.frames[f].q - before.frames[f].q).cwiseAbs().maxCoeff(), 1e-9) << f;
  }
}

TEST(RegionOperators, ToKeysKeepsTheBlendAfterTheRegion) {
  Session session;
  AddArms(&session);
  for (const int frame : {16, 18, 21}) {
    Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", frame}, {"value", frame}});
  }
  Do(&session, "region.set", {{"region", "arms"}, {"blend", 6}});
  Refused(&session, "region.set", {{"region", "arms"}, {"blend", -1}});
  ASSERT_EQ(session.project().regions[0].blend_frames, 6);
  const Motion before = *session.WholeMotion().value();
  const int shoulder = session.figure().FindJoint("r_shoulder_flexion")->value();
  EXPECT_NEAR(before.frames[21].q[shoulder], 21.0 / 57.29577951, 1e-8);
  Do(&session, "region.to_keys", {{"region", "arms"}});
  const Motion& after = *session.WholeMotion().value();
  for (size_t f = 0; f <= 21; ++f) {
    EXPECT_LE((after.frames[f].q - before.frames[f].q).cwiseAbs().maxCoeff(), 1e-9) << f;
  }
}

TEST(RegionOperators, ToKeysKeepsARootThatTumbles) {
  Session session;
  Do(&session, "root.move", {{"x", 0}, {"y", 0}, {"z", 20}, {"feet_stay", false}});
  Do(&session, "key.set", {{"curve", "root.angle_x"}, {"frame", 0}, {"value", 0}});
  Do(&session, "key.set", {{"curve", "root.angle_x"}, {"frame", 5}, {"value", 100}});
  Do(&session, "key.set", {{"curve", "root.angle_y"}, {"frame", 5}, {"value", 40}});
  Do(&session, "placement.set", {{"kind", "gravity"}, {"first", 0}, {"last", 30}});
  Do(&session, "region.add",
     {{"name", "tumble"}, {"first", 5}, {"last", 25}, {"joints", {"pelvis", "r_shoulder"}}});
  const Motion before = *session.WholeMotion().value();
  ASSERT_GT((before.frames[8].X_WR.R - before.frames[5].X_WR.R).norm(), 0.5);
  Do(&session, "region.to_keys", {{"region", "tumble"}});
  const Motion& after = *session.WholeMotion().value();
  for (int f = 0; f <= 25; ++f) {
    EXPECT_LE((after.frames[f].X_WR.R - before.frames[f].X_WR.R).norm(), 1e-8) << f;
  }
  const ProjectCurve& curve = session.project().root.curves[kRootAngleX];
  for (size_t i = 1; i < curve.keys.size(); ++i) {
    EXPECT_LE(std::abs(curve.keys[i].value - curve.keys[i - 1].value), 120.0) << i;
  }
}

TEST(RegionOperators, AMutedRegionIsAsIfItWereNotThere) {
  Session session;
  AddArms(&session);
  const Motion with = *session.WholeMotion().value();
  Do(&session, "region.set", {{"region", "arms"}, {"mute", true}});
  EXPECT_NE(WriteProject(session.project()).find("\"version\": 2"), std::string::npos);
  // What it drove another may drive now.
  Do(&session, "region.add",
     {{"name", "again"}, {"first", 10}, {"last", 20}, {"joints", {"r_elbow"}}});
  const Motion muted = *session.WholeMotion().value();
  EXPECT_FALSE(muted.frames[7].in_region[session.figure().FindJoint("l_elbow_flexion")->value()]);
  Do(&session, "region.remove", {{"region", "arms"}});
  const Motion removed = *session.WholeMotion().value();
  ASSERT_EQ(muted.frames.size(), removed.frames.size());
  for (size_t i = 0; i < muted.frames.size(); ++i) {
    EXPECT_EQ(muted.frames[i].q, removed.frames[i].q) << i;
    EXPECT_EQ(muted.frames[i].X_WR.p, removed.frames[i].X_WR.p) << i;
  }
  for (int i = 0; i < 3; ++i) Do(&session, "edit.undo");
  const Motion again = *session.WholeMotion().value();
  for (size_t i = 0; i < with.frames.size(); ++i) EXPECT_EQ(again.frames[i].q, with.frames[i].q);
}

TEST(RegionOperators, ItsJointsAreKeyedOnItsFirstFrameAndTheWayIntoItStaysWhateverIsKeyedInside) {
  const auto add = [](Session* session, bool key_start) {
    for (const auto& [frame, value] : {std::pair{0, 0}, {4, 60}, {12, -20}, {30, 0}}) {
      Do(session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", frame}, {"value", value}});
    }
    Do(session, "region.add",
       {{"first", 7}, {"last", 15}, {"joints", {"r_shoulder+"}}, {"key_start", key_start}});
  };
  Session plain, keyed;
  add(&plain, false);
  add(&keyed, true);
  const size_t steps = keyed.document().num_steps();
  EXPECT_EQ(steps, plain.document().num_steps());
  const Motion expected = *plain.WholeMotion().value();
  const auto expect_as_before = [&] {
    const Motion motion = *keyed.WholeMotion().value();
    for (size_t i = 0; i <= 15; ++i) {
      EXPECT_LT((motion.frames[i].q - expected.frames[i].q).lpNorm<Eigen::Infinity>(), 1e-6) << i;
    }
  };
  expect_as_before();
  // Keys that are not used.
  Do(&keyed, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 9}, {"value", 140}});
  Do(&keyed, "key.set", {{"curve", "r_elbow_flexion"}, {"frame", 10}, {"value", 90}});
  expect_as_before();
}

TEST(RegionOperators, ARegionTakesTheProjectsMethodAgain) {
  Session session;
  AddArms(&session);
  const std::vector<ProjectRegion> before = session.project().regions;
  Do(&session, "region.set", {{"region", "arms"}, {"method", "paper"}, {"tolerance", 0.1}});
  EXPECT_NE(session.project().regions, before);
  Do(&session, "region.set", {{"region", "arms"}, {"as_project", true}});
  EXPECT_EQ(session.project().regions, before);
}

const ProjectRegion& First(const Session& session) { return session.project().regions[0]; }

std::vector<std::string> NamesOf(const ProjectRegion& region) {
  std::vector<std::string> names;
  for (const JointRef& ref : region.joints) names.push_back(edit::NameOf(ref));
  return names;
}

TEST(RegionOperators, AddJoints_TakesTheSelectedOnesAndTheRoot) {
  Session session;
  AddArms(&session);
  session.set_selected_joints({"pelvis", "r_knee", "r_elbow_flexion"});
  Do(&session, "region.add_joints", {{"region", "arms"}});
  EXPECT_EQ(NamesOf(First(session)),
            (std::vector<std::string>{"l_shoulder+", "r_shoulder+", "pelvis", "r_knee"}));
  EXPECT_TRUE(session.animation()->regions[0].root);
  Do(&session, "region.add_joints", {{"region", "arms"}, {"joints", {"root", "r_knee"}}});
  EXPECT_EQ(First(session).joints.size(), 4u);  // the region has them already
  session.set_selected_joints({});
  Refused(&session, "region.add_joints", {{"region", "arms"}});
  Refused(&session, "region.add_joints", {{"region", "arms"}, {"joints", {"wing"}}});
}

TEST(RegionOperators, RemoveJoints_LeavesTheRestOfAReference) {
  Session session;
  AddArms(&session);
  Do(&session, "region.remove_joints", {{"region", "arms"}, {"joints", {"r_elbow"}}});
  EXPECT_EQ(NamesOf(First(session)),
            (std::vector<std::string>{"l_shoulder+", "r_shoulder", "r_wrist"}));
  const Error all = Refused(&session, "region.remove_joints",
                            {{"region", "arms"}, {"joints", {"l_shoulder+", "r_shoulder+"}}});
  EXPECT_NE(all.message.find("remove the region"), std::string::npos) << all.message;
}

TEST(RegionOperators, RemoveJoints_TakesTheRootOutOfAWholeBody) {
  Session session;
  Do(&session, "region.add", {{"first", 0}, {"last", 10}, {"joints", {"pelvis+"}}});
  ASSERT_TRUE(session.animation()->regions[0].root);
  const size_t hinges = session.animation()->regions[0].joints.size();
  session.set_selected_joints({"pelvis"});
  Do(&session, "region.remove_joints", {{"region", "region"}});
  EXPECT_FALSE(session.animation()->regions[0].root);
  EXPECT_EQ(session.animation()->regions[0].joints.size(), hinges);
}

TEST(RegionOperators, RemoveJoints_TakesTheirMuscleAndFrictionAlong) {
  Session session;
  AddArms(&session);
  Do(&session, "region.friction", {{"region", "arms"}, {"joint", "r_elbow"}, {"factor", 0.5}});
  Do(&session, "drive.add",
     {{"region", "arms"}, {"kind", "spring"}, {"joints", {"r_elbow", "l_elbow"}}});
  Do(&session, "drive.add", {{"region", "arms"}, {"kind", "spring"}, {"joints", {"r_wrist"}}});
  Do(&session, "region.remove_joints", {{"region", "arms"}, {"joints", {"r_elbow", "r_wrist"}}});
  EXPECT_TRUE(First(session).friction.joints.empty());
  ASSERT_EQ(First(session).drives.size(), 1u);
  EXPECT_EQ(First(session).drives[0].joints, (std::vector<JointRef>{{"l_elbow", false, {}}}));
}

TEST(RegionOperators, RemoveJoints_LeavesMuscleOfTheWholeBodyWithoutTheRoot) {
  Session session;
  Do(&session, "region.add", {{"first", 0}, {"last", 10}, {"joints", {"pelvis+"}}});
  Do(&session, "drive.add", {{"region", "region"}, {"kind", "spring"}, {"joints", {"pelvis+"}}});
  Do(&session, "region.remove_joints", {{"region", "region"}, {"joints", {"r_shoulder+"}}});
  EXPECT_EQ(session.animation()->regions[0].drives[0].joints,
            session.animation()->regions[0].joints);
  EXPECT_TRUE(session.animation()->regions[0].root);
}

TEST(RegionOperators, WholeBodyThatIsLetGo_StartsWithTheFrictionOfAFall) {
  const auto friction = [](const edit::Json& more) {
    Session session;
    edit::Json region = {{"first", 0}, {"last", 10}};
    region.update(more);
    Do(&session, "region.add", region);
    return First(session).friction.default_factor;
  };
  EXPECT_EQ(friction({{"joints", {"pelvis+"}}, {"contacts", true}}), edit::kFallFriction);
  EXPECT_EQ(friction({{"joints", {"pelvis+"}}}), edit::kLimpFriction);
  EXPECT_EQ(friction({{"joints", {"r_hip+", "pelvis"}}, {"contacts", true}}), edit::kLimpFriction);
  EXPECT_EQ(friction({{"joints", {"pelvis+"}}, {"contacts", true}, {"friction", 0.5}}), 0.5);
}

// A hand with a finger and a twist beside it.
void GiveFigureWithFinger(Session* session) {
  Project project = session->project();
  FigureSpec spec;
  spec.name = "hand";
  spec.root_name = "root";
  const auto joint = [&](const char* name, const char* parent, BodyRole role) {
    JointSpec made;
    made.name = name;
    made.parent = parent;
    made.offset = Vec3(0, 0, -0.2);
    HingeSpec hinge;
    hinge.axis = Vec3::UnitY();
    hinge.lower = -1.0;
    hinge.upper = 1.0;
    made.hinges = {hinge};
    LinkSpec link;
    link.name = name;
    link.to = Vec3(0, 0, -0.2);
    link.radius = 0.02;
    link.mass = 0.3;
    made.links = {link};
    made.body = BodyPlace{role, BodySide::kLeft};
    spec.joints.push_back(made);
  };
  LinkSpec root;
  root.name = "root";
  root.radius = 0.1;
  root.mass = 5.0;
  spec.root_links = {root};
  joint("arm", "root", BodyRole::kUpperArm);
  joint("twist", "arm", BodyRole::kTwist);
  joint("wrist", "arm", BodyRole::kHand);
  joint("finger", "wrist", BodyRole::kFinger);
  project.figure = {};
  project.figure.embedded_json = FigureText(spec);
  project.figure.spec = spec;
  project.skin = {};
  project.joints.clear();
  project.placements.clear();
  session->Replace(std::move(project), "");
}

TEST(RegionOperators, TwistsAndFingersStayOutUnlessTheyAreAskedFor) {
  Session session;
  GiveFigureWithFinger(&session);
  const auto moved = [&](const char* joint) -> bool {
    return JointsOf(session.project().regions.back(),
                    session.figure())[session.figure().FindJoint(joint)->value()];
  };
  Do(&session, "region.add", {{"first", 5}, {"last", 10}, {"joints", {"arm+"}}});
  EXPECT_TRUE(moved("arm") && moved("wrist"));
  EXPECT_FALSE(moved("twist") || moved("finger"));
  EXPECT_TRUE(session.project().regions.back().limit_tangents);
  Do(&session, "region.add", {{"first", 12}, {"last", 15}, {"joints", {"arm", "finger+"}}});
  EXPECT_TRUE(moved("arm") && moved("finger"));
  Do(&session, "region.add",
     {{"first", 20}, {"last", 25}, {"joints", {"wrist+"}}, {"limit_tangents", false}});
  EXPECT_FALSE(moved("finger"));
  EXPECT_FALSE(session.project().regions.back().limit_tangents);
}

}  // namespace
}  // namespace hazumi::test
