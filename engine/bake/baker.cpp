#include "engine/bake/baker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/bake/limits.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

constexpr double kSameFrame = 1e-9;  // instants this near are one [frames]

Error CannotGoOn(std::string place, std::string message) {
  return {ErrorCode::kSemantics, "", std::move(place), std::move(message)};
}

}  // namespace

Baker::Baker(const Animation& animation, const BakeOptions& options, Motion* motion)
    : animation_(animation),
      cancel_(options.cancel),
      energy_(options.energy),
      refine_(options.refine),
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
  const auto mark_ends = [&](const auto& spans) {
    for (const auto& span : spans) {
      mark(span.first_frame);
      mark(span.last_frame);
    }
  };
  is_edge_.assign(Index(animation_.last_frame) + 1, 0);
  mark(animation_.last_frame);
  mark_ends(animation_.regions);
  mark_ends(animation_.placements);
  mark_ends(animation_.holds);
  for (const HeldObject& object : animation_.held_objects) {
    if (object.release_frame) mark(*object.release_frame);
  }
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
  motion_->frames.resize(std::max(0, last - first_output_ + 1));
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
    holds_.push_back({&hold, HoldSolver(figure_, hold.joint, hold.hold_orientation), held.target});
  }
}

Result<std::optional<Checkpoint>> Baker::BakeStretch(const GroupLogs& known, Stretch* stretch) {
  known_ = &known;
  stretch_ = stretch;
  std::fill(refinements_.begin(), refinements_.end(), Refinement());
  int frame;
  do {
    stretch->events.clear();
    stretch->warnings.clear();
    stretch->logs.clear();
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

// ceil(frame time / step) equal steps; a frame that is a whole number of steps but for rounding
// gets that number.
Baker::Failure Baker::AdvanceFrame(int frame) {
  const double step = driver_ ? driver_->step() : animation_.solver.step;
  const double wanted = animation_.rate.seconds_per_frame() / step;
  const int steps = std::max(1, static_cast<int>(std::ceil(wanted * (1.0 - 1e-12))));
  for (int i = 0; i < steps; ++i) {
    if (is_cancelled()) return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
    const double from = frame + static_cast<double>(i) / steps;
    const double to = i + 1 == steps ? frame + 1.0 : frame + (i + 1.0) / steps;
    if (auto error = Step(from, to, i + 1 == steps)) return error;
    if (i + 1 < steps) RecordIfOutput();
  }
  return std::nullopt;
}

Baker::Failure Baker::Step(double frame_from, double frame_to, bool to_boundary) {
  const double seconds = Seconds(frame_to - frame_from);
  FigureMotion next = now_;
  next.frame = frame_to;
  if (auto error = StepRegions(seconds, &next)) return error;
  const Side side = to_boundary ? Side::kBefore : Side::kAfter;
  curves_.SampleJoints(frame_to, side, free_, &next);
  curves_.SampleRootOrientation(frame_to, side, &next);
  if (auto error = StepPlacement(frame_from, seconds, side, &next)) return error;
  RecordBetween(now_, next);
  now_ = std::move(next);
  before_ = LimitOf(now_);
  return FinishLanding();
}

Baker::Failure Baker::StepRegions(double seconds, FigureMotion* next) {
  if (!driver_) return std::nullopt;
  const auto start = std::chrono::steady_clock::now();
  std::vector<JointIndex> stops;
  const auto failure =
      driver_->Advance(now_, root_hold(), seconds, &ws_, &next->q, &next->qd, &stops);
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
  if (failure) {
    return CannotGoOnAfter(now_.frame, failure->joint, failure->cause);
  }
  for (const int r : driver_->active()) {
    RegionReport& report = motion_->regions[r];
    ++report.steps;
    ++report.evaluations;
    report.solves += driver_->solves_of_last_step();
    report.microseconds += spent.count() / static_cast<double>(driver_->active().size());
  }
  for (const JointIndex j : stops) {
    AddEvent(EventKind::kStop, next->frame, figure_.joint(j).name);
  }
  return std::nullopt;
}

Baker::Failure Baker::StepPlacement(double frame_from, double seconds, Side side,
                                    FigureMotion* next) {
  if (!gravity_) {
    PlaceRoot(next->frame, side, next);
    return SolveHolds(next->frame, side, next);
  }
  const std::optional<GroupIndex> pin_before = gravity_->pin();
  gravity_->Advance(now_, seconds, &ws_, next);
  for (const GravityPlacement::Event& event : gravity_->events()) {
    const double frame = frame_from + animation_.rate.FrameAt(event.seconds_into_step);
    using Kind = GravityPlacement::EventKind;
    if (event.kind == Kind::kTakeOff) {
      AddEvent(EventKind::kTakeOff, frame, figure_.group(*pin_before).name);
    }
    if (event.kind == Kind::kApex) AddEvent(EventKind::kApex, frame, "");
    if (event.kind == Kind::kLanding) {
      AddEvent(EventKind::kLanding, frame, figure_.group(*gravity_->pin()).name);
    }
  }
  return std::nullopt;
}

// An invalid joint is the root.
Error Baker::CannotGoOnAfter(double frame, JointIndex joint, const std::string& cause) const {
  const std::string who = joint.is_valid() ? "joint \"" + figure_.joint(joint).name + "\""
                                           : "root \"" + figure_.root_name() + "\"";
  return CannotGoOn(RegionPlace(joint.is_valid() ? std::optional(joint) : std::nullopt),
                    "cannot go on after frame " + FormatShort(frame) + ": " + who + ": " + cause);
}

// "regions[1]", where it is known which: the one that moves the joint, or the only active one.
std::string Baker::RegionPlace(std::optional<JointIndex> joint) const {
  std::vector<int> candidates = driver_ ? driver_->active() : exact_->active();
  std::erase_if(candidates, [&](int r) {
    const auto& joints = animation_.regions[r].joints;
    return joint && !std::binary_search(joints.begin(), joints.end(), *joint);
  });
  if (candidates.size() != 1) return "regions";
  return "regions[" + std::to_string(candidates[0]) + "]";
}

// A landing stops the root's fall; the free joints feel the blow. [METHOD 2, "kicks"]
Baker::Failure Baker::FinishLanding() {
  if (!gravity_ || !gravity_->has_landed()) return std::nullopt;
  const JointIndex pin = figure_.group(*gravity_->pin()).first;
  if (driver_ && !driver_->ApplyLanding(now_, pin, &ws_, &now_.qd)) {
    return CannotGoOn(RegionPlace(std::nullopt), "cannot go on after the landing at frame " +
                                                     FormatShort(now_.frame) +
                                                     ": a joint in a region moves no mass");
  }
  gravity_->Place(&ws_, &now_);
  return std::nullopt;
}

Baker::Failure Baker::Evaluate(double frame, Side side, FigureMotion* motion) {
  motion->frame = frame;
  curves_.SampleJoints(frame, side, free_, motion);
  TurnRoot(frame, side, motion);
  PlaceRoot(frame, side, motion);
  return SolveHolds(frame, side, motion);
}

void Baker::PlaceRoot(double frame, Side side, FigureMotion* motion) {
  if (fall_) {
    fall_->Place(Seconds(frame), &ws_, motion);
  } else if (gravity_) {
    gravity_->Place(&ws_, motion);
  } else if (span_ && span_->kind == PlacementKind::kPinned) {
    PinRoot(figure_, figure_.group(*span_->pin).first, pin_W_, &ws_, motion);
  } else {
    curves_.SampleRootPosition(frame, side, motion);
  }
}

Baker::Failure Baker::SolveHolds(double frame, Side side, FigureMotion* motion) {
  if (holds_.empty()) return std::nullopt;
  const PoseOf<Jet> X_WR = RootJet(curves_.RootAnglesAt(frame, side), *motion);
  std::vector<Jet> q(figure_.num_joints());
  for (int j = 0; j < figure_.num_joints(); ++j) {
    q[j] = Jet(motion->q[j], motion->qd[j], motion->qdd[j]);
  }
  for (ActiveHold& active : holds_) {
    const HoldSolution solution = active.solver.Solve(X_WR, active.target, &q);
    const size_t index = active.hold - animation_.holds.data();
    if (!solution.reached) {
      return CannotGoOn("holds[" + std::to_string(index) + "]",
                        "\"" + figure_.group(active.hold->joint).name +
                            "\" is out of reach at frame " + FormatShort(frame) + ": " +
                            FormatShort(solution.distance) +
                            " m short; move the root nearer or shorten the hold");
    }
    for (const JointIndex j : active.solver.joints()) {
      motion->q[j.value()] = q[j.value()].v;
      motion->qd[j.value()] = q[j.value()].d;
      motion->qdd[j.value()] = q[j.value()].dd;
    }
  }
  return std::nullopt;
}

Result<Motion> Bake(const Animation& animation, const BakeOptions& options) {
  const auto falls = [](const PlacementSpan& span) { return span.kind == PlacementKind::kGravity; };
  const auto& spans = animation.placements;
  const auto span = std::find_if(spans.begin(), spans.end(), falls);
  if (span != spans.end() && animation.figure->groups().empty()) {
    return CannotGoOn("placements[" + std::to_string(span - spans.begin()) + "]",
                      "the figure has no joint that could be pinned where it lands; give it one");
  }
  Motion motion;
  Baker baker(animation, options, &motion);
  Result<Checkpoint> first = baker.Begin();
  if (!first.ok()) return first.error();
  Stretch stretch;
  stretch.start = std::move(first.value());
  for (;;) {
    Result<std::optional<Checkpoint>> next = baker.BakeStretch({}, &stretch);
    if (!next.ok()) return next.error();
    stretch.AppendTo(&motion);
    if (!next.value()) break;
    stretch.start = std::move(*next.value());
  }
  SortByTime(&motion.events);
  return motion;
}

}  // namespace hazumi
