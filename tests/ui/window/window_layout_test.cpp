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

}  // namespace
}  // namespace hazumi::test
