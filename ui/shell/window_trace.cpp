#include "ui/shell/window_trace.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

void WindowTrace::AddEvent(const Event& event) {
  ++events_;
  if (!event.has_changed) return;
  changes_.push_back(event.seconds);
  if (event.is_behind) ++behind_;
}

double WindowTrace::TimeOf(double share) const {
  if (changes_.empty()) return 0.0;
  std::vector<double> sorted = changes_;
  std::sort(sorted.begin(), sorted.end());
  const auto kept = std::lround(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[static_cast<size_t>(std::max(1L, kept) - 1)];
}

void WindowTrace::AddFrame(const Frame& frame) {
  ++frames_;
  passed_over_ += frame.passed_over;
  if (frame.late > frame.seconds) ++late_frames_;
  latest_ = std::max(latest_, frame.late);
}

}  // namespace hazumi::ui
