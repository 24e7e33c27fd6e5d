// How curves go on after a region.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/bake/baker.h"
#include "engine/bake/limits.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

// The angle without the whole turns that it is away from another one. A stop cannot be turned
// through, so they stay where the angle would not be inside the joint's limits without them.
double WithoutTurns(double angle, double from, const Joint* joint) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double near = angle - kTurn * std::round((angle - from) / kTurn);
  const bool is_inside = !joint || (near >= joint->lower && near <= joint->upper);
  return is_inside ? near : angle;
}

}  // namespace

// With a blend the curve counts its turns from here on as its keys do: the pose is the same, the
// angle may jump by whole turns. `joint`: whose limits the angle keeps; null: it has none.
void Baker::ResumeCurve(int frame, double angle, double rate, const DynamicsRegion& region,
                        const Joint* joint, CurveTrack* curve) {
  if (region.blend_frames == 0) return curve->Resume(frame, angle, rate);
  const double until = static_cast<double>(frame) + region.blend_frames;
  curve->Blend(frame, WithoutTurns(angle, curve->BlendTarget(until).value, joint), rate, until);
}

void Baker::ResumeJoint(int frame, JointIndex j, double rate, const DynamicsRegion& region) {
  ResumeCurve(frame, now_.q[j.value()], rate, region, &figure_.joint(j), &curves_.joint(j));
}

// The curves go on from what the region left [Arai 2.5 (3)], which may be too fast for them to turn
// back before a stop.
void Baker::ResumeAfterRegion(int frame, size_t region) {
  constexpr double kNoticed = 1e-6;  // [rad]
  JointIndex worst;
  double most = kNoticed;
  for (const JointIndex j : animation_.regions[region].joints) {
    free_[j.value()] = 0;
    if (schedule_.HasRegionFrom(frame, j)) {
      curves_.joint(j).Resume(frame, now_.q[j.value()], now_.qd[j.value()]);
      continue;
    }
    ResumeJoint(frame, j, now_.qd[j.value()], animation_.regions[region]);
    if (animation_.regions[region].blend_frames == 0) WarnIfNoKeyAfter(frame, j, "regions", region);
    if (animation_.regions[region].limit_tangents) LimitTangent(frame, j, region);
    const double overshoot = Overshoot(frame, j);
    if (overshoot <= most) continue;
    most = overshoot;
    worst = j;
  }
  if (!worst.is_valid()) return;
  recorder_.AddWarning(
      "regions[" + std::to_string(region) + "]",
      "joint \"" + figure_.joint(worst).name + "\" goes " +
          FormatShort(most * 180.0 / std::numbers::pi) + " degrees beyond its limit after frame " +
          std::to_string(frame) +
          ", before it turns back; set \"limit_tangents\": true on the region, or give it a "
          "key there");
}

// How far a joint's curve goes beyond its limits on the way to its next key, beyond which neither
// end of the way is [rad].
double Baker::Overshoot(int frame, JointIndex j) {
  const CurveTrack::Piece piece = curves_.joint(j).PieceAt(frame);
  if (!std::isfinite(piece.last_frame)) return 0.0;
  const double duration = Seconds(piece.last_frame - piece.first_frame);
  const auto [c0, c1, c2, c3] = piece.interval.coefficients();
  const double first = c0, last = piece.interval.At(duration).value;
  const double root = c2 * c2 - 3.0 * c1 * c3;
  double most = 0.0;
  for (const double sign : {-1.0, 1.0}) {
    // Where the rate c1 + 2 c2 t + 3 c3 t^2 is zero.
    const double t =
        c3 != 0.0 ? (-c2 + sign * std::sqrt(std::max(root, 0.0))) / (3.0 * c3) : -0.5 * c1 / c2;
    if (root < 0.0 || !(t > 0.0 && t < duration)) continue;
    const double turn = piece.interval.At(t).value;
    const double lower = std::min({figure_.joint(j).lower, first, last});
    const double upper = std::max({figure_.joint(j).upper, first, last});
    most = std::max({most, lower - turn, turn - upper});
  }
  return most;
}

// The greatest part of the rate that the region left with which the curve stays inside.
void Baker::LimitTangent(int frame, JointIndex j, size_t region) {
  const double rate = now_.qd[j.value()];
  const auto overshoots = [&](double part) {
    ResumeJoint(frame, j, part * rate, animation_.regions[region]);
    return Overshoot(frame, j) > 0.0;
  };
  if (!overshoots(1.0)) return;
  double inside = 0.0, outside = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (inside + outside);
    (overshoots(middle) ? outside : inside) = middle;
  }
  ResumeJoint(frame, j, inside * rate, animation_.regions[region]);
}

// The root's curves go on from the angles that the region left.
void Baker::EndRoot(int frame, const DynamicsRegion& region) {
  root_free_ = false;
  for (int i = 0; i < kRootAngles; ++i) {
    ResumeCurve(frame, root_.q[i], root_.qd[i], region, nullptr, &curves_.root(kRootAngleZ + i));
  }
}

}  // namespace hazumi
