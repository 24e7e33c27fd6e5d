// Falls, as both methods tell of them: a take-off is of the joint that was pinned, a landing of the
// one that is pinned now.

#include "engine/bake/pose/ballistic_root.h"

namespace hazumi {

namespace {

// Of both methods' kinds.
template <typename Kind>
EventKind KindOf(Kind kind) {
  if (kind == Kind::kTakeOff) return EventKind::kTakeOff;
  return kind == Kind::kApex ? EventKind::kApex : EventKind::kLanding;
}

// The joint that an event is about, of those that are pinned before and after it.
std::optional<GroupIndex> JointOf(EventKind kind, std::optional<GroupIndex> before,
                                  std::optional<GroupIndex> after) {
  if (kind == EventKind::kTakeOff) return before;
  return kind == EventKind::kLanding ? after : std::nullopt;
}

}  // namespace

PaperBallisticRoot::PaperBallisticRoot(const PlacementSpan& span, const RootPlacementSite& site)
    : BallisticRoot(site),
      gravity_(site.figure, site.animation.scene, span, site.animation.gravity) {}

std::vector<RootEvent> PaperBallisticRoot::Step(const FigureMotion& from, double seconds,
                                                Side /*side*/, FigureMotion* to) {
  const std::optional<GroupIndex> before = gravity_.pin();
  gravity_.Advance(from, seconds, &ws_, to);
  std::vector<RootEvent> events;
  for (const GravityPlacement::Event& event : gravity_.events()) {
    const EventKind kind = KindOf(event.kind);
    const auto joint = JointOf(kind, before, gravity_.pin());
    events.push_back({kind, event.seconds_into_step, Vec3::Zero(), joint});
  }
  return events;
}

bool PaperBallisticRoot::PlaceWithinStep(double seconds_before_end, FigureMotion* motion) {
  if (gravity_.has_landed()) return false;
  gravity_.Place(&ws_, motion, seconds_before_end);
  return true;
}

ExactBallisticRoot::ExactBallisticRoot(const PlacementSpan& span, const RootPlacementSite& site)
    : BallisticRoot(site),
      rate_(site.animation.rate),
      gravity_(site.figure, site.animation.scene, span, site.animation.gravity,
               site.animation.solver.rules()) {}

RootEvent ExactBallisticRoot::Happen(const GravityEvent& event, const FigureMotion& motion) {
  const std::optional<GroupIndex> before = gravity_.pin();
  const Vec3 pin_velocity = gravity_.Happen(event, motion, &ws_);
  const EventKind kind = KindOf(event.kind);
  return {kind, event.time, pin_velocity, JointOf(kind, before, gravity_.pin())};
}

}  // namespace hazumi
