// The point p(q) is brought to the place by damped steps within the limits,
//
//   dq = J^T (J J^T + d 1)^-1 (place - p),  J = dp / dq of the hinges that no limit stops,
//
// and then along the null space of J towards the angles that are wanted. It begins at several
// poses, for limits make dead ends.

#include "engine/makers/aims/reach_pose.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hazumi::makers {

namespace {

constexpr double kThere = 1e-5;  // [m]

class ReachSolver {
 public:
  ReachSolver(const Pose& carrier, const std::vector<ReachHinge>& hinges, const Vec3& offset,
              const Vec3& place)
      : carrier_(carrier), hinges_(hinges), offset_(offset), place_(place) {}

  Reach From(VecX q) {
    constexpr int kMostSteps = 60;
    constexpr double kLongest = 0.5;  // of any angle [rad]
    Clamp(&q);
    double off = Place(q);
    double damping = 1e-4;
    for (int i = 0; i < kMostSteps; ++i) {
      VecX dq = Step(q, damping);
      const double longest = dq.cwiseAbs().maxCoeff();
      if (longest > kLongest) dq *= kLongest / longest;
      VecX next = q + dq;
      Clamp(&next);
      if ((next - q).cwiseAbs().maxCoeff() < 1e-7) break;
      const double there = Place(next);
      // Once it is there it may go sideways, as long as it stays there.
      if (there < off || there < kThere) {
        q = next;
        off = there;
        damping = std::max(damping / 4.0, 1e-7);
      } else {
        Place(q);
        damping *= 8.0;
        if (damping > 1e3) break;
      }
    }
    return {q, off};
  }

  // Squared distance from the pose that is wanted, in shares of ranges.
  double Strain(const VecX& q) const {
    double sum = 0.0;
    for (size_t k = 0; k < hinges_.size(); ++k) {
      const ReachHinge& hinge = hinges_[k];
      const double range = std::min(hinge.upper - hinge.lower, 2.0 * kHalfTurn);
      if (!(range > 0.0)) continue;
      const double share = (q[static_cast<int>(k)] - hinge.wanted) / range;
      sum += share * share;
    }
    return sum;
  }

 private:
  static constexpr double kHalfTurn = 3.14159265358979323846;

  void Clamp(VecX* q) const {
    for (size_t k = 0; k < hinges_.size(); ++k) {
      double& angle = (*q)[static_cast<int>(k)];
      angle = std::clamp(angle, hinges_[k].lower, hinges_[k].upper);
    }
  }

  // Puts the hinges; returns the distance that is left [m].
  double Place(const VecX& q) {
    Pose at = carrier_;
    axes_.clear();
    origins_.clear();
    for (size_t k = 0; k < hinges_.size(); ++k) {
      at = at * hinges_[k].X_PJ;
      axes_.push_back(at.R * hinges_[k].axis);
      origins_.push_back(at.p);
      at.R *= Eigen::AngleAxisd(q[static_cast<int>(k)], hinges_[k].axis).toRotationMatrix();
    }
    point_ = at * offset_;
    return (place_ - point_).norm();
  }

  VecX Step(const VecX& q, double damping) const {
    const int n = static_cast<int>(hinges_.size());
    const Vec3 off = place_ - point_;
    Eigen::Matrix3Xd J(3, n);
    for (int k = 0; k < n; ++k) {
      const size_t at = static_cast<size_t>(k);
      J.col(k) = axes_[at].cross(point_ - origins_[at]);
    }
    // Hinges at a limit that would go on are left out, one round after the other.
    std::vector<char> is_stopped(hinges_.size(), 0);
    VecX dq = VecX::Zero(n);
    for (int round = 0; round <= n; ++round) {
      for (int k = 0; k < n; ++k) {
        if (is_stopped[static_cast<size_t>(k)]) J.col(k).setZero();
      }
      Mat3 A = J * J.transpose();
      A.diagonal().array() += damping;
      const Eigen::LDLT<Mat3> factor(A);
      VecX home(n);
      for (int k = 0; k < n; ++k) {
        const size_t at = static_cast<size_t>(k);
        home[k] = is_stopped[at] ? 0.0 : 0.3 * (hinges_[at].wanted - q[k]);
      }
      dq = J.transpose() * factor.solve(off) + home - J.transpose() * factor.solve(J * home);
      bool any = false;
      for (int k = 0; k < n; ++k) {
        const ReachHinge& hinge = hinges_[static_cast<size_t>(k)];
        const bool is_out =
            (q[k] >= hinge.upper && dq[k] > 0.0) || (q[k] <= hinge.lower && dq[k] < 0.0);
        if (!is_out || is_stopped[static_cast<size_t>(k)]) continue;
        is_stopped[static_cast<size_t>(k)] = 1;
        any = true;
      }
      if (!any) break;
    }
    return dq;
  }

  const Pose& carrier_;
  const std::vector<ReachHinge>& hinges_;
  const Vec3& offset_;
  const Vec3& place_;
  std::vector<Vec3> axes_, origins_;
  Vec3 point_;
};

// Numbers between 0 and 1 that fill it evenly: those of Halton, by index from 1 on.
double Halton(int index, int base) {
  double value = 0.0, share = 1.0;
  for (; index > 0; index /= base) {
    share /= base;
    value += share * (index % base);
  }
  return value;
}

}  // namespace

Reach ReachFor(const Pose& carrier, const std::vector<ReachHinge>& hinges, const Vec3& offset,
               const Vec3& place, const std::function<double(const VecX&)>& depth) {
  constexpr int kStarts = 24, kAlways = 6;
  constexpr int kBases[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
  constexpr double kShallow = 5e-4;   // [m]
  constexpr double kPerMetre = 50.0;  // strain
  ReachSolver solver(carrier, hinges, offset, place);
  const int n = static_cast<int>(hinges.size());
  std::optional<Reach> best;
  double least = 0.0, deep = 0.0;  // strain and depth of the best
  for (int i = 0; i < kStarts; ++i) {
    VecX q(n);
    for (int k = 0; k < n; ++k) {
      const ReachHinge& hinge = hinges[static_cast<size_t>(k)];
      const double share = i == 2 ? 0.5 : Halton(i, kBases[k % 10]);
      q[k] = i == 0   ? hinge.wanted
             : i == 1 ? hinge.other
                      : hinge.lower + share * (hinge.upper - hinge.lower);
    }
    const Reach reach = solver.From(q);
    const bool is_there = reach.distance < kThere;
    const bool was_there = best && best->distance < kThere;
    const double now = is_there && depth ? std::max(0.0, depth(reach.angles) - kShallow) : 0.0;
    const double strain = solver.Strain(reach.angles) + kPerMetre * now;
    const bool is_better = !best || (is_there && (!was_there || strain < least)) ||
                           (!is_there && !was_there && reach.distance < best->distance);
    if (is_better) {
      best = reach;
      least = strain;
      deep = now;
    }
    if (i + 1 >= kAlways && best->distance < kThere && deep == 0.0) break;
  }
  return *best;
}

}  // namespace hazumi::makers
