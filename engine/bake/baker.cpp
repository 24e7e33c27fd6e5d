#include "engine/bake/baker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/bake/limits.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

constexpr double kSameFrame = 1e-9;  // instants this near are one [frames]

}  // namespace

Baker::Baker(const Animation& animation, const BakeOptions& options, Motion* motion, Team* team)
    : animation_(animation),
      cancel_(options.cancel),
      energy_(options.energy),
      refine_(options.refine),
      keep_frames_(options.keep_frames),
      team_(team),
      figure_(*animation.figure),
      ws_(figure_),
      curves_(animation),
      free_(figure_.num_joints(), 0),
      refinements_(animation.regions.size()),
      has_twin_(figure_.num_joints() + kRootAngles, 0),
      motion_(motion) {
  motion_->rate = options.output_rate.value_or(animation.rate);
  PrepareMotion();
  FindEdges();
  num_keys_.assign(is_edge_.size(), 0);
  for (const Keys& keys : animation_.joint_keys) CountKeys(keys, 1);
  for (const Keys& keys : animation_.root_keys) CountKeys(keys, 1);
  driven_.angles.resize(figure_.num_joints() + kRootAngles);
  twin_.q = twin_.qd = VecX::Zero(figure_.num_joints() + kRootAngles);
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
  FindEdges();
}

void Baker::FindEdges() {
  const auto mark = [this](int frame) {
    if (animation_.first_frame <= frame && frame <= animation_.last_frame)
      is_edge_[Index(frame)] = 1;
  };
  const auto mark_ends = [&](const auto& spans, ItemsByFrame* starts, ItemsByFrame* ends) {
    for (size_t i = 0; i < spans.size(); ++i) {
      mark(spans[i].first_frame);
      mark(spans[i].last_frame);
      if (starts) starts->Add(spans[i].first_frame, i);
      if (ends) ends->Add(spans[i].last_frame, i);
    }
  };
  is_edge_.assign(Index(animation_.last_frame) + 1, 0);
  const auto lists = {&region_starts_, &region_ends_, &hold_starts_, &releases_};
  for (ItemsByFrame* list : lists) *list = ItemsByFrame();
  mark(animation_.last_frame);
  mark_ends(animation_.regions, &region_starts_, &region_ends_);
  mark_ends(animation_.placements, nullptr, nullptr);
  mark_ends(animation_.holds, &hold_starts_, nullptr);
  for (size_t i = 0; i < animation_.held_objects.size(); ++i) {
    const std::optional<int>& release = animation_.held_objects[i].release_frame;
    if (!release) continue;
    mark(*release);
    releases_.Add(*release, i);
  }
  for (ItemsByFrame* list : lists) list->Sort();
}

void Baker::CountKeys(const Keys& keys, int by) {
  for (const Key& key : keys) {
    const bool is_inside =
        animation_.first_frame <= key.frame && key.frame <= animation_.last_frame;
    if (!is_inside || key.frame != std::floor(key.frame)) continue;
    num_keys_[Index(static_cast<int>(key.frame))] += by;
  }
}

// Room for all frames, and reports of regions that did nothing yet.
void Baker::PrepareMotion() {
  const double per_frame = OutputFramesPerFrame();
  first_output_ = static_cast<int>(std::ceil(animation_.first_frame * per_frame - kSameFrame));
  const int last = static_cast<int>(std::floor(animation_.last_frame * per_frame + kSameFrame));
  if (keep_frames_) motion_->frames.resize(std::max(0, last - first_output_ + 1));
  motion_->regions.clear();
  for (const DynamicsRegion& region : animation_.regions) {
    motion_->regions.push_back(EmptyReport(region));
  }
}

RegionReport Baker::EmptyReport(const DynamicsRegion& region) const {
  RegionReport report;
  report.name = region.name;
  report.method = region.method;
  report.step = region.step.value_or(animation_.solver.step);
  report.tolerance = region.tolerance.value_or(animation_.solver.tolerance);
  report.free_joints = static_cast<int>(region.joints.size());
  report.all_joints = figure_.num_joints();
  return report;
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

void Baker::Restore(const Checkpoint& checkpoint) {
  now_ = checkpoint.now;
  before_ = checkpoint.before;
  curves_.Restart(checkpoint.pieces);
  active_regions_.clear();
  std::fill(free_.begin(), free_.end(), 0);
  std::fill(has_twin_.begin(), has_twin_.end(), 0);
  root_free_ = exact_begun_ = false;
  driver_.reset();
  exact_.reset();
  if (objects_ != checkpoint.objects) {
    objects_ = checkpoint.objects;
    LoadFigure();
  }
  span_ = checkpoint.span ? &animation_.placements[*checkpoint.span] : nullptr;
  pin_W_ = checkpoint.pin_W;
  gravity_.reset();
  fall_.reset();
  if (checkpoint.gravity) {
    gravity_.emplace(figure_, animation_.scene, *span_, animation_.gravity);
    gravity_->Resume(*checkpoint.gravity);
  }
  if (checkpoint.fall) {
    fall_.emplace(figure_, animation_.scene, *span_, animation_.gravity);
    fall_->Resume(*checkpoint.fall);
  }
  holds_.clear();
  for (const Checkpoint::Hold& held : checkpoint.holds) {
    const IkHold& hold = animation_.holds[held.index];
    holds_.push_back({&hold, HoldSolver(figure_, hold), held.target});
  }
}

Result<std::optional<Checkpoint>> Baker::BakeStretch(const KnownLogs* known, Stretch* stretch) {
  known_ = known;
  stretch_ = stretch;
  std::fill(refinements_.begin(), refinements_.end(), Refinement());
  int frame;
  do {
    stretch->events.clear();
    stretch->warnings.clear();
    stretch->placement_jumps.clear();
    stretch->logs.clear();
    begun_.clear();
    last_stop_.assign(figure_.num_joints(), std::nullopt);
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
    if (!driver_ && !exact_ && ChangesAt(frame)) return frame;
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
    const RegionReport& report = motion_->regions[r];
    Refinement& refinement = refinements_[r];
    const double safe = kSafely * report.tolerance;
    if (report.method != Method::kExact || report.error_estimate <= safe) continue;
    const double finer = refinement.sharpness * 3.0 * report.error_estimate / safe;
    if (finer > kFinest || report.error_estimate > 0.3 * refinement.last_estimate) {
      if (report.error_estimate <= report.tolerance) continue;
      AddWarning("regions[" + std::to_string(r) + "]",
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
