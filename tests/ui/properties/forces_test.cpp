// Forces from outside among the scene's properties, by the mouse.

#include "tests/ui/user.h"
#include "ui/panels/window/layout.h"
#include "ui/panels/window/panels.h"

namespace hazumi::test {
namespace {

class Forces : public testing::Test {
 protected:
  static constexpr int kWidth = 600, kHeight = 900;
  // In the panel, of the heading; rows are so far apart [px].
  static constexpr float kHeading = 301.0f, kRow = 21.0f;

  Forces() : user("throw.kfa", {kWidth, kHeight}) {
    user.editor().settings.shares.side = 0.6;
    user.editor().settings.shares.outliner = 0.05;
    user.editor().side.section = ui::Section::kScene;
    user.Wait();
  }

  const std::vector<ProjectForce>& forces() { return user.project().forces; }
  ui::Rect Panel() {
    const ui::Rect window = {0.0f, 0.0f, kWidth, kHeight};
    return ui::LayOutWindow(window, user.editor().settings.shares, 1.0).properties;
  }
  const WindForce* Wind() {
    for (const ProjectForce& force : forces()) {
      if (const auto* wind = std::get_if<WindForce>(&force.action)) return wind;
    }
    return nullptr;
  }

  void ClickHeading() {
    const ui::Rect panel = Panel();
    user.Click({panel.x + 0.5f * panel.w, panel.y + kHeading});
  }

  // Clicks, or drags to the right by so much, down the panel at a share of its width, from a
  // row below the heading on, until something is so; what else that did is undone.
  template <typename Condition>
  bool Try(float share, float by, int row, Condition is_done) {
    const ui::Rect panel = Panel();
    const std::string text = user.text();
    const float x = panel.x + share * panel.w;
    for (;; ++row) {
      const float y = panel.y + kHeading + kRow * static_cast<float>(row);
      if (y >= panel.bottom()) return false;
      by == 0.0f ? user.Click({x, y}) : user.Drag({x, y}, {x + by, y});
      if (is_done()) return true;
      while (user.text() != text && user.editor().Do("edit.undo")) continue;
      if (user.editor().has_tool()) user.editor().DropTool();
    }
  }

  User user;
};

TEST_F(Forces, WindIsAddedChangedRemovedAndAllOfItIsUndone) {
  const std::string before = user.text();
  const size_t steps = user.num_steps();
  ClickHeading();
  ASSERT_TRUE(Try(0.2f, 0.0f, 1, [&] { return Wind() != nullptr; }));
  EXPECT_EQ(user.num_steps(), steps + 1);
  // It is open: its velocity is dragged.
  const Vec3 velocity = Wind()->velocity;
  user.Wait();
  ASSERT_TRUE(Try(0.7f, 40.0f, 4, [&] { return Wind() && Wind()->velocity != velocity; }));
  EXPECT_EQ(user.num_steps(), steps + 2);
  const Vec3 faster = Wind()->velocity;
  user.editor().Do("edit.undo");
  EXPECT_EQ(Wind()->velocity, velocity);
  user.editor().Do("edit.redo");
  EXPECT_EQ(Wind()->velocity, faster);
  user.Wait();
  ASSERT_TRUE(Try(0.5f, 0.0f, 9, [&] { return forces().empty(); }));
  while (user.text() != before && user.editor().Do("edit.undo")) continue;
  EXPECT_EQ(user.text(), before);
}

TEST_F(Forces, WhatIsAddedIsOpenedInThePanel) {
  user.editor().Do("time.frame", {{"frame", 8}});
  ASSERT_TRUE(user.editor().Do("force.add", {{"kind", "push"}, {"joint", "r_wrist"}}));
  EXPECT_TRUE(user.editor().side.added.is_valid());
  user.Wait();
  EXPECT_FALSE(user.editor().side.added.is_valid());
}

}  // namespace
}  // namespace hazumi::test
