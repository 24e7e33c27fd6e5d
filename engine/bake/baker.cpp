#include "engine/bake/baker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/bake/limits.h"
#include "engine/base/text.h"

namespace hazumi {

Baker::Baker(const Animation& animation, const BakeOptions& options, Motion* motion,
             ThreadPool* pool)
    : animation_(animation),
      cancel_(options.cancel),
      energy_(options.energy),
      refine_(options.refine),
      pool_(pool),
      figure_(*animation.figure),
      ws_(figure_),
      curves_(animation),
      schedule_(animation),
      free_(figure_.num_joints(), 0),
      refinements_(animation.regions.size()),
      has_control_(figure_.num_joints() + kRootAngles, 0),
      recorder_(animation, options, motion) {
  driven_.angles.resize(figure_.num_joints() + kRootAngles);
  control_.q = control_.qd = VecX::Zero(figure_.num_joints() + kRootAngles);
  root_.q = root_.qd = VecX::Zero(kRootAngles);
}

// The figure with what it holds.
void Baker::LoadFigure() {
  figure_ = *animation_.figure;
  for (size_t i = 0; i < objects_.size(); ++i) {
    const HeldObject& object = animation_.held_objects[i];
    if (!objects_[i].is_held()) continue;
    figure_ = figure_.WithLoad(figure_.group(object.holder).last(), InertiaOf(object));
  }
}

void Baker::RegionsChanged() {
  curves_ = CurveSet(animation_);
  schedule_.RegionsChanged();
}

Result<Checkpoint> Baker::Begin() {
  curves_ = CurveSet(animation_);
  Checkpoint nothing;
  nothing.now.q = nothing.now.qd = nothing.now.qdd = VecX::Zero(figure_.num_joints());
  nothing.pieces = curves_.PiecesBefore(animation_.first_frame);
  for (const HeldObject& object : animation_.held_objects) {
    nothing.objects.emplace_back(figure_, object, animation_.gravity);
  }
  Restore(nothing);
  if (auto error = Evaluate(animation_.first_frame, Side::kBefore, &now_)) return *error;
  before_ = LimitOf(now_);
  return Save(animation_.first_frame);
}

Checkpoint Baker::Save(int frame) {
  Checkpoint checkpoint;
  checkpoint.frame = frame;
  checkpoint.now = now_;
  checkpoint.before = before_;
  checkpoint.pieces = curves_.PiecesBefore(frame);
  if (span_) checkpoint.span = span_ - animation_.placements.data();
  checkpoint.pin_W = pin_W_;
  if (gravity_) checkpoint.gravity = gravity_->state();
  if (fall_) checkpoint.fall = fall_->state();
  for (const ActiveHold& active : holds_) {
    const size_t index = active.hold - animation_.holds.data();
    checkpoint.holds.push_back({index, active.target});
  }
  checkpoint.objects = objects_;
  return checkpoint;
}

// Names every member, so that one that is added is not forgotten here.
void Baker::Restore(const Checkpoint& checkpoint) {
  const auto& [frame, now, before, pieces, span, pin_W, gravity, fall, holds, objects] = checkpoint;
  now_ = now;
  before_ = before;
  curves_.Restart(pieces);
  active_regions_.clear();
  std::fill(free_.begin(), free_.end(), 0);
  std::fill(has_control_.begin(), has_control_.end(), 0);
  root_free_ = exact_begun_ = false;
  driver_.reset();
  exact_.reset();
  if (objects_ != objects) {
    objects_ = objects;
    LoadFigure();
  }
  span_ = span ? &animation_.placements[*span] : nullptr;
  pin_W_ = pin_W;
  gravity_.reset();
  fall_.reset();
  if (gravity) {
    gravity_.emplace(figure_, animation_.scene, *span_, animation_.gravity);
    gravity_->Resume(*gravity);
  }
  if (fall) {
    fall_.emplace(figure_, animation_.scene, *span_, animation_.gravity);
    fall_->Resume(*fall);
  }
  holds_.clear();
  for (const Checkpoint::Hold& held : holds) {
    const IkHold& hold = animation_.holds[held.index];
    holds_.push_back({&hold, HoldSolver(figure_, hold), held.target});
  }
}

Result<std::optional<Checkpoint>> Baker::BakeStretch(const KnownLogs* known, Stretch* stretch) {
  known_ = known;
  std::fill(refinements_.begin(), refinements_.end(), Refinement());
  int frame;
  do {
    recorder_.BeginStretch(stretch);
    begun_.clear();
    Restore(stretch->start);
    const Result<int> end = AdvanceToCheckpoint(stretch->start.frame);
    if (!end.ok()) return end.error();
    frame = end.value();
  } while (refine_ && Sharpen());
  if (frame > animation_.last_frame) return std::optional<Checkpoint>();
  return std::optional(Save(frame));
}

// Up to a frame where something changes while no region is active, or beyond the last frame.
Result<int> Baker::AdvanceToCheckpoint(int frame) {
  for (;;) {
    if (auto error = CrossFrame(frame)) return *error;
    RecordIfOutput();
    if (frame == animation_.last_frame) break;
    if (IsExact(frame)) {
      const Result<int> next = AdvanceExact(frame);
      if (!next.ok()) return next.error();
      frame = next.value();
    } else {
      if (auto error = AdvanceFrame(frame)) return *error;
      ++frame;
    }
    if (!driver_ && !exact_ && schedule_.ChangesAt(frame)) return frame;
  }
  if (exact_) TakeReports();
  return animation_.last_frame + 1;
}

// Asks for finer steps where the estimate says that a region may miss its tolerance, as long as
// that helps. The error is at times a few times the estimate. False if there is nothing to ask for.
bool Baker::Sharpen() {
  constexpr double kFinest = 1e6, kSafely = 0.2;
  bool any = false;
  for (const int r : begun_) {
    const RegionReport& report = recorder_.report(r);
    Refinement& refinement = refinements_[r];
    const double safe = kSafely * report.tolerance;
    if (report.method != Method::kExact || report.error_estimate <= safe) continue;
    const double finer = refinement.sharpness * 3.0 * report.error_estimate / safe;
    if (finer > kFinest || report.error_estimate > 0.3 * refinement.last_estimate) {
      if (report.error_estimate <= report.tolerance) continue;
      recorder_.AddWarning(
          "regions[" + std::to_string(r) + "]",
          "its angles may be off by " +
              FormatShort(report.error_estimate * 180.0 / std::numbers::pi) +
              " degrees, more than its tolerance: the motion is so sensitive that finer "
              "steps do not help");
      continue;
    }
    refinement = {finer, report.error_estimate};
    any = true;
  }
  return any;
}

}  // namespace hazumi
