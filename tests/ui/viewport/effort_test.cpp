// The colours of effort in the viewport.

#include "ui/panels/viewport/effort.h"

#include <algorithm>

#include "tests/ui/user.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::test {
namespace {

bool IsTinted(const render::BoneTint& tint) { return tint.a > 0.0f; }

TEST(Effort, ColoursGoFromGreenToRedAndAreOthersBeyond) {
  const auto red = [](double share) { return ui::EffortColor(share).r - ui::EffortColor(share).g; };
  EXPECT_LT(red(0.0), 0.0f);
  for (double share = 0.05; share <= 1.0; share += 0.05) EXPECT_GT(red(share), red(share - 0.05));
  EXPECT_GT(red(1.0), 0.5f);
  EXPECT_NE(ui::EffortColor(1.01).b, ui::EffortColor(1.0).b);
  EXPECT_EQ(ui::EffortColor(3.0).r, ui::EffortColor(1.01).r);
}

class EffortOverlay : public testing::Test {
 protected:
  EffortOverlay() : user("throw.kfa") {
    user.editor().Do("time.frame", {{"frame", 2}});
    user.Wait();
  }
  void Show() {
    user.editor().Do("view.overlay", {{"name", "effort"}});
    user.Wait();
  }
  const Figure& figure() { return user.session().figure(); }
  render::Scene Scene() {
    return ui::SceneNow(&user.editor(), user.editor().viewport.rect).value().scene;
  }

  User user;
};

TEST_F(EffortOverlay, TintsWhatLiesBeyondJointsByTheLargestShareOfTheirHinges) {
  Show();
  const FrameEffort& effort = *user.editor().effort.At(2);
  const std::vector<render::BoneTint> tints = ui::EffortTints(figure(), effort);
  int num_tinted = 0;
  for (const JointGroup& joint : figure().groups()) {
    const double share = ui::LargestShare(effort, joint.first, joint.size);
    const render::BoneTint& tint = tints[static_cast<size_t>(joint.last().value())];
    EXPECT_EQ(IsTinted(tint), share >= 0.0) << joint.name;
    if (share < 0.0) continue;
    ++num_tinted;
    EXPECT_EQ(tint.r, ui::EffortColor(share).r) << joint.name;
  }
  EXPECT_GT(num_tinted, 10);
}

TEST_F(EffortOverlay, ChangesThePictureAndNotTheDocument) {
  const std::vector<uint8_t> before = user.picture();
  const std::string text = user.text();
  Show();
  EXPECT_NE(user.picture(), before);
  const render::Scene scene = Scene();
  ASSERT_FALSE(scene.skins.empty());
  const std::vector<render::BoneTint>& tints = scene.skins[0].tints;
  EXPECT_TRUE(std::any_of(tints.begin(), tints.end(), IsTinted));
  Show();
  EXPECT_EQ(user.picture(), before);
  EXPECT_EQ(user.text(), text);
}

TEST_F(EffortOverlay, MarksJointsOfWhichMoreIsAskedThanThereIs) {
  Show();
  FrameEffort effort = *user.editor().effort.At(2);
  const JointIndex elbow = *figure().FindJoint("r_elbow_flexion");
  effort.share.setConstant(0.5);
  EXPECT_TRUE(ui::EffortMarks(figure(), effort).empty());
  effort.share[elbow.value()] = 1.3;
  const std::vector<ui::EffortMark> marks = ui::EffortMarks(figure(), effort);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(figure().group(marks[0].joint).name, "r_elbow");
  EXPECT_EQ(marks[0].share, 1.3);
}

TEST_F(EffortOverlay, SaysWhereMostIsAsked) {
  EXPECT_EQ(ui::EffortText(figure(), user.editor().effort, 2), "No torques are known");
  Show();
  const std::string text = ui::EffortText(figure(), user.editor().effort, 2);
  EXPECT_TRUE(text.starts_with("Effort: most at ") && text.ends_with(" %")) << text;
  const GroupIndex elbow = *figure().FindGroup("r_elbow");
  EXPECT_TRUE(ui::EffortOfJoint(user.editor(), elbow).ends_with(" % of its strength"));
}

}  // namespace
}  // namespace hazumi::test
