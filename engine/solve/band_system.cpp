#include "engine/solve/band_system.h"

#include <algorithm>
#include <cmath>

#include "engine/base/assert.h"

namespace hazumi::solve {

BandSystem::BandSystem(int size, int width)
    : size_(size),
      width_(width),
      rows_(static_cast<size_t>(size) * static_cast<size_t>(width)),
      gradient_(VecX::Zero(size)) {}

void BandSystem::Clear() {
  std::fill(rows_.begin(), rows_.end(), 0.0);
  gradient_.setZero();
}

double& BandSystem::Entry(std::vector<double>* rows, int i, int k) const {
  return (*rows)[static_cast<size_t>(i) * static_cast<size_t>(width_) +
                 static_cast<size_t>(k - i + width_ - 1)];
}

void BandSystem::Add(int first, const Eigen::Ref<const MatX>& J, const Eigen::Ref<const VecX>& r) {
  const int n = static_cast<int>(J.cols());
  HAZUMI_DEMAND(n <= width_ && first >= 0 && first + n <= size_);
  gradient_.segment(first, n).noalias() += J.transpose() * r;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k <= i; ++k) Entry(&rows_, first + i, first + k) += J.col(i).dot(J.col(k));
  }
}

void BandSystem::Add(const std::vector<int>& unknowns, const VecX& J, double r) {
  HAZUMI_DEMAND(unknowns.empty() || unknowns.back() - unknowns.front() < width_);
  for (size_t i = 0; i < unknowns.size(); ++i) {
    const double value = J[static_cast<int>(i)];
    gradient_[unknowns[i]] += value * r;
    for (size_t k = 0; k <= i; ++k) {
      Entry(&rows_, unknowns[i], unknowns[k]) += value * J[static_cast<int>(k)];
    }
  }
}

// Cholesky, row by row.
bool BandSystem::Solve(double damping, VecX* x) {
  factor_ = rows_;
  *x = -gradient_;
  const auto row = [&](int i, int k, int count) {
    return Eigen::Map<const VecX>(&Entry(&factor_, i, k), count);
  };
  for (int i = 0; i < size_; ++i) {
    double& pivot = Entry(&factor_, i, i);
    const int left = std::max(0, i - width_ + 1);
    if (pivot == 0.0) {
      pivot = 1.0;
      (*x)[i] = 0.0;
      continue;
    }
    pivot += damping * pivot;
    for (int k = left; k < i; ++k) {
      const int from = std::max(left, k - width_ + 1);
      double& entry = Entry(&factor_, i, k);
      entry = (entry - row(i, from, k - from).dot(row(k, from, k - from))) / Entry(&factor_, k, k);
    }
    const double rest = pivot - row(i, left, i - left).squaredNorm();
    if (!(rest > 1e-14 * pivot)) return false;
    pivot = std::sqrt(rest);
  }
  for (int i = 0; i < size_; ++i) {
    const int left = std::max(0, i - width_ + 1);
    (*x)[i] =
        ((*x)[i] - row(i, left, i - left).dot(x->segment(left, i - left))) / Entry(&factor_, i, i);
  }
  for (int i = size_; i-- > 0;) {
    const int left = std::max(0, i - width_ + 1);
    (*x)[i] /= Entry(&factor_, i, i);
    x->segment(left, i - left) -= (*x)[i] * row(i, left, i - left);
  }
  return true;
}

}  // namespace hazumi::solve
