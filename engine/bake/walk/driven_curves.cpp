// Keyed curves are cubics between their keys, c0 + c1 t + c2 t^2 + c3 t^3 with t from the key on
// the left. A joint that holds move has no curve, and an eased interval or one with tangents of
// lengths of their own is no polynomial: from frame to frame such an angle is fitted by the
// polynomial p of degree n through n + 1 Chebyshev points s_i = h cos(pi (2 i + 1) / (2 n + 2)) of
// the frame, h being half of it, in Newton's form with divided differences d_i,
//   p(s) = d_0 + (s - s_0) (d_1 + (s - s_1) (d_2 + ...)),
// multiplied out about the frame's middle [METHOD 7.6].

#include "engine/bake/walk/driven_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/text.h"
#include "engine/timeline/frame_time.h"

namespace hazumi {

namespace {

constexpr int kPoints = DrivenCurve::kMaxDegree + 1;
using Points = std::array<double, kPoints>;

DrivenCurve ToDriven(const CurveTrack::Piece& piece, FrameRate rate) {
  DrivenCurve curve;
  const auto c = piece.interval.coefficients();
  std::copy(c.begin(), c.end(), curve.c.begin());
  curve.degree = 3;
  while (curve.degree > 0 && curve.c[curve.degree] == 0.0) --curve.degree;
  if (std::isfinite(piece.first_frame)) curve.start = rate.SecondsAt(piece.first_frame);
  return curve;
}

static_assert(kPoints == 10);
// cos(pi (2 i + 1) / 20), written out: a compiler that computes such a constant by itself does so
// with the functions of its own machine.
constexpr Points kCosines = {0.9876883405951378,  0.8910065241883679,  0.7071067811865476,
                             0.4539904997395468,  0.15643446504023087, -0.15643446504023087,
                             -0.4539904997395468, -0.7071067811865476, -0.8910065241883679,
                             -0.9876883405951378};

Points ChebyshevPoints(double half) {
  Points s;
  for (int i = 0; i < kPoints; ++i) s[i] = half * kCosines[i];
  return s;
}

// That takes the values d at the points s from the middle.
DrivenCurve PolynomialThrough(const Points& s, Points d, double middle) {
  for (int level = 1; level < kPoints; ++level) {
    for (int i = kPoints - 1; i >= level; --i) d[i] = (d[i] - d[i - 1]) / (s[i] - s[i - level]);
  }
  DrivenCurve curve;
  curve.start = middle;
  curve.degree = DrivenCurve::kMaxDegree;
  for (int i = kPoints - 1; i >= 0; --i) {  // c := c (x - s_i) + d_i
    for (int p = kPoints - 1; p > 0; --p) curve.c[p] = curve.c[p - 1] - s[i] * curve.c[p];
    curve.c[0] = d[i] - s[i] * curve.c[0];
  }
  return curve;
}

}  // namespace

DrivenCurves::DrivenCurves(BakeContext* context) : context_(*context), drives_(context) {
  motion_.angles.resize(context->poses.figure().num_joints() + kRootAngles);
}

void DrivenCurves::SetRegions(const std::vector<int>& regions) {
  drives_.SetRegions(regions);
  motion_.drives.clear();
  motion_.springs.clear();
  if (!drives_.entries().empty()) motion_.drives.resize(motion_.angles.size());
  const auto reads = [](const DriveCurves::Entry& entry) { return entry.reads_curves(); };
  if (std::any_of(drives_.entries().begin(), drives_.entries().end(), reads)) {
    motion_.springs.resize(motion_.angles.size());
  }
  stands_by_contacts_ = std::any_of(regions.begin(), regions.end(), [&](int r) {
    const DynamicsRegion& region = context_.animation.regions[r];
    return region.root && region.touches_scene;
  });
  const auto asks = [](const DriveCurves::Entry& entry) { return entry.drive->feed_forward; };
  forward_.reset();
  if (std::any_of(drives_.entries().begin(), drives_.entries().end(), asks)) {
    forward_ = std::make_unique<FeedForward>(context_.animation, context_.poses.figure(), regions);
  }
}

void DrivenCurves::TakeCurve(CurveTrack* track, const FromTo& span, DrivenCurve* curve,
                             double* to) const {
  const CurveTrack::Piece piece = track->PieceAt(span.from);
  if (!piece.interval.is_polynomial()) {
    const double until = std::min(span.end * 1.0, FitUntil(piece, span.from));
    *curve = Fitted(piece, span.from, until);
    *to = std::min(*to, until);
    return;
  }
  *curve = ToDriven(piece, context_.animation.rate);
  if (piece.last_frame > span.from + kSameFrame) *to = std::min(*to, piece.last_frame);
}

void DrivenCurves::TakeDrives(const FromTo& span, double* to) {
  for (DriveCurves::Entry& entry : drives_.entries()) {
    DrivenCurve* curve = &motion_.drives[entry.joint.value()];
    if (CurveTrack* track = drives_.TrackOf(&entry)) {
      TakeCurve(track, span, curve, to);
    } else {
      *curve = DrivenCurve::Constant(*entry.constant);
    }
    if (motion_.springs.empty()) continue;
    SpringCurves* more = &motion_.springs[entry.joint.value()];
    if (entry.frequency) TakeCurve(&*entry.frequency, span, &more->frequency, to);
    if (entry.strength) TakeCurve(&*entry.strength, span, &more->share, to);
  }
}

void DrivenCurves::TakeLimp(const FromTo& span, double* to) {
  PoseEvaluator& poses = context_.poses;
  const int n = poses.figure().num_joints();
  limp_.resize(motion_.angles.size());
  for (int j = 0; j < n; ++j) {
    if (poses.free()[j]) TakeCurve(&poses.curves().joint(JointIndex(j)), span, &limp_[j], to);
  }
  for (int i = 0; i < kRootAngles && poses.free_root(); ++i) {
    TakeCurve(&poses.curves().root(kRootAngleZ + i), span, &limp_[n + i], to);
  }
}

Result<double> DrivenCurves::Take(double from, int end, bool with_holds) {
  PoseEvaluator& poses = context_.poses;
  const FromTo span = {from, end};
  const bool is_causal = context_.animation.solver.rules().is_causal;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double to = is_causal ? kInfinity : end;
  const auto take = [&](CurveTrack& track, DrivenCurve* curve) {
    TakeCurve(&track, span, curve, &to);
  };
  const int n = poses.figure().num_joints();
  for (int j = 0; j < n; ++j) {
    if (!poses.free()[j]) take(poses.curves().joint(JointIndex(j)), &motion_.angles[j]);
  }
  for (int i = 0; i < kRootAngles; ++i) {
    if (!poses.free_root()) take(poses.curves().root(kRootAngleZ + i), &motion_.angles[n + i]);
    take(poses.curves().root(kRootX + i), &motion_.root_position[i]);
  }
  TakeDrives(span, &to);
  if (forward_) TakeLimp(span, &to);
  if (with_holds || forward_) to = std::min(to, std::floor(from + kSameFrame) + 1.0);
  if (with_holds) {
    if (auto error = FitHolds(from, to)) return *error;
  }
  if (forward_) {
    constexpr double kLongestFit = 0.05;  // [s]
    to = std::min(to, from + context_.animation.rate.FrameAt(kLongestFit));
    FitForward(from, to);
  }
  motion_.holds_until = is_causal ? context_.Seconds(to) : -kInfinity;
  return std::min(to, end * 1.0);
}

double DrivenCurves::FitUntil(const CurveTrack::Piece& piece, double from) const {
  const FrameRate rate = context_.animation.rate;
  // From a little later on: by rounding, the corner that was reached may still lie ahead.
  constexpr double kPast = 1e-6;  // [frames]
  const double seconds = rate.SecondsAt(from + kPast - piece.first_frame);
  const double smooth = piece.first_frame + rate.FrameAt(piece.interval.SmoothUntil(seconds));
  const double whole = std::floor(from + kSameFrame) + 1.0;
  const double until = std::min({whole, piece.last_frame, smooth});
  return until > from + kSameFrame ? until : whole;  // whatever rounding does, it goes on
}

DrivenCurve DrivenCurves::Fitted(const CurveTrack::Piece& piece, double from, double to) const {
  const double middle = 0.5 * context_.Seconds(from + to);
  const Points s = ChebyshevPoints(0.5 * context_.Seconds(to - from));
  const double start = context_.Seconds(piece.first_frame);
  Points d;
  for (int i = 0; i < kPoints; ++i) d[i] = piece.interval.At(middle + s[i] - start).value;
  return PolynomialThrough(s, d, middle);
}

std::optional<Error> DrivenCurves::FitHolds(double from, double to) {
  PoseEvaluator& poses = context_.poses;
  if (poses.free_root() || poses.IsPlacedByRegions()) {
    return Error{ErrorCode::kSemantics, "", "holds",
                 "cannot go on after frame " + FormatShort(from) +
                     ": a held joint cannot be solved while a region moves the root; end the hold "
                     "before the region or leave the joints up to the pin out of it"};
  }
  const double middle = 0.5 * context_.Seconds(from + to);
  const Points s = ChebyshevPoints(0.5 * context_.Seconds(to - from));
  std::vector<FigureMotion> solved(kPoints, context_.now);
  for (int i = 0; i < kPoints; ++i) {
    const double frame = context_.animation.rate.FrameAt(middle + s[i]);
    if (auto error = poses.Evaluate(frame, Side::kAfter, &solved[i])) return error;
  }
  for (const ActiveHolds::Moved& moved : poses.holds().moved()) {
    for (const JointIndex j : moved.joints) {
      Points d;
      for (int i = 0; i < kPoints; ++i) d[i] = solved[i].q[j.value()];
      motion_.angles[j.value()] = PolynomialThrough(s, d, middle);
    }
  }
  return std::nullopt;
}

// By its keys, and where springs pull to something else there. The root's place does not matter.
FigureMotion DrivenCurves::KeyedAt(double seconds) const {
  const PoseEvaluator& poses = context_.poses;
  const int n = poses.figure().num_joints();
  FigureMotion motion = context_.now;
  const auto set = [&](int j, const Jet& jet) {
    motion.q[j] = jet.v;
    motion.qd[j] = jet.d;
    motion.qdd[j] = jet.dd;
  };
  for (int j = 0; j < n; ++j) {
    set(j, (poses.free()[j] ? limp_ : motion_.angles)[j].At(seconds));
  }
  for (const DriveCurves::Entry& entry : drives_.entries()) {
    if (entry.drive->kind != DriveKind::kSpring) continue;
    set(entry.joint.value(), motion_.drives[entry.joint.value()].At(seconds));
  }
  RootAngles angles;
  for (int i = 0; i < kRootAngles; ++i) {
    const Jet jet = (poses.free_root() ? limp_ : motion_.angles)[n + i].At(seconds);
    angles.angle[i] = jet.v;
    angles.rate[i] = jet.d;
    angles.acceleration[i] = jet.dd;
    motion.root.a[i] = motion_.root_position[i].At(seconds).dd;
  }
  SetRootOrientation(angles, &motion);
  return motion;
}

void DrivenCurves::FitForward(double from, double to) {
  const double middle = 0.5 * context_.Seconds(from + to);
  const Points s = ChebyshevPoints(0.5 * context_.Seconds(to - from));
  std::vector<ForwardTorques> found;
  found.reserve(kPoints);
  const bool stands = context_.animation.solver.rules().stands_on_springs && stands_by_contacts_;
  if (stands) forward_->StandAsIn(context_.now, context_.animation.scene);
  for (int i = 0; i < kPoints; ++i) {
    found.push_back(forward_->Of(KeyedAt(middle + s[i]), context_.poses.placement().hold()));
  }
  const auto fitted = [&](const VecX ForwardTorques::*of, int j) {
    Points d;
    for (int i = 0; i < kPoints; ++i) d[i] = (found[i].*of)[j];
    return PolynomialThrough(s, d, middle);
  };
  for (const DriveCurves::Entry& entry : drives_.entries()) {
    if (!entry.drive->feed_forward) continue;
    const int j = entry.joint.value();
    motion_.springs[j].torque = fitted(&ForwardTorques::torques, j);
    motion_.springs[j].moment = fitted(&ForwardTorques::moments, j);
  }
}

}  // namespace hazumi
