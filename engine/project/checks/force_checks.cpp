#include "engine/project/checks/force_checks.h"

#include <algorithm>
#include <optional>
#include <string>

#include "engine/project/checks/hold_checks.h"
#include "engine/project/checks/spans.h"

namespace hazumi {

namespace {

// The point where a force acts; null: it acts on every link.
const ForcePoint* PointOf(const OuterForce& force) {
  if (const auto* attract = std::get_if<AttractForce>(&force.action)) return &attract->at;
  if (const auto* push = std::get_if<PushForce>(&force.action)) return &push->at;
  return nullptr;
}

bool IsBeyondAny(JointIndex j, const DynamicsRegion& region, const Figure& figure) {
  return std::any_of(region.joints.begin(), region.joints.end(),
                     [&](JointIndex moved) { return figure.IsBeyond(j, moved); });
}

// Whether the root's place may answer what the region's joints do.
bool MayMoveRoot(const DynamicsRegion& region, const Animation& animation) {
  const Figure& figure = *animation.figure;
  return std::any_of(animation.placements.begin(), animation.placements.end(),
                     [&](const PlacementSpan& span) {
                       if (Common(SpanOf(span), SpanOf(region)).is_empty()) return false;
                       if (span.kind == PlacementKind::kGravity) return true;
                       return span.kind == PlacementKind::kPinned && span.pin &&
                              IsBeyondAny(figure.group(*span.pin).first, region, figure);
                     });
}

// Whether a region may move what a force acts on.
bool MayMove(const DynamicsRegion& region, const OuterForce& force, const Animation& animation) {
  if (region.moves_nothing() || Common(SpanOf(region), SpanOf(force)).is_empty()) return false;
  const ForcePoint* point = PointOf(force);
  if (!point || region.root) return true;
  const Figure& figure = *animation.figure;
  if (point->joint && IsBeyondAny(figure.group(*point->joint).last(), region, figure)) return true;
  return MayMoveRoot(region, animation);
}

bool IsFelt(const OuterForce& force, const Animation& animation) {
  return std::any_of(
      animation.regions.begin(), animation.regions.end(),
      [&](const DynamicsRegion& region) { return MayMove(region, force, animation); });
}

std::string NameOfPoint(const ForcePoint& point, const Figure& figure) {
  return Quoted(point.joint ? figure.group(*point.joint).name : figure.root_name());
}

void CheckFrames(const OuterForce& force, const std::string& place, const Animation& animation,
                 FirstError* errors) {
  const int first = animation.first_frame, last = animation.last_frame;
  if (force.first_frame >= first && force.last_frame <= last) return;
  if (force.kind() == ForceKind::kPush) {
    const int before_last = std::max(first, last - 1);  // nothing moves from the last one on
    return errors->Report(Check::kReleaseOutside, place + ".frame",
                          {Text(force.first_frame), Text(first), Text(before_last)});
  }
  errors->Report(Check::kOutsideFrames, place,
                 {Text(force.first_frame), Text(force.last_frame), Text(first), Text(last)});
}

// The paper's step has no place for them.
void CheckMethods(const OuterForce& force, const std::string& place, const Animation& animation,
                  FirstError* errors) {
  for (const DynamicsRegion& region : animation.regions) {
    const Span both = Common(SpanOf(region), SpanOf(force));
    if (region.method == Method::kExact || region.moves_nothing() || both.is_empty()) continue;
    errors->Report(Check::kForceInPaper, place,
                   {Quoted(force.name), Text(both.first), Text(both.last), Quoted(region.name)});
  }
}

// There is one air.
void CheckWind(size_t i, const Animation& animation, FirstError* errors) {
  const OuterForce& force = animation.forces[i];
  for (size_t k = 0; k < i && force.kind() == ForceKind::kWind; ++k) {
    const OuterForce& other = animation.forces[k];
    const Span both = Common(SpanOf(force), SpanOf(other));
    if (other.kind() != ForceKind::kWind || both.is_empty()) continue;
    errors->Report(Check::kWindsOverlap, At("forces", i),
                   {Quoted(other.name), Quoted(force.name), Text(both.first), Text(both.last)});
  }
}

}  // namespace

void CheckForces(const Animation& animation, FirstError* errors) {
  for (size_t i = 0; i < animation.forces.size() && errors->ok(); ++i) {
    const OuterForce& force = animation.forces[i];
    CheckFrames(force, At("forces", i), animation, errors);
    CheckMethods(force, At("forces", i), animation, errors);
    CheckWind(i, animation, errors);
    if (force.kind() != ForceKind::kPush || IsFelt(force, animation)) continue;
    errors->Report(Check::kPushFeltByNone, At("forces", i),
                   {NameOfPoint(*PointOf(force), *animation.figure), Text(force.first_frame),
                    Quoted(force.name)});
  }
}

void WarnAboutForces(const Animation& animation, std::vector<Warning>* warnings) {
  for (size_t i = 0; i < animation.forces.size(); ++i) {
    const OuterForce& force = animation.forces[i];
    if (IsFelt(force, animation)) continue;
    const ForcePoint* point = PointOf(force);
    const std::string what = point ? NameOfPoint(*point, *animation.figure) : "anything";
    warnings->push_back(
        {At("forces", i),
         MessageOf(Check::kForceFeltByNone,
                   {Quoted(force.name), what, Text(force.first_frame), Text(force.last_frame)})});
  }
}

}  // namespace hazumi
