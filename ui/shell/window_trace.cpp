#include "ui/shell/window_trace.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

static double KeptBy(double share, std::vector<double> times) {
  if (times.empty()) return 0.0;
  std::sort(times.begin(), times.end());
  const auto kept = std::lround(std::ceil(share * static_cast<double>(times.size())));
  return times[static_cast<size_t>(std::max(1L, kept) - 1)];
}

void WindowTrace::AddEvent(const Event& event) {
  ++events_;
  if (event.is_typing) typed_.push_back(event.seconds);
  if (!event.has_changed) return;
  changes_.push_back(event.seconds);
  if (event.is_behind) ++behind_;
}

double WindowTrace::TimeOf(double share) const { return KeptBy(share, changes_); }

double WindowTrace::TypingTimeOf(double share) const { return KeptBy(share, typed_); }

void WindowTrace::AddFrame(const Frame& frame) {
  ++frames_;
  passed_over_ += frame.passed_over;
  if (frame.late > frame.seconds) ++late_frames_;
  latest_ = std::max(latest_, frame.late);
}

}  // namespace hazumi::ui
