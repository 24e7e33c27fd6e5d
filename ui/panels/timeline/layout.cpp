#include "ui/panels/timeline/layout.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

TimelineLayout LayOutTimeline(const Rect& rect, double scale) {
  TimelineLayout layout;
  const auto px = [&](double at_1) { return static_cast<float>(std::round(at_1 * scale)); };
  const float h = px(22.0), y = rect.y + std::round(0.5f * (rect.h - h)), gap = px(6.0);
  layout.sheet = {rect.x + gap, y, px(116.0), h};
  // The buttons in the middle, but never over what is beside them.
  const float side = px(28.0), buttons = 5.0f * side;
  const float fields = px(58.0) + 2.0f * px(80.0) + px(86.0) + 4.0f * gap;
  const float left = layout.sheet.right() + 2.0f * gap, right = rect.right() - fields - gap;
  float x =
      std::clamp(rect.x + 0.5f * (rect.w - buttons), left, std::max(left, right - buttons - gap));
  for (Rect* button :
       {&layout.to_first, &layout.previous_key, &layout.play, &layout.next_key, &layout.to_last}) {
    *button = {std::round(x), y, side, h};
    x += side;
  }
  float field = std::max(right, layout.to_last.right() + 2.0f * gap);
  const auto take = [&](double width) {
    const Rect taken = {field, y, px(width), h};
    field = taken.right() + gap;
    return taken.right() <= rect.right() ? taken : Rect();
  };
  layout.frame = take(58.0);
  layout.first = take(80.0);
  layout.last = take(80.0);
  layout.fps = take(86.0);
  const float begin = layout.to_last.right() + gap;
  layout.rate = {begin, y, std::max(0.0f, right - begin - gap), h};
  return layout;
}

}  // namespace hazumi::ui
