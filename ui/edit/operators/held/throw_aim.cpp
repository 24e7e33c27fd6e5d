// A throw that is to come down on a spot s, rising h above the point p where it is let go, leaves
// with
//   v_z = sqrt(2 g h),  T = (v_z + sqrt(2 g (h + p_z - s_z))) / g,  v_xy = (s - p)_xy / T.
// The slowest one leaves at the angle with tan = (z + sqrt(z^2 + d^2)) / d, where d and z are how
// far away and how much higher the spot is, and with v^2 = g (z + sqrt(z^2 + d^2)).
//
// What the hand does with start rates r is found by baking the motion up to the release. The rates
// sought bring e(r), by how far the spot is missed, to zero: where the path comes down through the
// spot's height less the spot, or, if a height is asked for, T (v(r) - v of that throw from p(r)).
// There are more rates than that, of which the step dr = -W J' (J W J' + m I)^-1 e changes those
// least that move the object least: W has the squared distances of the hinges from it. J is from
// finite differences, m grows until e falls (Levenberg and Marquardt).

#include "ui/edit/operators/held/throw_aim.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "engine/bake/incremental_bake.h"
#include "engine/collision/distance.h"
#include "engine/project/compile.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/held/held_objects.h"

namespace hazumi::edit {

namespace {

constexpr double kNear = 0.005;                 // of a hit [m]
constexpr double kMostRate = 2000.0 * kDegree;  // [rad/s]

Error OutOfReach(double miss, int release) {
  return {ErrorCode::kSemantics, "", "x",
          "let go in frame " + std::to_string(release) + " it misses by " +
              std::to_string(std::lround(100.0 * miss)) +
              " cm at best; choose a nearer spot, less friction, or a region of more frames or "
              "joints"};
}

Error NotInTime() {
  return {ErrorCode::kInterrupted, "", "x",
          "no such throw was found in a few seconds; choose a nearer spot or a shorter region"};
}

// Until it comes down through a height, or, if it does not rise so high, until it is highest [s].
double SecondsDown(const ThrowPath& path, double z, double gravity) {
  const double up = path.velocity.z();
  const double square = up * up + 2.0 * gravity * (path.from.z() - z);
  return std::max(0.0, (up + std::sqrt(std::max(0.0, square))) / gravity);
}

// The first thing of the scene that is in the way; empty: nothing. Where it comes down does not
// count.
std::string InTheWay(const ThrowPath& path, double radius, const Animation& animation) {
  constexpr double kStep = 0.01, kTouch = 0.01;  // [s, m]
  const Vec3 g(0.0, 0.0, -animation.gravity);
  const auto at = [&](double t) { return Vec3(path.from + t * path.velocity + 0.5 * t * t * g); };
  const Vec3 spot = at(path.seconds);
  for (double t = kStep; t < path.seconds; t += kStep) {
    const Capsule swept = {at(t - kStep), at(t), radius};
    for (const SceneObject& object : animation.scene) {
      if (SignedDistance(swept, object.shape).value > -kTouch) continue;
      if ((at(t) - spot).norm() > radius + 0.05) return object.name;
    }
  }
  return "";
}

}  // namespace

double HeightOfSlowestThrow(const Vec3& from, const Vec3& spot, double gravity) {
  const double d = (spot - from).head<2>().norm(), z = spot.z() - from.z();
  const double up = z + std::hypot(z, d);  // d times the tangent of the angle
  const double square = gravity * up, sine_square = up * up / (up * up + d * d + 1e-12);
  return 0.5 * square * sine_square / gravity;
}

ThrowPath ThrowOver(const Vec3& from, const Vec3& spot, double height, double gravity) {
  ThrowPath path;
  path.from = from;
  const double fall = std::max(0.0, height + from.z() - spot.z());
  path.velocity.z() = std::sqrt(2.0 * gravity * height);
  path.seconds = (path.velocity.z() + std::sqrt(2.0 * gravity * fall)) / gravity;
  path.velocity.head<2>() = (spot - from).head<2>() / path.seconds;
  return path;
}

ThrowAim::ThrowAim(Project project, std::shared_ptr<const Figure> figure, ThrowCase of,
                   std::chrono::steady_clock::time_point until)
    : project_(std::move(project)),
      figure_(std::move(figure)),
      case_(std::move(of)),
      until_(until) {
  project_.frames.last = std::max(project_.frames.last, case_.release + 1);
}

void ThrowAim::Apply(const ThrowCase& of, const VecX& rates, const Figure& figure,
                     Project* project) {
  constexpr double kShown = 100.0;  // hundredths of a degree per second
  ProjectHeldObject& object = project->held_objects[of.object];
  (of.holder < 0 ? object.release_frame : object.holders[of.holder].last_frame) = of.release;
  for (size_t i = 0; i < of.hinges.size(); ++i) {
    ProjectKey key = of.keys[i];
    key.rate = std::round(kShown * rates[i] / kDegree) / kShown + 0.0;
    const Result<ProjectCurve*> curve =
        CurveNamed(figure.joint(of.hinges[i]).name, figure, project);
    if (curve.ok()) PutKey(key, curve.value());
  }
}

// Where it is, and how fast, as it is let go.
Result<ThrowPath> ThrowAim::Let(const VecX& rates) {
  if (std::chrono::steady_clock::now() > until_) return NotInTime();
  Apply(case_, rates, *figure_, &project_);
  Result<Compiled> compiled = CompileAnimation(project_, nullptr, figure_);
  if (!compiled.ok()) return compiled.error();
  const Animation& animation = compiled.value().animation;
  if (bake_) {
    bake_->Update(animation);
  } else {
    bake_ = std::make_unique<IncrementalBake>(animation);
  }
  if (const auto error = bake_->BakeTo(case_.release + 1)) return *error;
  const size_t i = static_cast<size_t>(case_.release - animation.first_frame);
  const auto at = [&](size_t frame) {
    return bake_->motion().frames[frame].objects[static_cast<size_t>(case_.object)].X_WO.p;
  };
  const double dt = animation.rate.SecondsAt(1);
  ThrowPath path;
  path.from = at(i);
  path.velocity = (at(i + 1) - at(i)) / dt + 0.5 * dt * Vec3(0.0, 0.0, animation.gravity);
  return path;
}

// By how far the spot is missed: with a height in three directions, without one in the plane of the
// spot, whose height the path passes where it comes down, or comes nearest to from below.
VecX ThrowAim::MissOf(const ThrowPath& path, const Vec3& spot,
                      const std::optional<double>& height) const {
  const double g = project_.scene.gravity_m_s2;
  if (height) {
    const ThrowPath wanted = ThrowOver(path.from, spot, *height, g);
    return wanted.seconds * (path.velocity - wanted.velocity);
  }
  return (path.from + SecondsDown(path, spot.z(), g) * path.velocity - spot).head<2>();
}

Result<AimedThrow> ThrowAim::Solve(const Vec3& spot, const std::optional<double>& height,
                                   VecX rates) {
  constexpr int kMostSteps = 12, kMostTries = 5;
  constexpr double kDifference = 5.0 * kDegree;  // [rad/s]
  constexpr double kWorthwhile = 0.97;           // slower progress is none
  double damping = 1e-3;
  Result<ThrowPath> path = Let(rates);
  if (!path.ok()) return path.error();
  VecX e = MissOf(path.value(), spot, height);
  const auto n = rates.size(), m = e.size();
  for (int step = 0; step < kMostSteps && e.norm() > 0.1 * kNear; ++step) {
    MatX J(m, n);
    for (int i = 0; i < n; ++i) {
      VecX other = rates;
      other[i] += kDifference;
      const Result<ThrowPath> there = Let(other);
      if (!there.ok()) return there.error();
      J.col(i) = (MissOf(there.value(), spot, height) - e) / kDifference;
    }
    const MatX WJ = case_.ease.asDiagonal() * J.transpose(), square = J * WJ;
    const double before = e.norm();
    for (int i = 0; i < kMostTries; ++i, damping *= 6.0) {
      const MatX damped = square + (damping * square.trace() + 1e-12) * MatX::Identity(m, m);
      const VecX by = -WJ * damped.ldlt().solve(e);
      const VecX tried = (rates + by).cwiseMin(kMostRate).cwiseMax(-kMostRate);
      const Result<ThrowPath> there = Let(tried);
      if (!there.ok()) continue;
      const VecX missed = MissOf(there.value(), spot, height);
      if (missed.norm() >= e.norm()) continue;
      rates = tried;
      path = there;
      e = missed;
      damping *= 0.1;
      break;
    }
    if (e.norm() > kWorthwhile * before) break;
  }
  if (e.norm() > kNear) return OutOfReach(e.norm(), case_.release);
  AimedThrow aimed = {rates, path.value()};
  aimed.path.seconds = SecondsDown(aimed.path, spot.z(), project_.scene.gravity_m_s2);
  return aimed;
}

// Start 0: the rates there are. Others are farther and farther from them, and always the same.
VecX ThrowAim::Start(int number) const {
  constexpr double kSpread = 300.0 * kDegree;  // [rad/s]
  std::mt19937 random(static_cast<unsigned>(number));
  VecX rates = case_.rates;
  for (double& rate : rates) rate += number * kSpread * (random() / 2147483648.0 - 1.0);
  return rates.cwiseMin(kMostRate).cwiseMax(-kMostRate);
}

Result<AimedThrow> ThrowAim::At(const Vec3& spot, std::optional<double> height, int start) {
  constexpr double kHigher = 0.2;  // [m]
  constexpr int kTries = 8;
  Result<Compiled> compiled = CompileAnimation(project_, nullptr, figure_);
  if (!compiled.ok()) return compiled.error();
  const Animation& animation = compiled.value().animation;
  const double radius = InnerRadius(animation.held_objects[static_cast<size_t>(case_.object)]);
  const Result<ThrowPath> now = Let(case_.rates);
  if (!now.ok()) return now.error();
  const Vec3 from = now.value().from;
  const double least = spot.z() - from.z();
  if (height && *height <= std::max(0.0, least)) {
    return Refusal("height", "the spot is " + std::to_string(std::lround(100.0 * least)) +
                                 " cm higher than the hand: let it rise higher");
  }
  Result<AimedThrow> flat = Solve(spot, {}, Start(start));
  if (!flat.ok()) return flat;
  std::string in_the_way = InTheWay(flat.value().path, radius, animation);
  if (!height && in_the_way.empty()) return flat;
  double high = height.value_or(HeightOfSlowestThrow(from, spot, animation.gravity));
  for (int i = 0; i < (height ? 1 : kTries); ++i, high += kHigher) {
    // Paths from here are tried first: most that something is in the way of need no solution.
    const ThrowPath over = ThrowOver(from, spot, high, animation.gravity);
    if (!height && !InTheWay(over, radius, animation).empty()) continue;
    Result<AimedThrow> aimed = Solve(spot, high, flat.value().rates);
    if (!aimed.ok() && height) return aimed;
    if (!aimed.ok()) continue;
    in_the_way = InTheWay(aimed.value().path, radius, animation);
    if (in_the_way.empty()) return aimed;
  }
  return Refusal(height ? "height" : "x",
                 "\"" + in_the_way + "\" is in the way; " +
                     (height ? "let it rise higher" : "choose a spot that is open from above"));
}

}  // namespace hazumi::edit
