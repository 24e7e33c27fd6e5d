// Forces f_i at points r_i with weights w_i, in cones K_i = {f : |tangential| <= mu normal}:
//   least sum |f_i|^2 / (2 w_i)   so that   sum G_i f_i = b,   f_i in K_i,   G_i = (1; r_i x)
// with b the force needed and its moment. To each point belongs, for the multipliers y = (a, c) of
// the two rows, the force that is wanted there, u_i = G_i^T y = a + c x r_i, and
//   f_i = P_i(w_i u_i),   P_i the projection on K_i,
// so that six equations are left,
//   s(y) = sum G_i P_i(w_i G_i^T y) = b,
// the gradient of a convex function: Newton's method with a line search. A point that pins has all
// of space for its cone, and may give a moment w kArm^2 c.
//
// What the cones cannot supply has no solution: s(y) + e (y - y_0) = b, with e small, comes as near
// as they do, and has one always. Where there is a solution, y_0 is the y before, until it is met.
//
// The projection of f = n N + T, T tangential:
//   f                                   mu n >= |T|   (inside)
//   0                                   mu |T| <= -n  (the polar cone)
//   (n + mu |T|) / (1 + mu^2) (N + mu T / |T|)   else, on the cone's side.

#include "engine/analysis/contact_forces.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

constexpr double kArm = 0.3;        // of moments, which are divided by it [m]
constexpr double kSoftness = 1e-6;  // e, in units of the sum of weights
constexpr double kMet = 1e-10;      // share of b

Mat3 Cross(const Vec3& r) {
  Mat3 cross;
  cross << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  return cross;
}

// f, and what its derivative lacks of the identity: nothing inside, which is told by false.
bool Project(const Vec3& normal, double mu, Vec3* f, Mat3* lacking) {
  const double n = f->dot(normal);
  const Vec3 tangential = *f - n * normal;
  const double t = tangential.norm();
  if (t <= mu * n) return false;
  lacking->setIdentity();
  if (mu * t <= -n) {
    f->setZero();
    return true;
  }
  const Vec3 along = tangential / t;
  const double size = (n + mu * t) / (1.0 + mu * mu);
  const Vec3 side = normal + mu * along;
  const double turn = size * mu / t;
  *lacking *= 1.0 - turn;
  lacking->noalias() -= side * (side.transpose() / (1.0 + mu * mu));
  lacking->noalias() += turn * normal * normal.transpose();
  lacking->noalias() += turn * along * along.transpose();
  *f = size * side;
  return true;
}

// G S G^T, into the lower half.
template <typename Mat6>
void AddBlock(const Mat3& S, const Vec3& arm, double sign, Mat6* slope) {
  const Mat3 C = Cross(arm), CS = C * S;
  slope->template topLeftCorner<3, 3>() += sign * S;
  slope->template bottomLeftCorner<3, 3>() += sign * CS;
  slope->template bottomRightCorner<3, 3>() -= sign * CS * C;
}

}  // namespace

// What the cones do not cut off is the same at any y.
void ContactForceSolver::Begin(const Vec3& middle, const std::vector<ContactPoint>& points,
                               double softness) {
  softness_ = softness;
  whole_ = softness * Mat6::Identity();
  arms_.clear();
  for (const ContactPoint& point : points) {
    arms_.push_back((point.p - middle) / kArm);
    AddBlock(point.weight * Mat3::Identity(), arms_.back(), 1.0, &whole_);
    if (point.has_moment) whole_.diagonal().tail<3>().array() += point.weight;
  }
}

void ContactForceSolver::Evaluate(const Vec6& y, const std::vector<ContactPoint>& points,
                                  double friction) {
  supplied_.setZero();
  potential_ = 0.0;
  is_cut_ = false;
  slope_ = whole_;
  Mat3 lacking;
  for (size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& point = points[i];
    Vec3 f = point.weight * (y.head<3>() + y.tail<3>().cross(arms_[i]));
    const bool is_cut = !point.is_pin && Project(point.normal, friction, &f, &lacking);
    supplied_.head<3>() += f;
    supplied_.tail<3>() += arms_[i].cross(f);
    potential_ += 0.5 * f.squaredNorm() / point.weight;
    is_cut_ |= is_cut;
    if (is_cut) AddBlock(point.weight * lacking, arms_[i], -1.0, &slope_);
    if (!point.has_moment) continue;
    supplied_.tail<3>() += point.weight * y.tail<3>();
    potential_ += 0.5 * point.weight * y.tail<3>().squaredNorm();
  }
}

double ContactForceSolver::Merit(const Vec6& y, const Vec6& start, const Vec6& needed) const {
  return potential_ + 0.5 * softness_ * (y - start).squaredNorm() - needed.dot(y);
}

// Solves s(y) + e (y - y_0) = b from *y on; leaves what belongs to it.
void ContactForceSolver::Approach(const Vec6& needed, const std::vector<ContactPoint>& points,
                                  double friction, const Vec6& start, Vec6* y) {
  constexpr int kMostSteps = 50, kMostHalvings = 20;
  Evaluate(*y, points, friction);
  for (int step = 0; step < kMostSteps; ++step) {
    const double merit = Merit(*y, start, needed);
    const Vec6 rest = needed - supplied_ - softness_ * (*y - start);
    if (rest.norm() <= kMet * needed.norm()) return;
    const Vec6 way = slope_.selfadjointView<Eigen::Lower>().llt().solve(rest);
    const double gain = 1e-4 * rest.dot(way), rounding = 1e-14 * std::abs(merit);
    double part = 1.0;
    Vec6 next = *y + way;
    Evaluate(next, points, friction);
    for (int i = 0;
         i < kMostHalvings && Merit(next, start, needed) > merit - part * gain + rounding; ++i) {
      part *= 0.5;
      next = *y + part * way;
      Evaluate(next, points, friction);
    }
    *y = next;
  }
}

// Without cones, which is right where all forces are inside them.
bool ContactForceSolver::SolveWithoutCones(const Vec6& needed,
                                           const std::vector<ContactPoint>& points, double friction,
                                           Vec6* y) {
  Mat6 all = whole_;
  all.diagonal().array() -= (1.0 - 1e-6) * softness_;
  *y = all.selfadjointView<Eigen::Lower>().llt().solve(needed);
  Evaluate(*y, points, friction);
  if (is_cut_) return false;
  *y += all.selfadjointView<Eigen::Lower>().llt().solve(Vec6(needed - supplied_));
  Evaluate(*y, points, friction);
  return !is_cut_ && (needed - supplied_).norm() <= kMet * needed.norm();
}

Wrench ContactForceSolver::Solve(const Wrench& needed, const Vec3& about,
                                 const std::vector<ContactPoint>& points, double friction,
                                 std::vector<ContactForce>* forces) {
  forces->assign(points.size(), {});
  if (points.empty()) {
    has_guess_ = false;
    return needed;
  }
  Vec3 middle = Vec3::Zero();
  double weights = 0.0;
  for (const ContactPoint& point : points) {
    middle += point.weight * point.p;
    weights += point.weight;
  }
  middle /= weights;
  Begin(middle, points, kSoftness * weights);
  Vec6 b;
  b << needed.force, (needed.moment - (middle - about).cross(needed.force)) / kArm;

  // The last answer is near; it changes the way, not where it leads.
  Vec6 y = Vec6::Zero(), start = y;
  const bool is_met = SolveWithoutCones(b, points, friction, &y);
  if (!is_met) y.setZero();
  if (!is_met && has_guess_) {
    y << guess_.head<3>() + guess_.tail<3>().cross(middle - guess_middle_) / kArm, guess_.tail<3>();
  }
  // Met at the second or third time, if it can be.
  constexpr int kMostTimes = 4;
  constexpr double kCannot = 0.01;
  double missing = b.norm();
  for (int i = 0; i < kMostTimes && !is_met; ++i) {
    Approach(b, points, friction, start, &y);
    const double now = (b - supplied_).norm();
    if (now <= kMet * b.norm() || now > kCannot * b.norm() || now > 0.5 * missing) break;
    missing = now;
    start = y;
  }
  has_guess_ = true;
  guess_ = y;
  guess_middle_ = middle;
  for (size_t i = 0; i < points.size(); ++i) {
    Vec3 f = points[i].weight * (y.head<3>() + y.tail<3>().cross(arms_[i]));
    Mat3 lacking;
    if (!points[i].is_pin) Project(points[i].normal, friction, &f, &lacking);
    (*forces)[i].force = f;
    if (points[i].has_moment) (*forces)[i].moment = points[i].weight * kArm * y.tail<3>();
  }
  const Vec6 rest = b - supplied_;
  Wrench left;
  left.force = rest.head<3>();
  left.moment = kArm * Vec3(rest.tail<3>()) + (middle - about).cross(left.force);
  return left;
}

}  // namespace hazumi
