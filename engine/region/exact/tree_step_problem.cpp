// Block Gauss-Seidel iteration as in SweepCones. Each block uses its current velocities under all
// impulses so far. A tour visits each node twice, on its way out and on its way back, and so
// performs a forward and a backward sweep.

#include "engine/region/exact/tree_step_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

using Kind = ConeProblem::Kind;
using Impulse = TreeImpulses::Impulse;

namespace {

constexpr int kMostTours = 60;
// Tolerance of the velocity correction of a block, relative to the largest velocity without forces.
// Nearly dependent rows, as of two links at their joint, may redistribute their force for long
// without moving anything.
constexpr double kTolerance = 1e-4;
constexpr double kRelativeCompliance = 1e-6;  // compliance relative to the diagonal of a block

double StepOf(double own) { return own > 0.0 ? 1.0 / ((1.0 + kRelativeCompliance) * own) : 0.0; }

}  // namespace

TreeStepProblem::TreeStepProblem(RegionDynamics* dynamics)
    : dynamics_(dynamics), tree_(dynamics->model()) {
  contacts_.resize(dynamics->model().nodes.size());
  limits_of_.resize(dynamics->model().nodes.size());
}

void TreeStepProblem::Assemble(double t, const HingeState& state) {
  equations_.emplace(dynamics_->AssembleByTree(t, state));
}

void TreeStepProblem::Factor() { equations_->Begin(&tree_); }

VecX TreeStepProblem::Rates() const {
  VecX rates(static_cast<Eigen::Index>(all_rows().size()));
  for (size_t k = 0; k < all_rows().size(); ++k)
    rates[static_cast<Eigen::Index>(k)] = all_rows()[k].rate;
  return rates;
}

VecX TreeStepProblem::Accelerations(VecX* x_0) const {
  *x_0 = equations_->x_0();
  return equations_->of_rows();
}

double TreeStepProblem::KineticEnergy(const VecX& qd) const {
  return equations_->KineticEnergy(qd);
}

void TreeStepProblem::SetUp(Acting, const std::vector<int>& side, const VecX& rows,
                            const VecX& hinges) {
  ListLimits(side, rows.size());
  const Eigen::Index count = rows.size() + static_cast<Eigen::Index>(limits().size());
  b_.resize(count);
  b_.head(rows.size()) = rows;
  own_.setZero(count);
  compliance_.setZero(count);
  blocks_.clear();
  for (auto& contacts : contacts_) contacts.clear();
  for (auto& limits : limits_of_) limits.clear();
  for (int row = 0; row < static_cast<int>(rows.size()); row += 3) {
    const int contact = all_rows()[static_cast<size_t>(row)].contact;
    ListContact(row, dynamics_->mode().contacts.FrictionOf(contact));
  }
  for (size_t k = 0; k < limits().size(); ++k) {
    const int i = limits()[k], row = static_cast<int>(RowOfLimit(k));
    const FreeHinge& hinge = dynamics_->hinges()[i];
    limits_of_[hinge.node].push_back({row, hinge.node, hinge.slot, static_cast<double>(side[i])});
    own_[row] = tree_.ResponseOfHinge(hinge.node, hinge.slot);
    b_[row] = -side[i] * hinges[i];
    blocks_.push_back({Kind::kPush, row});
  }
}

// Lists a contact. Nodes that are not dynamic have no response.
void TreeStepProblem::ListContact(int row, double friction) {
  const auto rows = all_rows().begin() + row;
  blocks_.push_back({Kind::kContact, row, friction});
  if (!tree_.is_dynamic(rows[0].a)) return;
  Contact contact{row, rows[0].a, friction, rows[0].r_a, rows[0].n, rows[1].n, rows[2].n, {}, {}};
  const V3 units[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  V3 responses[3];
  for (int k = 0; k < 3; ++k) {
    const auto motion = tree_.ResponseTo(contact.node, ImpulseOf(contact, units[k]));
    const V3 v = motion.v + Cross(motion.w, contact.r);
    responses[k] = {Dot(contact.n, v), Dot(contact.s, v), Dot(contact.t, v)};
  }
  contact.own[0] = responses[0].x;
  contact.own[1] = responses[1].y;
  contact.own[2] = responses[2].z;
  contact.mixed[0] = responses[0].y;
  contact.mixed[1] = responses[0].z;
  contact.mixed[2] = responses[1].z;
  for (int k = 0; k < 3; ++k) own_[row + k] = contact.own[k];
  contacts_[contact.node].push_back(contact);
}

Impulse TreeStepProblem::ImpulseOf(const Contact& contact, const V3& l) const {
  const V3 f = l.x * contact.n + l.y * contact.s + l.z * contact.t;
  return {Cross(contact.r, f), f};
}

// Velocities along the rows of a contact due to impulses.
V3 TreeStepProblem::VelocitiesAt(const Contact& contact) const {
  const TreeImpulses::Motion& motion = tree_.Of(contact.node);
  const V3 v = motion.v + Cross(motion.w, contact.r);
  return {Dot(contact.n, v), Dot(contact.s, v), Dot(contact.t, v)};
}

void TreeStepProblem::Sweep(VecX start, bool) {
  forces_ = std::move(start);
  Settle();
  const double enough = kTolerance * (b_.size() > 0 ? b_.lpNorm<Eigen::Infinity>() : 0.0);
  int tours = 0;
  for (; tours < kMostTours; ++tours) {
    change_ = 0.0;
    Tour();
    if (change_ <= enough) break;
  }
  Settle();
  dynamics_->AddWork({.contacts = static_cast<double>(tours + 2)});
}

// Updates the motion of all nodes, and w_, for the current forces.
void TreeStepProblem::Settle() {
  tree_.Clear();
  for (const auto& contacts : contacts_) {
    for (const Contact& own : contacts) {
      const V3 l{forces_[own.row], forces_[own.row + 1], forces_[own.row + 2]};
      tree_.Add(own.node, ImpulseOf(own, l));
    }
  }
  for (const auto& limits : limits_of_) {
    for (const Limit& own : limits) {
      tree_.AddAboutHinge(own.node, own.hinge, -own.side * forces_[own.row]);
    }
  }
  tree_.Settle();
  w_ = b_ + compliance_.cwiseProduct(forces_);
  for (const auto& contacts : contacts_) {
    for (const Contact& own : contacts) w_.segment<3>(own.row) += VelocitiesAt(own).eigen();
  }
  for (const auto& limits : limits_of_) {
    for (const Limit& own : limits) w_[own.row] -= own.side * tree_.Rate(own.node, own.hinge);
  }
}

void TreeStepProblem::Tour() {
  for (const TreeImpulses::Step& step : tree_.tour()) {
    if (step.up) {
      SolveAt(step.node);
      tree_.Take(step);
      SolveLimitsOf(step.node);
    } else {
      SolveLimitsOf(step.node);
      tree_.Take(step);
      SolveAt(step.node);
    }
  }
}

void TreeStepProblem::SolveAt(int node) {
  for (const Contact& contact : contacts_[node]) Solve(contact);
}

void TreeStepProblem::SolveLimitsOf(int node) {
  for (const Limit& limit : limits_of_[node]) Solve(limit);
}

void TreeStepProblem::Solve(const Contact& contact) {
  const int i = contact.row;
  const V3 w = VelocitiesAt(contact);
  const double w_n = w.x + b_[i] + compliance_[i] * forces_[i];
  const double to = std::max(0.0, forces_[i] - StepOf(Response(i)) * w_n), by = to - forces_[i];
  change_ = std::max(change_, std::abs(by) * Response(i));
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  const Eigen::Vector2d before = forces_.segment<2>(i + 1);
  const double radius = contact.friction * to;
  if (radius > 0.0) {
    const double p = contact.own[1], q = contact.own[2], r = contact.mixed[2];
    const double stiffest = 0.5 * (p + q) + std::sqrt(0.25 * (p - q) * (p - q) + r * r);
    const Eigen::Vector2d w_t(w.y + b_[i + 1] + by * contact.mixed[0],
                              w.z + b_[i + 2] + by * contact.mixed[1]);
    across = before - StepOf(stiffest) * w_t;
    const double size = across.norm();
    if (size > radius) across *= radius / size;
  }
  const double response = std::max(contact.own[1], contact.own[2]);
  change_ = std::max(change_, (across - before).lpNorm<Eigen::Infinity>() * response);
  const V3 more{by, across[0] - before[0], across[1] - before[1]};
  if (more.x == 0.0 && more.y == 0.0 && more.z == 0.0) return;
  forces_[i] = to;
  forces_.segment<2>(i + 1) = across;
  tree_.Push(contact.node, ImpulseOf(contact, more));
}

void TreeStepProblem::Solve(const Limit& limit) {
  const int i = limit.row;
  const double w =
      b_[i] + compliance_[i] * forces_[i] - limit.side * tree_.Rate(limit.node, limit.hinge);
  const double to = std::max(0.0, forces_[i] - StepOf(Response(i)) * w), by = to - forces_[i];
  change_ = std::max(change_, std::abs(by) * Response(i));
  if (by == 0.0) return;
  forces_[i] = to;
  tree_.PushHinge(limit.node, limit.hinge, -limit.side * by);
}

}  // namespace hazumi
