#include "engine/project/checks/driven_frames.h"

#include <algorithm>

#include "engine/project/checks/checks.h"

namespace hazumi {

JointSet JointsOf(const DynamicsRegion& region, const Figure& figure) {
  JointSet set(figure.joints().size());
  for (const JointIndex joint : region.joints) set[joint.value()] = true;
  for (const JointIndex joint : region.keyed) set[joint.value()] = true;
  return set;
}

JointSet Common(const JointSet& a, const JointSet& b) {
  JointSet both(a.size());
  for (size_t j = 0; j < a.size(); ++j) both[j] = a[j] && b[j];
  return both;
}

std::optional<JointIndex> FirstOf(const JointSet& set) {
  const auto it = std::find(set.begin(), set.end(), true);
  if (it == set.end()) return std::nullopt;
  return JointIndex(static_cast<int>(it - set.begin()));
}

DrivenFrames::DrivenFrames(const Animation& animation)
    : animation_(animation), joints_(animation.figure->joints().size()), keyed_(joints_.size()) {}

void DrivenFrames::Add(const DynamicsRegion& region) {
  for (const JointIndex j : region.joints) joints_[j.value()].Add(SpanOf(region));
  for (const JointIndex j : region.keyed) keyed_[j.value()].Add(SpanOf(region));
  if (region.root) root_.Add(SpanOf(region));
}

bool DrivenFrames::Clashes(const DynamicsRegion& region) const {
  const auto is_driven = [&](JointIndex j) { return joint(j).Overlaps(SpanOf(region)); };
  const auto is_keyed = [&](JointIndex j) { return keyed_[j.value()].Overlaps(SpanOf(region)); };
  return (region.root && root_.Overlaps(SpanOf(region))) ||
         std::any_of(region.joints.begin(), region.joints.end(), is_keyed) ||
         std::any_of(region.keyed.begin(), region.keyed.end(), is_driven) ||
         std::any_of(region.joints.begin(), region.joints.end(), is_driven);
}

std::optional<DrivenFrames::Driver> DrivenFrames::FindDriver(const JointSet& joints,
                                                             Span span) const {
  const Figure& figure = *animation_.figure;
  for (const DynamicsRegion& region : animation_.regions) {
    const Span both = Common(SpanOf(region), span);
    if (both.is_empty()) continue;
    const auto joint = FirstOf(Common(JointsOf(region, figure), joints));
    if (joint) return Driver{Quoted(region.name), Quoted(figure.joint(*joint).name), both};
  }
  return std::nullopt;
}

namespace {

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

}  // namespace

bool MayMove(const DynamicsRegion& region, std::optional<GroupIndex> joint, Span span,
             const Animation& animation) {
  if (region.moves_nothing() || Common(SpanOf(region), span).is_empty()) return false;
  const Figure& figure = *animation.figure;
  return region.root || (joint && IsBeyondAny(figure.group(*joint).last(), region, figure)) ||
         MayMoveRoot(region, animation);
}

}  // namespace hazumi
