// Coulomb's law as equations that hold where nothing is left over [Alart, Curnier 1991]:
//   push      l = max(0, l - r w)
//   contact   n as a push;  l_t = projection of l_t - r w_t on the disk with radius friction l_n
// Sweeps from block to block come near a solution from everywhere, Newton's steps reach it. Rows
// that say the same twice, of which a body that touches with many points has many, leave forces
// open: each round stays near the forces f of the one before,
//   A + rho D  instead of A,  b - rho D f  instead of b,   D = diagonal of A,
// with rho smaller from round to round.

#include "engine/region/contact/cone_solver.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/matrix/semidefinite.h"
#include "engine/spatial/checks.h"

namespace hazumi {

using Kind = ConeProblem::Kind;
using Block = ConeProblem::Block;

namespace {

constexpr double kFirstNearness = 1e-2, kLastNearness = 1e-8;  // rho
constexpr int kFirstSweeps = 40, kSweeps = 4, kSteps = 12, kRounds = 8;
constexpr int kMostNear = 4;  // steps
// What may be left, as a part of the largest force: nothing; no way from inside is worth it.
constexpr double kExact = 1e-12, kGood = 1e-10;

Eigen::Vector2d OnDisk(const Eigen::Vector2d& x, double radius) {
  const double size = x.norm();
  return size > radius ? Eigen::Vector2d(x * (radius / size)) : x;
}

}  // namespace

ConeSolver::ConeSolver(const ConeProblem& problem)
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

bool ConeSolver::Run() {
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
  StayInCones();
  return left <= kGoodEnough && !hopeless_;
}

bool ConeSolver::RunNear(const VecX& start) {
  l_ = start;
  A_.diagonal() += kLastNearness * own_;
  b_ -= kLastNearness * own_.cwiseProduct(l_);
  double left = Left(given_.A, given_.b);
  for (int i = 0; i < kMostNear && left > kGoodEnough; ++i) {
    const double before = left;
    if (!Step()) return false;
    StayInCones();
    left = Left(given_.A, given_.b);
    if (left > before) return false;
  }
  return left <= kGoodEnough && !hopeless_ && TakesEnergy();
}

// Whether work done by velocities that the forces change, l (A l / 2 + b), is negative for certain,
// or next to nothing of what rows by themselves might take: where things are wedged, forces of
// which next to nothing is left may still give energy.
bool ConeSolver::TakesEnergy() const {
  constexpr double kMost = 0.01, kNone = 1e-12;
  const VecX answer = given_.A * l_;
  const double none = kNone * given_.b.dot(step_.cwiseProduct(given_.b));
  return l_.dot(answer + given_.b) <= kMost * l_.dot(answer) + none;
}

// To forces of the round.
void ConeSolver::Approach(int sweeps) {
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
double ConeSolver::Left(const MatX& A, const VecX& b) const {
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
  if (!std::isfinite(left)) return HUGE_VAL;
  const double slightest = 1e-12 * step_.cwiseProduct(b_).lpNorm<Eigen::Infinity>() + 1e-300;
  return left / std::max(l_.lpNorm<Eigen::Infinity>(), slightest);
}

void ConeSolver::StayInCones() {
  for (const Block& block : blocks_) {
    const int i = block.row;
    if (block.kind == Kind::kBoth) continue;
    l_[i] = std::max(0.0, l_[i]);
    if (block.kind != Kind::kContact) continue;
    l_.segment<2>(i + 1) = OnDisk(l_.segment<2>(i + 1), block.friction * l_[i]);
  }
}

void ConeSolver::Solve(MatX& K, VecX& right) {
  const double n = static_cast<double>(right.size());
  products_ += n * n * n / 3.0;
  SolveGeneral(K, right);
}

void ConeSolver::Sweep() {
  products_ += static_cast<double>(A_.size());
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

// F change = f, of which rows that give a force alone are known. Of the others, `active`, those
// that slide mix the two across: `turn` of them.
bool ConeSolver::Step() {
  struct Slide {
    Eigen::Index at;  // of its push in active
    Eigen::Matrix2d turn;
    Eigen::Vector2d lean;
  };
  const VecX w = A_ * l_ + b_;
  VecX f(b_.size()), known = VecX::Zero(b_.size());
  std::vector<int> active;
  std::vector<Slide> slides;
  const auto takes_force = [&](int i) { known[i] = f[i] = l_[i]; };
  const auto takes_motion = [&](int i) {
    if (step_[i] == 0.0) return takes_force(i);
    f[i] = step_[i] * w[i];
    active.push_back(i);
  };
  for (const Block& block : blocks_) {
    const int i = block.row;
    const bool pushes = block.kind == Kind::kBoth || l_[i] - step_[i] * w[i] > 0.0;
    pushes ? takes_motion(i) : takes_force(i);
    if (block.kind != Kind::kContact) continue;
    if (block.friction == 0.0) {
      known.segment<2>(i + 1) = f.segment<2>(i + 1) = l_.segment<2>(i + 1);
      continue;
    }
    const Eigen::Vector2d z = l_.segment<2>(i + 1) - step_[i + 1] * w.segment<2>(i + 1);
    const double size = z.norm(), radius = block.friction * l_[i];
    if (!pushes || step_[i] == 0.0 || radius <= 0.0 || size <= radius) {
      for (int t : {i + 1, i + 2}) pushes ? takes_motion(t) : takes_force(t);
      continue;
    }
    const Eigen::Vector2d d = z / size;
    const Eigen::Matrix2d turn = radius / size * (Eigen::Matrix2d::Identity() - d * d.transpose());
    slides.push_back({static_cast<Eigen::Index>(active.size()) - 1, turn, block.friction * d});
    f.segment<2>(i + 1) = l_.segment<2>(i + 1) - radius * d;
    active.insert(active.end(), {i + 1, i + 2});
  }
  MatX own = A_(active, active);
  const VecX step = step_(active);
  VecX by_known = (A_ * known)(active);
  own.array().colwise() *= step.array();
  by_known.array() *= step.array();
  for (const Slide& slide : slides) {
    const Eigen::Index t = slide.at + 1;
    own.middleRows<2>(t) = (slide.turn * own.middleRows<2>(t)).eval();
    own.block<2, 2>(t, t) += Eigen::Matrix2d::Identity() - slide.turn;
    own.block<2, 1>(t, slide.at) -= slide.lean;
    by_known.segment<2>(t) = (slide.turn * by_known.segment<2>(t)).eval();
  }
  VecX right = f(active) - by_known;
  Solve(own, right);
  if (!right.allFinite()) return false;
  l_ -= known;
  l_(active) -= right;
  return true;
}

bool SolveCones(const ConeProblem& problem, VecX* forces, double* products) {
  HAZUMI_ASSERT(problem.A.rows() == problem.b.size() && problem.A.cols() == problem.b.size());
  ConeSolver solver(problem);
  const bool is_solved = solver.Run();
  if (products) *products += solver.products();
  *forces = solver.forces();
  return is_solved;
}

bool SolveConesInside(const ConeProblem& problem, VecX* forces, double* products) {
  ConeSolver solver(problem);
  const bool is_solved = solver.RunInside();
  if (products) *products += solver.products();
  if (!is_solved) return false;
  *forces = solver.forces();
  return true;
}

bool SolveConesNear(const ConeProblem& problem, VecX* forces, double* products) {
  HAZUMI_ASSERT(forces->size() == problem.b.size());
  ConeSolver solver(problem);
  const bool is_solved = solver.RunNear(*forces);
  if (products) *products += solver.products();
  if (!is_solved) return false;
  *forces = solver.forces();
  return true;
}

}  // namespace hazumi
