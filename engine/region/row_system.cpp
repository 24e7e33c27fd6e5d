// With x_0 the accelerations by forces and rules together, rows (J, c) that ask for J x + c = 0 get
// forces l, which push along P:
//   x = x_0 + M^-1 P^T l,   A l = -(J x_0 + c),   A = J M^-1 P^T + G
// P is J except for contacts that slide, whose forces lean backwards. G is the response of what no
// hinge moves: in flight the centre of mass, by n n' / m for rows that push it along n and n', and
// balls. Rows with a gap to close are compliant (RowCompliance): A + C instead of A, with C d on
// the right. Friction in joints is in x_0, as if it were the torques M r. Redundant rows share the
// smallest forces.

#include "engine/region/row_system.h"

#include <algorithm>
#include <cmath>

#include "engine/base/assert.h"
#include "engine/matrix/eigen_system.h"
#include "engine/matrix/semidefinite.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

bool Slides(const ConstraintRow& row) {
  return row.is_contact() &&
         (row.push.x != row.n.x || row.push.y != row.n.y || row.push.z != row.n.z);
}

}  // namespace

const std::vector<ConstraintRow>& RowSystem::Measure(const RegionMode& mode,
                                                     const RegionState& state, bool may_slide) {
  rows_.clear();
  mode.constraints.AppendRows(state, &rows_);
  mode.contacts.AppendRows(state, &rows_);
  if (!may_slide) {
    for (ConstraintRow& row : rows_) row.push = row.n;
  }
  return rows_;
}

// Acceleration of a point of a node in the world, r from the node's origin, for the root's.
V3 RowSystem::AccelerationAt(const NodeKinematics& nodes, int node, const V3& r,
                             const V3& root) const {
  if (node < 0) return {};
  const NodeMotion& own = nodes.motion()[node];
  const V3 a = model_->is_ball(node) ? own.a : root + own.a;
  return a + Cross(own.alpha, r) + Cross(own.w, Cross(own.w, r));
}

VecX RowSystem::Errors(const AssembledEquations& equations, const double* x,
                       RegionKinematics* kinematics) const {
  NodeKinematics& nodes = kinematics->nodes();
  nodes.Accelerate(equations.layout(), x, 0);
  const auto& motion = nodes.motion();
  const V3 up(0.0, 0.0, bodies_.gravity());
  const bool flies = model_->coupling == RootCoupling::kFlight;
  const V3 root =
      (flies ? equations.RootAcceleration(x) : kinematics->BaseAcceleration(equations.state().t)) -
      up;
  VecX errors(static_cast<Eigen::Index>(rows_.size()));
  for (size_t k = 0; k < rows_.size(); ++k) {
    const ConstraintRow& row = rows_[k];
    V3 difference;
    if (row.turns) {
      if (row.a >= 0) difference += motion[row.a].alpha;
      if (row.b >= 0) difference -= motion[row.b].alpha;
    } else {
      difference =
          AccelerationAt(nodes, row.a, row.r_a, root) - AccelerationAt(nodes, row.b, row.r_b, root);
    }
    errors[static_cast<Eigen::Index>(k)] = Dot(row.n, difference) + row.bend - row.wanted;
  }
  return errors;
}

void RowSystem::AddToRow(const AssembledEquations& equations, const ConstraintRow& row, const V3& n,
                         Eigen::Ref<VecX> column) const {
  if (row.a >= 0 && !model_->is_ball(row.a)) {
    equations.AddToRow(row.a, row.r_a, n, row.turns, column);
  }
  if (row.b >= 0 && !model_->is_ball(row.b)) {
    equations.AddToRow(row.b, row.r_b, -n, row.turns, column);
  }
}

const RowMatrices& RowSystem::Assemble(const AssembledEquations& equations) {
  MatX &J = matrices_.J, &P = matrices_.P, &G = matrices_.G;
  const auto count = static_cast<Eigen::Index>(rows_.size());
  equations.PrepareRows();
  J.setZero(equations.num_unknowns(), count);
  for (Eigen::Index k = 0; k < count; ++k) AddToRow(equations, rows_[k], rows_[k].n, J.col(k));
  matrices_.any_slides = std::any_of(rows_.begin(), rows_.end(), Slides);
  if (matrices_.any_slides) {
    P = J;
    for (Eigen::Index k = 0; k < count; ++k) {
      if (Slides(rows_[k])) AddToRow(equations, rows_[k], rows_[k].push - rows_[k].n, P.col(k));
    }
  }
  G.setZero(count, count);
  if (!model_->balls.empty()) bodies_.AddResponse(rows_, &G);
  if (equations.method() == EquationsMethod::kTree) return matrices_;
  Eigen::Matrix3Xd moves(3, count), pushes(3, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    moves.col(k) = bodies_.NetOf(rows_[k], rows_[k].n);
    pushes.col(k) = bodies_.NetOf(rows_[k], rows_[k].force());
  }
  if (matrices_.any_slides) equations.AddRootToRows(pushes, P);
  equations.AddRootToRows(moves, J);
  if (model_->coupling != RootCoupling::kFlight) return matrices_;
  G.noalias() += moves.transpose().lazyProduct(pushes / model_->mass);
  return matrices_;
}

const RowMatrices& RowSystem::LeaveClosed() {
  for (Eigen::Index k = 0; k < matrices_.J.cols(); ++k) {
    if (rows_[static_cast<size_t>(k)].is_closed) continue;
    matrices_.J.col(k).setZero();
    matrices_.G.row(k).setZero();
    matrices_.G.col(k).setZero();
  }
  return matrices_;
}

const RowResponse& RowSystem::Respond(const RowMatrices& matrices,
                                      const SolvedEquations& equations) {
  HAZUMI_ASSERT(matrices.J.rows() == equations.num_unknowns());
  response_.half = matrices.push();
  equations.FinishHalves(response_.half);
  if (!matrices.any_slides) {
    response_.A = ProductOf(response_.half, response_.half) + matrices.G;
    return response_;
  }
  MatX J = matrices.J;
  equations.FinishHalves(J);
  response_.A = ProductOf(J, response_.half) + matrices.G;
  return response_;
}

// Contacts, of which a body may have many more than it has directions to move in, get a tiny
// compliance, which is faster than the smallest norm.
VecX RowSystem::Solve(const RegionMode& mode, const MatX& A, const VecX& errors) const {
  HAZUMI_ASSERT(A.rows() == errors.size() && A.cols() == errors.size());
  if (!mode.contacts.any_closed()) return -LeastNorm(A, errors);
  const bool is_symmetric = !matrices_.any_slides && !mode.constraints.any_closing();
  return SolveGivingWay(A, is_symmetric, -errors, Softness(mode.contacts));
}

// Relative compliance of rows across contacts: smaller for a larger normal force, so that contacts
// share a drag as their friction cones do.
VecX RowSystem::Softness(const ContactSet& contacts) const {
  constexpr double kLeast = 0.01;
  VecX softness = VecX::Ones(static_cast<Eigen::Index>(rows_.size()));
  double most = 0.0;
  for (const ContactPair& pair : contacts.pairs()) {
    if (pair.mode == ContactMode::kStick) most = std::max(most, pair.load);
  }
  for (size_t k = 0; k < rows_.size(); ++k) {
    if (!rows_[k].is_contact()) continue;
    const ContactPair& pair = contacts.pairs()[rows_[k].contact];
    if (pair.mode != ContactMode::kStick) continue;
    const double share = most > 0.0 ? std::max(kLeast, pair.load / most) : 1.0;
    softness.segment<2>(static_cast<Eigen::Index>(k) + 1).setConstant(1.0 / share);
    k += 2;
  }
  return softness;
}

void RowSystem::FindCompliance(const RegionMode& mode, const RowResponse& response) {
  compliance_ = ComplianceOf(rows_, response.A, mode.constraints.Damping(rows_), model_->mass,
                             mode.least_compliance);
}

void RowSystem::Constrain(const RegionMode& mode, const SolvedEquations& equations,
                          RegionKinematics* kinematics, double* x) {
  const RegionLayout& layout = equations.layout();
  Measure(mode, equations.state());
  if (rows_.empty()) return forces_.resize(0);
  VecX errors = Errors(equations, x, kinematics);
  const RowResponse& response = Respond(Assemble(equations), equations);
  if (mode.constraints.any_closing()) {
    if (!layout.is_any_locked()) FindCompliance(mode, response);
    errors -= compliance_.C * compliance_.d;
    forces_ = Solve(mode, response.A + compliance_.C, errors);
  } else {
    forces_ = Solve(mode, response.A, errors);
  }
  Eigen::Map<VecX>(x, layout.num_dofs()) += equations.Respond(response.half * forces_);
}

void RowSystem::AssembleForHinges(const RegionMode& mode, const AssembledEquations& equations,
                                  const VecX& rules, RegionKinematics* kinematics,
                                  EquationsOfMotion* of_motion) {
  const RowMatrices& matrices = Assemble(equations);
  for_forces_ = {
      matrices.J.transpose(), matrices.G, Errors(equations, rules.data(), kinematics), {}, {}};
  if (matrices.any_slides) for_forces_.P = matrices.P.transpose();
  if (mode.contacts.any_closed()) for_forces_.softness = Softness(mode.contacts);
  if (mode.constraints.any_closing()) {
    FindCompliance(mode, Respond(matrices, of_motion->Factor(equations)));
    for_forces_.G += compliance_.C;
    for_forces_.c -= compliance_.C * compliance_.d;
  }
  VecX rates = VecX::Zero(matrices.J.cols());
  for (Eigen::Index k = 0; k < rates.size(); ++k) {
    const ConstraintRow& row = rows_[static_cast<size_t>(k)];
    if (row.is_closed) rates[k] = row.rate;
  }
  LeaveClosed();
  for_impulses_ = {matrices.J.transpose(), matrices.G, rates, for_forces_.P, for_forces_.softness};
}

void RowSystem::AddForces(Kind kind, NodeKinematics* nodes) const {
  for (size_t k = 0; k < rows_.size(); ++k) {
    const ConstraintRow& row = rows_[k];
    if (kind != Kind::kAll && row.is_contact() != (kind == Kind::kContacts)) continue;
    const V3 force = forces_[static_cast<Eigen::Index>(k)] * row.force();
    if (row.turns) {
      if (row.a >= 0) nodes->AddTorque(row.a, force);
      if (row.b >= 0) nodes->AddTorque(row.b, -force);
    } else {
      if (row.a >= 0) nodes->AddForce(row.a, row.r_a, force);
      if (row.b >= 0) nodes->AddForce(row.b, row.r_b, -force);
    }
  }
}

RowSystem::Excess RowSystem::ContactExcess(const ContactSet& contacts) const {
  Excess excess;
  for (size_t k = 0; k < rows_.size(); ++k) {
    if (!rows_[k].is_contact()) continue;
    const double push = forces_[static_cast<Eigen::Index>(k)];
    excess.pushes += std::abs(push);
    excess.newtons = std::max(excess.newtons, -push);
    if (contacts.pairs()[rows_[k].contact].mode != ContactMode::kStick) continue;
    const double drag = forces_.segment<2>(static_cast<Eigen::Index>(k) + 1).norm();
    excess.newtons = std::max(excess.newtons, drag - contacts.FrictionOf(rows_[k].contact) * push);
    k += 2;
  }
  return excess;
}

std::vector<ContactPush> RowSystem::ContactPushes(const RegionMode& mode,
                                                  const RegionState& state) const {
  std::vector<ContactPush> pushes;
  const auto add = [&](const ContactParts& parts, const V3& p, const Vec3& force) {
    if (parts.link < 0) return;  // a ball that lies on something
    pushes.push_back({parts, p.eigen(), force});
    if (parts.by_link >= 0) pushes.push_back({parts.Swapped(), p.eigen(), -force});
  };
  for (size_t k = 0; k < rows_.size();) {
    const ConstraintRow& row = rows_[k];
    if (!row.is_contact()) {
      ++k;
      continue;
    }
    Vec3 force = Vec3::Zero();
    do {  // a pair's rows follow one another
      force += forces_[static_cast<Eigen::Index>(k)] * rows_[k].push.eigen();
    } while (++k < rows_.size() && rows_[k].contact == row.contact);
    add(mode.contacts.PartsOf(mode.contacts.pairs()[row.contact]), state.places[row.a].p + row.r_a,
        force);
  }
  for (const StepForces::Push& push : mode.constant.pushes) {
    const V3 r = StepForces::PointOn(state.kinematics, push.node, push.p_N);
    const double sign = push.parts.by_ball >= 0 ? -1.0 : 1.0;  // the force acts on the ball
    add(push.parts, state.places[push.node].p + r, sign * push.force);
  }
  return pushes;
}

// Rows are scaled by the firmest one of their constraint, points and turns apart; distances, of one
// row each, by the firmest of all.
std::vector<RowSystem::Eigenvalue> RowSystem::Spectrum() const {
  std::vector<size_t> closed;
  for (size_t k = 0; k < rows_.size(); ++k) {
    if (!rows_[k].is_contact() && rows_[k].is_closed) closed.push_back(k);
  }
  std::vector<Eigenvalue> spectrum;
  if (closed.empty() || response_.half.cols() != matrices_.J.cols()) return spectrum;
  const MatX half = response_.half(Eigen::all, closed);
  const MatX A = ProductOf(half, half) + matrices_.G(closed, closed);
  VecX unit(A.rows());
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    double firmest = 0.0;
    int others = 0;
    for (Eigen::Index l = 0; l < A.rows(); ++l) {
      const ConstraintRow &own = rows_[closed[k]], &other = rows_[closed[l]];
      if (other.constraint != own.constraint || other.turns != own.turns) continue;
      firmest = std::max(firmest, A(l, l));
      others += l != k;
    }
    if (others == 0) firmest = A.diagonal().maxCoeff();
    unit[k] = firmest > 0.0 ? 1.0 / std::sqrt(firmest) : 0.0;
  }
  const EigenSystem eigen = EigenSystemOf(unit.asDiagonal() * A * unit.asDiagonal());
  for (Eigen::Index k = 0; k < unit.size(); ++k) {
    Eigen::Index most = 0;
    eigen.vectors.col(k).cwiseAbs().maxCoeff(&most);
    spectrum.push_back({eigen.values[k], rows_[closed[most]].constraint});
  }
  return spectrum;
}

}  // namespace hazumi
