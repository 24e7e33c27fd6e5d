#include "ui/panels/sheet/wave.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

std::vector<WaveColumn> WaveColumns(const Peaks& peaks, const ProjectAudio& audio,
                                    const FrameRate& rate, const SheetFrame& frame) {
  const Rect& row = frame.sound;
  const auto seconds_at = [&](float x) {
    return rate.SecondsAt(frame.axis.FrameAt(x) - audio.start_frame);
  };
  const float factor = static_cast<float>(std::pow(10.0, audio.gain_db / 20.0));
  const float middle = row.y + 0.5f * row.h, half = 0.5f * row.h - 1.0f;
  std::vector<WaveColumn> columns;
  for (float x = row.x; x < row.right(); x += 1.0f) {
    const double from = seconds_at(x), to = seconds_at(x + 1.0f);
    if (to <= 0.0 || from >= peaks.seconds()) continue;
    const Peaks::Range range = peaks.In(from, to);
    const float low = std::clamp(factor * range.low, -1.0f, 1.0f);
    const float high = std::clamp(factor * range.high, -1.0f, 1.0f);
    // Silence is a line.
    columns.push_back({x, middle - half * high - 0.5f, middle - half * low + 0.5f});
  }
  return columns;
}

}  // namespace hazumi::ui
