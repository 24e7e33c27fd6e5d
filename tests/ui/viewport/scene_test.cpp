#include "ui/panels/viewport/scene.h"

#include <gtest/gtest.h>

#include "engine/spatial/degrees.h"
#include "tests/ui/viewport/fixture.h"

namespace hazumi::test {
namespace {

using ui::Refined;
using ui::RefinedMotion;

class RefinedThrow : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(
        session_.Run("file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa"}}).ok());
    motion_ = *session_.WholeMotion().value();
    refined_ = Refined(motion_, 3, 20);
  }

  edit::Session session_;
  Motion motion_;
  RefinedMotion refined_;
};

TEST_F(RefinedThrow, HasItsFramesWhereTheyWere) {
  ASSERT_EQ(refined_.at_frames.size(), 18u);
  for (size_t i = 0; i < refined_.at_frames.size(); ++i) {
    const MotionFrame& frame = refined_.motion.frames[refined_.at_frames[i]];
    EXPECT_EQ(frame.q, motion_.frames[3 + i].q);
    EXPECT_EQ(frame.X_WR.p, motion_.frames[3 + i].X_WR.p);
  }
}

TEST_F(RefinedThrow, HasMorePointsWhereItIsFasterSoThatNoLineIsACorner) {
  for (size_t i = 0; i + 1 < refined_.motion.frames.size(); ++i) {
    const VecX turn = refined_.motion.frames[i + 1].q - refined_.motion.frames[i].q;
    EXPECT_LE(turn.lpNorm<Eigen::Infinity>(), 8.0 * kDegree) << i;
  }
  const auto& at = refined_.at_frames;
  size_t least = 1000, most = 0;
  for (size_t i = 1; i < at.size(); ++i) {
    least = std::min(least, at[i] - at[i - 1]);
    most = std::max(most, at[i] - at[i - 1]);
  }
  EXPECT_GE(most, 2 * least);
}

}  // namespace
}  // namespace hazumi::test

namespace hazumi::ui {
namespace {

using ViewportOfASkin = ViewportFixture;

TEST_F(ViewportOfASkin, NamesATextureThatCannotBeReadOnce) {
  Project project = editor_.session().project();
  Skin skin;
  skin.textures = {{"face.png", {1, 2, 3}}, {"hand.png", {4}}};
  project.skin = {.skin = std::make_shared<const Skin>(std::move(skin))};
  editor_.session().Replace(std::move(project), "");
  editor_.Say("");
  shell_->Frame();
  EXPECT_TRUE(editor_.message.is_error);
  EXPECT_NE(editor_.message.text.find("textures[0] face.png: "), std::string::npos)
      << editor_.message.text;
  EXPECT_NE(editor_.message.text.find(" (+1)"), std::string::npos);
  editor_.Say("");
  editor_.session().set_frame(editor_.session().frame() + 1.0);
  shell_->Frame();
  EXPECT_EQ(editor_.message.text, "");
}

TEST_F(ViewportOfASkin, ShowsTheSkinOrTheCapsules) {
  const auto scene = [&] { return SceneNow(&editor_, editor_.viewport.rect).value().scene; };
  EXPECT_EQ(scene().skins.size(), 1u);
  EXPECT_TRUE(scene().capsules.empty());
  editor_.Do("view.overlay", {{"name", "skin"}});
  EXPECT_TRUE(scene().skins.empty());
  EXPECT_FALSE(scene().capsules.empty());
  editor_.Do("view.overlay", {{"name", "skin"}, {"on", true}});
  EXPECT_EQ(scene().skins.size(), 1u);
}

}  // namespace
}  // namespace hazumi::ui
