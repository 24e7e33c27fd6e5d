#include "tests/unit/analysis/made_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace hazumi::test {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStanding = 0.95, kCrouched = 0.70, kLeaving = 1.02;  // the CoM over the feet [m]
constexpr double kCrouchTime = 0.5;                                    // [s]
constexpr double kBall = 0.04, kHeel = 0.06;  // where they are on the ground [m]

// From a to b while u goes from 0 to 1, at rest at both ends.
double Smooth(double a, double b, double u) {
  const double s = std::clamp(u, 0.0, 1.0);
  return a + (b - a) * s * s * (3.0 - 2.0 * s);
}

// From rest at `from` with constant acceleration to speed v at `to`.
double PushTime(double from, double to, double v) { return 2.0 * (to - from) / v; }

class Noise {
 public:
  explicit Noise(double deviation) : deviation_(deviation) {}
  Vec3 operator()(double share) {
    Vec3 p;
    for (double& x : p) x = share * deviation_ * normal_(random_);
    return p;
  }

 private:
  double deviation_;
  std::mt19937 random_{12345};
  std::normal_distribution<double> normal_;
};

FootTrack Foot(const char* name) { return {name, {{}, {}}}; }

void Add(const Vec3& ball, double heel_lift, Noise* noise, FootTrack* foot) {
  foot->points[0].push_back(ball + Vec3(0.0, 0.0, kBall) + (*noise)(1.0));
  foot->points[1].push_back(ball + Vec3(-0.15, 0.0, kHeel + heel_lift) + (*noise)(1.0));
}

}  // namespace

double Jump::take_off() const { return stand + kCrouchTime + PushTime(kCrouched, kLeaving, v); }
double Jump::apex() const { return take_off() + v / gravity; }

double Jump::landing() const {
  const double down = std::sqrt(v * v + 2.0 * gravity * ground_before);
  return apex() + down / gravity;
}

double Jump::end() const { return landing() + 1.2; }

Vec3 Jump::Com(double t) const {
  const double push = stand + kCrouchTime;
  Vec3 p(forward * std::clamp(t - take_off(), 0.0, landing() - take_off()), 0.0, 0.0);
  if (t < push) {
    p.z() = Smooth(kStanding, kCrouched, (t - stand) / kCrouchTime);
  } else if (t < take_off()) {
    const double u = (t - push) / (take_off() - push);
    p.z() = kCrouched + (kLeaving - kCrouched) * u * u;
  } else if (t < landing()) {
    const double u = t - take_off();
    p.z() = kLeaving + v * u - 0.5 * gravity * u * u;
  }
  if (t < landing()) return p + Vec3(0.0, 0.0, ground_before);
  // Braked by twice the weight, then up again.
  const double down = std::sqrt(v * v + 2.0 * gravity * ground_before), brake = 2.0 * gravity;
  const double u = std::min(t - landing(), down / brake);
  p.z() = kLeaving - down * u + 0.5 * brake * u * u;
  p.z() = Smooth(p.z(), kStanding, (t - landing() - down / brake) / 0.6);
  return p;
}

double Jump::FootRise(double t) const {
  if (t < take_off()) return ground_before;
  if (t > landing()) return 0.0;
  return Com(t).z() - kLeaving;
}

MotionSeries SeriesOf(const Jump& jump, double fps, double stated_fps, double noise) {
  MotionSeries series;
  series.frame_time = 1.0 / stated_fps;
  series.feet = {Foot("l_foot"), Foot("r_foot")};
  Noise add(noise);
  for (int i = 0; i <= jump.end() * fps; ++i) {
    const double t = i / fps;
    series.com.push_back(jump.Com(t) + add(1.0 / 3.0));
    series.angular_momentum.push_back(Vec3(0.0, 2.0, 0.0));
    const double heel = t < jump.take_off() ? Smooth(0.0, 0.06, (t - jump.take_off()) / 0.08 + 1.0)
                                            : Smooth(0.06, 0.0, (t - jump.take_off()) / 0.2);
    const double x = jump.Com(t).x();
    for (FootTrack& foot : series.feet) Add({x, 0.0, jump.FootRise(t)}, heel, &add, &foot);
  }
  return series;
}

MotionSeries Walk(double fps, double seconds, double slope, double noise) {
  constexpr double kStep = 0.5, kSpeed = 1.4, kLift = 0.15;
  MotionSeries series;
  series.frame_time = 1.0 / fps;
  series.feet = {Foot("l_foot"), Foot("r_foot")};
  Noise add(noise);
  for (int i = 0; i <= seconds * fps; ++i) {
    const double t = i / fps;
    const int step = static_cast<int>(t / kStep + 1e-9);
    const double u = std::max(t / kStep - step, 0.0);
    const Vec3 climb(0.0, 0.0, slope * t);
    const double bob = 0.04 * std::sin(kPi * u);
    series.com.push_back(Vec3(kSpeed * t, 0.0, 0.95 + bob) + climb + add(1.0 / 3.0));
    for (int side = 0; side < 2; ++side) {
      const bool swings = step % 2 == side;
      const double x = (step + (swings ? u * 2.0 - 1.0 : 0.0)) * kSpeed * kStep;
      Add(Vec3(x, 0.0, swings ? kLift * std::sin(kPi * u) : 0.0) + climb, 0.0, &add,
          &series.feet[side]);
    }
  }
  return series;
}

MotionSeries Run(double fps, int steps) {
  constexpr double kStance = 0.24, kFlight = 0.12, kStep = kStance + kFlight, kSpeed = 4.0;
  constexpr double kUp = 0.5 * 9.81 * kFlight;  // [m/s] at take-off
  MotionSeries series;
  series.frame_time = 1.0 / fps;
  series.feet = {Foot("l_foot"), Foot("r_foot")};
  Noise none(0.0);
  for (int i = 0; i <= steps * kStep * fps; ++i) {
    const double t = i / fps;
    const int step = static_cast<int>(t / kStep + 1e-9);
    const double u = std::max(t - step * kStep, 0.0);
    const double flown = u - kStance;
    const double z = u < kStance ? -kUp * kStance / kPi * std::sin(kPi * u / kStance)
                                 : kUp * flown - 0.5 * 9.81 * flown * flown;
    series.com.push_back({kSpeed * t, 0.0, 0.95 + z});
    for (int side = 0; side < 2; ++side) {
      // A foot leaves the ground after its own stance and is back when its next one begins.
      const bool stands = step % 2 == side && u < kStance;
      const double since = step % 2 == side ? flown : u + kFlight;  // its last stance [s]
      const double air = kStep + kFlight;
      const double lift = stands ? 0.0 : 0.25 * std::sin(kPi * since / air);
      Add({kSpeed * t, 0.0, lift}, 0.0, &none, &series.feet[side]);
    }
  }
  return series;
}

MotionSeries Reversed(const MotionSeries& series) {
  MotionSeries reversed = series;
  std::ranges::reverse(reversed.com);
  std::ranges::reverse(reversed.angular_momentum);
  for (FootTrack& foot : reversed.feet) {
    for (auto& point : foot.points) std::ranges::reverse(point);
  }
  return reversed;
}

MotionSeries Joined(const MotionSeries& first, const MotionSeries& second) {
  MotionSeries joined = first;
  const auto append = [](const std::vector<Vec3>& more, std::vector<Vec3>* track) {
    track->insert(track->end(), more.begin(), more.end());
  };
  append(second.com, &joined.com);
  append(second.angular_momentum, &joined.angular_momentum);
  for (size_t f = 0; f < joined.feet.size(); ++f) {
    for (size_t k = 0; k < joined.feet[f].points.size(); ++k) {
      append(second.feet[f].points[k], &joined.feet[f].points[k]);
    }
  }
  return joined;
}

MotionSeries Cut(const MotionSeries& series, int first, int last) {
  MotionSeries cut = series;
  const auto keep = [&](std::vector<Vec3>* track) {
    if (!track->empty()) *track = {track->begin() + first, track->begin() + last + 1};
  };
  keep(&cut.com);
  keep(&cut.angular_momentum);
  for (FootTrack& foot : cut.feet) {
    for (auto& point : foot.points) keep(&point);
  }
  cut.first_frame = series.first_frame + first;
  return cut;
}

}  // namespace hazumi::test
