// How flights are found, without a word of gravity, seconds or metres:
//
// 1. The clearance c of the lower foot (foot_contact.h) is cut into hills: peaks that rise above
//    the valleys on both sides. A walk has none, its lower foot stays on the ground; the ground
//    itself may rise and fall (drift of a capture, stairs), for a hill is measured from its own
//    valleys. A valley high above the ground, where legs are tucked or spread in the air, parts no
//    hills, unless a foot stands there: a box.
// 2. The figure is in the air where the hill is 2 cm (of 1.7 m) above its valleys: above the noise
//    of captures, and at speeds of 2 m/s within 10 ms of the true take-off and landing.
// 3. In the air the CoM must be on a parabola that opens downwards, and move uniformly over the
//    ground, within tolerances that go with the arc's height and the noise of the clip. Where it is
//    not (hands or back on the ground, a bar), the end with the worse residual is cut until it is.
//    Three quarters must be left, for the top of anything is a parabola.
// 4. Frames before and after that are on the parabola as well belong to it: a foot that is drawn up
//    slowly, or stretched for the ground.
//
// So a flight in slow motion is found like any other, and its gravity comes out as it may.

#include "engine/analysis/flights.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/hills.h"

namespace hazumi {

namespace {

// Shares of the stature.
constexpr double kContact = 0.02 / 1.7;   // a foot this high is off the ground
constexpr double kHill = 2.5 * kContact;  // lower ones are steps on tiptoe, or noise
constexpr double kSlow = 0.001 / 1.7;     // of the CoM's error, rms, that no noise shows
constexpr double kFlatArc = 0.004 / 1.7;  // lower arcs of the CoM say nothing of gravity

// With a frame on the ground before and after, so that a flight that the clip cuts off is a hill
// as well. The ground is where a tenth of the frames are lower.
std::vector<double> Padded(std::vector<double> c) {
  if (c.empty()) return c;
  const double ground = Quantile(c, 0.1);
  c.insert(c.begin(), ground);
  c.push_back(ground);
  return c;
}

// Standard deviation of what is independent from frame to frame in the CoM's height: from third
// differences, in which smooth motion is small, by their median, which jolts leave alone.
double NoiseOf(const std::vector<Vec3>& com) {
  std::vector<double> differences;
  for (size_t i = 3; i < com.size(); ++i) {
    const double d = com[i].z() - 3.0 * com[i - 1].z() + 3.0 * com[i - 2].z() - com[i - 3].z();
    differences.push_back(std::abs(d));
  }
  if (differences.empty()) return 0.0;
  return Quantile(std::move(differences), 0.5) / (0.6745 * std::sqrt(20.0));
}

class Finder {
 public:
  explicit Finder(const MotionSeries& series)
      : series_(series),
        clearance_(Padded(FootClearance(series))),
        noise_(NoiseOf(series.com)),
        heights_{kContact * series.stature, kHill * series.stature} {}

  std::vector<Flight> Find() const {
    std::vector<Flight> flights;
    if (clearance_.empty()) return flights;
    for (const Hill& hill : HillsOf(clearance_, heights_)) {
      if (const auto flight = FlightOver(hill)) flights.push_back(*flight);
    }
    return flights;
  }

 private:
  int last_frame() const { return static_cast<int>(series_.com.size()) - 1; }
  double SecondsAt(double index) const { return index * series_.frame_time; }

  std::optional<Flight> FlightOver(const Hill& hill) const {
    const Edge before = EdgeOf(clearance_, hill.peak, hill.left, -1, heights_);
    const Edge after = EdgeOf(clearance_, hill.peak, hill.right, 1, heights_);
    const double height = clearance_[hill.peak] - std::max(before.ground, after.ground);
    if (height < heights_.hill) return std::nullopt;
    const double left = before.at - 1.0, right = after.at - 1.0;  // without the padding
    int first = std::max(static_cast<int>(std::ceil(left)), 0);
    int last = std::min(static_cast<int>(std::floor(right)), last_frame());
    auto fit = LongestParabola(&first, &last);
    if (!fit) return std::nullopt;
    Flight flight;
    flight.take_off = std::max({left, first - 1.0, 0.0});
    flight.landing = std::min({right, last + 1.0, static_cast<double>(last_frame())});
    if (Extend(*fit, -1, std::max(hill.left - 1, 0), &first)) flight.take_off = first - 0.5;
    if (last >= right - 1.0) flight.landing = LandingAfter(right, after.touch - 1.0, *fit);
    if (Extend(*fit, 1, std::min(hill.right - 1, last_frame()), &last))
      flight.landing = std::max(flight.landing, last + 0.5);
    flight.parabola = FitParabola(series_.com, series_.frame_time, first, last);
    flight.gravity = EstimateGravity(series_, flight.parabola, first, last);
    flight.begins_before_clip = left < 0.0 && first == 0;
    flight.ends_after_clip = right > last_frame() && last == last_frame();
    Describe(first, last, &flight);
    return flight;
  }

  // From where the foot is 2 cm above the ground to where it touches, unless the CoM is stopped
  // before: it is braked, and higher than its parabola.
  double LandingAfter(double right, double touch, const Parabola& fit) const {
    const double tolerance = std::max(2.5 * fit.rms, kSlow * series_.stature);
    const double until = std::min(touch, static_cast<double>(last_frame()));
    for (int i = static_cast<int>(std::ceil(right)); i < until; ++i) {
      const double above = series_.com[i].z() - fit.PositionAt(SecondsAt(i)).z();
      if (above > tolerance) return std::max(right, i - 1.0);
    }
    return until;
  }

  // A foot may stay low after take-off, or be low before landing: frames beyond `end`, by `step`,
  // as far as they are on the parabola too. Within the residual of those that are on it, so that
  // nothing is won where it is rough; at least 0.1 mm.
  bool Extend(const Parabola& fit, int step, int limit, int* end) const {
    const double tolerance = std::max(fit.rms, 1e-4 / 1.7 * series_.stature);
    const int before = *end;
    while (*end != limit && Residual(fit, *end + step) <= tolerance) *end += step;
    return *end != before;
  }

  // Cuts frames first..last until they are on a parabola; nothing if too few are left.
  std::optional<Parabola> LongestParabola(int* first, int* last) const {
    const int fewest = std::max(kFewestFrames, (*last - *first + 1) * 3 / 4);
    while (*last - *first + 1 >= fewest) {
      const Parabola fit = FitParabola(series_.com, series_.frame_time, *first, *last);
      if (IsBallistic(fit, *first, *last)) return fit;
      const int cut = 1 + (*last - *first) / 100;  // long ones soon
      const double begin = Residual(fit, *first), end = Residual(fit, *last);
      (begin > end ? *first : *last) += begin > end ? cut : -cut;
    }
    return std::nullopt;
  }

  double Residual(const Parabola& fit, int i) const {
    return (series_.com[i] - fit.PositionAt(SecondsAt(i))).norm();
  }

  bool IsBallistic(const Parabola& fit, int first, int last) const {
    constexpr double kShape = 0.015, kUniform = 0.05, kAtMost = 0.06;  // of the arc's height
    constexpr double kNoise = 1.3, kMasses = 2.0;                      // times their deviations
    const double noise = std::hypot(kNoise * noise_, kSlow * series_.stature);
    const MassResiduals masses = ResidualsByMass(series_, first, last);
    const double tolerance = std::hypot(kShape * fit.sagitta, noise, kMasses * masses.height);
    const double horizontal_tolerance =
        std::hypot(kUniform * fit.sagitta, noise, kMasses * masses.horizontal);
    return fit.sagitta >= kFlatArc * series_.stature && fit.gravity > 4.0 * fit.gravity_error &&
           fit.rms <= std::min(tolerance, kAtMost * fit.sagitta) &&
           fit.horizontal_rms <= horizontal_tolerance;
  }

  // What follows from the parabola; first..last are the frames in the air.
  void Describe(int first, int last, Flight* flight) const {
    const Parabola& fit = flight->parabola;
    const double t = SecondsAt(flight->take_off);
    flight->rise = fit.apex.z() - fit.PositionAt(t).z();
    flight->v_take_off = fit.VelocityAt(t);
    flight->horizontal_speed = fit.horizontal_v.norm();
    flight->angular_momentum = DriftOver(first, last);
    flight->apex = fit.apex_time / series_.frame_time + series_.first_frame;
    flight->take_off += series_.first_frame;
    flight->landing += series_.first_frame;
  }

  std::optional<AngularMomentumDrift> DriftOver(int first, int last) const {
    if (series_.angular_momentum.empty()) return std::nullopt;
    const double n = last - first + 1;
    AngularMomentumDrift drift;
    Vec3 slope = Vec3::Zero();  // a frame
    double square = 0.0, spread = 0.0;
    for (int i = first; i <= last; ++i) {
      const Vec3& L = series_.angular_momentum[i];
      const double u = i - 0.5 * (first + last);
      drift.mean += L / n;
      slope += u * L;
      spread += u * u;
      square += L.squaredNorm() / n;
    }
    drift.change = slope / spread * (n - 1.0);
    drift.relative = square > 0.0 ? drift.change.norm() / std::sqrt(square) : 0.0;
    return drift;
  }

  const MotionSeries& series_;
  std::vector<double> clearance_;  // padded: frame i is at i + 1
  double noise_;                   // [m]
  Heights heights_;
};

}  // namespace

std::vector<Flight> FindFlights(const MotionSeries& series) { return Finder(series).Find(); }

FlightAnalysis AnalyseFlights(const MotionSeries& series, double gravity) {
  FlightAnalysis analysis;
  analysis.flights = FindFlights(series);
  analysis.skates = FootSkates(series);
  analysis.time =
      TimeOf(analysis.flights, series.frame_time, series.stature, series.scale_known, gravity);
  return analysis;
}

TimeScale TimeOf(const std::vector<Flight>& flights, double frame_time, double stature,
                 bool scale_known, double gravity) {
  std::vector<GravityEstimate> estimates;
  estimates.reserve(flights.size());
  for (const Flight& flight : flights) estimates.push_back(flight.gravity);
  return JudgeTime(estimates, frame_time, stature, scale_known, gravity);
}

}  // namespace hazumi
