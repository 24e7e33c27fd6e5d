#include "ui/panels/viewport/start_speed.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/user.h"

namespace hazumi::test {
namespace {

TEST(StartSpeeds, AreThoseOfTheEndsOfTheLimbsThatARegionMoves) {
  User user("throw.kfa");
  edit::Session& session = user.session();
  const Figure& figure = session.figure();
  const DynamicsRegion& arms = session.animation()->regions[0];
  const Motion& motion = *session.WholeMotion().value();
  const MotionFrame& start = motion.frames[static_cast<size_t>(arms.first_frame)];
  const auto speeds = ui::StartSpeeds(arms, start, figure);
  ASSERT_EQ(speeds.size(), 2u);
  // A turning elbow: the wrist goes as fast as the rate times the length of the forearm says.
  MotionFrame still = start;
  still.after.qd.setZero();
  still.after.root_v.setZero();
  still.after.root_w.setZero();
  const JointIndex elbow = *figure.FindJoint("r_elbow_flexion");
  still.after.qd[elbow.value()] = 2.0;
  double fastest = 0.0;
  for (const ui::StartSpeed& speed : ui::StartSpeeds(arms, still, figure)) {
    fastest = std::max(fastest, speed.velocity.norm());
  }
  EXPECT_GT(fastest, 2.0 * 0.2);  // a forearm of 0.2 to 0.35 m
  EXPECT_LT(fastest, 2.0 * 0.35);
}

}  // namespace
}  // namespace hazumi::test
