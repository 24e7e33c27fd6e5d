// Forces f_i at points r_i with weights w_i, in cones K_i = {f : |tangential| <= mu normal}:
//   least sum |f_i|^2 / (2 w_i)   so that   sum G_i f_i = b,   f_i in K_i,   G_i = (1; r_i x)
// with b the force needed and its moment. To each point belongs, for the multipliers y = (a, c) of
// the two rows, u_i = G_i^T y = a + c x r_i, the force that is wanted there of each unit of weight,
// and
//   f_i = w_i P_i(u_i),   P_i the projection on K_i,
// so that six equations are left,
//   s(y) = sum w_i G_i P_i(G_i^T y) = b,
// the gradient of the convex function sum w_i |P_i(u_i)|^2 / 2. A point that pins has all of space
// for its cone, and may give a moment w kArm^2 c.
//
// The projection of u = n N + T, T tangential along the unit vector e, and its derivative:
//   u                                           1         mu n >= |T|   (inside)
//   0                                           0         mu |T| <= -n  (the polar cone)
//   q d, q = (n + mu |T|) / (1 + mu^2), d = N + mu e      else, on the cone's side:
//                     d d^T / (1 + mu^2) + mu q / |T| (N x e)(N x e)^T
//
// Newton's method from the y of the frames before, extrapolated, meets s(y) = b in two or three
// steps where it can be met. What the cones cannot supply has no solution: s(y) + e (y - y_0) = b,
// with e small, comes as near as they do, and has one always, which a line search finds. Where
// there is a solution, y_0 is the y before, until it is met.

#include "engine/analysis/contact_forces.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

constexpr double kArm = 0.3;              // of moments, which are divided by it [m]
constexpr double kSoftness = 1e-6;        // e, in units of the sum of weights
constexpr double kLeastSoftness = 1e-12;  // where all is thought to be met: no division by zero
constexpr double kMet = 1e-10;            // share of b

// (A + softness 1)^-1 x, A positive semidefinite, of which the lower half is read: L D L^T.
Vec6 SolveDefinite(Mat6 A, double softness, Vec6 x) {
  Vec6 inverse;
  A.diagonal().array() += softness;
  for (int j = 0; j < 6; ++j) {
    inverse[j] = 1.0 / A(j, j);
    for (int i = j + 1; i < 6; ++i) {
      const double l = A(i, j) * inverse[j];
      x[i] -= l * x[j];
      for (int k = i; k < 6; ++k) A(k, i) -= l * A(k, j);
    }
  }
  for (int j = 5; j >= 0; --j) {
    for (int i = j + 1; i < 6; ++i) x[j] -= A(i, j) * x[i];
    x[j] *= inverse[j];
  }
  return x;
}

// Of the values of u, for a cone.
enum class Parts { kFound, kKept };

// The points of a frame. Arms are from their middle, in units of kArm.
class Cones {
 public:
  Cones(const std::vector<ContactPoint>& points, double friction, std::vector<ConePart>* parts,
        std::vector<ContactForce>* forces)
      : points_(points), mu_(friction), parts_(*parts), forces_(*forces) {
    for (const ContactPoint& point : points) {
      middle_ += point.weight * point.p;
      weights_ += point.weight;
    }
    middle_ /= weights_;
  }

  const Vec3& middle() const { return middle_; }
  double weights() const { return weights_; }

  // At y: the forces, s, its derivative, and the function that s is the gradient of. kKept: each
  // force goes on as it does in the part of its cone where it was found last.
  void Evaluate(const Vec6& y, Parts parts) {
    Begin();
    const Vec3 a = y.head<3>(), c = y.tail<3>();
    for (size_t i = 0; i < points_.size(); ++i) {
      const ContactPoint& point = points_[i];
      const Vec3 arm = (point.p - middle_) * (1.0 / kArm), u = a + c.cross(arm);
      const Vec3 f = point.weight * Project(point, arm, u, parts, &parts_[i]);
      forces_[i].force = f;
      supplied_.head<3>() += f;
      supplied_.tail<3>() += arm.cross(f);
      potential_ += 0.5 * f.dot(u);
      if (point.has_moment) AddMoment(point.weight, c, &forces_[i]);
    }
    AddWhole();
  }
  // Whether all were where they are kept.
  bool are_parts_right() const { return are_parts_right_; }

  const Vec6& supplied() const { return supplied_; }
  const Mat6& slope() const { return slope_; }
  double potential() const { return potential_; }

 private:
  void Begin() {
    are_parts_right_ = true;
    supplied_.setZero();
    slope_.setZero();
    potential_ = 0.0;
    whole_ = 0.0;
    first_.setZero();
    second_.setZero();
  }

  Vec3 Project(const ContactPoint& point, const Vec3& arm, const Vec3& u, Parts parts,
               ConePart* part) {
    if (point.is_pin) return Inside(point, arm, u);
    const double n = u.dot(point.normal);
    const Vec3 tangential = u - n * point.normal;
    const double t2 = tangential.squaredNorm(), mu2 = mu_ * mu_;
    const ConePart found = n >= 0.0 && t2 <= mu2 * n * n   ? ConePart::kInside
                           : n <= 0.0 && mu2 * t2 <= n * n ? ConePart::kPolar
                                                           : ConePart::kSide;
    if (parts == Parts::kFound || t2 == 0.0) *part = found;
    are_parts_right_ &= *part == found;
    if (*part == ConePart::kInside) return Inside(point, arm, u);
    if (*part == ConePart::kPolar) return Vec3::Zero();
    const double t = std::sqrt(t2), share = 1.0 / (1.0 + mu2), size = (n + mu_ * t) * share;
    const Vec3 along = tangential * (1.0 / t), side = point.normal + mu_ * along;
    AddSide(point, arm, share, side, mu_ * std::max(size, 0.0) / t, point.normal.cross(along));
    return size * side;
  }

  Vec3 Inside(const ContactPoint& point, const Vec3& arm, const Vec3& u) {
    const Vec3 weighted = point.weight * arm;
    whole_ += point.weight;
    first_ += weighted;
    for (int k = 0; k < 3; ++k) second_.col(k) += weighted[k] * arm;
    return u;
  }

  // w G (a d d^T + b e e^T) G^T: all that matters of the lower half, by pairs of rows.
  void AddSide(const ContactPoint& point, const Vec3& arm, double a, const Vec3& d, double b,
               const Vec3& e) {
    Vec6 D, E;
    D << d, arm.cross(d);
    E << e, arm.cross(e);
    const Vec6 aD = (point.weight * a) * D, bE = (point.weight * b) * E;
    slope_.col(0) += aD[0] * D + bE[0] * E;
    slope_.col(1) += aD[1] * D + bE[1] * E;
    slope_.col(2).tail<4>() += aD[2] * D.tail<4>() + bE[2] * E.tail<4>();
    slope_.col(3).tail<4>() += aD[3] * D.tail<4>() + bE[3] * E.tail<4>();
    slope_.col(4).tail<2>() += aD[4] * D.tail<2>() + bE[4] * E.tail<2>();
    slope_.col(5).tail<2>() += aD[5] * D.tail<2>() + bE[5] * E.tail<2>();
  }

  void AddMoment(double weight, const Vec3& c, ContactForce* force) {
    force->moment = weight * kArm * c;
    supplied_.tail<3>() += weight * c;
    potential_ += 0.5 * weight * c.squaredNorm();
    slope_.diagonal().tail<3>().array() += weight;
  }

  // sum w G G^T of what is inside: (w 1, -w [r]; w [r], w (r^2 1 - r r^T)), the lower half.
  void AddWhole() {
    slope_.diagonal().head<3>().array() += whole_;
    slope_.bottomRightCorner<3, 3>() -= second_;
    slope_.diagonal().tail<3>().array() += second_.trace();
    slope_(3, 1) -= first_.z();
    slope_(3, 2) += first_.y();
    slope_(4, 0) += first_.z();
    slope_(4, 2) -= first_.x();
    slope_(5, 0) -= first_.y();
    slope_(5, 1) += first_.x();
  }

  const std::vector<ContactPoint>& points_;
  double mu_;
  std::vector<ConePart>& parts_;  // by point
  std::vector<ContactForce>& forces_;
  bool are_parts_right_;
  Vec3 middle_ = Vec3::Zero();  // [m]
  double weights_ = 0.0;
  Vec6 supplied_;
  Mat6 slope_;  // its lower half
  double potential_;
  double whole_;  // of those inside: weights, and their first and second moments
  Vec3 first_;
  Mat3 second_;
};

// Solves s(y) = b from *y on; leaves what belongs to it. False: it was not met.
bool Follow(const Vec6& b, Cones* cones, Vec6* y) {
  constexpr int kMostSteps = 8, kKept = 1;
  const double met = kMet * b.norm(), softness = kLeastSoftness * cones->weights();
  double before = 1e300;
  for (int step = 0; step < kMostSteps; ++step) {
    cones->Evaluate(*y, step < kKept ? Parts::kKept : Parts::kFound);
    const Vec6 rest = b - cones->supplied();
    const double now = rest.norm();
    if (now <= met && cones->are_parts_right()) return true;
    if (step > kKept && !(now < before)) return false;
    before = now;
    *y += SolveDefinite(cones->slope(), softness, rest);
  }
  return false;
}

// Solves s(y) + e (y - y_0) = b from *y on; leaves what belongs to it.
void Approach(const Vec6& b, const Vec6& start, Cones* cones, Vec6* y) {
  constexpr int kMostSteps = 50, kMostHalvings = 20, kKept = 3;
  constexpr double kNearer = 0.5;
  const double softness = kSoftness * cones->weights(), met = kMet * b.norm();
  Vec6 rest;
  double merit;
  const auto move_to = [&](const Vec6& at, Parts parts) {
    cones->Evaluate(at, parts);
    rest = b - cones->supplied() - softness * (at - start);
    merit = cones->potential() + 0.5 * softness * (at - start).squaredNorm() - b.dot(at);
  };
  for (int step = 0; step < kKept; ++step) {
    move_to(*y, Parts::kKept);
    if (rest.norm() <= met) {
      if (cones->are_parts_right()) return;
      break;
    }
    *y += SolveDefinite(cones->slope(), softness, rest);
  }
  move_to(*y, Parts::kFound);
  for (int step = 0; step < kMostSteps; ++step) {
    const double size = rest.norm();
    if (size <= met) return;
    const Vec6 from = *y, way = SolveDefinite(cones->slope(), softness, rest);
    const double gain = 1e-4 * rest.dot(way), most = merit + 1e-14 * std::abs(merit);
    double part = 1.0;
    move_to(from + way, Parts::kFound);
    for (int i = 0; i < kMostHalvings && rest.norm() > kNearer * size && merit > most - part * gain;
         ++i) {
      part *= 0.5;
      move_to(from + part * way, Parts::kFound);
    }
    *y = from + part * way;
  }
}

// As near as can be; met at the second or third time, if it can be.
bool ComeNearest(const Vec6& b, Cones* cones, Vec6* y) {
  constexpr int kMostTimes = 4;
  constexpr double kCannot = 0.01;
  Vec6 start = Vec6::Zero();
  double missing = b.norm();
  for (int i = 0; i < kMostTimes; ++i) {
    Approach(b, start, cones, y);
    const double now = (b - cones->supplied()).norm();
    if (now <= kMet * b.norm()) return true;
    if (now > kCannot * b.norm() || now > 0.5 * missing) return false;
    missing = now;
    start = *y;
  }
  return false;
}

// The same forces wanted, told about another point that is further by `way` [m].
Vec6 Moved(Vec6 y, const Vec3& way) {
  y.head<3>() += y.tail<3>().cross(way) / kArm;
  return y;
}

}  // namespace

Wrench ContactForceSolver::Solve(const Wrench& needed, const Vec3& about,
                                 const std::vector<ContactPoint>& points, double friction,
                                 std::vector<ContactForce>* forces) {
  forces->assign(points.size(), {});
  if (points.empty()) {
    num_last_ = 0;
    return needed;
  }
  if (parts_.size() != points.size()) parts_.assign(points.size(), ConePart::kInside);
  Cones cones(points, friction, &parts_, forces);
  const Vec3& middle = cones.middle();
  Vec6 b;
  b << needed.force, (needed.moment - (middle - about).cross(needed.force)) / kArm;

  Vec6 guess = Vec6::Zero();
  if (num_last_ == 1) guess = last_[0];
  if (num_last_ == 2) guess = 2.0 * last_[0] - last_[1];
  guess = Moved(guess, middle);
  Vec6 y = guess;
  bool is_met = (num_last_ == 0 || was_met_) && Follow(b, &cones, &y);
  if (!is_met) {
    y = guess;
    is_met = ComeNearest(b, &cones, &y);
  }
  if (is_met != was_met_) num_last_ = 0;
  was_met_ = is_met;
  last_[1] = last_[0];
  last_[0] = Moved(y, -middle);
  num_last_ = std::min(num_last_ + 1, 2);

  const Vec6 rest = b - cones.supplied();
  Wrench left;
  left.force = rest.head<3>();
  left.moment = kArm * Vec3(rest.tail<3>()) + (middle - about).cross(left.force);
  return left;
}

}  // namespace hazumi
