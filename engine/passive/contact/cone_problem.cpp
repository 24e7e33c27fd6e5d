// Coulomb's law as equations that hold where nothing is left over [Alart, Curnier 1991]:
//   push      l = max(0, l - r w)
//   contact   n as a push;  l_t = projection of l_t - r w_t on the disk with radius friction l_n
// Sweeps from block to block come near a solution from everywhere, Newton's steps reach it. Rows
// that say the same twice, of which a body that touches with many points has many, leave forces
// open: each round stays near the forces f of the one before,
//   A + rho D  instead of A,  b - rho D f  instead of b,   D = diagonal of A,
// with rho smaller from round to round.

#include "engine/passive/contact/cone_problem.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/passive/semidefinite.h"

namespace hazumi {

namespace {

using Kind = ConeProblem::Kind;
using Block = ConeProblem::Block;

constexpr double kFirstNearness = 1e-2, kLastNearness = 1e-8;  // rho
constexpr int kFirstSweeps = 40, kSweeps = 4, kSteps = 12, kRounds = 8;
// From inside: steps, what of mu is left in each, and how far each goes towards the nearest cone.
constexpr int kMostInside = 100;
constexpr double kCenter = 0.3, kShy = 0.8;
// What may be left, as a part of the largest force: nothing; no way from inside is worth it; it is
// a solution.
constexpr double kExact = 1e-12, kGood = 1e-10, kGoodEnough = 1e-6;

class Solver {
 public:
  explicit Solver(const ConeProblem& problem)
      : given_(problem), A_(problem.A), b_(problem.b), blocks_(problem.blocks) {
    const Eigen::Index n = b_.size();
    own_ = A_.diagonal();
    hopeless_ = n > 0 && own_.minCoeff() < 0.0;
    const double largest = n > 0 ? own_.maxCoeff() : 0.0;
    own_ = own_.cwiseMax(1e-9 * largest);
    step_ = own_.unaryExpr([](double own) { return own > 0.0 ? 1.0 / own : 0.0; });
    for (const Block& block : blocks_) {
      if (block.kind != Kind::kContact) continue;
      const double sum = own_[block.row + 1] + own_[block.row + 2];
      step_[block.row + 1] = step_[block.row + 2] = sum > 0.0 ? 1.0 / sum : 0.0;
    }
    l_ = VecX::Zero(n);
  }

  bool Run() {
    if (b_.size() == 0) return true;
    double nearness = kFirstNearness, left = HUGE_VAL;
    VecX best = l_;
    for (int round = 0; round < kRounds && left > kExact; ++round) {
      A_ = given_.A;
      A_.diagonal() += nearness * own_;
      b_ = given_.b - nearness * own_.cwiseProduct(l_);
      Approach(round == 0 ? kFirstSweeps : kSweeps);
      const double now = Left(given_.A, given_.b);
      if (now < left) {
        left = now;
        best = l_;
      }
      nearness = std::max(kLastNearness, 0.1 * nearness);
    }
    if (left > kGood) {
      const double inside = FromInside(kExact);
      if (inside < left) {
        left = inside;
        best = l_;
      }
    }
    l_ = best;
    for (const Block& block : blocks_) {
      if (block.kind != Kind::kBoth) l_[block.row] = std::max(0.0, l_[block.row]);
    }
    return left <= kGoodEnough && !hopeless_;
  }

  bool RunInside() { return !hopeless_ && FromInside(kGoodEnough) <= kGoodEnough; }

  const VecX& forces() const { return l_; }

 private:
  // From inside of all cones: with d = w + friction |w_t| n, l and d have the product
  //   l . d = mu,  mu -> 0,   (A + W^-2) dl = -(A l + b + friction |w_t| n) + mu l^-1
  // W being the scaling of Nesterov and Todd. Returns what is left.
  double FromInside(double enough) {
    A_ = given_.A;
    b_ = given_.b;
    const Eigen::Index n = b_.size();
    for (Eigen::Index i = 0; i < n; ++i) A_(i, i) += 1e-13 * own_[i] + 1e-300;
    Start();
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

  void Start() {
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

  // Of x and its partner z in the cone x0 >= |x_t|.
  static double Det(const Eigen::Vector3d& x) {
    return (x[0] - x.tail<2>().norm()) * (x[0] + x.tail<2>().norm());
  }

  // The farthest that x can go along d inside.
  static double Room(const Eigen::Vector3d& x, const Eigen::Vector3d& d) {
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
  static Eigen::Vector3d Scaled(const Eigen::Vector3d& x, double by) {
    return {x[0] * by, x[1], x[2]};
  }

  bool StepInside() {
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
    SolveGeneral(K, change);
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

  static Eigen::Vector2d DirectionOf(const Eigen::Vector2d& x) {
    const double size = x.norm();
    return size > 0.0 ? Eigen::Vector2d(x / size) : Eigen::Vector2d::Zero();
  }

  static bool is_cone(const Block& block) {
    return block.kind == Kind::kContact && block.friction > 0.0;
  }

  void Finish(double enough, double* left) {
    A_ = given_.A;
    b_ = given_.b;
    A_.diagonal() += 1e-9 * own_;
    b_ -= 1e-9 * own_.cwiseProduct(l_);
    const VecX inside = l_;
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

  // To forces of the round.
  void Approach(int sweeps) {
    for (int i = 0; i < sweeps; ++i) Sweep();
    double left = Left(A_, b_);
    const VecX swept = l_;
    const double left_swept = left;
    for (int i = 0; i < kSteps && left > 0.1 * kExact; ++i) {
      if (!Step()) break;
      left = Left(A_, b_);
    }
    if (!(left < left_swept)) l_ = swept;
  }

  // How far forces are from fulfilling everything, in parts of the largest.
  double Left(const MatX& A, const VecX& b) const {
    const VecX w = A * l_ + b;
    double left = 0.0;
    for (const Block& block : blocks_) {
      const int i = block.row;
      if (block.kind == Kind::kBoth) {
        left = std::max(left, std::abs(step_[i] * w[i]));
        continue;
      }
      left = std::max(left, std::abs(l_[i] - std::max(0.0, l_[i] - step_[i] * w[i])));
      if (block.kind == Kind::kContact) {
        const Eigen::Vector2d t = l_.segment<2>(i + 1);
        left = std::max(left, (t - OnDisk(t - step_[i + 1] * w.segment<2>(i + 1),
                                          block.friction * std::max(0.0, l_[i])))
                                  .norm());
      }
    }
    const double largest = l_.lpNorm<Eigen::Infinity>();
    return std::isfinite(left) ? left / std::max(largest, Slightest()) : HUGE_VAL;
  }

  double Slightest() const {
    return 1e-12 * (step_.cwiseProduct(b_)).lpNorm<Eigen::Infinity>() + 1e-300;
  }

  static Eigen::Vector2d OnDisk(const Eigen::Vector2d& x, double radius) {
    const double size = x.norm();
    return size > radius ? Eigen::Vector2d(x * (radius / size)) : x;
  }

  void Sweep() {
    for (const Block& block : blocks_) {
      const int i = block.row;
      const double w = A_.row(i).dot(l_) + b_[i];
      l_[i] -= step_[i] * w;
      if (block.kind != Kind::kBoth) l_[i] = std::max(0.0, l_[i]);
      if (block.kind != Kind::kContact) continue;
      const Eigen::Vector2d w_t = A_.middleRows<2>(i + 1) * l_ + b_.segment<2>(i + 1);
      l_.segment<2>(i + 1) =
          OnDisk(l_.segment<2>(i + 1) - step_[i + 1] * w_t, block.friction * l_[i]);
    }
  }

  bool Step() {
    const Eigen::Index n = b_.size();
    const VecX w = A_ * l_ + b_;
    MatX F = MatX::Zero(n, n);
    VecX f(n);
    std::vector<int> active, idle;
    const auto takes_force = [&](int i) {
      f[i] = l_[i];
      idle.push_back(i);
    };
    const auto takes_motion = [&](int i) {
      if (step_[i] == 0.0) return takes_force(i);
      F.row(i) = step_[i] * A_.row(i);
      f[i] = step_[i] * w[i];
      active.push_back(i);
    };
    for (const Block& block : blocks_) {
      const int i = block.row;
      const bool pushes = block.kind == Kind::kBoth || l_[i] - step_[i] * w[i] > 0.0;
      pushes ? takes_motion(i) : takes_force(i);
      if (block.kind != Kind::kContact) continue;
      const Eigen::Vector2d z = l_.segment<2>(i + 1) - step_[i + 1] * w.segment<2>(i + 1);
      const double size = z.norm(), radius = block.friction * l_[i];
      if (!pushes || radius <= 0.0 || size <= radius) {
        for (int t : {i + 1, i + 2}) pushes ? takes_motion(t) : takes_force(t);
        continue;
      }
      const Eigen::Vector2d d = z / size;
      const Eigen::Matrix2d turn =
          radius / size * (Eigen::Matrix2d::Identity() - d * d.transpose());
      F.middleRows<2>(i + 1) = step_[i + 1] * turn * A_.middleRows<2>(i + 1);
      F.block<2, 2>(i + 1, i + 1) += Eigen::Matrix2d::Identity() - turn;
      F.block<2, 1>(i + 1, i) -= block.friction * d;
      f.segment<2>(i + 1) = l_.segment<2>(i + 1) - radius * d;
      active.insert(active.end(), {i + 1, i + 2});
    }
    VecX change = f;
    VecX right = f(active) - F(active, idle) * f(idle);
    MatX own = F(active, active);
    SolveGeneral(own, right);
    change(active) = right;
    if (!change.allFinite()) return false;
    l_ -= change;
    return true;
  }

  const ConeProblem& given_;
  MatX A_;  // of the round
  VecX b_;
  const std::vector<Block>& blocks_;
  VecX l_, step_, own_;
  VecX z_;  // d
  bool hopeless_ = false;
};

}  // namespace

bool SolveCones(const ConeProblem& problem, VecX* forces) {
  Solver solver(problem);
  const bool is_solved = solver.Run();
  *forces = solver.forces();
  return is_solved;
}

bool SolveConesInside(const ConeProblem& problem, VecX* forces) {
  Solver solver(problem);
  if (!solver.RunInside()) return false;
  *forces = solver.forces();
  return true;
}

}  // namespace hazumi
