#include <algorithm>
#include <optional>
#include <string>

#include "engine/project/checks/animation_checks.h"
#include "engine/project/checks/driven_frames.h"
#include "engine/project/checks/spans.h"

namespace hazumi {

namespace {

// Whether a region may move what a force acts on.
bool MayMove(const DynamicsRegion& region, const OuterForce& force, const Animation& animation) {
  if (const ForcePoint* point = ForcePointOf(force.action)) {
    return MayMove(region, point->joint, SpanOf(force), animation);
  }
  return !region.moves_nothing() && !Common(SpanOf(region), SpanOf(force)).is_empty();
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
                   {NameOfPoint(*ForcePointOf(force.action), *animation.figure),
                    Text(force.first_frame), Quoted(force.name)});
  }
}

void WarnAboutForces(const Animation& animation, std::vector<Warning>* warnings) {
  for (size_t i = 0; i < animation.forces.size(); ++i) {
    const OuterForce& force = animation.forces[i];
    if (IsFelt(force, animation)) continue;
    const ForcePoint* point = ForcePointOf(force.action);
    const std::string what = point ? NameOfPoint(*point, *animation.figure) : "anything";
    warnings->push_back(
        {At("forces", i),
         MessageOf(Check::kForceFeltByNone,
                   {Quoted(force.name), what, Text(force.first_frame), Text(force.last_frame)})});
  }
}

}  // namespace hazumi
