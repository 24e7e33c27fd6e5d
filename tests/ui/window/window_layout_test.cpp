#include <gtest/gtest.h>

#include <vector>

#include "ui/panels/window/layout.h"

namespace hazumi::test {
namespace {

using namespace ui;

std::vector<Rect> Parts(const WindowLayout& layout) {
  return {layout.menu,     layout.viewport,   layout.timeline, layout.sheet,
          layout.outliner, layout.properties, layout.status};
}

bool Overlap(const Rect& a, const Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(WindowLayout, PanelsLieInTheWindowAndDoNotOverlap) {
  for (const double scale : {0.75, 1.0, 2.0}) {
    for (const Rect& window :
         {Rect{0, 0, 1280, 800}, Rect{0, 0, 3840, 2160}, Rect{0, 0, 700, 500}}) {
      const std::vector<Rect> parts = Parts(LayOutWindow(window, {}, scale));
      for (size_t i = 0; i < parts.size(); ++i) {
        EXPECT_GE(parts[i].x, 0.0f);
        EXPECT_LE(parts[i].right(), window.w);
        EXPECT_LE(parts[i].bottom(), window.h);
        for (size_t j = 0; j < i; ++j) EXPECT_FALSE(Overlap(parts[i], parts[j])) << i << " " << j;
      }
    }
  }
}

TEST(WindowLayout, ASplitterFollowsTheMouse) {
  const Rect window = {0, 0, 1280, 800};
  const WindowLayout before = LayOutWindow(window, {}, 1.0);
  const Point grip = {before.viewport.right() + 1.0f, 300.0f};
  ASSERT_EQ(SplitterAt(before, grip, 1.0), Splitter::kSide);
  const Shares shares = DragSplitter(window, {}, Splitter::kSide, {900.0f, 300.0f}, 1.0);
  const WindowLayout after = LayOutWindow(window, shares, 1.0);
  EXPECT_NEAR(after.outliner.x, 900.0f, 1.0f);
  const Shares lower = DragSplitter(window, {}, Splitter::kBottom, {300.0f, 600.0f}, 1.0);
  EXPECT_NEAR(LayOutWindow(window, lower, 1.0).timeline.y, 604.0f, 2.0f);
}

TEST(WindowLayout, TheSideHasRoomForItsLabelsAtAnyScale) {
  for (const double scale : {1.0, 1.5}) {
    for (const Rect& window : {Rect{0, 0, 1280, 800}, Rect{0, 0, 1024, 640}}) {
      EXPECT_GE(LayOutWindow(window, {}, scale).properties.w, 220.0 * scale);
    }
  }
}

TEST(WindowLayout, NoSplitterMakesAPanelVanish) {
  const Rect window = {0, 0, 1280, 800};
  for (const Splitter splitter : {Splitter::kSide, Splitter::kBottom, Splitter::kOutliner}) {
    for (const Point to : {Point{-500, -500}, Point{5000, 5000}}) {
      const Shares shares = DragSplitter(window, {}, splitter, to, 1.0);
      for (const Rect& part : Parts(LayOutWindow(window, shares, 1.0))) {
        EXPECT_GE(part.w, 100.0f);
        EXPECT_GE(part.h, 20.0f);
      }
    }
  }
}

// Rows of a panel at the right, of a menu, of a dialog, a button above the viewport, all of a
// sheet.
TEST(TooltipPlace, CoversNeitherItsItemNorWhatIsAroundIt) {
  const Rect screen = {0, 0, 1280, 800}, side = {960, 24, 320, 700}, menu = {200, 24, 220, 400};
  const Rect dialog = {440, 300, 400, 120}, viewport = {0, 24, 956, 500};
  const Point size = {300, 60};
  const auto placed = [&](const Rect& item, const Rect& window) {
    const Point at = TooltipPlace(item, window, {item.x + 3.0f, item.y + 3.0f}, size, screen, 1.0);
    const Rect tip = {at.x, at.y, size.x, size.y};
    EXPECT_TRUE(at.x >= 0.0f && tip.right() <= 1280.0f && at.y >= 0.0f && tip.bottom() <= 800.0f);
    EXPECT_FALSE(Overlap(tip, item));
    return tip;
  };
  EXPECT_FALSE(Overlap(placed({970, 300, 300, 20}, side), side));
  EXPECT_FALSE(Overlap(placed({970, 700, 300, 20}, side), side));
  EXPECT_FALSE(Overlap(placed({204, 100, 210, 20}, menu), menu));
  EXPECT_FALSE(Overlap(placed({740, 390, 90, 20}, dialog), dialog));
  EXPECT_GE(placed({400, 30, 60, 20}, viewport).y, 50.0f);
  EXPECT_LE(placed({400, 780, 60, 20}, {0, 776, 1280, 24}).bottom(), 780.0f);
  const Rect sheet = {0, 560, 956, 220};
  const Point mouse = {500, 600};
  const Point at = TooltipPlace(sheet, sheet, mouse, size, screen, 1.0);
  EXPECT_TRUE(at.y > mouse.y && at.y < mouse.y + 40.0f);
}

}  // namespace
}  // namespace hazumi::test
