// What ends and what begins at a frame.

#include <algorithm>
#include <cmath>

#include "engine/bake/baker.h"
#include "engine/base/text.h"

namespace hazumi {

Baker::Failure Baker::CrossFrame(int frame) {
  const bool was_keyed = !span_ || span_->kind == PlacementKind::kKeyed;
  const bool regions_ended = EndRegions(frame), holds_ended = EndHolds(frame);
  const bool has_landed = gravity_ && gravity_->has_landed();  // which stops the root by itself
  const bool unplaced = EndPlacement(frame);
  const bool released = ReleaseObjects(frame);
  const bool regions_begun = BeginRegions(frame), holds_begun = BeginHolds(frame);
  const bool placed = BeginPlacement(frame, was_keyed);
  const bool ended = regions_ended || holds_ended, begun = regions_begun || holds_begun;
  if (ended || begun) RebuildDriver(frame);
  exact_begun_ &= !ended && !unplaced && !released && !begun && !placed;
  if (!ended && !unplaced && !released && !begun && !placed && !schedule_.HasKeyAt(frame)) {
    return std::nullopt;
  }
  if (auto error = Evaluate(frame, Side::kAfter, &now_)) return error;
  if ((placed || unplaced) && !has_landed) WarnOfVelocityJump(frame);
  return std::nullopt;
}

// At the animation's last frame nothing takes over: regions, holds and pins are what they were.
bool Baker::Ends(int last_frame, int frame) const {
  return last_frame == frame && frame != animation_.last_frame;
}

bool Baker::EndRegions(int frame) {
  if (!Ends(frame, frame)) return false;
  bool any = false;
  for (const auto& [last_frame, r] : schedule_.RegionsUntil(frame)) {
    const DynamicsRegion& region = animation_.regions[r];
    any = true;
    active_regions_.erase(r);
    if (region.root) EndRoot(frame, region);
    ResumeAfterRegion(frame, r);
  }
  return any;
}

void Baker::BeginRoot(int frame) {
  if (root_free_) return;
  root_free_ = true;
  const bool is_first = frame == animation_.first_frame;
  const RootAngles angles = curves_.RootAnglesAt(frame, is_first ? Side::kAfter : Side::kBefore);
  for (int i = 0; i < kRootAngles; ++i) {
    const Key* key = curves_.root(kRootAngleZ + i).KeyAt(frame);
    root_.q[i] = angles.angle[i];
    root_.qd[i] = key && key->rate ? *key->rate : angles.rate[i];
  }
}

bool Baker::EndHolds(int frame) {
  const auto ends = [&](const ActiveHold& active) { return Ends(active.hold->last_frame, frame); };
  for (const ActiveHold& active : holds_) {
    if (!ends(active)) continue;
    for (const JointIndex j : active.solver.joints()) {
      curves_.joint(j).Resume(frame, now_.q[j.value()], now_.qd[j.value()], /*as_keyed=*/true);
      if (schedule_.HasRegionFrom(frame, j)) continue;
      WarnIfNoKeyAfter(frame, j, "holds", active.hold - animation_.holds.data());
    }
  }
  return std::erase_if(holds_, ends) > 0;
}

void Baker::WarnIfNoKeyAfter(int frame, JointIndex j, const char* list, size_t index) {
  constexpr double kMoving = 1e-6;  // [rad/s]
  if (curves_.joint(j).HasKeyAfter(frame) || std::abs(now_.qd[j.value()]) < kMoving) return;
  recorder_.AddWarning(std::string(list) + "[" + std::to_string(index) + "]",
                       "joint \"" + figure_.joint(j).name + "\" has no key after frame " +
                           std::to_string(frame) + ": it stops dead there");
}

bool Baker::EndPlacement(int frame) {
  if (!span_ || !Ends(span_->last_frame, frame)) return false;
  if (span_->kind != PlacementKind::kKeyed) {
    WarnOfDistance(frame);
    for (int i = 0; i < 3; ++i) {
      curves_.root(kRootX + i).Resume(frame, now_.X_WR.p[i], now_.root.v[i]);
    }
  }
  gravity_.reset();
  fall_.reset();
  span_ = nullptr;
  return true;
}

bool Baker::ReleaseObjects(int frame) {
  bool any = false;
  for (const auto& [release_frame, i] : schedule_.Releases(frame)) {
    const HeldObject& object = animation_.held_objects[i];
    ComputePositions(figure_, now_.X_WR, now_.q, &ws_);
    ComputeVelocities(figure_, before_.root_w, before_.root_v, before_.qd, &ws_);
    objects_[i].Release(ws_, Seconds(frame));
    recorder_.AddEvent(EventKind::kRelease, frame, figure_.group(object.holder).name);
    any = true;
  }
  if (!any) return false;
  LoadFigure();
  if (gravity_) gravity_->MassesChanged(now_, &ws_);
  if (fall_) fall_->MassesChanged(Seconds(frame), now_, &ws_);
  return true;
}

bool Baker::BeginRegions(int frame) {
  bool any = false;
  for (const auto& [first_frame, r] : schedule_.RegionsFrom(frame)) {
    const DynamicsRegion& region = animation_.regions[r];
    any = true;
    active_regions_.insert(r);
    begun_.push_back(r);
    recorder_.ClearReport(r);
    if (region.root) BeginRoot(frame);
    for (const JointIndex j : region.joints) {
      const bool handed_over =
          (driver_ && driver_->is_free(j)) || (exact_ && exact_->is_free(j.value()));
      StartFreeJoint(j, frame, handed_over);
    }
  }
  return any;
}

// With the rate given by a key on the first frame, else with that which the curve, the hold or the
// region before left.
void Baker::StartFreeJoint(JointIndex j, int frame, bool handed_over) {
  free_[j.value()] = 1;
  now_.qdd[j.value()] = 0.0;
  const Key* key = curves_.joint(j).KeyAt(frame);
  if (!handed_over && key && key->rate) now_.qd[j.value()] = *key->rate;
}

void Baker::RebuildDriver(int frame) {
  std::vector<int> active;
  for (const int r : active_regions_) {
    if (frame < animation_.regions[r].last_frame) active.push_back(r);
  }
  driver_.reset();
  if (exact_) TakeReports();
  exact_.reset();
  if (active.empty()) std::fill(has_control_.begin(), has_control_.end(), 0);
  if (active.empty()) return;
  if (IsExact(frame)) {
    double sharpness = 1.0;
    for (const int r : active) sharpness = std::max(sharpness, refinements_[r].sharpness);
    exact_ = std::make_unique<ExactDriver>(animation_, figure_, active, sharpness, known_, pool_);
    return;
  }
  driver_ = std::make_unique<RegionDriver>(animation_, figure_, active);
  for (const int r : active) ReportStep(r, frame);
}

// Regions that are active together are one system and take the smallest of their steps.
void Baker::ReportStep(int region, int frame) {
  double& step = recorder_.report(region).step;
  if (driver_->step() >= step) return;
  recorder_.AddWarning("regions[" + std::to_string(region) + "]",
                       "takes the step of another region that is active from frame " +
                           std::to_string(frame) + " on: " + FormatNumber(driver_->step()) +
                           " s instead of " + FormatNumber(step) + " s");
  step = driver_->step();
}

bool Baker::BeginHolds(int frame) {
  bool any = false;
  for (const auto& [first_frame, i] : schedule_.HoldsFrom(frame)) {
    const IkHold& hold = animation_.holds[i];
    any = true;
    ComputePositions(figure_, now_.X_WR, now_.q, &ws_);
    const JointIndex held = figure_.group(hold.joint).first;
    const HoldTarget target{ws_.body(held).p, ws_.body(figure_.joint(held).parent).R};
    holds_.push_back({&hold, HoldSolver(figure_, hold), target});
  }
  return any;
}

bool Baker::BeginPlacement(int frame, bool was_keyed) {
  const PlacementSpan* next = schedule_.PlacementFrom(frame);
  if (!next) return false;
  const PlacementSpan& span = *next;
  span_ = &span;
  if (span.kind == PlacementKind::kPinned) {
    ComputePositions(figure_, now_.X_WR, now_.q, &ws_);
    pin_W_ = ws_.body(figure_.group(*span.pin).first).p;
  }
  if (span.kind == PlacementKind::kGravity) {
    if (was_keyed) TakeKeyedVelocity(frame);
    if (animation_.solver.method == Method::kExact) {
      fall_.emplace(figure_, animation_.scene, span, animation_.gravity);
      fall_->Start(Seconds(frame), now_, &ws_);
    } else {
      gravity_.emplace(figure_, animation_.scene, span, animation_.gravity);
      gravity_->Start(now_, &ws_);
    }
  }
  AddPinEvent(frame);
  return true;
}

// Gravity takes the figure over as a region takes a joint over: with the root's rates given by keys
// on its first frame, else with those that the curves before it left. Before the animation's first
// frame there is nothing, so all curves start as their keys say.
void Baker::TakeKeyedVelocity(int frame) {
  if (frame == animation_.first_frame) {
    curves_.SampleJoints(frame, Side::kAfter, free_, &now_);
    TurnRoot(frame, Side::kAfter, &now_);
    curves_.SampleRootPosition(frame, Side::kAfter, &now_);
  }
  for (int i = 0; i < 3; ++i) {
    const Key* key = curves_.root(kRootX + i).KeyAt(frame);
    if (key && key->rate) now_.root.v[i] = *key->rate;
  }
}

void Baker::WarnOfVelocityJump(int frame) {
  constexpr double kJump = 1e-3;  // [m/s]
  const double jump = (now_.root.v - before_.root_v).norm();
  if (frame == animation_.first_frame || jump <= kJump) return;
  recorder_.AddJump({schedule_.PlacementAt(frame), frame, jump},
                    "the root's velocity jumps by " + FormatShort(jump) + " m/s at frame " +
                        std::to_string(frame) + ", where the placement changes");
}

// A figure that is not where the keys beyond the placement have it gets there by the next one.
void Baker::WarnOfDistance(int frame) {
  constexpr double kFar = 0.01, kFast = 0.25;  // [m], [m/s]
  constexpr double kNext = 1e-9;               // [frames]
  Vec3 way = Vec3::Zero();
  double seconds = 0.0;
  for (int i = 0; i < 3; ++i) {
    CurveTrack& curve = curves_.root(kRootX + i);
    if (!curve.HasKeyAfter(frame)) continue;
    const double until = Seconds(curve.BlendTarget(frame + kNext).frame - frame);
    way[i] = curve.At(frame).value - now_.X_WR.p[i];
    seconds = seconds > 0.0 ? std::min(seconds, until) : until;
  }
  if (way.norm() <= kFar || way.norm() <= kFast * seconds) return;
  recorder_.AddJump(
      {static_cast<int>(span_ - animation_.placements.data()), frame, 0.0, way.norm(), seconds},
      "at frame " + std::to_string(frame) + ", where the placement ends, the root is " +
          FormatShort(way.norm()) + " m from where its keys have it; it gets there within " +
          FormatShort(seconds) + " s");
}

}  // namespace hazumi
