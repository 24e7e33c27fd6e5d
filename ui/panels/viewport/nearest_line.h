#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ui/panels/viewport/camera.h"

namespace hazumi::ui {

inline double DistanceToLine(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
  const double t = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// The mark whose line is nearest, null if none is within reach. `line_of`: its two ends.
template <typename Mark, typename LineOf>
const Mark* NearestLine(const View& view, Point at, const std::vector<Mark>& marks, double scale,
                        LineOf line_of) {
  constexpr double kReachPx = 7.0;  // at scale 1
  const Mark* nearest = nullptr;
  double least = kReachPx * scale;
  for (const Mark& mark : marks) {
    const auto [from, to] = line_of(mark);
    const auto a = view.ToWindow(from), b = view.ToWindow(to);
    if (!a || !b || DistanceToLine(at, *a, *b) >= least) continue;
    least = DistanceToLine(at, *a, *b);
    nearest = &mark;
  }
  return nearest;
}

// Of arrows.
template <typename Mark>
const Mark* NearestLine(const View& view, Point at, const std::vector<Mark>& marks, double scale) {
  return NearestLine(view, at, marks, scale,
                     [](const Mark& mark) { return std::pair(mark.from, mark.to); });
}

}  // namespace hazumi::ui
