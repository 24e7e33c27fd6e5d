// Continuous time, from a frame to the next at which regions, holds, placement or keys change. In
// between
//   the curves        are polynomials, from one change of theirs to the next (DrivenCurves):
//   pieces, the free joints   solve M y'' = -b to a tolerance in steps of their own (ExactDriver),
//   the placement     may have events in each piece: the first one of a frame ends what is known,
//   output frames     are read off the solution.
// Where nothing but curves and limits acts on the regions a piece is solved at once, on all
// threads.

#include "engine/bake/walk/exact_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/text.h"
#include "engine/placement/figure_motion.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

ExactWalk::ExactWalk(BakeContext* context, Refinements* refinements, ThreadPool* pool)
    : RegionWalk(context),
      refinements_(*refinements),
      pool_(pool),
      curves_(context),
      arrivals_(context->animation) {
  const int n = context->poses.figure().num_joints() + kRootAngles;
  has_control_.assign(n, 0);
  control_.q = control_.qd = sample_.q = sample_.qd = VecX::Zero(n);
}

void ExactWalk::Reset() {
  DropDriver();
  curves_.SetRegions({});
  has_begun_ = false;
  std::fill(has_control_.begin(), has_control_.end(), 0);
}

void ExactWalk::Begin(const std::vector<int>& regions, int /*frame*/) {
  curves_.SetRegions(regions);
  arrivals_.Forget();
  DropDriver();
  driver_ = std::make_unique<ExactDriver>(
      ActiveRegions(context_.animation, context_.poses.figure(), regions, context_.starts),
      refinements_.SharpnessOf(regions), context_.now.broken, known_, pool_);
  has_begun_ = false;
}

void ExactWalk::End() {
  if (driver_) WriteReports();
  DropDriver();
  curves_.SetRegions({});
  RootPlacement& placement = context_.poses.placement();
  const double t = context_.Seconds(context_.now.frame);
  LetLooseFly(t);
  if (context_.now.fall) {
    context_.now.fall.reset();
    placement.RenewFlight(t, context_.now);
  }
  placement.TakeBack(t, context_.now);
}

bool ExactWalk::Push(const PushForce& push) {
  PoseEvaluator& poses = context_.poses;
  FigureMotion& now = context_.now;
  RotationState state = poses.StateAt(now), control = WithControl(state);
  const RootHold hold = poses.placement().hold();
  if (!driver_ || !driver_->Push(push, hold, &state)) return false;
  driver_->Push(push, hold, &control);
  control_.qd = control.qd;
  has_begun_ = false;
  for (Eigen::Index j = 0; j < now.qd.size(); ++j) {
    if (poses.free()[j]) now.qd[j] = state.qd[j];
  }
  poses.TurnFreeRoot(state);
  poses.TurnRoot(now.frame, Side::kAfter, &now);
  if (hold.coupling != RootCoupling::kFlight) return true;
  PlaceCenterOfMass(poses.figure(), state.anchor.p, state.anchor.v, &poses.workspace(), &now);
  poses.placement().RenewFlight(context_.Seconds(now.frame), now);
  return true;
}

Result<int> ExactWalk::Advance(int frame) {
  int end = frame + 1;
  while (!context_.schedule.ChangesAt(end)) ++end;
  for (double from = frame; from < end;) {
    if (auto error = context_.CheckCancelled()) return *error;
    const bool fits_holds = driver_ && !context_.poses.holds().empty();
    const Result<double> to = curves_.Take(from, end, fits_holds);
    if (!to.ok()) return to.error();
    const bool begins = !has_begun_;
    Drive(from, to.value(), Vec3::Zero());
    if (begins && driver_) {
      WarnOfInside();
      WarnOfOverlap();
      WarnOfWeightless();
      if (auto error = CheckGaps()) return *error;
      if (!context_.animation.constraints.empty()) {
        arrivals_.Begin(driver_->constraints(), context_.now, &context_.poses.workspace());
      }
    }
    if (from == frame && context_.wants_start) TellStart();
    if (const auto output = context_.recorder.OutputAt(from)) {
      RecordPushes(*output, context_.Seconds(from));
    }
    if (auto error = AdvancePiece(from, to.value(), end)) return *error;
    if (auto error = Arrive(to.value())) return *error;
    from = to.value();
  }
  if (!driver_) return end;
  LookAtArrivals(context_.now);
  WarnOfSpentSprings(end);
  if (auto error = EstimateAt(end)) return *error;
  KeepControl(end);
  return end;
}

// Returns an error where a finer solution does not exist; the refinement is then abandoned.
std::optional<Error> ExactWalk::EstimateAt(int frame) {
  const VecX angles = driver_->Estimate(context_.Seconds(frame));
  const std::vector<int>& active = driver_->regions().indices();
  for (size_t a = 0; a < active.size(); ++a) {
    refinements_.Note(active[a], frame, driver_->estimates().LargestOf(a), active);
  }
  if (const VecX* kept = refinements_.KeepAngles(frame, angles)) {
    const std::vector<double> distances = driver_->Distances(angles, *kept);
    for (size_t a = 0; a < active.size(); ++a) refinements_.NoteKept(active[a], distances[a]);
  }
  if (!refinements_.is_no_help()) return std::nullopt;
  return Error{ErrorCode::kInterrupted, "", "", "finer steps do not help"};
}

std::optional<Error> ExactWalk::Arrive(double frame) {
  FigureMotion motion;
  if (auto error = PoseAt(frame, Side::kBefore, &motion)) return error;
  context_.Arrive(std::move(motion));
  return std::nullopt;
}

void ExactWalk::Drive(double frame, double to, const Vec3& pin_velocity) {
  if (!driver_) return;
  const double end = context_.Seconds(to);
  const bool goes_on = has_begun_ && pin_velocity.isZero(0.0);
  if (!goes_on && driver_->regions().places_root()) {
    context_.poses.placement().LeaveToContacts(context_.Seconds(frame), context_.now);
  }
  const std::vector<LooseObject> loose_before = context_.now.loose;
  if (!goes_on && driver_->regions().has_contacts()) {
    LetLooseFly(context_.Seconds(frame));
    context_.now.loose = context_.poses.objects().LooseAt(frame);
  }
  RotationState state = context_.poses.StateAt(context_.now);
  state.pin_velocity = pin_velocity;
  if (goes_on) return driver_->Drive(end, state, curves_.motion());
  driver_->Begin(context_.Seconds(frame), end, state, ControlStart(state),
                 context_.poses.placement().hold(), curves_.motion());
  if (!driver_->moves_loose()) context_.now.loose.clear();
  driver_->ExchangeLoose(loose_before, context_.now.loose);
  has_begun_ = true;
}

// Objects that nothing but the scene moves from here on.
void ExactWalk::LetLooseFly(double seconds) {
  for (const LooseObject& loose : context_.now.loose) {
    context_.poses.objects().LetFly(loose, seconds);
  }
  context_.now.loose.clear();
}

// Control solutions go on from where they were; others begin with the solution.
RotationState ExactWalk::ControlStart(const RotationState& state) {
  for (size_t c = 0; c < has_control_.size(); ++c) has_control_[c] &= driver_->regions().is_free(c);
  return WithControl(state);
}

RotationState ExactWalk::WithControl(RotationState state) const {
  for (size_t c = 0; c < has_control_.size(); ++c) {
    if (!has_control_[c]) continue;
    state.q[c] = control_.q[c];
    state.qd[c] = control_.qd[c];
  }
  return state;
}

// Where the control solutions are, for those that go on from there.
void ExactWalk::KeepControl(double frame) {
  driver_->SampleControl(context_.Seconds(frame), &control_);
  for (size_t c = 0; c < has_control_.size(); ++c) {
    has_control_[c] = driver_->regions().is_free(static_cast<int>(c));
  }
}

// Smooth curves from `from` to `to`; `end` is where the next change is.
std::optional<Error> ExactWalk::AdvancePiece(double from, double to, double end) {
  const bool falls = context_.poses.placement().is_ballistic();
  const bool accounts = driver_ && context_.options.energy;
  const bool is_bounded = std::isfinite(context_.options.most_work);  // work is checked by steps
  const bool looks_on = falls || accounts || is_bounded ||
                        (driver_ && driver_->regions().has_contacts()) ||
                        context_.options.accelerations || !context_.animation.constraints.empty();
  if (driver_ && !looks_on) return AdvanceUndisturbed(from, to, end);
  const double last = context_.Seconds(to);
  for (double t = context_.Seconds(from); t < last;) {
    if (auto error = context_.CheckCancelled()) return error;
    double next = falls ? std::min(last, t + context_.animation.rate.seconds_per_frame()) : last;
    if (driver_) {
      if (auto error = AdvanceRegions(t, last)) return error;
      next = std::min(next, driver_->time());
    }
    const std::optional<GravityEvent> event = FirstEvent(t, next, to);
    if (auto error = CheckWork(context_.animation.rate.FrameAt(t))) return error;
    if (event) next = event->time;
    if (accounts) driver_->Account(next, event.has_value() && event->is_change());
    if (auto error = RecordUpTo(FrameOf(t, from, to), FrameOf(next, from, to), end)) return error;
    t = next;
    if (!event) continue;
    const Side side = t >= last ? Side::kBefore : Side::kAfter;
    if (auto error = PoseAt(FrameOf(t, from, to), side, &context_.now)) return error;
    Happen(*event, to);
  }
  return std::nullopt;
}

// The regions are solved up to the end at once, or as far as so many frames need.
std::optional<Error> ExactWalk::AdvanceUndisturbed(double from, double to, double end) {
  constexpr size_t kMostAhead = 4096;  // frames
  const double per_frame = context_.recorder.outputs_per_frame();
  const std::vector<int> outputs = context_.recorder.OutputsUpTo(from, to, end);
  double done = from;
  for (size_t i = 0; done < to; i += kMostAhead) {
    std::vector<double> times;
    for (size_t k = i; k < std::min(i + kMostAhead, outputs.size()); ++k) {
      times.push_back(context_.Seconds(outputs[k] / per_frame));
    }
    const bool is_last = i + kMostAhead >= outputs.size();
    if (is_last) times.push_back(context_.Seconds(to));
    const double next = is_last ? to : outputs[i + kMostAhead - 1] / per_frame;
    for (const int frame : EstimatedFrames(done, next, end)) {
      times.push_back(context_.Seconds(frame));
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (auto error = AdvanceAhead(times, done, next, to, end)) return error;
    done = next;
  }
  return std::nullopt;
}

// From frame to frame, with the curves' next change at `to`; the regions can be sampled at `times`.
std::optional<Error> ExactWalk::AdvanceAhead(const std::vector<double>& times, double from,
                                             double next, double to, double end) {
  const auto failure = driver_->AdvanceAhead(times, context_.Seconds(to), context_.options.cancel);
  if (auto error = context_.CheckCancelled()) return error;
  const double reached = failure ? failure->time : context_.Seconds(to);
  AddEvents(reached);
  if (auto error = RecordUpTo(from, std::min(next, FrameOf(reached, from, to)), end)) return error;
  if (!failure) return CheckWork(context_.animation.rate.FrameAt(reached));
  return CannotGoOnAfter(context_.animation.rate.FrameAt(reached), failure->joint, failure->cause);
}

std::optional<Error> ExactWalk::AdvanceRegions(double t, double last) {
  const auto failure = driver_->Advance(t, last);
  AddEvents(last);
  if (!failure) return std::nullopt;
  return CannotGoOnAfter(context_.animation.rate.FrameAt(t), failure->joint, failure->cause);
}

std::vector<ConstraintPush> ExactWalk::ConstraintPushesThere() {
  const size_t count = context_.animation.constraints.size();
  if (!driver_ || count == 0) return std::vector<ConstraintPush>(count);
  return driver_->ConstraintPushes(context_.Seconds(context_.now.frame));
}

SceneContacts ExactWalk::ContactsThere() {
  return driver_ ? driver_->ContactsAt(context_.Seconds(context_.now.frame)) : SceneContacts();
}

void ExactWalk::RecordPushes(int output, double t) {
  if (!driver_ || !context_.recorder.keeps_frames()) return;
  if (driver_->regions().has_contacts())
    context_.recorder.SetContacts(output, driver_->ContactsAt(t));
  if (context_.animation.constraints.empty()) return;
  context_.recorder.SetConstraintPushes(output, driver_->ConstraintPushes(t));
}

std::optional<GravityEvent> ExactWalk::FirstEvent(double t, double next, double to) {
  const auto pose = [this, to](double seconds, FigureMotion* motion) {
    ++poses_looked_at_;
    const bool at_end = seconds >= context_.Seconds(to);
    const double frame = at_end ? to : std::min(to, context_.animation.rate.FrameAt(seconds));
    PoseWithoutPlace(frame, seconds, at_end ? Side::kBefore : Side::kAfter, Gaps::kLeft, motion);
  };
  return context_.poses.placement().FirstEvent(t, next, pose);
}

// The figure is at the event.
void ExactWalk::Happen(const GravityEvent& event, double to) {
  const double frame = context_.now.frame;
  const RootEvent happened = context_.poses.placement().Happen(event, context_.now);
  AddEvent(happened.kind, frame, happened.joint);
  if (!event.is_change() || !driver_) return;
  control_ = context_.poses.StateAt(context_.now);
  KeepControl(frame);
  has_begun_ = false;
  Drive(frame, to, happened.pin_velocity);
}

std::optional<Error> ExactWalk::PoseAt(double frame, Side side, FigureMotion* motion) {
  PoseWithoutPlace(frame, context_.Seconds(frame), side, Gaps::kClosed, motion);
  context_.poses.placement().Place(frame, side, motion);
  return context_.poses.SolveHolds(side, motion);
}

void ExactWalk::PoseWithoutPlace(double frame, double seconds, Side side, Gaps gaps,
                                 FigureMotion* motion) {
  const FigureMotion& now = context_.now;
  *motion = now;
  context_.poses.SetJoints(frame, side, motion);
  if (driver_) {
    driver_->Sample(seconds, &sample_, gaps);
    for (int j = 0; j < static_cast<int>(motion->q.size()); ++j) {
      if (!context_.poses.free()[j]) continue;
      motion->q[j] = driver_->regions().is_frozen(j) ? now.q[j] : sample_.q[j];
      motion->qd[j] = driver_->regions().is_frozen(j) ? 0.0 : sample_.qd[j];
    }
    context_.poses.TurnFreeRoot(sample_);
    motion->fall = driver_->solves_fall() ? std::optional(sample_.anchor) : std::nullopt;
    if (driver_->moves_loose()) motion->loose = sample_.loose;
  }
  context_.poses.TurnRoot(frame, side, motion);
}

// What regions drive moves as the islands do, which are at its time.
MotionAcceleration ExactWalk::AccelerationOf(const FigureMotion& motion) {
  free_rates_.setZero(sample_.q.size());
  VecX free = VecX::Zero(sample_.q.size());
  std::optional<Vec3> fall;
  if (driver_) fall = driver_->Accelerations(context_.Seconds(motion.frame), &free_rates_, &free);
  return Completed(motion, free, fall);
}

// An impact on limits, where the regions begin, has happened.
void ExactWalk::TellStart() {
  began_with_ = AccelerationOf(context_.now);
  began_with_rates_ = context_.now.qd;
  for (int j = 0; j < static_cast<int>(began_with_rates_.size()); ++j) {
    if (driver_ && context_.poses.free()[j]) began_with_rates_[j] = free_rates_[j];
  }
}

// The frame of an instant between two others, which are exact.
double ExactWalk::FrameOf(double seconds, double from, double to) const {
  if (seconds >= context_.Seconds(to)) return to;
  return std::clamp(context_.animation.rate.FrameAt(seconds), from, to);
}

// Whole frames after `from` up to `to`, before `end`, at which errors are estimated: all of them,
// so that no frame depends on the output rate. Version 1 of the solver estimates at output frames.
std::vector<int> ExactWalk::EstimatedFrames(double from, double to, double end) const {
  std::vector<int> frames;
  if (!driver_ || !is_causal()) return frames;
  const auto first = static_cast<int>(std::floor(from + kSameFrame)) + 1;
  for (int frame = first; frame <= to + kSameFrame && frame < end; ++frame) frames.push_back(frame);
  return frames;
}

std::optional<Error> ExactWalk::RecordUpTo(double from, double to, double end) {
  const bool can_fail = driver_ || !context_.poses.holds().empty();
  if (!context_.recorder.keeps_frames() && !can_fail) return std::nullopt;
  for (const int frame : EstimatedFrames(from, to, end)) {
    if (auto error = EstimateAt(frame)) return error;
  }
  for (const int output : context_.recorder.OutputsUpTo(from, to, end)) {
    if (auto error = context_.CheckCancelled()) return error;
    const double frame = output / context_.recorder.outputs_per_frame();
    FigureMotion motion;
    if (auto error = PoseAt(frame, Side::kAfter, &motion)) return error;
    if (driver_ && !is_causal()) (void)driver_->Estimate(context_.Seconds(frame));
    LookAtArrivals(motion);
    context_.Record(output, motion, LimitOf(motion));
    RecordPushes(output, context_.Seconds(frame));
    if (context_.options.accelerations) {
      context_.recorder.SetAcceleration(output, AccelerationOf(motion));
    }
  }
  return std::nullopt;
}

}  // namespace hazumi
