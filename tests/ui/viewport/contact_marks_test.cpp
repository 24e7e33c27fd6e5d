// What pushes where a region touches the scene, in the viewport.

#include "ui/panels/viewport/contact_marks.h"

#include "tests/ui/viewport/objects.h"
#include "ui/panels/viewport/acting.h"

namespace hazumi::test {
namespace {

// The right arm swings down and comes to lie on a table.
class ContactMarks : public Objects {
 protected:
  ContactMarks() {
    Do("key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 100}});
    Do("object.add_box", {{"name", "table"}, {"x", 0.5}, {"y", -0.2}, {"z", 0.5}, {"size_x", 0.6}});
    Do("region.add", {{"name", "arm"},
                      {"joints", {"r_shoulder+"}},
                      {"first", 0},
                      {"last", 30},
                      {"contacts", true}});
  }
  std::vector<ui::ContactMark> MarksAt(int frame) {
    Do("time.frame", {{"frame", frame}});
    const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
    return ui::ContactMarks(*user.session().animation(), figure);
  }
};

TEST_F(ContactMarks, WhatTouchesIsPushedAway) {
  EXPECT_TRUE(MarksAt(1).empty());
  const std::vector<ui::ContactMark> marks = MarksAt(29);
  ASSERT_FALSE(marks.empty());
  for (const ui::ContactMark& mark : marks) {
    EXPECT_GT(mark.to.z(), mark.from.z());
    EXPECT_GT(mark.force, 0.0);
  }
  const std::string said = ui::TextOf(marks[0], *user.session().animation());
  EXPECT_NE(said.find(", table: "), std::string::npos) << said;
  EXPECT_TRUE(said.starts_with("r_") && said.ends_with(" N")) << said;
}

TEST_F(ContactMarks, WhatTouchesTheOwnBodyIsPushedAwayByIt) {
  Do("object.remove", {{"object", "table"}});
  Do("key.set", {{"curve", "r_hip_flexion"}, {"frame", 0}, {"value", 80}});
  Do("key.set", {{"curve", "r_hip_abduction"}, {"frame", 0}, {"value", 30}});
  Do("region.set", {{"region", "arm"}, {"contacts_self", true}});
  const std::vector<ui::ContactMark> marks = MarksAt(29);
  ASSERT_GE(marks.size(), 2u);
  Vec3 sum = Vec3::Zero();
  for (const ui::ContactMark& mark : marks) sum += mark.force * (mark.to - mark.from).normalized();
  EXPECT_LT(sum.norm(), 1e-6 * marks[0].force);
  const std::string said = ui::TextOf(marks[0], *user.session().animation());
  EXPECT_NE(said.find(", r_thigh: "), std::string::npos) << said;
}

TEST_F(ContactMarks, WhatABallPushesIsSaidByItsName) {
  Animation animation = *user.session().animation();
  animation.held_objects.emplace_back().name = "ball";
  MotionFrame frame = ui::PoseNow(&user.session()).value().frame();
  ContactPush push;
  push.link = 0;
  push.by_ball = 0;
  push.force = 100.0 * Vec3::UnitZ();
  frame.contacts.pushes = {push};
  const ui::PosedFigure figure(*animation.figure, frame);
  const std::vector<ui::ContactMark> marks = ui::ContactMarks(animation, figure);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_NE(ui::TextOf(marks[0], animation).find(", ball: 100 N"), std::string::npos);
  // The motion may be from before the ball was deleted.
  animation.held_objects.clear();
  EXPECT_TRUE(ui::ContactMarks(animation, figure).empty());
}

TEST_F(ContactMarks, ItSaysSoUnderTheMouseUnlessItIsHidden) {
  const std::vector<ui::ContactMark> marks = MarksAt(29);
  ASSERT_FALSE(marks.empty());
  const ui::PosedFigure figure = ui::PoseNow(&user.session()).value();
  const ui::ViewportState& state = user.editor().viewport;
  const ui::View view = ui::ViewOf(state, user.project(), state.rect);
  const ui::Point middle = InWindow(0.5 * (marks[0].from + marks[0].to));
  const auto said = [&] { return ui::ActingAt(&user.editor(), view, figure, middle); };
  EXPECT_NE(said().find(", table: "), std::string::npos) << said();
  user.Wait();
  const std::vector<uint8_t> shown = user.picture();
  Do("view.overlay", {{"name", "forces"}, {"on", false}});
  user.Wait();
  EXPECT_EQ(said(), "");
  EXPECT_NE(user.picture(), shown);
}

}  // namespace
}  // namespace hazumi::test
