// Torques below the curves of the graph editor.

#include "ui/panels/graph/torque.h"

#include <algorithm>

#include "tests/ui/user.h"
#include "ui/panels/graph/layout.h"

namespace hazumi::test {
namespace {

class TorqueGraph : public testing::Test {
 protected:
  TorqueGraph() : user("throw.kfa") {
    user.session().set_selected_joints({"r_elbow_flexion"});
    user.editor().Do("view.sheet", {{"graph", true}});
    user.Wait();
  }

  ui::GraphLayout Layout() { return ui::CurrentGraph(&user.editor()); }
  void Toggle() {
    const ui::Rect toggle = Layout().torque_toggle;
    user.Click({toggle.x + 12.0f, toggle.y + 0.5f * toggle.h});
  }

  User user;
};

TEST_F(TorqueGraph, AClickShowsTheTorqueThatTheMotionNeedsAndAnotherHidesIt) {
  const float whole = Layout().frame.tracks.h;
  EXPECT_FALSE(Layout().torque);
  const std::vector<uint8_t> before = user.picture();
  Toggle();
  const ui::GraphLayout layout = Layout();
  ASSERT_TRUE(layout.torque);
  EXPECT_NE(user.picture(), before);
  EXPECT_LT(layout.frame.tracks.h, 0.7f * whole);
  EXPECT_NEAR(layout.torque->rect.y, layout.frame.tracks.bottom(), 1e-3);
  ASSERT_EQ(layout.torque->curves.size(), 1u);
  const auto& points = layout.torque->curves[0].points;
  ASSERT_EQ(points.size(), user.session().WholeMotion().value()->frames.size());
  const JointIndex elbow = *user.session().figure().FindJoint("r_elbow_flexion");
  for (const auto& [frame, torque] : points) {
    const FrameEffort* effort = user.editor().effort.At(static_cast<int>(frame));
    ASSERT_NE(effort, nullptr);
    EXPECT_EQ(torque, effort->tau[elbow.value()]);
    EXPECT_GE(torque, layout.torque->values.low);
    EXPECT_LE(torque, layout.torque->values.high);
  }
  Toggle();
  EXPECT_FALSE(Layout().torque);
  EXPECT_EQ(Layout().frame.tracks.h, whole);
}

TEST_F(TorqueGraph, TheBandIsWhatMusclesCanGive) {
  Toggle();
  const ui::TorquePanel panel = *Layout().torque;
  const Figure& figure = user.session().figure();
  const JointIndex elbow = *figure.FindJoint("r_elbow_flexion");
  EXPECT_EQ(panel.band_of, elbow);
  const Motion& motion = *user.session().WholeMotion().value();
  ASSERT_EQ(panel.band.size(), motion.frames.size());
  for (size_t i = 0; i < panel.band.size(); ++i) {
    const MotionLimit& at = motion.frames[i].after;
    const StrengthLimits limits =
        figure.joint(elbow).strength->At(at.q[elbow.value()], at.qd[elbow.value()]);
    EXPECT_EQ(panel.band[i].high, limits.positive.torque);
    EXPECT_EQ(panel.band[i].low, -limits.negative.torque);
  }
}

TEST_F(TorqueGraph, ASpringsShareNarrowsTheBandInItsFrames) {
  Toggle();
  user.editor().Do("drive.add", {{"region", user.project().regions[0].name},
                                 {"kind", "spring"},
                                 {"joints", {"r_elbow"}},
                                 {"strength", 0.25}});
  user.Wait();
  const Animation& animation = *user.session().animation();
  const JointIndex elbow = *user.session().figure().FindJoint("r_elbow_flexion");
  EXPECT_EQ(ui::MuscleShareAt(animation, elbow, 4.0), 1.0);
  EXPECT_EQ(ui::MuscleShareAt(animation, elbow, 5.0), 0.25);
  EXPECT_EQ(ui::MuscleShareAt(animation, elbow, 15.0), 1.0);
  // A spring changes the rate with which the elbow arrives. The strength is that at the new rate.
  const MotionLimit& start = user.session().WholeMotion().value()->frames[5].after;
  const StrengthLimits whole = user.session().figure().joint(elbow).strength->At(
      start.q[elbow.value()], start.qd[elbow.value()]);
  const ui::StrengthBand band = Layout().torque->band[5];
  EXPECT_DOUBLE_EQ(band.high, 0.25 * whole.positive.torque);
  EXPECT_DOUBLE_EQ(band.low, -0.25 * whole.negative.torque);
  EXPECT_GT(band.high, 0.0);
}

TEST_F(TorqueGraph, UnderTheMouseItSaysTorqueAndShare) {
  Toggle();
  const ui::GraphLayout layout = Layout();
  const ui::Point at = {layout.frame.axis.XOf(12.2), layout.torque->rect.y + 20.0f};
  EXPECT_EQ(ui::HitGraph(layout, at).part, ui::GraphPart::kTorque);
  const std::string text = ui::TorqueTextAt(user.editor().effort, layout, at);
  EXPECT_TRUE(text.starts_with("r_elbow_flexion   frame 12   ")) << text;
  EXPECT_TRUE(text.ends_with(" % of its strength")) << text;
}

TEST_F(TorqueGraph, CurvesOfTheRootHaveNone) {
  Toggle();
  user.session().set_selected_joints({user.session().figure().root_name()});
  user.Wait();
  EXPECT_TRUE(Layout().torque->curves.empty());
  EXPECT_FALSE(Layout().torque->band_of);
}

}  // namespace
}  // namespace hazumi::test
