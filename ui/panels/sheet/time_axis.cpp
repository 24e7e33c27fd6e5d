#include "ui/panels/sheet/time_axis.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

namespace {

constexpr double kFewest = 2.0, kMost = 1e5;  // frames that are seen

// 1, 2 or 5 times a power of ten, not less than `least`.
double RoundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

int FrameStep(const TimeAxis& axis, double min_px) {
  const double least = std::max(1.0, min_px / axis.px_per_frame());
  return static_cast<int>(std::lround(RoundStep(least)));
}

std::vector<Tick> FrameTicks(const TimeAxis& axis, double min_px) {
  const int major = FrameStep(axis, min_px);
  // Lines between the numbers as far as they do not crowd.
  constexpr double kMinorPx = 7.0;
  const int minor = std::min(major, FrameStep(axis, kMinorPx));
  std::vector<Tick> ticks;
  const long begin = static_cast<long>(std::ceil(axis.first / minor));
  const long end = static_cast<long>(std::floor(axis.last / minor));
  for (long i = begin; i <= end; ++i) ticks.push_back({double(i * minor), i * minor % major == 0});
  return ticks;
}

std::vector<Tick> ValueTicks(double low, double high, double px, double min_px) {
  std::vector<Tick> ticks;
  if (high <= low || px <= 0.0) return ticks;
  const double step = RoundStep(min_px * (high - low) / px);
  const double begin = std::ceil(low / step), end = std::floor(high / step);
  for (double i = begin; i <= end; ++i) ticks.push_back({i * step, true});
  return ticks;
}

TimeAxis Zoomed(const TimeAxis& axis, float about_px, double factor) {
  const double about = axis.FrameAt(about_px), seen = axis.last - axis.first;
  const double now = std::clamp(seen / factor, kFewest, kMost);
  TimeAxis next = axis;
  next.first = about - (about - axis.first) * now / seen;
  next.last = next.first + now;
  return next;
}

TimeAxis Showing(const TimeAxis& axis, double first, double last) {
  const double seen = std::max(last - first, kFewest);
  const double room = std::max(1.0, 0.04 * seen);
  TimeAxis next = axis;
  next.first = 0.5 * (first + last - seen) - room;
  next.last = 0.5 * (first + last + seen) + room;
  return next;
}

}  // namespace hazumi::ui
