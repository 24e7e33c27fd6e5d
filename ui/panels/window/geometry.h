#pragma once

namespace hazumi::ui {

// Of the window [px]: x to the right, y downwards from the upper left corner.
struct Point {
  float x = 0.0f, y = 0.0f;
};

struct Rect {
  float x = 0.0f, y = 0.0f, w = 0.0f, h = 0.0f;

  float right() const { return x + w; }
  float bottom() const { return y + h; }
  bool Contains(Point p) const { return p.x >= x && p.x < right() && p.y >= y && p.y < bottom(); }
  bool operator==(const Rect&) const = default;
};

}  // namespace hazumi::ui
