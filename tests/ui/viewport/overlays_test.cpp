#include "ui/panels/viewport/overlays.h"

#include <gtest/gtest.h>

#include "tests/ui/user.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::test {
namespace {

using ui::GhostFrames;
using ui::ViewportOverlays;

TEST(GhostFrames, AreCountedFromTheCurrentOneAndStayInTheAnimation) {
  ViewportOverlays overlays{.ghosts = true, .ghost_every = 4};
  overlays.ghosts_before = 9, overlays.ghosts_after = 4;
  EXPECT_EQ(GhostFrames(overlays, 10, 30, {}), (std::vector<int>{2, 6, 14}));
  EXPECT_EQ(GhostFrames(overlays, 1, 4, {}), (std::vector<int>{}));
  overlays.ghosts_at_keys = true;
  EXPECT_EQ(GhostFrames(overlays, 10, 30, {0, 3, 10, 14, 15}), (std::vector<int>{3, 14}));
  overlays.ghosts = false;
  EXPECT_EQ(GhostFrames(overlays, 10, 30, {0, 3, 10}), (std::vector<int>{}));
}

struct Seen {
  size_t skins, capsules;
};

Seen SeenBy(User* user) {
  const auto scene = ui::SceneNow(&user->editor(), {0, 0, 400, 300});
  EXPECT_TRUE(scene.ok());
  if (!scene.ok()) return {};
  return {scene.value().scene.skins.size(), scene.value().scene.capsules.size()};
}

size_t SkinsSeen(User* user) { return SeenBy(user).skins; }

TEST(Ghosts, AreChosenByTheirMenuAndSeen) {
  User user("throw.kfa");
  user.editor().Do("time.frame", {{"frame", 10}});
  ASSERT_EQ(SkinsSeen(&user), 1u);
  user.editor().Do("view.ghosts", {{"before", 5}, {"after", 3}, {"every", 1}});
  EXPECT_EQ(SkinsSeen(&user), 9u);
  user.editor().Do("view.ghosts", {{"at_keys", true}});
  EXPECT_EQ(SkinsSeen(&user), 5u);  // F5, F7, F9, F12
  user.editor().Do("view.overlay", {{"name", "ghosts"}});
  EXPECT_EQ(SkinsSeen(&user), 1u);
  user.editor().Do("view.overlay", {{"name", "keyed"}});
  EXPECT_GT(SeenBy(&user).capsules, 5u);  // of the arms, which swing
  user.editor().Do("time.frame", {{"frame", 2}});
  EXPECT_EQ(SeenBy(&user).capsules, 0u);
}

TEST(Ghosts, OfNoFramesAreRefused) {
  User user("throw.kfa");
  EXPECT_FALSE(user.editor().Invoke("view.ghosts", {{"every", 0}}).ok());
  EXPECT_FALSE(user.editor().viewport.overlays.ghosts);
}

}  // namespace
}  // namespace hazumi::test
