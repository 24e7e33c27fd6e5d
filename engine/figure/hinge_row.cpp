#include "engine/figure/hinge_row.h"

// Three hinges at right angles turn to any R: in the basis of their axes their angles are Euler's.
// Other rows are turned hinge by hinge, each time by the angle that leaves least between A, what
// comes before, Rot(a, t) and B, what comes behind: with the quaternion (w, v) of A^T R B^T that is
// t = 2 atan2(v . a, w). Each step brings the row nearer; two hinges at right angles take one round
// where the row can turn to R. It ends where a round does not help any more.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/base/assert.h"
#include "engine/spatial/degrees.h"
#include "engine/spatial/euler_angles.h"

namespace hazumi {

namespace {

constexpr double kExact = 1e-9;  // [rad]

Mat3 About(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

double Between(const Mat3& A, const Mat3& B) {
  const Vec3 v = Eigen::Quaterniond(Mat3(A.transpose() * B)).vec();
  return 2.0 * std::asin(std::min(1.0, v.norm()));
}

bool IsFree(const HingeRow& row) {
  return std::none_of(row.begin(), row.end(), [](const RowHinge& h) { return h.is_fixed; });
}

// Its axes as columns.
Mat3 BasisOf(const HingeRow& row) {
  Mat3 basis;
  for (int i = 0; i < 3; ++i) basis.col(i) = row[static_cast<size_t>(i)].axis;
  return basis;
}

// A row of three at right angles. In a left-handed basis the last one turns the other way.
void TurnAsEuler(const Mat3& R, Mat3 basis, std::vector<double>* angles) {
  const double hand = basis.determinant() > 0.0 ? 1.0 : -1.0;
  basis.col(2) *= hand;
  const Vec3 before((*angles)[0], (*angles)[1], hand * (*angles)[2]);
  const Vec3 found = EulerAnglesNear(basis.transpose() * R * basis, {0, 1, 2}, before);
  *angles = {found[0], found[1], hand * found[2]};
}

void TurnOne(const Mat3& R, const HingeRow& row, size_t i, std::vector<double>* angles) {
  Mat3 before = Mat3::Identity(), behind = Mat3::Identity();
  for (size_t k = 0; k < row.size(); ++k) {
    if (k == i) continue;
    Mat3& side = k < i ? before : behind;
    side = side * About(row[k].axis, (*angles)[k]);
  }
  const Eigen::Quaterniond left(Mat3(before.transpose() * R * behind.transpose()));
  const double along = left.vec().dot(row[i].axis);
  if (std::hypot(along, left.w()) < 1e-12) return;  // any angle is as good
  const double angle = 2.0 * std::atan2(along, left.w());
  (*angles)[i] = NearestTurn(angle, (*angles)[i]);
}

// Where a second try begins, if the first one ends too soon.
std::vector<double> Unturned(const HingeRow& row, std::vector<double> angles) {
  for (size_t i = 0; i < row.size(); ++i) {
    if (!row[i].is_fixed) angles[i] = 0.0;
  }
  return angles;
}

void TurnInRounds(const Mat3& R, const HingeRow& row, std::vector<double>* angles) {
  constexpr int kMostRounds = 500;
  constexpr double kStill = 1e-13;  // [rad]
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<double> before = *angles;
    for (size_t i = 0; i < row.size(); ++i) {
      if (!row[i].is_fixed) TurnOne(R, row, i, angles);
    }
    double change = 0.0;
    for (size_t i = 0; i < row.size(); ++i) {
      change = std::max(change, std::abs((*angles)[i] - before[i]));
    }
    if (change <= kStill) return;
  }
}

}  // namespace

Mat3 RotationOf(const HingeRow& row, const std::vector<double>& angles) {
  HAZUMI_DEMAND(row.size() == angles.size());
  Mat3 R = Mat3::Identity();
  for (size_t i = 0; i < row.size(); ++i) R = R * About(row[i].axis, angles[i]);
  return R;
}

double TurnTo(const Mat3& R, const HingeRow& row, std::vector<double>* angles) {
  HAZUMI_DEMAND(row.size() == angles->size());
  if (row.size() == 3 && IsFree(row)) {
    const Mat3 basis = BasisOf(row);
    if ((basis.transpose() * basis).isIdentity(1e-9)) TurnAsEuler(R, basis, angles);
  }
  std::vector<double> other = Unturned(row, *angles);
  TurnInRounds(R, row, angles);
  const double left = Between(RotationOf(row, *angles), R);
  if (left <= kExact) return left;
  TurnInRounds(R, row, &other);
  const double left_of_other = Between(RotationOf(row, other), R);
  if (left_of_other >= left - kExact) return left;
  *angles = std::move(other);
  return left_of_other;
}

}  // namespace hazumi
