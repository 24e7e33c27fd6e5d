// A bake as a walk from change to change. At each frame F where something changes (CrossFrame)
//   what ends at F ends: regions, holds, placement, objects are let go of,
//   what begins at F begins, from the figure as it came there,
//   the figure is evaluated anew: the limit from the right.
// From F to the next frame a walk advances it (RegionWalk). Where no region is active the state at
// a frame is a checkpoint: all that comes after depends on it and the animation alone.

#include "engine/bake/baker.h"

#include <algorithm>

#include "engine/base/text.h"

namespace hazumi {

Baker::Baker(const Animation& animation, const BakeOptions& options, Motion* motion,
             ThreadPool* pool)
    : animation_(animation),
      rules_(animation.solver.rules()),
      motion_(motion),
      context_(animation, options, motion),
      regions_(&context_),
      placement_(&context_),
      seams_(&context_),
      refinements_(animation),
      exact_(&context_, &refinements_, pool),
      paper_(&context_),
      walk_(&WalkOf(animation.solver.method)) {}

RegionWalk& Baker::WalkOf(Method method) {
  if (method == Method::kExact) return exact_;
  return paper_;
}

std::optional<Warning> Baker::EndEarly() {
  if (context_.ended_early) context_.recorder.DropUnwritten();
  return context_.ended_early;
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
  nothing.objects = poses.objects().AtFirst();
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
  checkpoint.objects = poses.objects().states();
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
  exact_.Reset();
  if (rules_.is_causal) return BakeWithRefinements(stretch);
  for (;;) {
    context_.recorder.BeginStretch(stretch);
    Result<std::optional<Checkpoint>> next = BakeOnce(stretch->start);
    if (!next.ok() || !context_.options.refine) return next;
    if (!refinements_.SharpenAll(regions_.begun(), &context_.recorder)) return next;
  }
}

// Returns the next checkpoint; nullopt if the animation ends before.
Result<std::optional<Checkpoint>> Baker::BakeOnce(const Checkpoint& start) {
  Restore(start);
  exact_.BeginStretch(start.frame);
  const Result<int> end = AdvanceToCheckpoint(start.frame);
  if (!end.ok()) return end.error();
  if (end.value() > animation_.last_frame) return std::optional<Checkpoint>();
  return std::optional(Save(end.value()));
}

// Repeats the bake with finer steps from the first frame that misses its tolerance. Earlier frames
// keep their values. Where finer steps do not help, or fail, the solution before stays.
Result<std::optional<Checkpoint>> Baker::BakeWithRefinements(Stretch* stretch) {
  context_.recorder.BeginStretch(stretch);
  Result<std::optional<Checkpoint>> next = BakeOnce(stretch->start);
  const std::vector<int> begun = regions_.begun();
  while (next.ok() && context_.options.refine) {
    const std::optional<int> miss = refinements_.SharpenFromFirstMiss(begun);
    if (!miss) break;
    Recorder::Found found = context_.recorder.BeginAgain(stretch, *miss);
    Result<std::optional<Checkpoint>> finer = BakeOnce(stretch->start);
    if (finer.ok() || context_.CheckCancelled()) {
      next = std::move(finer);
      continue;
    }
    exact_.KeepLogs();
    context_.recorder.Restore(std::move(found));
    context_.ended_early.reset();
    refinements_.GiveUp();
  }
  if (!next.ok()) return next;
  refinements_.Report(begun, &context_.recorder);
  for (const int r : begun) WarnOfOpenAccount(r);
  return next;
}

void Baker::WarnOfOpenAccount(int region) {
  const std::optional<EnergyBalance>& energy = context_.recorder.report(region).energy;
  if (!energy || !energy->is_open()) return;
  context_.recorder.AddWarning("regions[" + std::to_string(region) + "]",
                               FormatShort(energy->residual()) +
                                   " J of its energy are unexplained, more than a millionth of "
                                   "the " +
                                   FormatShort(energy->turnover()) +
                                   " J that changed hands; a smaller tolerance "
                                   "explains more");
}

// Up to a frame where something changes while no region is active, or beyond the last frame.
Result<int> Baker::AdvanceToCheckpoint(int frame) {
  const bool accelerations = context_.options.accelerations;
  for (;;) {
    const bool is_last = frame == animation_.last_frame;
    std::optional<MotionAcceleration> last;
    if (is_last && accelerations) last = walk_->ArrivedWith();
    std::vector<ConstraintPush> pushes;
    SceneContacts contacts;
    if (is_last) {
      pushes = walk_->ConstraintPushesThere();
      contacts = walk_->ContactsThere();
    }
    seams_.Open(frame, walk_);
    if (auto error = CrossFrame(frame)) return *error;
    context_.RecordNow();
    if (last) SetAcceleration(frame, *last);
    if (const auto output = context_.recorder.OutputAt(frame); is_last && output) {
      context_.recorder.SetConstraintPushes(*output, pushes);
      context_.recorder.SetContacts(*output, std::move(contacts));
    }
    if (is_last) break;
    seams_.Cross();
    context_.wants_start = accelerations || seams_.is_open();
    const Result<int> next = walk_->Advance(frame);
    if (!next.ok()) return next.error();
    TellStart(frame);
    frame = next.value();
    if (!walk_->has_regions() && context_.schedule.ChangesAt(frame)) return frame;
  }
  walk_->End();
  return animation_.last_frame + 1;
}

// What is known only now: with which accelerations the figure set out at the frame.
void Baker::TellStart(int frame) {
  if (context_.options.accelerations) SetAcceleration(frame, walk_->began_with());
  seams_.Close(walk_->began_with_rates(), walk_->began_with());
}

void Baker::SetAcceleration(int frame, const MotionAcceleration& acceleration) {
  const auto output = context_.recorder.OutputAt(frame);
  if (output) context_.recorder.SetAcceleration(*output, acceleration);
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
  const bool released = HandOverObjects(frame);
  const bool regions_begun = regions_.Begin(frame, *walk_);
  const bool holds_begun = BeginHolds(frame);
  const bool placed = placement_.Begin(frame, was_keyed);
  if (released) {
    if (auto error = ReleaseAsItSetsOut(frame)) return error;
  }
  const bool is_moved_otherwise = regions_ended || holds_ended || regions_begun || holds_begun;
  const bool is_placed_otherwise = unplaced || placed;
  if (is_moved_otherwise) ChooseWalk(frame);
  const bool is_forced_otherwise = ChangeForces(frame);
  if (is_placed_otherwise || released || is_forced_otherwise) walk_->Interrupt();
  if (rules_.keeps_speed_of_what_touches) LeaveRootToContacts(frame);
  const bool changes = is_moved_otherwise || is_placed_otherwise || released || is_forced_otherwise;
  if (!changes && !context_.schedule.HasKeyAt(frame)) return std::nullopt;
  if (auto error = context_.poses.Evaluate(frame, Side::kAfter, &context_.now)) return error;
  if (auto error = Push(frame)) return error;
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

// An object goes from hand to hand, or is let go of.
bool Baker::HandOverObjects(int frame) {
  std::vector<ObjectChange> changes;
  for (const auto& [at, i] : context_.schedule.HandOvers(frame)) {
    const std::vector<Holder>& holders = animation_.held_objects[i].holders;
    const auto next = std::find_if(holders.begin(), holders.end(),
                                   [&](const Holder& h) { return h.first_frame == frame; });
    const bool is_taken = next != holders.end() && frame > animation_.first_frame;
    changes.push_back(
        {static_cast<size_t>(i), is_taken ? static_cast<int>(next - holders.begin()) : -1});
    if (is_taken) continue;
    const auto before = std::find_if(holders.begin(), holders.end(),
                                     [&](const Holder& h) { return h.last_frame == frame; });
    context_.recorder.AddEvent(EventKind::kRelease, frame, context_.NameOf(before->joint));
  }
  if (changes.empty()) return false;
  const std::vector<double> jumps = context_.poses.HandOver(changes, context_.now, context_.before);
  for (size_t i = 0; i < changes.size(); ++i) WarnOfJump(frame, changes[i], jumps[i]);
  for (const ObjectChange& change : changes) {
    if (change.holder < 0) WarnIfLetGoInside(frame, change.object);
  }
  context_.now.fall.reset();  // of what it was with them
  return true;
}

// Lets contacts that place the figure take over its velocity without a pin.
void Baker::LeaveRootToContacts(int frame) {
  if (!walk_->leaves_root_to_contacts()) return;
  PoseEvaluator& poses = context_.poses;
  poses.SetJoints(frame, Side::kAfter, &context_.now);
  poses.TurnRoot(frame, Side::kAfter, &context_.now);
  poses.placement().LeaveToContacts(context_.Seconds(frame), context_.now);
}

// Other forces act from outside from here on: a fall that they bent begins anew.
bool Baker::ChangeForces(int frame) {
  if (!context_.schedule.ForcesChangeAt(frame)) return false;
  FigureMotion& now = context_.now;
  if (now.fall) {
    now.fall.reset();
    context_.poses.placement().RenewFlight(context_.Seconds(frame), now);
  }
  return true;
}

std::optional<Error> Baker::Push(int frame) {
  bool any = false;
  for (const auto& [first_frame, i] : context_.schedule.ForcesFrom(frame)) {
    const auto* push = std::get_if<PushForce>(&animation_.forces[i].action);
    if (!push) continue;
    any = true;
    if (walk_->Push(*push)) continue;
    const std::string joint =
        push->at.joint ? context_.NameOf(*push->at.joint) : context_.poses.figure().root_name();
    return Error{ErrorCode::kSemantics, "", "forces[" + std::to_string(i) + "]",
                 "no region moves \"" + joint + "\" in frame " + std::to_string(frame) +
                     ", so that nothing can give way to the push; begin a region there that has it "
                     "or a joint between it and what holds it, or move the push"};
  }
  if (!any) return std::nullopt;
  return context_.poses.Evaluate(frame, Side::kAfter, &context_.now);
}

void Baker::WarnOfJump(int frame, const ObjectChange& change, double jump) {
  constexpr double kSeen = 0.01;  // [m]
  if (jump < kSeen) return;
  const HeldObject& object = animation_.held_objects[change.object];
  const std::string to =
      change.holder < 0
          ? "to its key"
          : "into joint \"" + context_.NameOf(object.holders[change.holder].joint) + "\"";
  context_.recorder.AddWarning({"held_objects[" + std::to_string(change.object) + "]",
                                "\"" + object.name + "\" jumps by " + FormatShort(jump) + " m " +
                                    to + " at frame " + std::to_string(frame) +
                                    ": bring them together there",
                                frame});
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
