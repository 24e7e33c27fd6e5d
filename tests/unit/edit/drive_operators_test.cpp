#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

// Both arms let go.
void AddLooseArms(Session* session) {
  Do(session, "key.set", {{"curve", "r_elbow_flexion"}, {"frame", 0}, {"value", 20}});
  Do(session, "key.set", {{"curve", "r_elbow_flexion"}, {"frame", 30}, {"value", 90}});
  Do(session, "region.add",
     {{"name", "arms"}, {"first", 5}, {"last", 15}, {"joints", {"l_shoulder+", "r_shoulder+"}}});
}

const std::vector<ProjectDrive>& DrivesOf(const Session& session) {
  return session.project().regions[0].drives;
}

TEST(DriveOperators, AddGivesTheSelectedJointsMuscle) {
  Session session;
  AddLooseArms(&session);
  Do(&session, "select.joints", {{"joints", {"r_elbow"}}});
  Do(&session, "drive.add", {{"region", "arms"}, {"frequency", 3}});
  ASSERT_EQ(DrivesOf(session).size(), 1u);
  EXPECT_EQ(DrivesOf(session)[0].kind, DriveKind::kSpring);
  ASSERT_EQ(DrivesOf(session)[0].joints.size(), 2u);
  EXPECT_EQ(DrivesOf(session)[0].joints[0].name, "r_elbow_flexion");
  EXPECT_TRUE(session.WholeMotion().ok());
  Do(&session, "edit.undo");
  EXPECT_TRUE(DrivesOf(session).empty());
}

TEST(DriveOperators, AJointThatIsGivenAnotherDriveLeavesTheFirst) {
  Session session;
  AddLooseArms(&session);
  Do(&session, "drive.add", {{"region", "arms"}, {"joints", {"r_elbow", "r_wrist"}}});
  Do(&session, "drive.add", {{"region", "arms"}, {"joints", {"r_wrist"}}, {"kind", "keys"}});
  ASSERT_EQ(DrivesOf(session).size(), 2u);
  EXPECT_EQ(DrivesOf(session)[0].joints.size(), 1u);
  Do(&session, "drive.set", {{"region", "arms"}, {"number", 1}, {"joints", {"r_elbow"}}});
  ASSERT_EQ(DrivesOf(session).size(), 1u);  // the first has no joint left
  EXPECT_EQ(DrivesOf(session)[0].kind, DriveKind::kKeys);
}

TEST(DriveOperators, TorqueIsKeyedWhereOneIs) {
  Session session;
  AddLooseArms(&session);
  Do(&session, "drive.add",
     {{"region", "arms"}, {"joints", {"r_elbow_flexion"}}, {"kind", "torque"}});
  Do(&session, "time.frame", {{"frame", 7}});
  Do(&session, "drive.key", {{"region", "arms"}, {"number", 0}, {"torque", 4}});
  Do(&session, "drive.key",
     {{"region", "arms"}, {"number", 0}, {"frame", 5}, {"torque", 1}, {"interpolation", "hold"}});
  ASSERT_EQ(DrivesOf(session)[0].torque.keys.size(), 2u);
  EXPECT_EQ(DrivesOf(session)[0].torque.keys[1].frame, 7.0);
  EXPECT_EQ(DrivesOf(session)[0].torque.keys[1].value, 4.0);
  Do(&session, "drive.remove_key", {{"region", "arms"}, {"number", 0}});
  EXPECT_EQ(DrivesOf(session)[0].torque.keys.size(), 1u);
  Refused(&session, "drive.remove_key", {{"region", "arms"}, {"number", 0}});
}

TEST(DriveOperators, AFrequencyAndAStrengthAreKeyedWhereOneIs) {
  Session session;
  AddLooseArms(&session);
  Do(&session, "drive.add", {{"region", "arms"}, {"joints", {"r_elbow"}}});
  const Json drive = {{"region", "arms"}, {"number", 0}};
  const auto with = [&](Json more) {
    more.update(drive);
    return more;
  };
  Do(&session, "drive.key", with({{"frame", 5}, {"frequency", 3}, {"strength", 1}}));
  Do(&session, "drive.key", with({{"frame", 12}, {"strength", 0.2}, {"interpolation", "hold"}}));
  EXPECT_EQ(DrivesOf(session)[0].frequency_over_time.keys.size(), 1u);
  ASSERT_EQ(DrivesOf(session)[0].strength_over_time.keys.size(), 2u);
  EXPECT_EQ(DrivesOf(session)[0].strength_over_time.keys[1].value, 0.2);
  EXPECT_TRUE(session.WholeMotion().ok());
  Do(&session, "drive.remove_key", with({{"frame", 5}, {"of", "strength"}}));
  EXPECT_EQ(DrivesOf(session)[0].frequency_over_time.keys.size(), 1u);
  EXPECT_EQ(DrivesOf(session)[0].strength_over_time.keys.size(), 1u);
  Do(&session, "drive.set", with({{"unlimited", true}, {"feed_forward", true}}));
  EXPECT_TRUE(DrivesOf(session)[0].strength_over_time.keys.empty());
  EXPECT_TRUE(DrivesOf(session)[0].feed_forward);
  Do(&session, "edit.undo");
  EXPECT_EQ(DrivesOf(session)[0].strength_over_time.keys.size(), 1u);
  Refused(&session, "drive.key", with({{"frequency", 31}}));
  Refused(&session, "drive.key", with({{"frame", 3}}));
}

// The file of a drive says the fields of its kind alone.
TEST(DriveOperators, AnotherKindDropsTheFieldsOfTheOneBefore) {
  Session session;
  AddLooseArms(&session);
  Do(&session, "drive.add", {{"region", "arms"}, {"joints", {"r_elbow"}}, {"frequency", 5}});
  const auto set = [&](const char* kind) {
    Do(&session, "drive.set", {{"region", "arms"}, {"number", 0}, {"kind", kind}});
    return DrivesOf(session)[0];
  };
  ProjectDrive expected = set("torque");
  EXPECT_EQ(expected.frequency_hz, ProjectDrive().frequency_hz);
  expected.kind = DriveKind::kKeys;
  EXPECT_EQ(set("keys"), expected);
  Do(&session, "drive.set",
     {{"region", "arms"}, {"number", 0}, {"kind", "spring"}, {"feed_forward", true}});
  EXPECT_EQ(set("keys"), expected);
}

TEST(DriveOperators, WhatCannotBeIsRefused) {
  Session session;
  AddLooseArms(&session);
  Refused(&session, "drive.add", {{"region", "arms"}, {"joints", {"r_knee"}}});
  Refused(&session, "drive.add", {{"region", "arms"}, {"frequency", 31}});
  Refused(&session, "drive.set", {{"region", "arms"}, {"number", 0}, {"frequency", 3}});
  Do(&session, "drive.add", {{"region", "arms"}});
  Refused(&session, "drive.key", {{"region", "arms"}, {"number", 0}, {"torque", 3}});
  EXPECT_EQ(Refused(&session, "drive.remove", {{"region", "arms"}, {"number", 1}}).ToString(),
            "drive.remove.number: \"arms\" has 1 drives, counted from 0");
}

TEST(DriveOperators, TorqueKeysGoAlongWhereItsRegionDoes) {
  Session session;
  AddLooseArms(&session);
  Do(&session, "drive.add",
     {{"region", "arms"}, {"joints", {"r_elbow_flexion"}}, {"kind", "torque"}});
  Do(&session, "drive.key", {{"region", "arms"}, {"number", 0}, {"frame", 10}, {"torque", 4}});
  Do(&session, "keys.select_all", Json::object());
  Do(&session, "keys.scale", {{"factor", 0.5}, {"about", 0}});
  EXPECT_EQ(session.project().regions[0].last_frame, 8);
  EXPECT_EQ(DrivesOf(session)[0].torque.keys[0].frame, 5.0);
}

TEST(DriveOperators, MuscleOfAWholeBody_LeavesTheRootWithout) {
  Session session;
  Do(&session, "region.add",
     {{"first", 0}, {"last", 10}, {"joints", {"pelvis", "r_hip", "waist"}}});
  Do(&session, "drive.add", {{"region", "region"}, {"kind", "spring"}});
  const ProjectRegion& region = session.project().regions[0];
  EXPECT_EQ(region.drives[0].joints,
            (std::vector<JointRef>{{"r_hip", false, {}}, {"waist", false, {}}}));
  Do(&session, "drive.set", {{"region", "region"}, {"number", 0}, {"joints", {"pelvis+"}}});
  EXPECT_EQ(session.animation()->regions[0].drives[0].joints,
            session.animation()->regions[0].joints);
}

}  // namespace
}  // namespace hazumi::test
