// From inside of all cones: with d = w + friction |w_t| n, l and d have the product
//   l . d = mu,  mu -> 0,   (A + W^-2) dl = -(A l + b + friction |w_t| n) + mu l^-1
// W being the scaling of Nesterov and Todd.

#include <algorithm>
#include <cmath>

#include "engine/matrix/semidefinite.h"
#include "engine/region/contact/cone_solver.h"

namespace hazumi {

using Kind = ConeProblem::Kind;
using Block = ConeProblem::Block;

namespace {

// Steps, what of mu is left in each, and how far each goes towards the nearest cone.
constexpr int kMostInside = 100;
constexpr double kCenter = 0.3, kShy = 0.8;

// Of x and its partner z in the cone x0 >= |x_t|.
double Det(const Eigen::Vector3d& x) {
  return (x[0] - x.tail<2>().norm()) * (x[0] + x.tail<2>().norm());
}

// The farthest that x can go along d inside.
double Room(const Eigen::Vector3d& x, const Eigen::Vector3d& d) {
  const double a = d[0] * d[0] - d.tail<2>().squaredNorm();
  const double b = x[0] * d[0] - x.tail<2>().dot(d.tail<2>()), c = Det(x);
  const double under = b * b - a * c;
  double room = d[0] < 0.0 ? -x[0] / d[0] : HUGE_VAL;
  if (under < 0.0) return room;
  // a s^2 + 2 b s + c = 0
  const double q = -(b + std::copysign(std::sqrt(under), b));
  for (const double s : {q != 0.0 ? c / q : HUGE_VAL, a != 0.0 ? q / a : HUGE_VAL}) {
    if (s > 0.0) room = std::min(room, s);
  }
  return room;
}

// Contacts with friction see (friction l_n, l_t) and (d_n / friction, d_t).
Eigen::Vector3d Scaled(const Eigen::Vector3d& x, double by) { return {x[0] * by, x[1], x[2]}; }

Eigen::Vector2d DirectionOf(const Eigen::Vector2d& x) {
  const double size = x.norm();
  return size > 0.0 ? Eigen::Vector2d(x / size) : Eigen::Vector2d::Zero();
}

bool is_cone(const Block& block) { return block.kind == Kind::kContact && block.friction > 0.0; }

}  // namespace

double ConeSolver::FromInside(double enough) {
  A_ = given_.A;
  b_ = given_.b;
  const Eigen::Index n = b_.size();
  for (Eigen::Index i = 0; i < n; ++i) A_(i, i) += 1e-13 * own_[i] + 1e-300;
  StartInside();
  VecX best = l_;
  double left = Left(given_.A, given_.b);
  for (int i = 0; i < kMostInside; ++i) {
    if (!StepInside()) break;
    const double now = Left(given_.A, given_.b);
    if (now < left) {
      left = now;
      best = l_;
    }
    if (left <= enough) break;
  }
  l_ = best;
  if (left > enough) Finish(enough, &left);
  return left;
}

void ConeSolver::StartInside() {
  const double force = b_.cwiseProduct(step_).lpNorm<Eigen::Infinity>() + 1e-300;
  const double motion = b_.lpNorm<Eigen::Infinity>() + 1e-300;
  l_.setZero();
  z_ = VecX::Zero(l_.size());
  for (const Block& block : blocks_) {
    if (block.kind == Kind::kBoth) continue;
    l_[block.row] = force;
    z_[block.row] = motion;
  }
}

bool ConeSolver::StepInside() {
  const Eigen::Index n = b_.size();
  const VecX w = A_ * l_ + b_;
  double sum = 0.0;
  int count = 0;
  for (const Block& block : blocks_) {
    const int i = block.row;
    if (block.kind == Kind::kBoth) continue;
    sum += l_[i] * z_[i];
    if (is_cone(block)) sum += l_.segment<2>(i + 1).dot(z_.segment<2>(i + 1));
    ++count;
  }
  const double mu = kCenter * sum / std::max(1, count);
  MatX K = A_;
  VecX right = -w, pull = VecX::Zero(n);
  for (const Block& block : blocks_) {
    const int i = block.row;
    if (block.kind == Kind::kBoth) continue;
    if (!is_cone(block)) {
      K(i, i) += z_[i] / l_[i];
      pull[i] = mu / l_[i];
      if (block.kind == Kind::kContact) {  // without friction
        for (int t : {i + 1, i + 2}) {
          K.row(t).setZero();
          K.col(t).setZero();
          K(t, t) = 1.0;
          right[t] = 0.0;
        }
      }
      continue;
    }
    const double f = block.friction;
    const Eigen::Vector3d x = Scaled(l_.segment<3>(i), f), z = Scaled(z_.segment<3>(i), 1.0 / f);
    right[i] -= f * w.segment<2>(i + 1).norm();
    K.row(i) += f * DirectionOf(w.segment<2>(i + 1)).transpose() * A_.middleRows<2>(i + 1);
    const double dx = Det(x), dz = Det(z);
    if (!(dx > 0.0) || !(dz > 0.0)) return false;
    const Eigen::Vector3d xn = x / std::sqrt(dx), zn = z / std::sqrt(dz);
    const double gamma = std::sqrt(0.5 * (1.0 + xn.dot(zn)));
    // J w of the scaling point w
    Eigen::Vector3d v = (Eigen::Vector3d(xn[0], -xn[1], -xn[2]) + zn) / (2.0 * gamma);
    Eigen::Matrix3d inverse = 2.0 * v * v.transpose();
    inverse(0, 0) -= 1.0;
    inverse(1, 1) += 1.0;
    inverse(2, 2) += 1.0;
    inverse *= std::sqrt(dz / dx);
    inverse.row(0) *= f;
    inverse.col(0) *= f;
    K.block<3, 3>(i, i) += inverse;
    const Eigen::Vector3d x_inverse = Eigen::Vector3d(x[0], -x[1], -x[2]) / dx;
    pull.segment<3>(i) = mu * Scaled(x_inverse, f);
  }
  right += pull;
  VecX& change = right;
  Solve(K, change);
  if (!change.allFinite()) return false;
  VecX dz = VecX::Zero(n);
  // dz = pull - z - W^-2 dl, from what is left of the equations
  const VecX moved = A_ * change;
  double room_l = HUGE_VAL, room_z = HUGE_VAL;
  for (const Block& block : blocks_) {
    const int i = block.row;
    if (block.kind == Kind::kBoth) continue;
    if (!is_cone(block)) {
      dz[i] = moved[i] + w[i] - z_[i];
      if (change[i] < 0.0) room_l = std::min(room_l, -l_[i] / change[i]);
      if (dz[i] < 0.0) room_z = std::min(room_z, -z_[i] / dz[i]);
      continue;
    }
    const double f = block.friction;
    dz.segment<3>(i) = moved.segment<3>(i) + w.segment<3>(i) - z_.segment<3>(i);
    const Eigen::Vector2d w_t = w.segment<2>(i + 1);
    dz[i] += f * (w_t.norm() + DirectionOf(w_t).dot(moved.segment<2>(i + 1)));
    room_l = std::min(room_l, Room(Scaled(l_.segment<3>(i), f), Scaled(change.segment<3>(i), f)));
    room_z = std::min(room_z,
                      Room(Scaled(z_.segment<3>(i), 1.0 / f), Scaled(dz.segment<3>(i), 1.0 / f)));
  }
  l_ += std::min(1.0, kShy * room_l) * change;
  z_ += std::min(1.0, kShy * room_z) * dz;
  return true;
}

void ConeSolver::Finish(double enough, double* left) {
  A_ = given_.A;
  b_ = given_.b;
  A_.diagonal() += 1e-9 * own_;
  b_ -= 1e-9 * own_.cwiseProduct(l_);
  VecX best = l_;
  for (int i = 0; i < 6 && *left > enough; ++i) {
    if (!Step()) break;
    const double now = Left(given_.A, given_.b);
    if (now < *left) {
      *left = now;
      best = l_;
    }
  }
  l_ = best;
}

}  // namespace hazumi
