#pragma once

#include <vector>

#include "engine/media/peaks.h"
#include "ui/panels/sheet/frame.h"

namespace hazumi::ui {

// A sound as columns of a pixel, from left to right: where each begins and ends.
struct WaveColumn {
  float x = 0.0f, top = 0.0f, bottom = 0.0f;  // [px]
};
// Of the columns that the sound reaches, in the sheet's row for it. Its gain counts; what is louder
// than the row is high is cut off.
std::vector<WaveColumn> WaveColumns(const Peaks& peaks, const ProjectAudio& audio,
                                    const FrameRate& rate, const SheetFrame& frame);

}  // namespace hazumi::ui
