#include "engine/analysis/lanes/low_pass_lanes.h"

// Torques as shares of a hinge's strength, a frame in each lane: strength.cpp has the equations.

// e^x for -700 <= x <= 0, to 1 ulp: with n = round(x / ln 2), r = x - n ln 2 in two pieces of ln 2,
// and the rational function of FreeBSD's msun for e^r.
HAZUMI_LANE_INLINE LaneReal Exponential(LaneReal x) {
  constexpr double kToInteger = 6755399441055744.0;  // 1.5 * 2^52
  const LaneReal shifted = x * 1.44269504088896338700e+00 + kToInteger;
  const LaneReal n = shifted - kToInteger;
  const LaneReal high = x - n * 6.93147180369123816490e-01, low = n * 1.90821492927058770002e-10;
  const LaneReal r = high - low, t = r * r;
  const LaneReal c =
      r - t * (1.66666666666666019037e-01 +
               t * (-2.77777777770155933842e-03 +
                    t * (6.61375632143793436117e-05 +
                         t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
  const LaneReal power = 1.0 - ((low - (r * c) / (2.0 - c)) - high);
  return SameBits<LaneReal>(SameBits<LaneBits>(power) + (SameBits<LaneBits>(shifted) << 52));
}

HAZUMI_LANE_INLINE LaneReal Magnitude(LaneReal x) {
  return SameBits<LaneReal>(SameBits<LaneBits>(x) & ~SameBits<LaneBits>(All(-0.0)));
}

// Of two directions, of which each lane goes by one.
struct LaneCurves {
  const StrengthCurve &positive, &negative;
  LaneBits is_positive;
  HAZUMI_LANE_INLINE LaneReal operator()(double StrengthCurve::*field) const {
    return Either(All(positive.*field), All(negative.*field), is_positive);
  }
};

HAZUMI_LANE_INLINE LaneReal ShareByCosine(const LaneCurves& of, LaneReal angle, LaneReal rate) {
  const LaneReal zero = All(0.0);
  const LaneReal x = (angle - of(&StrengthCurve::best_angle)) / of(&StrengthCurve::width);
  const LaneBits is_within = Greater(All(1.57079632679489655800e+00), Magnitude(x));
  LaneReal sine, cosine;
  SineAndCosine<4>(Only(x, is_within), &sine, &cosine);
  const LaneReal c4 = of(&StrengthCurve::rate_75), c5 = of(&StrengthCurve::rate_50);
  const LaneReal size = Magnitude(rate), both = 2.0 * c4 * c5;
  const LaneReal above = both + size * (c5 - 3.0 * c4), below = both + size * (2.0 * c5 - 4.0 * c4);
  const LaneBits is_some = Greater(above, zero) & is_within;
  const LaneReal longer = Only(of(&StrengthCurve::lengthening) * rate, Greater(zero, rate));
  return Only(cosine, is_some) * (above / Either(below, All(1.0), is_some)) * (1.0 - longer);
}

HAZUMI_LANE_INLINE LaneReal ShareByBell(const LaneCurves& of, LaneReal angle, LaneReal rate) {
  constexpr double kCurvature = 4.0, kGain = 0.4, kStretch = 0.08, kLowest = -700.0;
  const LaneReal zero = All(0.0), one = All(1.0);
  const LaneReal x = (angle - of(&StrengthCurve::best_angle)) / of(&StrengthCurve::width);
  const LaneReal power = -0.5 * x * x, s = rate / of(&StrengthCurve::fastest);
  const LaneBits is_longer = Greater(zero, s);
  const LaneReal above = Either(kGain * s, one - s, is_longer);
  const LaneReal below = Either(kStretch - s, one + kCurvature * s, is_longer);
  const LaneReal of_rate = Either(one - above / below, above / below, is_longer);
  return Exponential(Either(power, All(kLowest), Greater(power, All(kLowest)))) *
         Only(of_rate, Greater(of_rate, zero));
}

HAZUMI_LANE_INLINE LaneReal ShareBy(StrengthCurve::Form form, const LaneCurves& of, LaneReal angle,
                                    LaneReal rate) {
  switch (form) {
    case StrengthCurve::Form::kCosine:
      return ShareByCosine(of, angle, rate);
    case StrengthCurve::Form::kBell:
      return ShareByBell(of, angle, rate);
    default:
      return All(1.0);
  }
}

void Share(const HingeStrength* hinges, int num_hinges, const double* torques,
           const double* const angles[4], const double* const rates[4], double* shares,
           double* least) {
  constexpr double kAt = 1e-6;  // of a stop, which then gives what it takes [rad]
  const LaneReal zero = All(0.0);
  for (int j = 0; j < num_hinges; ++j) {
    const HingeStrength& hinge = hinges[j];
    if (hinge.strength == nullptr) {
      Store<4>(shares + 4 * j, All(-1.0));
      Store<4>(least + 4 * j, zero);
      continue;
    }
    const LaneReal torque = Load<4>(torques + 4 * j), angle = CollectAt(angles, j);
    const LaneReal rate = CollectAt(rates, j);
    const StrengthCurve &positive = hinge.strength->positive, &negative = hinge.strength->negative;
    const LaneBits is_negative = Greater(zero, torque);
    const LaneCurves of = {positive, negative, ~is_negative};
    const LaneReal shortening = Either(-rate, rate, is_negative);
    LaneReal share = ShareBy(positive.form, of, angle, shortening);
    if (negative.form != positive.form) {
      share = Either(ShareBy(negative.form, of, angle, shortening), share, is_negative);
    }
    const LaneBits is_stopped =
        Either(~Greater(All(hinge.upper - kAt), angle), ~Greater(angle, All(hinge.lower + kAt)),
               ~Greater(torque, zero));
    const LaneBits is_least = Greater(All(kLeastStrength), share) & ~is_stopped;
    const LaneReal strength =
        of(&StrengthCurve::torque) * Either(All(kLeastStrength), share, is_least);
    Store<4>(shares + 4 * j, Only(Magnitude(torque) / strength, ~is_stopped));
    Store<4>(least + 4 * j, Only(All(1.0), is_least));
  }
  LeaveLanes();
}
