// Finds the pose q and the rates q' with which the object comes down on the spot for which
//
//   sum over hinges  (f (q - wanted) / s)^2 + (q' / ease)^2 + (beyond(q, limits) / l)^2
//                    + ((q - start - (q' + start') T / 2) / d)^2 + (beyond(q', fastest) / m)^2
//   + (miss / n)^2
//
// is least. The fourth term asks for a swing that gains speed evenly in the time T; f: firmness.
// Gauss and Newton's method, damped as Levenberg does; derivatives are differences.

#include "engine/makers/throws/release_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr double kPose = 20.0 * kDegree;      // s
constexpr double kWay = 40.0 * kDegree;       // d
constexpr double kLimit = 1.0 * kDegree;      // l
constexpr double kNearLimit = 4.0 * kDegree;  // how far inside a limit pushes begin
constexpr double kTooFast = 20.0 * kDegree;   // m [rad/s]

constexpr double kGives = 1.15;   // how much faster than `fastest` is let pass
constexpr double kOver = 0.05;    // that a path rises above its spot, from which it comes down [m]
constexpr double kStiff = 200.0;  // of limits and speeds, where they have to be kept

double Beyond(double value, double lower, double upper) {
  return value > upper ? value - upper : std::min(0.0, value - lower);
}

class ReleaseSolver {
 public:
  ReleaseSolver(const ReleaseCarrier& carrier, const std::vector<ReleaseHinge>& hinges,
                const ReleaseTarget& target)
      : carrier_(carrier), hinges_(hinges), target_(target) {
    for (size_t k = 0; k < hinges.size(); ++k) {
      if (hinges[k].moves) moving_.push_back(static_cast<int>(k));
    }
  }

  Release Find() const {
    const int n = static_cast<int>(moving_.size());
    VecX x(2 * n);
    for (int i = 0; i < n; ++i) {
      const ReleaseHinge& hinge = HingeOf(i);
      x[i] = std::clamp(hinge.wanted, hinge.lower, hinge.upper);
      x[n + i] = std::clamp(2.0 * (x[i] - hinge.start) / target_.seconds, -0.5 * hinge.fastest,
                            0.5 * hinge.fastest);
    }
    // The spot counts more and more: what comes near it by force at once stays in a poor pose.
    for (const double miss : {0.5, 0.05, 0.005, 0.0005}) Minimize(miss, 1.0, &x);
    // What goes beyond what the arm can comes down short.
    if (IsBeyond(x)) {
      for (const double miss : {0.5, 0.05, 0.005}) Minimize(miss, kStiff, &x);
    }
    Release found = At(x);
    found.miss = MissOfSpot(found.path, target_.spot, target_.height, target_.gravity).norm();
    return found;
  }

 private:
  bool IsBeyond(const VecX& x) const {
    const int n = static_cast<int>(moving_.size());
    for (int i = 0; i < n; ++i) {
      const ReleaseHinge& hinge = HingeOf(i);
      const bool is_fast = std::abs(x[n + i]) > kGives * hinge.fastest;
      if (is_fast || Beyond(x[i], hinge.lower, hinge.upper) != 0.0) return true;
    }
    return false;
  }

  // Scales of the terms.
  struct Scales {
    double miss;   // n
    double stiff;  // how many times as much limits and speeds count
  };
  void Minimize(double miss, double stiff, VecX* at) const {
    constexpr int kMostSteps = 40;
    const Scales scales = {miss, stiff};
    VecX x = *at;
    VecX r = Residuals(x, scales);
    double damping = 1e-3;
    for (int step = 0; step < kMostSteps && damping < 1e8; ++step) {
      const MatX J = Jacobian(x, r, scales);
      MatX A = J.transpose() * J;
      A.diagonal() *= 1.0 + damping;
      const VecX dx = -A.ldlt().solve(J.transpose() * r);
      const VecX next = x + dx;
      const VecX there = Residuals(next, scales);
      if (!(there.squaredNorm() < r.squaredNorm())) {
        damping *= 8.0;
        continue;
      }
      const bool is_done = r.squaredNorm() - there.squaredNorm() < 1e-7 * r.squaredNorm();
      x = next;
      r = there;
      damping = std::max(damping / 6.0, 1e-9);
      if (is_done) break;
    }
    *at = x;
  }

  const ReleaseHinge& HingeOf(int i) const {
    return hinges_[static_cast<size_t>(moving_[static_cast<size_t>(i)])];
  }

  Release At(const VecX& x) const {
    const int n = static_cast<int>(moving_.size());
    Release at;
    at.angles = VecX::Zero(static_cast<int>(hinges_.size()));
    at.rates = at.angles;
    for (size_t k = 0; k < hinges_.size(); ++k) at.angles[static_cast<int>(k)] = hinges_[k].wanted;
    for (int i = 0; i < n; ++i) {
      at.angles[moving_[static_cast<size_t>(i)]] = x[i];
      at.rates[moving_[static_cast<size_t>(i)]] = x[n + i];
    }
    Pose pose = carrier_.pose;
    Vec3 w = carrier_.w, v = carrier_.v;
    for (size_t k = 0; k < hinges_.size(); ++k) {
      const int i = static_cast<int>(k);
      const Vec3 arm = pose.R * hinges_[k].X_PJ.p;
      v += w.cross(arm);
      pose = pose * hinges_[k].X_PJ;
      w += at.rates[i] * (pose.R * hinges_[k].axis);
      pose.R *= Eigen::AngleAxisd(at.angles[i], hinges_[k].axis).toRotationMatrix();
    }
    const Vec3 arm = pose.R * target_.offset;
    at.path = {pose.p + arm, v + w.cross(arm), 0.0};
    return at;
  }

  VecX Residuals(const VecX& x, const Scales& scales) const {
    const int n = static_cast<int>(moving_.size());
    const Release at = At(x);
    const Vec3 miss = MissOfSpot(at.path, target_.spot, target_.height, target_.gravity);
    VecX r(5 * n + 3);
    for (int i = 0; i < n; ++i) {
      const ReleaseHinge& hinge = HingeOf(i);
      const double q = x[i], rate = x[n + i];
      r[5 * i] = target_.firmness * (q - hinge.wanted) / kPose;
      r[5 * i + 1] = rate / hinge.ease;
      r[5 * i + 2] = (q - hinge.start - 0.5 * target_.seconds * (rate + hinge.start_rate)) / kWay;
      const double inside = std::min(kNearLimit, 0.25 * (hinge.upper - hinge.lower));
      const double near = Beyond(q, hinge.lower + inside, hinge.upper - inside);
      r[5 * i + 3] = scales.stiff * near / kLimit;
      r[5 * i + 4] = scales.stiff * Beyond(rate, -hinge.fastest, hinge.fastest) / kTooFast;
    }
    r.tail<3>() = miss / scales.miss;
    return r;
  }

  MatX Jacobian(const VecX& x, const VecX& r, const Scales& scales) const {
    constexpr double kStep = 1e-6;
    MatX J(r.size(), x.size());
    for (int i = 0; i < x.size(); ++i) {
      VecX moved = x;
      moved[i] += kStep;
      J.col(i) = (Residuals(moved, scales) - r) / kStep;
    }
    return J;
  }

  const ReleaseCarrier& carrier_;
  const std::vector<ReleaseHinge>& hinges_;
  const ReleaseTarget& target_;
  std::vector<int> moving_;  // hinges
};

}  // namespace

Release ReleaseFor(const ReleaseCarrier& carrier, const std::vector<ReleaseHinge>& hinges,
                   const ReleaseTarget& target) {
  return ReleaseSolver(carrier, hinges, target).Find();
}

Vec3 MissOfSpot(const ThrowPath& path, const Vec3& spot, const std::optional<double>& height,
                double gravity) {
  const double up = std::max(0.0, path.velocity.z());
  const double rise = height.value_or(0.5 * up * up / gravity);
  const double over = height ? 0.0 : kOver;
  const double lacks = std::max(0.0, spot.z() + over - path.from.z() - rise);
  Vec3 miss = Vec3::Zero();
  if (height) {
    const ThrowPath wanted = ThrowOver(path.from, spot, *height, gravity);
    miss = wanted.seconds * (path.velocity - wanted.velocity);
  } else {
    const double seconds = SecondsDown(path, spot.z(), gravity);
    miss.head<2>() = (path.from + seconds * path.velocity - spot).head<2>();
  }
  // No other velocity makes up for that.
  miss.z() += miss.z() > 0.0 ? lacks : -lacks;
  return miss;
}

}  // namespace hazumi::makers
