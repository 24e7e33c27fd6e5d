#include "ui/panels/sheet/frame.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

namespace {

constexpr double kRuler = 24.0, kMarkers = 17.0, kSound = 30.0, kNames = 150.0;  // at scale 1 [px]

float Whole(double x) { return static_cast<float>(std::round(x)); }

}  // namespace

SheetFrame LayOutSheetFrame(const edit::Session& session, const SheetState& state, const Rect& rect,
                            double scale) {
  SheetFrame frame;
  frame.rect = rect;
  frame.scale = scale;
  const float ruler = Whole(kRuler * scale);
  const float markers = session.project().markers.empty() ? 0.0f : Whole(kMarkers * scale);
  const float names = std::min(Whole(kNames * scale), Whole(0.4 * rect.w));
  const float sound = session.project().audio ? Whole(kSound * scale) : 0.0f;
  const float top = std::min(rect.h, ruler + markers + sound), width = rect.w - names;
  frame.corner = {rect.x, rect.y, names, std::min(top, ruler + markers)};
  frame.ruler = {rect.x + names, rect.y, width, ruler};
  frame.markers = {rect.x + names, rect.y + ruler, width, markers};
  frame.sound = {rect.x + names, rect.y + ruler + markers, width, sound};
  frame.names = {rect.x, rect.y + top, names, rect.h - top};
  frame.tracks = {rect.x + names, rect.y + top, width, rect.h - top};
  frame.axis = {state.first, state.last, frame.tracks.x, std::max(1.0f, width)};
  return frame;
}

std::vector<EventMark> EventMarks(const Motion& motion, const SheetFrame& frame) {
  std::vector<EventMark> marks;
  for (const MotionEvent& event : motion.events) {
    const double at = event.time / motion.rate.SecondsAt(1.0);
    const double last = event.last_time / motion.rate.SecondsAt(1.0);
    if (at < frame.axis.first || at > frame.axis.last) continue;
    const float y = frame.ruler.bottom() - static_cast<float>(5.0 * frame.scale);
    marks.push_back({event.kind,
                     {frame.axis.XOf(at), y},
                     at,
                     event.joint,
                     event.count,
                     last,
                     event.link,
                     event.on});
  }
  return marks;
}

const EventMark* EventMarkAt(const std::vector<EventMark>& marks, Point p, double scale) {
  const float reach = static_cast<float>(5.0 * scale);
  for (const EventMark& mark : marks) {
    if (std::abs(p.x - mark.at.x) <= reach && std::abs(p.y - mark.at.y) <= reach) return &mark;
  }
  return nullptr;
}

std::vector<SinkingMark> SinkingMarks(const std::vector<Sinking>& sinkings,
                                      const SheetFrame& frame) {
  std::vector<SinkingMark> marks;
  const float high = Whole(6.0 * frame.scale), half = Whole(3.0 * frame.scale);
  for (const Sinking& sinking : sinkings) {
    if (sinking.last < frame.axis.first || sinking.first > frame.axis.last) continue;
    const float left = frame.axis.XOf(sinking.first) - half;
    const float right = frame.axis.XOf(sinking.last) + half;
    marks.push_back({{left, frame.ruler.bottom() - high, right - left, high}, sinking});
  }
  return marks;
}

const SinkingMark* SinkingMarkAt(const std::vector<SinkingMark>& marks, Point p, double scale) {
  const float reach = Whole(2.0 * scale);
  for (const SinkingMark& mark : marks) {
    const Rect& rect = mark.rect;
    if (p.x < rect.x || p.x > rect.right()) continue;
    if (p.y >= rect.y - reach && p.y <= rect.bottom()) return &mark;
  }
  return nullptr;
}

std::vector<FlightMark> FlightMarks(const std::vector<Flight>& flights, const SheetFrame& frame) {
  std::vector<FlightMark> marks;
  const float high = Whole(9.0 * frame.scale);
  for (const Flight& flight : flights) {
    if (flight.landing < frame.axis.first || flight.take_off > frame.axis.last) continue;
    const float left = frame.axis.XOf(flight.take_off), right = frame.axis.XOf(flight.landing);
    const Rect rect = {left, frame.ruler.bottom() - high, right - left, high};
    marks.push_back({rect, {frame.axis.XOf(flight.apex), rect.y}, flight});
  }
  return marks;
}

const FlightMark* FlightMarkAt(const std::vector<FlightMark>& marks, Point p, double scale) {
  const float reach = Whole(2.0 * scale);
  for (const FlightMark& mark : marks) {
    const Rect& rect = mark.rect;
    if (p.x < rect.x - reach || p.x > rect.right() + reach) continue;
    if (p.y >= rect.y - reach && p.y <= rect.bottom()) return &mark;
  }
  return nullptr;
}

Rect MarkerName(const ProjectMarker& marker, const SheetFrame& frame) {
  const float left = frame.axis.XOf(marker.frame) + static_cast<float>(7.0 * frame.scale);
  return {left, frame.markers.y, static_cast<float>(160.0 * frame.scale), frame.markers.h};
}

int MarkerAt(const edit::Session& session, const SheetFrame& frame, Point p) {
  if (!frame.markers.Contains(p)) return -1;
  const std::vector<ProjectMarker>& markers = session.project().markers;
  for (size_t i = 0; i < markers.size(); ++i) {
    const double away = p.x - frame.axis.XOf(markers[i].frame);
    if (std::abs(away) <= 7.0 * frame.scale) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace hazumi::ui
