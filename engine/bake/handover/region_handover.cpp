// Joints on their way into a region and out of it [METHOD 7.1, 7.3]: the rate of a key on its first
// frame counts, unless another region hands the joint over; behind it the curve goes on from what
// the region left, at once or with a blend.

#include "engine/bake/handover/region_handover.h"

#include <cmath>

#include "engine/bake/handover/resume_curve.h"
#include "engine/base/text.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

std::string PlaceOfRegion(size_t region) { return "regions[" + std::to_string(region) + "]"; }

}  // namespace

void WarnIfItStopsDead(int frame, JointIndex j, const std::string& place, BakeContext* context) {
  constexpr double kMoving = 8.1 * kDegree;  // what is slower is at rest to the eye [rad/s]
  const bool is_moving = std::abs(context->now.qd[j.value()]) >= kMoving;
  if (!is_moving || context->poses.curves().joint(j).HasKeyAfter(frame)) return;
  context->recorder.AddWarning({place,
                                "joint \"" + context->poses.figure().joint(j).name +
                                    "\" has no key after frame " + std::to_string(frame) +
                                    ": it stops dead there",
                                frame, Warning::Remedy::kBlend});
}

void RegionHandover::Reset() {
  active_.clear();
  begun_.clear();
  context_.starts.clear();
}

std::vector<int> RegionHandover::ActiveFrom(int frame) const {
  std::vector<int> active;
  for (const int r : active_) {
    if (frame < context_.animation.regions[r].last_frame) active.push_back(r);
  }
  return active;
}

bool RegionHandover::Begin(int frame, const RegionWalk& walk) {
  const auto begins = context_.schedule.RegionsFrom(frame);
  for (const auto& [first_frame, r] : begins) {
    const DynamicsRegion& region = context_.animation.regions[r];
    active_.insert(r);
    begun_.push_back(r);
    context_.recorder.ClearReport(r);
    const bool stands =
        context_.animation.solver.rules().stands_on_springs && region.root && region.touches_scene;
    context_.starts[r] =
        StartOf(region, context_.poses.figure(), context_.now,
                stands ? &context_.animation.scene : nullptr, &context_.poses.workspace());
    if (region.root) BeginRoot(frame);
    for (const JointIndex j : region.joints) BeginJoint(j, frame, walk.moves(j));
  }
  return !begins.empty();
}

// As a joint begins; what a region before drives it goes on with.
void RegionHandover::BeginRoot(int frame) {
  PoseEvaluator& poses = context_.poses;
  if (poses.free_root()) return;
  const bool is_first = frame == context_.animation.first_frame;
  RootAngles angles = poses.curves().RootAnglesAt(frame, is_first ? Side::kAfter : Side::kBefore);
  for (int i = 0; i < kRootAngles; ++i) {
    const Key* key = poses.curves().root(kRootAngleZ + i).KeyAt(frame);
    if (key && key->rate) angles.rate[i] = *key->rate;
  }
  poses.FreeRoot(angles);
}

// With the rate given by a key on the first frame, else with that which the curve, the hold or the
// region before left [METHOD 7.1].
void RegionHandover::BeginJoint(JointIndex j, int frame, bool handed_over) {
  context_.poses.SetFree(j, true);
  context_.now.qdd[j.value()] = 0.0;
  const Key* key = context_.poses.curves().joint(j).KeyAt(frame);
  if (!handed_over && key && key->rate) context_.now.qd[j.value()] = *key->rate;
}

bool RegionHandover::End(int frame) {
  const auto ends = context_.schedule.RegionsUntil(frame);
  for (const auto& [last_frame, r] : ends) {
    const DynamicsRegion& region = context_.animation.regions[r];
    active_.erase(r);
    if (region.root) EndRoot(frame, region);
    EndJoints(frame, r);
  }
  return !ends.empty();
}

// The root's curves go on from the angles that the region left.
void RegionHandover::EndRoot(int frame, const DynamicsRegion& region) {
  const RotationState root = *context_.poses.free_root();
  context_.poses.BindRoot();
  for (int i = 0; i < kRootAngles; ++i) {
    ResumeCurve({frame, root.q[i], root.qd[i]}, region, nullptr,
                &context_.poses.curves().root(kRootAngleZ + i));
  }
}

// The curves go on from what the region left, which may be too fast for them to turn back before a
// limit.
void RegionHandover::EndJoints(int frame, size_t region) {
  constexpr double kNoticed = 1e-6;  // [rad]
  JointIndex worst;
  double most = kNoticed;
  for (const JointIndex j : context_.animation.regions[region].joints) {
    CurveTrack& curve = context_.poses.curves().joint(j);
    context_.poses.SetFree(j, false);
    if (context_.schedule.HasRegionFrom(frame, j)) {
      curve.Resume(frame, context_.now.q[j.value()], context_.now.qd[j.value()]);
      continue;
    }
    ResumeJoint(frame, region, j);
    const double overshoot =
        Overshoot(frame, context_.poses.figure().joint(j), context_.animation.rate, &curve);
    if (overshoot <= most) continue;
    most = overshoot;
    worst = j;
  }
  if (worst.is_valid()) WarnOfOvershoot(frame, region, worst, most);
}

void RegionHandover::ResumeJoint(int frame, size_t region, JointIndex j) {
  const DynamicsRegion& own = context_.animation.regions[region];
  const Joint& joint = context_.poses.figure().joint(j);
  CurveTrack& curve = context_.poses.curves().joint(j);
  const HingeEnd end = {frame, context_.now.q[j.value()], context_.now.qd[j.value()]};
  ResumeCurve(end, own, &joint, &curve);
  if (own.blend_frames == 0) WarnIfItStopsDead(frame, j, PlaceOfRegion(region), &context_);
  if (own.limit_tangents) ResumeInside(end, own, joint, context_.animation.rate, &curve);
}

void RegionHandover::WarnOfOvershoot(int frame, size_t region, JointIndex j, double overshoot) {
  context_.recorder.AddWarning(
      {PlaceOfRegion(region),
       "joint \"" + context_.poses.figure().joint(j).name + "\" goes " +
           FormatShort(overshoot / kDegree) + " degrees beyond its limit after frame " +
           std::to_string(frame) +
           ", before it turns back; set \"limit_tangents\": true on the region, or give it a "
           "key there",
       frame, Warning::Remedy::kLimitTangents});
}

}  // namespace hazumi
