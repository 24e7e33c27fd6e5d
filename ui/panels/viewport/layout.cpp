#include "ui/panels/viewport/layout.h"

#include <algorithm>

namespace hazumi::ui {

std::vector<Rect> LayOutToggles(const Rect& viewport, const std::vector<float>& widths,
                                float height, double scale) {
  const auto gap = static_cast<float>(4.0 * scale), edge = static_cast<float>(8.0 * scale);
  std::vector<Rect> rects;
  float y = viewport.y + edge;
  for (size_t begin = 0; begin < widths.size();) {
    size_t end = begin;
    float row = 0.0f;
    while (end < widths.size() &&
           (end == begin || row + gap + widths[end] <= viewport.w - 2 * edge)) {
      row += widths[end] + (end == begin ? 0.0f : gap);
      ++end;
    }
    float x = viewport.right() - edge - row;
    for (; begin < end; ++begin) {
      rects.push_back({x, y, widths[begin], height});
      x += widths[begin] + gap;
    }
    y += height + gap;
  }
  return rects;
}

AxisCross LayOutAxisCross(const View& view, double scale) {
  const double arm = 26.0 * scale, edge = 44.0 * scale;
  AxisCross cross;
  cross.center = {static_cast<float>(view.rect().x + edge),
                  static_cast<float>(view.rect().bottom() - edge)};
  for (int i = 0; i < 3; ++i) {
    cross.axes[i] = {i,
                     {static_cast<float>(cross.center.x + arm * view.right()[i]),
                      static_cast<float>(cross.center.y - arm * view.up()[i])},
                     view.back()[i]};
  }
  std::sort(cross.axes.begin(), cross.axes.end(),
            [](const CrossAxis& a, const CrossAxis& b) { return a.near < b.near; });
  return cross;
}

}  // namespace hazumi::ui
