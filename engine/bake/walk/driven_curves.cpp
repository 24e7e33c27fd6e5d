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
  if (!drives_.entries().empty()) motion_.drives.resize(motion_.angles.size());
}

Result<double> DrivenCurves::Take(double from, int end, bool with_holds) {
  PoseEvaluator& poses = context_.poses;
  double to = end;
  const auto take = [&](CurveTrack& track, DrivenCurve* curve) {
    const CurveTrack::Piece piece = track.PieceAt(from);
    if (!piece.interval.is_polynomial()) {
      const double until = std::min(end * 1.0, FitUntil(piece, from));
      *curve = Fitted(piece, from, until);
      to = std::min(to, until);
      return;
    }
    *curve = ToDriven(piece, context_.animation.rate);
    if (piece.last_frame > from + kSameFrame) to = std::min(to, piece.last_frame);
  };
  const int n = poses.figure().num_joints();
  for (int j = 0; j < n; ++j) {
    if (!poses.free()[j]) take(poses.curves().joint(JointIndex(j)), &motion_.angles[j]);
  }
  for (int i = 0; i < kRootAngles; ++i) {
    if (!poses.free_root()) take(poses.curves().root(kRootAngleZ + i), &motion_.angles[n + i]);
    take(poses.curves().root(kRootX + i), &motion_.root_position[i]);
  }
  for (DriveCurves::Entry& entry : drives_.entries()) {
    DrivenCurve* curve = &motion_.drives[entry.joint.value()];
    if (CurveTrack* track = drives_.TrackOf(&entry)) {
      take(*track, curve);
    } else {
      *curve = DrivenCurve::Constant(*entry.constant);
    }
  }
  if (!with_holds) return to;
  to = std::min(to, std::floor(from + kSameFrame) + 1.0);
  if (auto error = FitHolds(from, to)) return *error;
  return to;
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

}  // namespace hazumi
