#pragma once

#include <string>
#include <vector>

#include "ui/edit/session/session.h"
#include "ui/panels/sheet/state.h"
#include "ui/panels/sheet/time_axis.h"
#include "ui/panels/timeline/flight_watch.h"
#include "ui/panels/timeline/key_watch.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// What the dope sheet and the graph editor have in common: names on the left, the ruler above,
// markers and the sound below it, and time from left to right.
struct SheetFrame {
  Rect rect, corner, ruler, markers, sound, names, tracks;
  TimeAxis axis;
  double scale = 1.0;
};
// Markers have a row if there are any, and so has the sound. `scale`: of the interface.
SheetFrame LayOutSheetFrame(const edit::Session& session, const SheetState& state, const Rect& rect,
                            double scale);

// Something that happens, on the ruler.
struct EventMark {
  EventKind kind;
  Point at;
  double frame = 0.0;
  std::string joint;  // may be empty
  long count = 1;     // of times that it happens, as MotionEvent
  double last_frame = 0.0;
  std::string link, on;  // bodies of a touch-down, as in MotionEvent
};
std::vector<EventMark> EventMarks(const Motion& motion, const SheetFrame& frame);
// The one under a point, or null.
const EventMark* EventMarkAt(const std::vector<EventMark>& marks, Point p, double scale);

// Frames in which the figure is in the ground, on the lower edge of the ruler.
struct SinkingMark {
  Rect rect;
  Sinking sinking;
};
std::vector<SinkingMark> SinkingMarks(const std::vector<Sinking>& sinkings,
                                      const SheetFrame& frame);
const SinkingMark* SinkingMarkAt(const std::vector<SinkingMark>& marks, Point p, double scale);

// A flight that was found, as the arc of its parabola over the ruler.
struct FlightMark {
  Rect rect;  // from take-off to landing
  Point apex;
  Flight flight;
};
std::vector<FlightMark> FlightMarks(const std::vector<Flight>& flights, const SheetFrame& frame);
const FlightMark* FlightMarkAt(const std::vector<FlightMark>& marks, Point p, double scale);

// Where the name of a marker is written.
Rect MarkerName(const ProjectMarker& marker, const SheetFrame& frame);
// The marker whose sign is under a point, or -1.
int MarkerAt(const edit::Session& session, const SheetFrame& frame, Point p);

}  // namespace hazumi::ui
