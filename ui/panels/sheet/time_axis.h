#pragma once

#include <vector>

namespace hazumi::ui {

// Frames from left to right: which of them are seen, and where [px].
struct TimeAxis {
  double first = 0.0, last = 1.0;  // frames at the left and the right edge
  float x = 0.0f, w = 1.0f;        // the left edge and the width [px]

  double px_per_frame() const { return w / (last - first); }
  float XOf(double frame) const { return x + static_cast<float>((frame - first) * px_per_frame()); }
  double FrameAt(float px) const { return first + (px - x) / px_per_frame(); }
};

// A line of the ruler or a grid.
struct Tick {
  double value = 0.0;
  bool is_major = false;  // has a number
};

// Frames between two numbers of the ruler: 1, 2, 5, 10, 20 and so on, at least `min_px` apart.
int FrameStep(const TimeAxis& axis, double min_px);
// Lines at whole frames; those with numbers are at least `min_px` apart.
std::vector<Tick> FrameTicks(const TimeAxis& axis, double min_px);
// The same for values: steps of 1, 2 and 5 times a power of ten, all with numbers.
std::vector<Tick> ValueTicks(double low, double high, double px, double min_px);

// Zoomed about a place that stays; factor > 1 shows fewer frames. No closer than 2 frames and no
// farther than a hundred thousand.
TimeAxis Zoomed(const TimeAxis& axis, float about_px, double factor);
// All frames of [first, last] with some room beside them.
TimeAxis Showing(const TimeAxis& axis, double first, double last);

}  // namespace hazumi::ui
