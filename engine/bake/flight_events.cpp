// A figure that stands on a pin, is keyed for the few frames until it is off the ground, and falls
// freely from then on: gravity finds it in the air and knows nothing of a take-off. It comes down
// onto the next pin as its span ends, faster than its own pin would let it, which for that instant
// is a take-off.

#include "engine/bake/flight_events.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

constexpr double kAsItEnds = 1e-3;     // of a flight [s]
constexpr double kSameInstant = 1e-9;  // [s], [frames]

// From one time to another, both included [s].
bool HasEvent(EventKind kind, double from, double to, const Motion& motion) {
  return std::any_of(motion.events.begin(), motion.events.end(), [&](const MotionEvent& event) {
    return event.kind == kind && event.time >= from - kSameInstant &&
           event.time <= to + kSameInstant;
  });
}

// Of a flight that begins in the air: what touches is pinned as it begins.
void AddTakeOff(const Animation& animation, const PlacementSpan& pin, const PlacementSpan& flight,
                Motion* motion) {
  const double left = animation.rate.SecondsAt(pin.last_frame);
  const double begins = animation.rate.SecondsAt(flight.first_frame);
  const double ends = animation.rate.SecondsAt(flight.last_frame);
  const bool flies = HasEvent(EventKind::kApex, begins, ends, *motion) ||
                     HasEvent(EventKind::kLanding, begins, ends, *motion);
  const bool stands = HasEvent(EventKind::kPinChange, begins, begins, *motion);
  if (!flies || stands) return;
  const int frame = static_cast<int>(std::ceil(motion->rate.FrameAt(left) - kSameInstant));
  motion->events.push_back(
      {EventKind::kTakeOff, left, frame, animation.figure->group(*pin.pin).name});
}

void DropTakeOffsAsItEnds(const Animation& animation, const PlacementSpan& flight, Motion* motion) {
  const double ends = animation.rate.SecondsAt(flight.last_frame);
  if (!HasEvent(EventKind::kLanding, ends - kAsItEnds, ends, *motion)) return;
  std::erase_if(motion->events, [&](const MotionEvent& event) {
    return event.kind == EventKind::kTakeOff && event.time > ends - kAsItEnds && event.time <= ends;
  });
}

}  // namespace

void TellFlights(const Animation& animation, Motion* motion) {
  const std::vector<PlacementSpan>& spans = animation.placements;
  for (size_t i = 0; i < spans.size(); ++i) {
    const PlacementSpan* before = i > 0 ? &spans[i - 1] : nullptr;
    const PlacementSpan* after = i + 1 < spans.size() ? &spans[i + 1] : nullptr;
    const bool leaves = before && LeavesPin(*before, spans[i]);
    const bool stays = after && EndsOnPin(spans[i], *after);
    if (stays) DropTakeOffsAsItEnds(animation, spans[i], motion);
    if (leaves) AddTakeOff(animation, *before, spans[i], motion);
  }
  SortByTime(&motion->events);
}

}  // namespace hazumi
