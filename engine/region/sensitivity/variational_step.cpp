// With turns d and changes of velocities e of the dofs, and the accelerations a(q, v, t):
//   d' = e - w x d (ball joints, in the body's frame), d' = e (hinges),    e' = D_q a d + D_v a e.
// D_q a and D_v a are central differences, with steps of 2e-5 rad and 1e-4 rad/s: their error is
// h^2 / 6 of the third derivative and rounding / h, together some 1e-10 of a. a is quadratic in v
// but for forces from outside and muscles, so that its differences have no error but rounding. They
// are fitted over the step by Legendre polynomials up to P_5 through the six Gauss points. What a
// fit leaves out is orthogonal to polynomials of degree 5, so that its effect at the end is of
// second order; where the last coefficients are not small the interval is halved.

#include "engine/region/sensitivity/variational_step.h"

#include <algorithm>
#include <cmath>

#include "engine/base/root.h"

namespace hazumi {

namespace {

constexpr double kTurnOfDifference = 2e-5;  // [rad]
constexpr double kRateOfDifference = 1e-4;  // [rad/s]
constexpr int kMostFitHalvings = 12;
// Largest contribution of the last coefficient to the equations, over the interval.
constexpr double kMostLastCoefficient = 1e-4;
constexpr double kShortestFit = 1e-13;  // [s]

constexpr double kSixPlaces[] = {-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                                 0.2386191860831969,  0.6612093864662645,  0.9324695142031521};
constexpr double kSixWeights[] = {0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                                  0.4679139345726910, 0.3607615730481386, 0.1713244923791704};

// Values of P_0 to P_5 at s in [-1, 1].
std::array<double, 6> LegendreAt(double s) {
  std::array<double, 6> p = {1.0, s};
  for (size_t k = 1; k + 1 < p.size(); ++k) {
    const auto of_degree = static_cast<double>(k);
    p[k + 1] = ((2.0 * of_degree + 1.0) * s * p[k] - of_degree * p[k - 1]) / (of_degree + 1.0);
  }
  return p;
}

}  // namespace

VariationalStep::VariationalStep(RegionDynamics* dynamics, double tolerance)
    : dynamics_(dynamics), tolerance_(tolerance), sample_(dynamics->NewState()) {}

bool VariationalStep::Advance(double a, double b, ExactSolver* solver, MatX* X) {
  HAZUMI_ASSERT(a <= b && X->rows() == 2 * dynamics_->layout().num_dofs());
  if (X->size() == 0) return true;
  constexpr int kMostKinks = 64;
  for (int kinks = 0; dynamics_->has_kinks() && kinks < kMostKinks; ++kinks) {
    const std::optional<double> kink = FirstKink(a, b, solver);
    if (!kink) break;
    if (!AdvanceInParts(a, *kink, 0, solver, X)) return false;
    a = *kink;
  }
  return AdvanceInParts(a, b, 0, solver, X);
}

// Finds the first kink of the forces. The solver ends a step at a kink, as exactly as a step that
// went over it tells; the rest lies on the wrong side. Steps also miss a kink that is passed and
// passed back: it shows where looks, and the parabolas through three of them, change sign.
std::optional<double> VariationalStep::FirstKink(double a, double b, ExactSolver* solver) {
  constexpr int kLooks = 8;
  const auto place = [&](int look) { return look == kLooks ? b : a + (b - a) * look / kLooks; };
  for (std::vector<double>& kinks : looks_) kinks.clear();
  FindKinksAt(a, solver, &looks_[0]);
  for (int look = 1; look <= kLooks; ++look) {
    const auto at = static_cast<size_t>(look);
    FindKinksAt(place(look), solver, &looks_[at]);
    std::optional<double> first;
    for (size_t i = 0; i < looks_[at].size(); ++i) {
      const double before = looks_[at - 1][i], now = looks_[at][i];
      std::optional<double> kink;
      if (before * now < 0.0) {
        kink = KinkBetween(i, place(look - 1), before, place(look), now, solver);
      } else if (look > 1 && before * looks_[at - 2][i] > 0.0) {
        const double earlier = looks_[at - 2][i];
        const double bend = earlier - 2.0 * before + now, slope = 0.5 * (now - earlier);
        const double turn = -slope / bend;  // in looks, from the one before
        if (!(bend * before > 0.0 && std::abs(turn) < 1.0)) continue;
        const double t = place(look - 1) + turn * (b - a) / kLooks;
        FindKinksAt(t, solver, &kinks_);
        if (kinks_[i] * before < 0.0) {
          kink = KinkBetween(i, place(look - 2), earlier, t, kinks_[i], solver);
        }
      }
      if (kink && *kink > a + kSameTime && *kink < b && (!first || *kink < *first)) first = kink;
    }
    if (first) return first;
  }
  return std::nullopt;
}

// The first time at which a number that changes sign has its second one.
double VariationalStep::KinkBetween(size_t kink, double a, double at_a, double b, double at_b,
                                    ExactSolver* solver) {
  const double side = std::copysign(1.0, at_b);
  return Narrow({a, side * at_a, b, side * at_b}, kSameTime,
                [&](double t) {
                  FindKinksAt(t, solver, &kinks_);
                  return side * kinks_[kink];
                })
      .b;
}

void VariationalStep::FindKinksAt(double t, ExactSolver* solver, std::vector<double>* kinks) {
  solver->Sample(t, &sample_);
  y_.resize(dynamics_->state_size());
  dynamics_->Pack(sample_, y_.data());
  dynamics_->FindKinks(dynamics_->PlaceAt(t, y_.data()), kinks);
}

bool VariationalStep::AdvanceInParts(double a, double b, int halvings, ExactSolver* solver,
                                     MatX* X) {
  if (b - a < kShortestFit) return true;
  if (Fit(a, b, solver)) return Integrate(a, b, X);
  if (halvings == kMostFitHalvings) return false;
  const double middle = 0.5 * (a + b);
  return AdvanceInParts(a, middle, halvings + 1, solver, X) &&
         AdvanceInParts(middle, b, halvings + 1, solver, X);
}

bool VariationalStep::Fit(double a, double b, ExactSolver* solver) {
  const int m = dynamics_->layout().num_dofs();
  a_ = a;
  b_ = b;
  y_.resize(dynamics_->state_size());
  for (MatX& coefficient : fit_) coefficient.setZero(m, 2 * m + 1);
  for (int i = 0; i < kPoints; ++i) {
    const double s = kSixPlaces[i];
    const double t = 0.5 * ((1.0 - s) * a + (1.0 + s) * b);
    solver->Sample(t, &sample_);
    dynamics_->Pack(sample_, y_.data());
    LinearizeAt(t, &now_);
    const std::array<double, kPoints> p = LegendreAt(s);
    for (size_t k = 0; k < kPoints; ++k) {
      fit_[k] += (static_cast<double>(k) + 0.5) * kSixWeights[i] * p[k] * now_;
    }
  }
  const double h = b - a;
  const auto contribution = [&](const MatX& coefficient) {
    return std::max(h * h * coefficient.leftCols(m).lpNorm<Eigen::Infinity>(),
                    h * coefficient.rightCols(m + 1).lpNorm<Eigen::Infinity>());
  };
  return std::max(contribution(fit_[5]), 0.1 * contribution(fit_[4])) <= kMostLastCoefficient;
}

// Evaluates at the state y_.
void VariationalStep::LinearizeAt(double t, MatX* D) {
  const int m = dynamics_->layout().num_dofs();
  D->resize(m, 2 * m + 1);
  D->col(2 * m) = y_.segment(dynamics_->layout().num_positions(), m);
  steps_of_turns_ = TurnSteps();
  here_ = AccelerationsAt(t, 0, 0.0);
  kinks_here_ = kinks_;
  for (int j = 0; j < 2 * m; ++j) D->col(j) = DifferenceAt(t, j);
}

// Derivatives by turns, then by velocities. Next to a kink of a force only its own side tells:
//   f' = (-3 f(0) + 4 f(h) - f(2 h)) / (2 h).
VecX VariationalStep::DifferenceAt(double t, int column) {
  const bool is_turn = column < dynamics_->layout().num_dofs();
  const double h = is_turn ? steps_of_turns_[column] : kRateOfDifference;
  const VecX more = AccelerationsAt(t, column, h);
  const bool more_crosses = IsBeyondKink();
  const VecX less = AccelerationsAt(t, column, -h);
  const bool less_crosses = IsBeyondKink();
  if (more_crosses == less_crosses) return (more - less) / (2.0 * h);
  const double own = less_crosses ? h : -h;
  const VecX& near = less_crosses ? more : less;
  return (4.0 * near - 3.0 * here_ - AccelerationsAt(t, column, 2.0 * own)) / (2.0 * own);
}

// Steps by dof, at sample_ [rad]. Of a ball joint a small part of the way to its pole: about it
// torques of single hinges turn with the middle axis, and at it they jump.
VecX VariationalStep::TurnSteps() const {
  constexpr double kPartOfWay = 0.02, kLeastTurn = 1e-9;
  const RegionLayout& layout = dynamics_->layout();
  VecX steps = VecX::Constant(layout.num_dofs(), kTurnOfDifference);
  for (int i = 0; i < static_cast<int>(layout.nodes().size()); ++i) {
    const HingeTriple* ball = layout.triple(i);
    if (!ball) continue;
    const double way = ball->FromPole(sample_.q[layout.node(i).first_hinge + 1]);
    steps.segment<3>(layout.node(i).dof)
        .setConstant(std::clamp(kPartOfWay * way, kLeastTurn, kTurnOfDifference));
  }
  return steps;
}

// Accelerations of the state y_ with one turn or velocity changed. Sets kinks_ where forces have
// any.
VecX VariationalStep::AccelerationsAt(double t, int column, double change) {
  const RegionLayout& layout = dynamics_->layout();
  const int m = layout.num_dofs(), positions = layout.num_positions();
  shifted_ = y_;
  if (column < m) {
    change_.setZero(m);
    change_[column] = change;
    layout.Turn(change_, shifted_.data());
  } else {
    shifted_[positions + column - m] += change;
  }
  dy_.resize(dynamics_->state_size());
  dynamics_->Evaluate(t, shifted_.data(), dy_.data());
  if (dynamics_->has_kinks()) {
    dynamics_->FindKinks(dynamics_->PlacedAt(t, shifted_.data()), &kinks_);
  }
  return dy_.segment(positions, m);
}

bool VariationalStep::IsBeyondKink() const {
  if (!dynamics_->has_kinks()) return false;
  for (size_t i = 0; i < kinks_.size(); ++i) {
    if (kinks_[i] * kinks_here_[i] < 0.0) return true;
  }
  return false;
}

void VariationalStep::Derive(double t, const double* X, double* dX, Eigen::Index columns) {
  const RegionLayout& layout = dynamics_->layout();
  const int m = layout.num_dofs();
  const std::array<double, kPoints> p = LegendreAt((2.0 * t - a_ - b_) / (b_ - a_));
  now_ = fit_[0];
  for (size_t k = 1; k < kPoints; ++k) now_ += p[k] * fit_[k];
  const Eigen::Map<const MatX> x(X, 2 * m, columns);
  Eigen::Map<MatX> dx(dX, 2 * m, columns);
  dx.topRows(m) = x.bottomRows(m);
  dx.bottomRows(m).noalias() = now_.leftCols(2 * m) * x;
  for (const RegionLayout::Node& node : layout.nodes()) {
    if (node.kind != RegionLayout::NodeKind::kBall) continue;
    const Vec3 w = now_.block<3, 1>(node.dof, 2 * m);
    for (Eigen::Index c = 0; c < columns; ++c) {
      dx.block<3, 1>(node.dof, c) -= w.cross(Vec3(x.block<3, 1>(node.dof, c)));
    }
  }
}

bool VariationalStep::Integrate(double a, double b, MatX* X) {
  const Eigen::Index columns = X->cols(), m = X->rows() / 2;
  scale_.resize(X->size());
  Eigen::Map<MatX> scale(scale_.data(), 2 * m, columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    constexpr double kLeast = 1e-6;
    const double size =
        std::max({kLeast, X->col(c).head(m).lpNorm<Eigen::Infinity>(),
                  X->col(c).tail(m).lpNorm<Eigen::Infinity>() / ExactStep::kRateScale});
    scale.col(c).head(m).setConstant(tolerance_ * size);
    scale.col(c).tail(m).setConstant(tolerance_ * size * ExactStep::kRateScale);
  }
  const auto field = [&](double t, const double* x, double* dx) { Derive(t, x, dx, columns); };
  steps_.Resize(static_cast<int>(X->size()));
  steps_.Start(a, X->data(), field);
  double h = b - a;
  for (double t = a; t < b;) {
    const double use = std::min(h, b - t);
    const double error = steps_.Try(use, scale_.data(), field);
    const double grow = 0.9 * std::pow(std::max(error, 1e-10), -0.125);
    if (error <= 1.0) {
      steps_.Accept(field);
      t = use < b - t ? steps_.end_time() : b;
      h = use * std::clamp(grow, 0.333, 6.0);
      continue;
    }
    h = use * (std::isfinite(error) ? std::clamp(grow, 0.1, 0.9) : 0.1);
    if (h < kShortestFit) return false;
  }
  std::copy_n(steps_.y(), X->size(), X->data());
  return true;
}

}  // namespace hazumi
