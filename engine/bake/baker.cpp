// A bake as a walk from change to change. At each frame F where something changes (CrossFrame)
//   what ends at F ends: regions, holds, placement, objects are let go of,
//   what begins at F begins, from the figure as it came there,
//   the figure is evaluated anew: the limit from the right.
// From F to the next frame a walk advances it (RegionWalk). Where no region is active the state at
// a frame is a checkpoint: all that comes after depends on it and the animation alone.

#include "engine/bake/baker.h"

namespace hazumi {

Baker::Baker(const Animation& animation, const BakeOptions& options, Motion* motion,
             ThreadPool* pool)
    : animation_(animation),
      context_(animation, options, motion),
      regions_(&context_),
      placement_(&context_),
      refinements_(animation.regions.size()),
      exact_(&context_, &refinements_, pool),
      paper_(&context_),
      walk_(&WalkOf(animation.solver.method)) {}

RegionWalk& Baker::WalkOf(Method method) {
  if (method == Method::kExact) return exact_;
  return paper_;
}

void Baker::RegionsChanged() {
  context_.poses.ResetCurves();
  context_.schedule.RegionsChanged();
}

Result<Checkpoint> Baker::Begin() {
  PoseEvaluator& poses = context_.poses;
  const int frame = animation_.first_frame;
  poses.ResetCurves();
  Checkpoint nothing;
  nothing.now.q = nothing.now.qd = nothing.now.qdd = VecX::Zero(poses.figure().num_joints());
  nothing.pieces = poses.curves().PiecesBefore(frame);
  for (const HeldObject& object : animation_.held_objects) {
    nothing.objects.emplace_back(poses.figure(), object, animation_.gravity);
  }
  Restore(nothing);
  FigureMotion first = context_.now;
  if (auto error = poses.Evaluate(frame, Side::kBefore, &first)) return *error;
  context_.Arrive(std::move(first));
  return Save(frame);
}

Checkpoint Baker::Save(int frame) {
  PoseEvaluator& poses = context_.poses;
  Checkpoint checkpoint;
  checkpoint.frame = frame;
  checkpoint.now = context_.now;
  checkpoint.before = context_.before;
  checkpoint.pieces = poses.curves().PiecesBefore(frame);
  if (poses.span()) checkpoint.span = poses.span() - animation_.placements.data();
  checkpoint.placement = poses.placement().state();
  checkpoint.holds = poses.holds().begun();
  checkpoint.objects = poses.objects();
  return checkpoint;
}

// Names every member, so that one that is added is not forgotten here.
void Baker::Restore(const Checkpoint& checkpoint) {
  const auto& [frame, now, before, pieces, span, placement, holds, objects] = checkpoint;
  PoseEvaluator& poses = context_.poses;
  context_.now = now;
  context_.before = before;
  poses.Resume(pieces, objects);
  poses.StartPlacement(span ? &animation_.placements[*span] : nullptr).Resume(placement);
  poses.holds().Resume(holds);
  regions_.Reset();
  exact_.Reset();
  paper_.Reset();
  walk_ = &WalkOf(animation_.solver.method);
}

Result<std::optional<Checkpoint>> Baker::BakeStretch(const KnownLogs* known, Stretch* stretch) {
  exact_.UseLogs(known);
  refinements_.Reset();
  int frame;
  do {
    context_.recorder.BeginStretch(stretch);
    Restore(stretch->start);
    const Result<int> end = AdvanceToCheckpoint(stretch->start.frame);
    if (!end.ok()) return end.error();
    frame = end.value();
  } while (context_.options.refine && refinements_.Sharpen(regions_.begun(), &context_.recorder));
  if (frame > animation_.last_frame) return std::optional<Checkpoint>();
  return std::optional(Save(frame));
}

// Up to a frame where something changes while no region is active, or beyond the last frame.
Result<int> Baker::AdvanceToCheckpoint(int frame) {
  for (;;) {
    if (auto error = CrossFrame(frame)) return *error;
    context_.RecordNow();
    if (frame == animation_.last_frame) break;
    const Result<int> next = walk_->Advance(frame);
    if (!next.ok()) return next.error();
    frame = next.value();
    if (!walk_->has_regions() && context_.schedule.ChangesAt(frame)) return frame;
  }
  walk_->End();
  return animation_.last_frame + 1;
}

// At the animation's last frame nothing takes over: regions, holds and pins are what they were.
std::optional<Error> Baker::CrossFrame(int frame) {
  const bool is_last = frame == animation_.last_frame;
  const bool was_keyed = context_.poses.placement().is_keyed();
  const bool has_landed =
      context_.poses.placement().has_landed();  // which stops the root by itself
  const bool regions_ended = !is_last && regions_.End(frame);
  const bool holds_ended = !is_last && EndHolds(frame);
  const bool unplaced = !is_last && placement_.End(frame);
  const bool released = ReleaseObjects(frame);
  const bool regions_begun = regions_.Begin(frame, *walk_);
  const bool holds_begun = BeginHolds(frame);
  const bool placed = placement_.Begin(frame, was_keyed);
  const bool is_moved_otherwise = regions_ended || holds_ended || regions_begun || holds_begun;
  const bool is_placed_otherwise = unplaced || placed;
  if (is_moved_otherwise) ChooseWalk(frame);
  if (is_placed_otherwise || released) walk_->Interrupt();
  const bool changes = is_moved_otherwise || is_placed_otherwise || released;
  if (!changes && !context_.schedule.HasKeyAt(frame)) return std::nullopt;
  if (auto error = context_.poses.Evaluate(frame, Side::kAfter, &context_.now)) return error;
  if (is_placed_otherwise && !has_landed) placement_.WarnOfVelocityJump(frame);
  return std::nullopt;
}

bool Baker::EndHolds(int frame) {
  PoseEvaluator& poses = context_.poses;
  const FigureMotion& now = context_.now;
  bool any = false;
  for (const ActiveHolds::Moved& moved : poses.holds().moved()) {
    if (moved.last_frame != frame) continue;
    any = true;
    for (const JointIndex j : moved.joints) {
      poses.curves().joint(j).Resume(frame, now.q[j.value()], now.qd[j.value()], /*as_keyed=*/true);
      if (context_.schedule.HasRegionFrom(frame, j)) continue;
      WarnIfItStopsDead(frame, j, "holds[" + std::to_string(moved.index) + "]", &context_);
    }
  }
  if (any) poses.holds().EndAt(frame);
  return any;
}

bool Baker::BeginHolds(int frame) {
  PoseEvaluator& poses = context_.poses;
  const auto begins = context_.schedule.HoldsFrom(frame);
  if (begins.empty()) return false;
  ComputePositions(poses.figure(), context_.now.X_WR, context_.now.q, &poses.workspace());
  for (const auto& [first_frame, i] : begins) poses.holds().Begin(i, poses.workspace());
  return true;
}

bool Baker::ReleaseObjects(int frame) {
  std::vector<size_t> objects;
  for (const auto& [release_frame, i] : context_.schedule.Releases(frame)) {
    objects.push_back(i);
    const std::string holder = context_.NameOf(animation_.held_objects[i].holder);
    context_.recorder.AddEvent(EventKind::kRelease, frame, holder);
  }
  if (objects.empty()) return false;
  context_.poses.Release(objects, context_.Seconds(frame), context_.now, context_.before);
  context_.now.fall.reset();  // of what it was with them
  return true;
}

// That of the regions that are active from this frame on, else that of the file.
void Baker::ChooseWalk(int frame) {
  walk_->End();
  const std::vector<int> active = regions_.ActiveFrom(frame);
  const SolverSettings& solver = animation_.solver;
  walk_ = &WalkOf(active.empty() ? solver.method : animation_.regions[active[0]].method);
  if (!active.empty()) return walk_->Begin(active, frame);
  exact_.Reset();
  paper_.Reset();
}

}  // namespace hazumi
