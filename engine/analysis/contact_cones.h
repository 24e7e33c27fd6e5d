#pragma once

// Contact forces of a frame as functions of six multipliers. contact_forces.cpp has the equations.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "engine/analysis/contact_forces.h"

namespace hazumi {

using ContactMultipliers = Eigen::Matrix<double, 6, 1>;

inline constexpr double kMomentArm = 10.0;  // length that moments are divided by [m]

// Selects the formula of each force: of the part of the cone found at y, or of the part found in
// the previous evaluation, extrapolated beyond that part.
enum class ConeParts { kFound, kKept };

inline double* ConeFieldsOf(LaneArray* array, int num_fields, size_t i) {
  return array->data() + i / 4 * 4 * static_cast<size_t>(num_fields) + i % 4;
}

// Enlarges the array to hold the fields of that many contacts. Existing values keep their place.
inline void FitCones(int num_fields, size_t contacts, LaneArray* array) {
  const size_t size = (contacts + 3) / 4 * 4 * static_cast<size_t>(num_fields);
  if (array->size() >= size) return;
  LaneArray larger(size);
  std::copy_n(array->data(), array->size(), larger.data());
  *array = std::move(larger);
}

// Friction cones of the contacts of a frame. Arms are measured from `about`, in units of
// kMomentArm.
class ContactCones {
 public:
  ContactCones(const EffortKernels& kernels, const std::vector<ContactPoint>& points,
               const Vec3& about, double friction, bool knows_parts, LaneArray* given,
               LaneArray* found)
      : kernels_(kernels),
        about_(about),
        num_fours_(static_cast<int>(points.size() + 3) / 4),
        friction_(friction),
        knows_parts_(knows_parts),
        given_(given),
        found_(found) {
    for (const ContactPoint& point : points) weights_ += point.weight;
    for (size_t i = 0; i < points.size(); ++i) Set(i, points[i]);
    ContactPoint nothing;  // fills lanes without a contact
    nothing.p = about_;
    nothing.weight = 0.0;
    nothing.is_grip = true;
    for (size_t i = points.size(); i < 4 * static_cast<size_t>(num_fours_); ++i) Set(i, nothing);
  }

  double weights() const { return weights_; }

  // Evaluates at y the forces, s, the derivative of s, and the function whose gradient is s.
  void Evaluate(const ContactMultipliers& y, ConeParts parts) {
    are_parts_right_ = kernels_.supply(given_->data(), num_fours_, y.data(), friction_,
                                       parts == ConeParts::kKept, found_->data(), sums_);
    knows_parts_ = true;
    supplied_ = Eigen::Map<const ContactMultipliers>(sums_ + ConeField::kSupplied);
  }

  // Returns (derivative + softness 1)^-1 x.
  ContactMultipliers Solve(double softness, ContactMultipliers x) const {
    kernels_.solve(sums_ + ConeField::kSlope, softness, x.data());
    return x;
  }
  // Returns x . derivative x.
  double Bend(const ContactMultipliers& x) const {
    const double* lower = sums_ + ConeField::kSlope;
    double bend = 0.0;
    for (int column = 0; column < 6; ++column) {
      double sum = 0.5 * *lower++ * x[column];
      for (int row = column + 1; row < 6; ++row) sum += *lower++ * x[row];
      bend += 2.0 * sum * x[column];
    }
    return bend;
  }

  // Returns whether Evaluate has been called before.
  bool knows_parts() const { return knows_parts_; }
  // Returns whether each force lies in the part of its cone whose formula was used.
  bool are_parts_right() const { return are_parts_right_; }
  const ContactMultipliers& supplied() const { return supplied_; }
  double potential() const { return sums_[ConeField::kPotential]; }
  Vec3 force(size_t i) const {
    const double* at = ConeFieldsOf(found_, ConeField::kNumFound, i) + 4 * ConeField::kForce;
    return {at[0], at[4], at[8]};
  }

 private:
  void Set(size_t i, const ContactPoint& point) {
    double* at = ConeFieldsOf(given_, ConeField::kNumGiven, i);
    const Vec3 arm = (point.p - about_) * (1.0 / kMomentArm);
    for (int k = 0; k < 3; ++k) {
      at[4 * (ConeField::kArm + k)] = arm[k];
      at[4 * (ConeField::kNormal + k)] = point.normal[k];
    }
    at[4 * ConeField::kWeight] = point.weight;
    at[4 * ConeField::kGripBits] =
        std::bit_cast<double>(point.is_grip ? ~uint64_t{0} : uint64_t{0});
  }

  const EffortKernels& kernels_;
  Vec3 about_;  // [m]
  int num_fours_;
  double friction_;
  bool knows_parts_;
  LaneArray *given_, *found_;
  double weights_ = 0.0;
  bool are_parts_right_ = false;
  ContactMultipliers supplied_;
  alignas(32) double sums_[ConeField::kNumSums];
};

}  // namespace hazumi
