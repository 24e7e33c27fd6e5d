#pragma once

#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// The buttons and fields of the timeline's header.
struct TimelineLayout {
  Rect sheet;  // dope sheet or graph editor
  Rect to_first, previous_key, play, next_key, to_last;
  Rect rate;                     // frames per second shown, while it plays
  Rect frame, first, last, fps;  // fields, with their labels inside
};
// `scale`: of the interface. What has no room on the right is empty.
TimelineLayout LayOutTimeline(const Rect& rect, double scale);

}  // namespace hazumi::ui
