// With M x = -b + P^T l for hinges, rows w = J x + c + G l, and a row -side for each hinge at a
// limit, all of them are
//   w = A l + (J x_0 + c),   A = J M^-1 P^T + G,   M x_0 = -b
// for accelerations; the same for rates, with x their jump and c the velocities before.
// Contacts whose point a pin holds (J M^-1 J^T + G = 0 for the normal) neither push nor rub, since
// forces of any size would do. [METHOD 12.3]

#include "engine/region/exact/contact_problem.h"

#include <utility>

#include "engine/matrix/semidefinite.h"
#include "engine/spatial/checks.h"

namespace hazumi {

using Kind = ConeProblem::Kind;

namespace {

// Share of the largest response of all rows, below which a response is rounding.
constexpr double kNoAnswer = 1e-20;

}  // namespace

void ContactProblem::Factor(const MatX& M) {
  HAZUMI_ASSERT(IsSymmetric(M));
  L_ = M;
  FactorSemidefinite(L_);
}

LimitRows ContactProblem::Unheld(const HingeEquations& equations, const VecX& b, VecX* x_0) const {
  *x_0 = -b;
  SolveSemidefinite(L_, *x_0);
  LimitRows rows;
  rows.J.resize(0, x_0->size());
  if (const LimitRows* known = equations.for_forces()) rows = *known;
  if (rows.c.size() > 0) rows.c += rows.J * *x_0;
  return rows;
}

VecX ContactProblem::Answer() const {
  HAZUMI_ASSERT(half_answer_.cols() == forces_.size());
  VecX x = half_answer_ * forces_;
  SolveUpper(L_, x);
  return x;
}

double ContactProblem::WorkOfLimits(const std::vector<int>& side, const VecX& before,
                                    const VecX& after) const {
  double work = 0.0;
  for (size_t k = 0; k < limits_.size(); ++k) {
    const int hinge = limits_[k];
    work -= side[hinge] * forces_[RowOfLimit(k)] * 0.5 * (before[hinge] + after[hinge]);
  }
  return work;
}

bool ContactProblem::Solve() {
  double products = 0.0;
  const bool is_solved = SolveCones(cones_, &forces_, &products);
  AddWork(products);
  return is_solved;
}

void ContactProblem::SolveBeside(const VecX& known) {
  const VecX b = cones_.b;
  cones_.b += cones_.A * known;
  Solve();
  forces_ += known;
  cones_.b = b;
}

// A few sweeps mostly find out what pushes and what slides.
void ContactProblem::Sweep(VecX start, bool is_worth_it) {
  constexpr int kFew = 12, kMost = 60;
  constexpr double kNear = 1e-3;
  forces_ = std::move(start);
  double products = 0.0;
  const auto solve = [&] {
    if (SweepCones(cones_, kFew, &forces_, &products) == 0.0) return;
    if (SolveConesNear(cones_, &forces_, &products)) return;
    if (SweepCones(cones_, kMost, &forces_, &products) <= kNear || !is_worth_it) return;
    if (SolveConesNear(cones_, &forces_, &products)) return;
    SolveConesInside(cones_, &forces_, &products);
  };
  solve();
  AddWork(products);
}

void ContactProblem::SetUp(const std::vector<int>& side, const std::vector<char>& sticks,
                           const LimitRows& rows, const VecX& x_0) {
  HAZUMI_ASSERT(side.size() == static_cast<size_t>(x_0.size()) && sticks.size() == side.size());
  HAZUMI_ASSERT(rows.J.cols() == x_0.size() && rows.J.rows() == rows.c.size());
  limits_.clear();
  for (int i = 0; i < static_cast<int>(side.size()); ++i) {
    if (side[i] != 0) limits_.push_back(i);
  }
  const Eigen::Index n = x_0.size(), own = rows.c.size();
  const Eigen::Index count = own + static_cast<Eigen::Index>(limits_.size());
  MatX J = MatX::Zero(n, count);
  J.leftCols(own) = rows.J.transpose();
  cones_.b.resize(count);
  cones_.b.head(own) = rows.c;
  for (Eigen::Index k = own; k < count; ++k) {
    const int hinge = limits_[k - own];
    J(hinge, k) = -side[hinge];
    cones_.b[k] = -side[hinge] * x_0[hinge];
  }
  half_answer_ = J;
  if (rows.P.size() > 0) half_answer_.leftCols(own) = rows.P.transpose();
  SolveLower(L_, half_answer_);
  if (rows.P.size() > 0) {
    SolveLower(L_, J);
    cones_.A = ProductOf(J, half_answer_);
  } else {
    cones_.A = ProductOf(half_answer_, half_answer_);
  }
  VecX answers = (rows.P.size() > 0 ? J : half_answer_).colwise().squaredNorm();
  answers.head(own) += rows.G.diagonal().cwiseAbs();
  const double least_answer = kNoAnswer * (count > 0 ? answers.maxCoeff() : 0.0);
  cones_.A.topLeftCorner(own, own) += rows.G;
  cones_.blocks.clear();
  const std::vector<ConstraintRow>& all = dynamics_->rows().rows();
  const ContactSet& contacts = dynamics_->mode().contacts;
  for (int k = 0; k < static_cast<int>(own); ++k) {
    if (!all[k].is_contact()) {
      cones_.blocks.push_back({Kind::kBoth, k});
      continue;
    }
    const bool sticks_there = contacts.pairs()[all[k].contact].mode == ContactMode::kStick;
    const bool is_pinned = contacts.rules().no_friction_at_pins && answers[k] <= least_answer;
    const double friction = is_pinned ? 0.0 : contacts.FrictionOf(all[k].contact);
    if (is_pinned) cones_.b[k] = 0.0;
    cones_.blocks.push_back({sticks_there ? Kind::kContact : Kind::kPush, k, friction});
    if (sticks_there) k += 2;
  }
  for (Eigen::Index k = own; k < count; ++k) {
    const bool both = sticks[limits_[k - own]];
    cones_.blocks.push_back({both ? Kind::kBoth : Kind::kPush, static_cast<int>(k)});
  }
  AddWork(static_cast<double>(count * count) * static_cast<double>(n + count));
}

}  // namespace hazumi
