#include "ui/panels/window/layout.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

namespace {

constexpr double kMenu = 24.0, kStatus = 24.0, kTimeline = 30.0;  // heights at scale 1 [px]
constexpr double kGap = 4.0;                                      // between panels
constexpr double kSide = 220.0;     // least width of the side, which its labels need
constexpr double kMostSide = 0.33;  // of the window's width, for that

float Whole(double x) { return static_cast<float>(std::round(x)); }

}  // namespace

Rect LeastWindow(const Rect& size, double scale) {
  return {size.x, size.y, std::max(size.w, Whole(kLeastWidth * scale)),
          std::max(size.h, Whole(kLeastHeight * scale))};
}

WindowLayout LayOutWindow(const Rect& size, const Shares& shares, double scale) {
  WindowLayout layout;
  const float menu = Whole(kMenu * scale), status = Whole(kStatus * scale);
  const float timeline = Whole(kTimeline * scale), gap = Whole(kGap * scale);
  const float height = std::max(0.0f, size.h - menu - status);
  const double least = std::min(kSide * scale, kMostSide * size.w);
  const float side = Whole(std::max(size.w * shares.side, least));
  const float left = std::max(0.0f, size.w - side - gap);
  const float sheet = Whole(height * shares.bottom);
  const float top = std::max(0.0f, height - sheet - timeline - gap);
  layout.menu = {0.0f, 0.0f, size.w, menu};
  layout.viewport = {0.0f, menu, left, top};
  layout.timeline = {0.0f, menu + top + gap, left, timeline};
  layout.sheet = {0.0f, layout.timeline.bottom(), left, sheet};
  const float outliner = Whole(height * shares.outliner);
  layout.outliner = {left + gap, menu, side, outliner};
  layout.properties = {left + gap, menu + outliner + gap, side,
                       std::max(0.0f, height - outliner - gap)};
  layout.status = {0.0f, size.h - status, size.w, status};
  return layout;
}

std::optional<Splitter> SplitterAt(const WindowLayout& layout, Point p, double scale) {
  const float gap = Whole(kGap * scale);
  const Rect& view = layout.viewport;
  const Rect side = {view.right(), view.y, gap, layout.status.y - view.y};
  const Rect bottom = {0.0f, view.bottom(), view.w, gap};
  const Rect outliner = {layout.outliner.x, layout.outliner.bottom(), layout.outliner.w, gap};
  if (side.Contains(p)) return Splitter::kSide;
  if (bottom.Contains(p)) return Splitter::kBottom;
  if (outliner.Contains(p)) return Splitter::kOutliner;
  return std::nullopt;
}

Point TooltipPlace(const Rect& item, const Rect& window, Point mouse, Point size,
                   const Rect& screen, double scale) {
  const float gap = Whole(6.0 * scale), far = Whole(320.0 * scale), high = Whole(80.0 * scale);
  const auto within = [&](Point p) -> Point {
    return {std::clamp(p.x, screen.x, std::max(screen.x, screen.right() - size.x)),
            std::clamp(p.y, screen.y, std::max(screen.y, screen.bottom() - size.y))};
  };
  if (item.h <= high) {
    const bool fits_right = window.right() + gap + size.x <= screen.right();
    if (fits_right && window.right() - item.right() <= far) {
      return within({window.right() + gap, item.y});
    }
    const bool fits_left = window.x - gap - size.x >= screen.x;
    if (fits_left && item.x - window.x <= far) return within({window.x - gap - size.x, item.y});
  }
  const float left = std::max(item.x, mouse.x - 0.5f * size.x);
  const Rect from = item.h <= high ? Rect{left, item.y, 0.0f, item.h}
                                   : Rect{mouse.x + 2.0f * gap, mouse.y, 0.0f, 3.0f * gap};
  const bool fits_below = from.bottom() + gap + size.y <= screen.bottom();
  return within({from.x, fits_below ? from.bottom() + gap : from.y - gap - size.y});
}

Shares DragSplitter(const Rect& size, const Shares& shares, Splitter splitter, Point to,
                    double scale) {
  Shares next = shares;
  const WindowLayout layout = LayOutWindow(size, shares, scale);
  const double height = std::max(1.0f, layout.status.y - layout.menu.bottom());
  switch (splitter) {
    case Splitter::kSide:
      next.side = std::clamp(1.0 - to.x / std::max(1.0, double{size.w}), 0.12, 0.5);
      break;
    case Splitter::kBottom: {
      const double sheet = layout.status.y - to.y - layout.timeline.h - kGap * scale;
      next.bottom = std::clamp(sheet / height, 0.12, 0.75);
      break;
    }
    case Splitter::kOutliner:
      next.outliner = std::clamp((to.y - layout.menu.bottom()) / height, 0.1, 0.8);
      break;
  }
  return next;
}

}  // namespace hazumi::ui
