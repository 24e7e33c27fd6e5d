// Joints that are hidden or locked.

#include <gtest/gtest.h>

#include "ui/edit/session/session.h"
#include "ui/edit/session/session_state.h"

namespace hazumi::edit {
namespace {

using Names = std::set<std::string>;

TEST(JointStates, WhatIsHiddenIsNoLongerSelected) {
  Session session;
  ASSERT_TRUE(session.Run("select.joints", {{"joints", {"r_elbow", "r_knee"}}}).ok());
  ASSERT_TRUE(session.Run("joint.hide", {{"joints", {"r_elbow"}}}).ok());
  EXPECT_EQ(session.hidden_joints(), (Names{"r_elbow_flexion", "r_elbow_pronation"}));
  EXPECT_EQ(session.selected_joints(), (Names{"r_knee"}));
  ASSERT_TRUE(session.Run("joint.show_all").ok());
  EXPECT_TRUE(session.hidden_joints().empty());
  EXPECT_EQ(session.document().num_steps(), 0u);  // nothing to undo
}

TEST(JointStates, NothingSelectedIsSaid) {
  Session session;
  EXPECT_NE(session.Run("joint.lock").error().message.find("click"), std::string::npos);
}

TEST(JointStates, WhatIsLockedKeepsItsKeysWhenAPoseIsPasted) {
  Session session;
  ASSERT_TRUE(session.Run("pose.rotate", {{"joint", "r_knee"}, {"to", 30}}).ok());
  ASSERT_TRUE(session.Run("pose.rotate", {{"joint", "l_knee"}, {"to", 30}}).ok());
  ASSERT_TRUE(session.Run("pose.copy").ok());
  ASSERT_TRUE(session.Run("pose.clear").ok());
  ASSERT_TRUE(session.Run("joint.lock", {{"joints", {"r_knee"}}}).ok());
  ASSERT_TRUE(session.Run("pose.paste").ok());
  EXPECT_NEAR(session.ValueNow("l_knee").value(), 30.0, 1e-9);
  EXPECT_NEAR(session.ValueNow("r_knee").value(), 0.0, 1e-9);
}

TEST(JointStates, AReachTurnsNoLockedJoint) {
  Session session;
  ASSERT_TRUE(session.Run("joint.lock", {{"joints", {"r_elbow"}}}).ok());
  const double before = session.ValueNow("r_elbow_flexion").value();
  ASSERT_TRUE(
      session.Run("pose.reach", {{"joint", "r_wrist"}, {"x", 0.4}, {"y", -0.3}, {"z", 1.3}}).ok());
  EXPECT_EQ(session.ValueNow("r_elbow_flexion").value(), before);
  EXPECT_GT(std::abs(session.ValueNow("r_shoulder_flexion").value()), 1.0);
}

TEST(JointStates, SurviveACrash) {
  Session session;
  ASSERT_TRUE(session.Run("joint.hide", {{"joints", {"neck"}}}).ok());
  ASSERT_TRUE(session.Run("joint.lock", {{"joints", {"r_knee"}}}).ok());
  Session restored;
  ASSERT_TRUE(RestoreState(StateOf(session), &restored).ok());
  EXPECT_EQ(restored.hidden_joints(), session.hidden_joints());
  EXPECT_EQ(restored.locked_joints(), (Names{"r_knee"}));
}

}  // namespace
}  // namespace hazumi::edit
