// Forces f_i at points r_i with weights w_i, in cones K_i = {f : |tangential| <= mu normal}:
//   minimize sum |f_i|^2 / (2 w_i)   subject to   sum G_i f_i = b,   f_i in K_i,   G_i = (1; r_i x)
// with b the required force and moment. The multipliers y = (a, c) of the two constraints give each
// point the unconstrained force per unit of weight u_i = G_i^T y = a + c x r_i, and
//   f_i = w_i P_i(u_i),   P_i the projection on K_i.
// Six equations remain,
//   s(y) = sum w_i G_i P_i(G_i^T y) = b,
// where s is the gradient of the convex function sum w_i |P_i(u_i)|^2 / 2. The cone of a grip is
// all of space.
//
// The projection of u = n N + T, T tangential along the unit vector e, and its derivative:
//   u                                           1         mu n >= |T|   (inside)
//   0                                           0         mu |T| <= -n  (the polar cone)
//   q d, q = (n + mu |T|) / (1 + mu^2), d = N + mu e      else, on the cone's side:
//                     d d^T / (1 + mu^2) + mu q / |T| (N x e)(N x e)^T
//
// Newton's method starts at y extrapolated from the previous frames. Each force starts in the part
// of its cone of the previous frame, and the formula of that part is extrapolated beyond the part.
// Two or three iterations suffice where no force changes its part. The equations have no solution
// where the cones cannot supply b. The regularized equations s(y) + e (y - y_0) = b, with e small,
// always have one, which a line search finds. The solution minimizes
//   |b + e y_0 - s|^2,   moments divided by kMomentArm,
// so a residual moment changes the forces by its square over kMomentArm^2. Where b can be supplied,
// y_0 is the previous y, until b is met (augmented Lagrangian). Where b cannot be supplied, only
// the three numbers a of y_0 come from the previous y: the force then comes as near to b as the
// cones allow, whatever the residual moment, and the moment comes as near as these forces allow.

#include "engine/analysis/contact_forces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/analysis/contact_cones.h"

namespace hazumi {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

constexpr double kRegularization = 1e-8;        // regularization e, in units of the sum of weights
constexpr double kLeastRegularization = 1e-12;  // regularization where b can be met
constexpr double kMet = 1e-10;                  // tolerance, as a share of b

// Solves s(y) = b from *y on; leaves what belongs to it. False: it was not met.
bool Follow(const Vec6& b, ContactCones* cones, Vec6* y) {
  constexpr int kMostSteps = 8, kKept = 1;
  const double met = kMet * b.norm(), regularization = kLeastRegularization * cones->weights();
  double before = 1e300;
  const int kept = cones->knows_parts() ? kKept : 0;
  for (int step = 0; step < kMostSteps; ++step) {
    cones->Evaluate(*y, step < kept ? ConeParts::kKept : ConeParts::kFound);
    const Vec6 rest = b - cones->supplied();
    const double now = rest.norm();
    if (now <= met && cones->are_parts_right()) return true;
    if (step > kept && !(now < before)) return false;
    before = now;
    *y += cones->Solve(regularization, rest);
  }
  return false;
}

// Solves s(y) + e (y - y_0) = b from *y on; leaves what belongs to it.
void Approach(const Vec6& b, const Vec6& start, ContactCones* cones, Vec6* y) {
  constexpr int kMostSteps = 100, kMostParts = 15, kKept = 3;
  constexpr double kNearer = 0.5, kLeastPart = 0.1;
  const double regularization = kRegularization * cones->weights(), met = kMet * b.norm();
  Vec6 rest;
  double merit;
  const auto move_to = [&](const Vec6& at, ConeParts parts) {
    cones->Evaluate(at, parts);
    rest = b - cones->supplied() - regularization * (at - start);
    merit = cones->potential() + 0.5 * regularization * (at - start).squaredNorm() - b.dot(at);
  };
  const int kept = cones->knows_parts() ? kKept : 0;
  for (int step = 0; step < kept; ++step) {
    move_to(*y, ConeParts::kKept);
    if (rest.norm() <= met) {
      if (cones->are_parts_right()) return;
      break;
    }
    *y += cones->Solve(regularization, rest);
  }
  move_to(*y, ConeParts::kFound);
  for (int step = 0; step < kMostSteps; ++step) {
    const double size = rest.norm();
    if (size <= met) return;
    const Vec6 from = *y, way = cones->Solve(regularization, rest);
    const double fall = rest.dot(way), before = merit, rounding = 1e-14 * std::abs(merit);
    double part = 1.0;
    move_to(*y = from + way, ConeParts::kFound);
    for (int i = 0; i < kMostParts; ++i) {
      if (rest.norm() <= kNearer * size || merit <= before + rounding - 1e-4 * part * fall) {
        break;
      }
      // Too far: back to where the merit's parabola there has its least.
      const double bend = cones->Bend(way) + regularization * way.squaredNorm();
      const double next = part + rest.dot(way) / bend;
      part = std::max(kLeastPart * part, next < part ? next : 0.0);
      move_to(*y = from + part * way, ConeParts::kFound);
    }
    if (rest.norm() >= size && merit >= before - rounding) return;  // converged up to rounding
  }
}

// Minimizes the residual force, then the residual moment. Ends when the residual force changes by
// less than kSame of b.
void ComeNearestInForce(const Vec6& b, ContactCones* cones, Vec6* y) {
  constexpr int kMostTimes = 6;
  constexpr double kSame = 1e-10;
  Vec6 start = Vec6::Zero();
  Vec3 rest = (b - cones->supplied()).head<3>();
  for (int i = 0; i < kMostTimes; ++i) {
    Approach(b, start, cones, y);
    const Vec3 now = (b - cones->supplied()).head<3>();
    if (i > 0 && (now - rest).norm() <= kSame * b.norm()) return;
    rest = now;
    start.head<3>() = y->head<3>();
  }
}

// As near as can be; met at the second or third time, if it can be.
bool ComeNearest(const Vec6& b, ContactCones* cones, Vec6* y) {
  constexpr int kMostTimes = 4;
  constexpr double kCannot = 0.01;
  Vec6 start = Vec6::Zero();
  double missing = b.norm();
  for (int i = 0; i < kMostTimes; ++i) {
    Approach(b, start, cones, y);
    const double now = (b - cones->supplied()).norm();
    if (now <= kMet * b.norm()) return true;
    if (now > kCannot * b.norm() || now > 0.5 * missing) break;
    missing = now;
    start = *y;
  }
  ComeNearestInForce(b, cones, y);
  return false;
}

// The same forces wanted, told about another point that is further by `way` [m].
Vec6 Moved(Vec6 y, const Vec3& way) {
  y.head<3>() += y.tail<3>().cross(way) / kMomentArm;
  return y;
}

}  // namespace

// A contact that comes begins inside its cone.
void ContactForceSolver::KeepParts(const std::vector<ContactPoint>& points) {
  FitCones(ConeField::kNumGiven, points.size(), &given_);
  FitCones(ConeField::kNumFound, points.size(), &found_);
  const auto is_same = [](int id, const ContactPoint& point) { return id == point.id; };
  if (std::equal(ids_.begin(), ids_.end(), points.begin(), points.end(), is_same)) return;
  constexpr uint64_t kNone = 0;
  LaneArray last = found_;
  for (size_t i = 0, k = 0; i < points.size(); ++i) {
    while (k < ids_.size() && ids_[k] < points[i].id) ++k;
    const bool was_there = k < ids_.size() && ids_[k] == points[i].id;
    double* to = ConeFieldsOf(&found_, ConeField::kNumFound, i);
    const double* from = was_there ? ConeFieldsOf(&last, ConeField::kNumFound, k++) : nullptr;
    to[4 * ConeField::kInsideBits] =
        from ? from[4 * ConeField::kInsideBits] : std::bit_cast<double>(~kNone);
    to[4 * ConeField::kSideBits] =
        from ? from[4 * ConeField::kSideBits] : std::bit_cast<double>(kNone);
  }
  ids_.resize(points.size());
  std::transform(points.begin(), points.end(), ids_.begin(),
                 [](const ContactPoint& point) { return point.id; });
}

Wrench ContactForceSolver::Solve(const Wrench& needed, const Vec3& about,
                                 const std::vector<ContactPoint>& points, double friction,
                                 std::vector<Vec3>* forces) {
  forces->assign(points.size(), Vec3::Zero());
  if (points.empty()) {
    num_last_ = 0;
    ids_.clear();
    return needed;
  }
  const bool knows_parts = !ids_.empty();
  KeepParts(points);
  ContactCones cones(kernels_, points, about, friction, knows_parts, &given_, &found_);
  Vec6 b;
  b << needed.force, needed.moment / kMomentArm;

  Vec6 guess = Vec6::Zero();
  if (num_last_ == 1) guess = last_[0];
  if (num_last_ == 2) guess = 2.0 * last_[0] - last_[1];
  guess = Moved(guess, about);
  Vec6 y = guess;
  bool is_met = (num_last_ == 0 || was_met_) && Follow(b, &cones, &y);
  if (!is_met) {
    y = guess;
    is_met = ComeNearest(b, &cones, &y);
  }
  if (is_met != was_met_) num_last_ = 0;
  was_met_ = is_met;
  last_[1] = last_[0];
  last_[0] = Moved(y, -about);
  num_last_ = std::min(num_last_ + 1, 2);

  for (size_t i = 0; i < points.size(); ++i) (*forces)[i] = cones.force(i);
  const Vec6 rest = b - cones.supplied();
  return {rest.head<3>(), kMomentArm * Vec3(rest.tail<3>())};
}

}  // namespace hazumi
