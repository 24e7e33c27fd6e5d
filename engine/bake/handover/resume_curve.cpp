// How a curve goes on after a region [METHOD 7.3-7.5, Arai 2.5 (3)]: by a cubic
//   c(t) = c0 + c1 t + c2 t^2 + c3 t^3
// from the angle c0 and the rate c1 that the region left to the next key. It turns back where
// c'(t) = 0, t = (-c2 +- sqrt(c2^2 - 3 c1 c3)) / (3 c3): how far that is beyond a limit is its
// overshoot, which falls with c1, so that the greatest part of c1 without one is found by
// bisection.

#include "engine/bake/handover/resume_curve.h"

#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

// The angle without the whole turns that it is away from another one. A limit cannot be turned
// through, so they stay where the angle would not be inside the joint's limits without them.
double WithoutTurns(double angle, double from, const Joint* joint) {
  const double near = NearestTurn(angle, from);
  const bool is_inside = !joint || (near >= joint->lower && near <= joint->upper);
  return is_inside ? near : angle;
}

}  // namespace

// With a blend the curve counts its turns from here on as its keys do: the pose is the same, the
// angle may jump by whole turns.
void ResumeCurve(const HingeEnd& end, const DynamicsRegion& region, const Joint* joint,
                 CurveTrack* curve) {
  const auto& [frame, angle, rate] = end;
  if (region.blend_frames == 0) return curve->Resume(frame, angle, rate);
  const double until = static_cast<double>(frame) + region.blend_frames;
  curve->Blend(frame, WithoutTurns(angle, curve->BlendTarget(until).value, joint), rate, until);
}

double Overshoot(int frame, const Joint& joint, FrameRate rate, CurveTrack* curve) {
  const CurveTrack::Piece piece = curve->PieceAt(frame);
  if (!std::isfinite(piece.last_frame)) return 0.0;
  const double duration = rate.SecondsAt(piece.last_frame - piece.first_frame);
  const auto [c0, c1, c2, c3] = piece.interval.coefficients();
  const double first = c0, last = piece.interval.At(duration).value;
  const double root = c2 * c2 - 3.0 * c1 * c3;
  double most = 0.0;
  for (const double sign : {-1.0, 1.0}) {
    const double t =
        c3 != 0.0 ? (-c2 + sign * std::sqrt(std::max(root, 0.0))) / (3.0 * c3) : -0.5 * c1 / c2;
    if (root < 0.0 || !(t > 0.0 && t < duration)) continue;
    const double turn = piece.interval.At(t).value;
    const double lower = std::min({joint.lower, first, last});
    const double upper = std::max({joint.upper, first, last});
    most = std::max({most, lower - turn, turn - upper});
  }
  return most;
}

void ResumeInside(const HingeEnd& end, const DynamicsRegion& region, const Joint& joint,
                  FrameRate rate, CurveTrack* curve) {
  const auto overshoots = [&](double part) {
    ResumeCurve({end.frame, end.angle, part * end.rate}, region, &joint, curve);
    return Overshoot(end.frame, joint, rate, curve) > 0.0;
  };
  if (!overshoots(1.0)) return;
  double inside = 0.0, outside = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (inside + outside);
    (overshoots(middle) ? outside : inside) = middle;
  }
  ResumeCurve({end.frame, end.angle, inside * end.rate}, region, &joint, curve);
}

}  // namespace hazumi
