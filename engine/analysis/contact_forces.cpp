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
// Newton's method begins at the y of the frames before, extrapolated, with each force in the part
// of its cone where it was then, whose formula goes on beyond that part: where none changes it, two
// or three steps do. What the cones cannot supply has no solution: s(y) + e (y - y_0) = b, with e
// small, comes as near as they do, and has one always, which a line search finds. Where there is a
// solution, y_0 is the y before, until it is met.

#include "engine/analysis/contact_forces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace hazumi {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

constexpr double kArm = 0.3;              // of moments, which are divided by it [m]
constexpr double kSoftness = 1e-6;        // e, in units of the sum of weights
constexpr double kLeastSoftness = 1e-12;  // where all is thought to be met: no division by zero
constexpr double kMet = 1e-10;            // share of b

// Of each force: the part of its cone that is found at y, or the one that it had the last time,
// where it goes on as it does there.
enum class Parts { kFound, kKept };

double* Fields(LaneArray* array, int num_fields, size_t i) {
  return array->data() + i / 4 * 4 * static_cast<size_t>(num_fields) + i % 4;
}

// Room for so many fields of contacts; what is there stays where it is.
void Fit(int num_fields, size_t contacts, LaneArray* array) {
  const size_t size = (contacts + 3) / 4 * 4 * static_cast<size_t>(num_fields);
  if (array->size() >= size) return;
  LaneArray larger(size);
  std::copy_n(array->data(), array->size(), larger.data());
  *array = std::move(larger);
}

// The contacts of a frame. Arms are from their middle, in units of kArm.
class Cones {
 public:
  Cones(const EffortKernels& kernels, const std::vector<ContactPoint>& points, double friction,
        bool knows_parts, LaneArray* given, LaneArray* found)
      : kernels_(kernels),
        num_fours_(static_cast<int>(points.size() + 3) / 4),
        friction_(friction),
        knows_parts_(knows_parts),
        given_(given),
        found_(found) {
    for (const ContactPoint& point : points) {
      middle_ += point.weight * point.p;
      weights_ += point.weight;
      if (point.has_moment) moment_weights_ += point.weight;
    }
    middle_ /= weights_;
    for (size_t i = 0; i < points.size(); ++i) Set(i, points[i]);
    ContactPoint nothing;  // in lanes without a contact
    nothing.p = middle_;
    nothing.weight = 0.0;
    nothing.is_pin = true;
    for (size_t i = points.size(); i < 4 * static_cast<size_t>(num_fours_); ++i) Set(i, nothing);
  }

  const Vec3& middle() const { return middle_; }
  double weights() const { return weights_; }

  // At y: the forces, s, its derivative, and the function that s is the gradient of.
  void Evaluate(const Vec6& y, Parts parts) {
    are_parts_right_ = kernels_.supply(given_->data(), num_fours_, y.data(), friction_,
                                       parts == Parts::kKept, found_->data(), sums_);
    knows_parts_ = true;
    const Vec3 c = y.tail<3>();
    supplied_ = Eigen::Map<const Vec6>(sums_ + ConeField::kSupplied);
    if (moment_weights_ == 0.0) return;
    supplied_.tail<3>() += moment_weights_ * c;
    sums_[ConeField::kPotential] += 0.5 * moment_weights_ * c.squaredNorm();
    for (const int diagonal : {15, 18, 20}) sums_[ConeField::kSlope + diagonal] += moment_weights_;
  }

  // (derivative + softness 1)^-1 x
  Vec6 Solve(double softness, Vec6 x) const {
    kernels_.solve(sums_ + ConeField::kSlope, softness, x.data());
    return x;
  }
  // x . derivative x
  double Bend(const Vec6& x) const {
    const double* lower = sums_ + ConeField::kSlope;
    double bend = 0.0;
    for (int column = 0; column < 6; ++column) {
      double sum = 0.5 * *lower++ * x[column];
      for (int row = column + 1; row < 6; ++row) sum += *lower++ * x[row];
      bend += 2.0 * sum * x[column];
    }
    return bend;
  }

  // Whether there was a last time.
  bool knows_parts() const { return knows_parts_; }
  // Whether all are in the part that they were taken for.
  bool are_parts_right() const { return are_parts_right_; }
  const Vec6& supplied() const { return supplied_; }
  double potential() const { return sums_[ConeField::kPotential]; }
  Vec3 force(size_t i) const {
    const double* at = Fields(found_, ConeField::kNumFound, i) + 4 * ConeField::kForce;
    return {at[0], at[4], at[8]};
  }

 private:
  void Set(size_t i, const ContactPoint& point) {
    double* at = Fields(given_, ConeField::kNumGiven, i);
    const Vec3 arm = (point.p - middle_) * (1.0 / kArm);
    for (int k = 0; k < 3; ++k) {
      at[4 * (ConeField::kArm + k)] = arm[k];
      at[4 * (ConeField::kNormal + k)] = point.normal[k];
    }
    at[4 * ConeField::kWeight] = point.weight;
    at[4 * ConeField::kPinBits] = std::bit_cast<double>(point.is_pin ? ~uint64_t{0} : uint64_t{0});
  }

  const EffortKernels& kernels_;
  int num_fours_;
  double friction_;
  bool knows_parts_;
  LaneArray *given_, *found_;
  Vec3 middle_ = Vec3::Zero();  // [m]
  double weights_ = 0.0, moment_weights_ = 0.0;
  bool are_parts_right_ = false;
  Vec6 supplied_;
  alignas(32) double sums_[ConeField::kNumSums];
};

// Solves s(y) = b from *y on; leaves what belongs to it. False: it was not met.
bool Follow(const Vec6& b, Cones* cones, Vec6* y) {
  constexpr int kMostSteps = 8, kKept = 1;
  const double met = kMet * b.norm(), softness = kLeastSoftness * cones->weights();
  double before = 1e300;
  const int kept = cones->knows_parts() ? kKept : 0;
  for (int step = 0; step < kMostSteps; ++step) {
    cones->Evaluate(*y, step < kept ? Parts::kKept : Parts::kFound);
    const Vec6 rest = b - cones->supplied();
    const double now = rest.norm();
    if (now <= met && cones->are_parts_right()) return true;
    if (step > kept && !(now < before)) return false;
    before = now;
    *y += cones->Solve(softness, rest);
  }
  return false;
}

// Solves s(y) + e (y - y_0) = b from *y on; leaves what belongs to it.
void Approach(const Vec6& b, const Vec6& start, Cones* cones, Vec6* y) {
  constexpr int kMostSteps = 100, kMostParts = 15, kKept = 3;
  constexpr double kNearer = 0.5, kLeastPart = 0.1;
  const double softness = kSoftness * cones->weights(), met = kMet * b.norm();
  Vec6 rest;
  double merit;
  const auto move_to = [&](const Vec6& at, Parts parts) {
    cones->Evaluate(at, parts);
    rest = b - cones->supplied() - softness * (at - start);
    merit = cones->potential() + 0.5 * softness * (at - start).squaredNorm() - b.dot(at);
  };
  const int kept = cones->knows_parts() ? kKept : 0;
  for (int step = 0; step < kept; ++step) {
    move_to(*y, Parts::kKept);
    if (rest.norm() <= met) {
      if (cones->are_parts_right()) return;
      break;
    }
    *y += cones->Solve(softness, rest);
  }
  move_to(*y, Parts::kFound);
  for (int step = 0; step < kMostSteps; ++step) {
    const double size = rest.norm();
    if (size <= met) return;
    const Vec6 from = *y, way = cones->Solve(softness, rest);
    const double fall = rest.dot(way), most = merit + 1e-14 * std::abs(merit);
    double part = 1.0;
    move_to(*y = from + way, Parts::kFound);
    for (int i = 0; i < kMostParts; ++i) {
      if (rest.norm() <= kNearer * size || merit <= most - 1e-4 * part * fall) break;
      // Too far: back to where the merit's parabola there has its least.
      const double bend = cones->Bend(way) + softness * way.squaredNorm();
      const double next = part + rest.dot(way) / bend;
      part = std::max(kLeastPart * part, next < part ? next : 0.0);
      move_to(*y = from + part * way, Parts::kFound);
    }
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

// A contact that comes begins inside its cone.
void ContactForceSolver::KeepParts(const std::vector<ContactPoint>& points) {
  Fit(ConeField::kNumGiven, points.size(), &given_);
  Fit(ConeField::kNumFound, points.size(), &found_);
  const auto is_same = [](int id, const ContactPoint& point) { return id == point.id; };
  if (std::equal(ids_.begin(), ids_.end(), points.begin(), points.end(), is_same)) return;
  constexpr uint64_t kNone = 0;
  LaneArray last = found_;
  for (size_t i = 0, k = 0; i < points.size(); ++i) {
    while (k < ids_.size() && ids_[k] < points[i].id) ++k;
    const bool was_there = k < ids_.size() && ids_[k] == points[i].id;
    double* to = Fields(&found_, ConeField::kNumFound, i);
    const double* from = was_there ? Fields(&last, ConeField::kNumFound, k++) : nullptr;
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
                                 std::vector<ContactForce>* forces) {
  forces->assign(points.size(), {});
  if (points.empty()) {
    num_last_ = 0;
    ids_.clear();
    return needed;
  }
  const bool knows_parts = !ids_.empty();
  KeepParts(points);
  Cones cones(kernels_, points, friction, knows_parts, &given_, &found_);
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

  for (size_t i = 0; i < points.size(); ++i) {
    (*forces)[i].force = cones.force(i);
    if (points[i].has_moment) (*forces)[i].moment = points[i].weight * kArm * y.tail<3>();
  }
  const Vec6 rest = b - cones.supplied();
  Wrench left;
  left.force = rest.head<3>();
  left.moment = kArm * Vec3(rest.tail<3>()) + (middle - about).cross(left.force);
  return left;
}

}  // namespace hazumi
