// Continuous time: from a frame to the next at which regions, holds, placement or curves change.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/bake/baker.h"
#include "engine/bake/limits.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

constexpr double kSameFrame = 1e-9;  // instants this near are one [frames]

DrivenCurve ToDriven(const CurveTrack::Piece& piece, FrameRate rate) {
  DrivenCurve curve;
  const auto c = piece.interval.coefficients();
  std::copy(c.begin(), c.end(), curve.c.begin());
  curve.degree = 3;
  while (curve.degree > 0 && curve.c[curve.degree] == 0.0) --curve.degree;
  if (std::isfinite(piece.first_frame)) curve.start = rate.SecondsAt(piece.first_frame);
  return curve;
}

}  // namespace

// The method of the regions that are active from this frame on, else that of the file.
bool Baker::IsExact(int frame) const {
  for (const int r : active_regions_) {
    const DynamicsRegion& region = animation_.regions[r];
    if (frame < region.last_frame) return region.method == Method::kExact;
  }
  return animation_.solver.method == Method::kExact;
}

Result<int> Baker::AdvanceExact(int frame) {
  int end = frame + 1;
  while (!schedule_.ChangesAt(end)) ++end;
  for (double from = frame; from < end;) {
    const double to = DriveCurves(from, end);
    if (exact_ && !holds_.empty()) {
      if (auto error = FitHolds(from, to)) return *error;
    }
    if (auto error = BeginExact(from, to, Vec3::Zero())) return *error;
    if (auto error = AdvancePiece(from, to, end)) return *error;
    if (to < end) {
      FigureMotion motion;
      if (auto error = PoseAt(to, Side::kBefore, &motion)) return *error;
      now_ = std::move(motion);
    }
    from = to;
  }
  if (auto error = FinishExact(end)) return *error;
  return end;
}

// Sets what drives the model from `from` on; returns up to which frame that holds. Curves break at
// keys; the motion of holds is fitted frame by frame.
double Baker::DriveCurves(double from, int end) {
  double to = end;
  const auto take = [&](CurveTrack& track, DrivenCurve* curve) {
    const CurveTrack::Piece piece = track.PieceAt(from);
    *curve = ToDriven(piece, animation_.rate);
    if (curve->degree > 0 || piece.last_frame > from) to = std::min(to, piece.last_frame);
  };
  const int n = figure_.num_joints();
  for (int j = 0; j < n; ++j) {
    if (!free_[j]) take(curves_.joint(JointIndex(j)), &driven_.angles[j]);
  }
  for (int i = 0; i < kRootAngles; ++i) {
    if (!root_free_) take(curves_.root(kRootAngleZ + i), &driven_.angles[n + i]);
    take(curves_.root(kRootX + i), &driven_.root_position[i]);
  }
  if (!holds_.empty() && exact_) to = std::min(to, std::floor(from + kSameFrame) + 1.0);
  return to;
}

// Fits the joints that holds move, from one frame to the next, by polynomials through Chebyshev
// points (Newton's form, multiplied out about the middle).
Baker::Failure Baker::FitHolds(double from, double to) {
  if (root_free_ || DependsOnRegions(root_hold())) {
    return Error{ErrorCode::kSemantics, "", "holds",
                 "cannot go on after frame " + FormatShort(from) +
                     ": a held joint cannot be solved while a region moves the root; end the hold "
                     "before the region or leave the joints up to the pin out of it"};
  }
  constexpr int kPoints = DrivenCurve::kMaxDegree + 1;
  constexpr double kPi = 3.14159265358979323846;
  const double middle = 0.5 * Seconds(from + to), half = 0.5 * Seconds(to - from);
  double s[kPoints];
  std::vector<FigureMotion> poses(kPoints, now_);
  for (int i = 0; i < kPoints; ++i) {
    s[i] = half * std::cos(kPi * (2 * i + 1) / (2.0 * kPoints));
    const double frame = animation_.rate.FrameAt(middle + s[i]);
    if (auto error = Evaluate(frame, Side::kAfter, &poses[i])) return error;
  }
  for (const ActiveHold& active : holds_) {
    for (const JointIndex j : active.solver.joints()) {
      double d[kPoints];
      for (int i = 0; i < kPoints; ++i) d[i] = poses[i].q[j.value()];
      for (int level = 1; level < kPoints; ++level) {
        for (int i = kPoints - 1; i >= level; --i) d[i] = (d[i] - d[i - 1]) / (s[i] - s[i - level]);
      }
      DrivenCurve& curve = driven_.angles[j.value()];
      curve = DrivenCurve();
      curve.start = middle;
      curve.degree = DrivenCurve::kMaxDegree;
      for (int i = kPoints - 1; i >= 0; --i) {  // c := c (x - s_i) + d_i
        for (int p = kPoints - 1; p > 0; --p) curve.c[p] = curve.c[p - 1] - s[i] * curve.c[p];
        curve.c[0] = d[i] - s[i] * curve.c[0];
      }
    }
  }
  return std::nullopt;
}

// Whether a free joint lies between root and pin, or the figure flies.
bool Baker::DependsOnRegions(const RootHold& hold) const {
  if (hold.coupling == RootCoupling::kFlight) return true;
  if (hold.coupling == RootCoupling::kPrescribed) return false;
  for (JointIndex j = figure_.joint(hold.pin).parent; j.is_valid(); j = figure_.joint(j).parent) {
    if (free_[j.value()]) return true;
  }
  return false;
}

// The rotations of the figure at a frame; free ones as they are now.
RotationState Baker::StateAt(double frame) {
  const int n = figure_.num_joints();
  RotationState state{VecX(n + kRootAngles), VecX(n + kRootAngles)};
  state.q.head(n) = now_.q;
  state.qd.head(n) = now_.qd;
  if (root_free_) {
    state.q.tail(kRootAngles) = root_.q;
    state.qd.tail(kRootAngles) = root_.qd;
  } else {
    const RootAngles angles = curves_.RootAnglesAt(frame, Side::kAfter);
    for (int i = 0; i < kRootAngles; ++i) {
      state.q[n + i] = angles.angle[i];
      state.qd[n + i] = angles.rate[i];
    }
  }
  return state;
}

Baker::Failure Baker::BeginExact(double frame, double to, const Vec3& v_pin) {
  if (!exact_) return std::nullopt;
  const RotationState state = StateAt(frame);
  if (exact_begun_ && v_pin.isZero(0.0)) {
    exact_->Drive(Seconds(to), state, driven_);
    return std::nullopt;
  }
  RotationState control = state;
  for (int c = 0; c < static_cast<int>(has_control_.size()); ++c) {
    if (!exact_->is_free(c)) {
      has_control_[c] = 0;
    } else if (has_control_[c]) {
      control.q[c] = control_.q[c];
      control.qd[c] = control_.qd[c];
    }
  }
  exact_->Begin(Seconds(frame), Seconds(to), state, control, root_hold(), driven_);
  if (!v_pin.isZero(0.0)) exact_->FeelPin(v_pin);
  exact_begun_ = true;
  return std::nullopt;
}

// Where the root's orientation comes from: a region or its curves.
void Baker::TurnRoot(double frame, Side side, FigureMotion* motion) {
  if (!root_free_) return curves_.SampleRootOrientation(frame, side, motion);
  RootAngles angles;
  for (int i = 0; i < kRootAngles; ++i) {
    angles.angle[i] = root_.q[i];
    angles.rate[i] = root_.qd[i];
    angles.acceleration[i] = 0.0;
  }
  SetRootOrientation(angles, motion);
}

void Baker::PoseWithoutPlace(double frame, double seconds, Side side, FigureMotion* motion) {
  *motion = now_;
  motion->frame = frame;
  curves_.SampleJoints(frame, side, free_, motion);
  if (exact_) {
    RotationState state = control_;
    exact_->Sample(seconds, &state);
    for (int j = 0; j < figure_.num_joints(); ++j) {
      if (!free_[j]) continue;
      motion->q[j] = exact_->is_frozen(j) ? now_.q[j] : state.q[j];
      motion->qd[j] = exact_->is_frozen(j) ? 0.0 : state.qd[j];
    }
    root_.q = state.q.tail(kRootAngles);
    root_.qd = state.qd.tail(kRootAngles);
  }
  TurnRoot(frame, side, motion);
}

Baker::Failure Baker::PoseAt(double frame, Side side, FigureMotion* motion) {
  PoseWithoutPlace(frame, Seconds(frame), side, motion);
  PlaceRoot(frame, side, motion);
  return SolveHolds(frame, side, motion);
}

// Smooth curves from `from` to `to`; `end` is where the next change is.
Baker::Failure Baker::AdvancePiece(double from, double to, double end) {
  if (exact_ && !fall_ && !energy_) return AdvanceUndisturbed(from, to, end);
  const double last = Seconds(to);
  for (double t = Seconds(from); t < last;) {
    if (is_cancelled()) return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
    double next = fall_ ? std::min(last, t + animation_.rate.seconds_per_frame()) : last;
    if (exact_) {
      if (auto error = AdvanceRegions(t, last)) return *error;
      next = std::min(next, exact_->time());
    }
    const std::optional<GravityEvent> event = FirstGravityEvent(t, next, to);
    if (event) next = event->time;
    if (exact_ && energy_) exact_->Account(next, event.has_value() && event->is_change());
    if (auto error = RecordUpTo(FrameOf(t, from, to), FrameOf(next, from, to), end)) return error;
    t = next;
    if (!event) continue;
    const double frame = FrameOf(t, from, to);
    if (auto error = PoseAt(frame, t >= last ? Side::kBefore : Side::kAfter, &now_)) return error;
    if (auto error = Happen(*event, to)) return error;
  }
  return std::nullopt;
}

// Where nothing but curves and stops acts on the regions they are solved up to the end at once, or
// as far as so many frames need.
Baker::Failure Baker::AdvanceUndisturbed(double from, double to, double end) {
  constexpr size_t kMostAhead = 4096;  // frames
  const double last = Seconds(to);
  const std::vector<int> outputs = recorder_.OutputsUpTo(from, to, end);
  double done = from;
  for (size_t i = 0; done < to; i += kMostAhead) {
    std::vector<double> times;
    for (size_t k = i; k < std::min(i + kMostAhead, outputs.size()); ++k) {
      times.push_back(Seconds(outputs[k] / recorder_.outputs_per_frame()));
    }
    const bool is_last = i + kMostAhead >= outputs.size();
    if (is_last) times.push_back(last);
    std::sort(times.begin(), times.end());
    const double next = is_last ? to : outputs[i + kMostAhead - 1] / recorder_.outputs_per_frame();
    if (auto error = AdvanceAhead(times, done, next, to, end)) return error;
    done = next;
  }
  return std::nullopt;
}

// From frame to frame, with the curves' next change at `to`; the regions can be sampled at `times`.
Baker::Failure Baker::AdvanceAhead(const std::vector<double>& times, double from, double next,
                                   double to, double end) {
  const auto failure = exact_->AdvanceAhead(times, Seconds(to), cancel_);
  if (is_cancelled()) return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
  const double reached = failure ? failure->time : Seconds(to);
  AddHits(reached);
  if (auto error = RecordUpTo(from, std::min(next, FrameOf(reached, from, to)), end)) return error;
  if (!failure) return std::nullopt;
  return CannotGoOnAfter(animation_.rate.FrameAt(reached), failure->joint, failure->cause);
}

// Those up to a time [s].
void Baker::AddHits(double until) {
  for (const ExactDriver::Hit& hit : exact_->TakeHits()) {
    if (hit.time > until) continue;
    recorder_.AddStop(JointIndex(hit.coordinate), hit.time, hit.last_time, hit.count);
  }
}

// The frame of an instant between two others, which are exact.
double Baker::FrameOf(double seconds, double from, double to) const {
  if (seconds >= Seconds(to)) return to;
  return std::clamp(animation_.rate.FrameAt(seconds), from, to);
}

Baker::Failure Baker::AdvanceRegions(double t, double last) {
  const auto failure = exact_->Advance(t, last);
  AddHits(last);
  if (!failure) return std::nullopt;
  return CannotGoOnAfter(animation_.rate.FrameAt(t), failure->joint, failure->cause);
}

std::optional<GravityEvent> Baker::FirstGravityEvent(double t, double next, double to) {
  if (!fall_) return std::nullopt;
  const auto pose = [this, to](double seconds, FigureMotion* motion) {
    const bool at_end = seconds >= Seconds(to);
    const double frame = at_end ? to : std::min(to, animation_.rate.FrameAt(seconds));
    PoseWithoutPlace(frame, seconds, at_end ? Side::kBefore : Side::kAfter, motion);
  };
  return fall_->FirstEvent(t, next, pose, &ws_);
}

Baker::Failure Baker::Happen(const GravityEvent& event, double to) {
  const double frame = now_.frame;
  const std::optional<GroupIndex> pin_before = fall_->pin();
  const Vec3 v_pin = fall_->Happen(event, now_, &ws_);
  using Kind = GravityEvent::Kind;
  if (event.kind == Kind::kApex) {
    recorder_.AddEvent(EventKind::kApex, frame, "");
    return std::nullopt;
  }
  if (event.kind == Kind::kTakeOff) {
    recorder_.AddEvent(EventKind::kTakeOff, frame, figure_.group(*pin_before).name);
  } else {
    recorder_.AddEvent(EventKind::kLanding, frame, figure_.group(*fall_->pin()).name);
  }
  if (exact_) {
    control_ = StateAt(frame);
    KeepControl(frame);
    exact_begun_ = false;
  }
  return BeginExact(frame, to, v_pin);
}

Baker::Failure Baker::FinishExact(int frame) {
  FigureMotion motion;
  if (auto error = PoseAt(frame, Side::kBefore, &motion)) return error;
  now_ = std::move(motion);
  now_.frame = frame;
  before_ = LimitOf(now_);
  if (!exact_) return std::nullopt;
  exact_->Estimate(Seconds(frame));
  KeepControl(frame);
  return std::nullopt;
}

// Where the control solutions are, for those that go on from there.
void Baker::KeepControl(double frame) {
  exact_->SampleControl(Seconds(frame), &control_);
  for (size_t c = 0; c < has_control_.size(); ++c) {
    has_control_[c] = exact_->is_free(static_cast<int>(c));
  }
}

// What the driver did, for the reports of its regions.
void Baker::TakeReports() {
  recorder_.AddLogs(exact_->logs());
  for (size_t a = 0; a < exact_->active().size(); ++a) {
    RegionReport& report = recorder_.report(exact_->active()[a]);
    report.steps += static_cast<int>(exact_->steps());
    report.evaluations += static_cast<int>(exact_->evaluations());
    report.microseconds += exact_->microseconds() / static_cast<double>(exact_->active().size());
    report.groups = exact_->group_sizes();
    report.bodies = exact_->num_bodies();
    report.energy = exact_->energy();
    report.error_estimate = std::max(report.error_estimate, exact_->estimates()[a]);
  }
}

}  // namespace hazumi
