// A rule adds accelerations to joints inside the figure. So that its angular momentum stays, a root
// that turns freely responds with accelerations u of its own:
//   I u + moment = 0
// with the inertia I of all bodies about their centre of mass, or in general the root's block of M,
// and the moment that the accelerations of the others need.

#include "engine/region/equations/equations_of_motion.h"

#include <Eigen/Cholesky>

#include "engine/base/assert.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

SolvedEquations EquationsOfMotion::Solve(const LoadedState& loaded, EquationsMethod method,
                                         double* x) {
  const RegionState& state = loaded.state();
  if (method == EquationsMethod::kTree) {
    tree_.Solve(state.layout, state.kinematics.motion(), x);
  } else {
    dense_.Assemble(state.layout, &loaded.nodes()->motion());
    dense_.Solve(state.layout, x);
  }
  return {this, method, state};
}

AssembledEquations EquationsOfMotion::Assemble(const LoadedState& loaded) {
  dense_.Assemble(loaded.state().layout, &loaded.nodes()->motion());
  return {this, EquationsMethod::kDense, loaded.state()};
}

SolvedEquations EquationsOfMotion::Factor(const AssembledEquations& assembled) {
  HAZUMI_ASSERT(assembled.method() == EquationsMethod::kDense);
  VecX unused(assembled.layout().num_dofs());
  dense_.Solve(assembled.layout(), unused.data());
  return {this, EquationsMethod::kDense, assembled.state()};
}

void EquationsOfMotion::AssembleSome(const LoadedState& loaded, const std::vector<int>& hinges) {
  const RegionState& state = loaded.state();
  tree_.AssembleSome(state.layout, state.kinematics.motion(), hinges);
}

int AssembledEquations::num_unknowns() const {
  const int root = method_ == EquationsMethod::kTree ? equations_->tree_.bodies().num_root() : 0;
  return root + layout().num_dofs();
}

void AssembledEquations::AddToRow(int node, const V3& r, const V3& n, bool turns,
                                  Eigen::Ref<VecX> column) const {
  const auto& motion = state_.kinematics.motion();
  if (method_ == EquationsMethod::kTree) {
    equations_->tree_.bodies().AddHalf(layout(), motion, node, r, n, turns, column.data());
  } else {
    equations_->dense_.AddToRow(layout(), motion, node, motion[node].p + r, n, turns, column);
  }
}

void AssembledEquations::AddRootToRows(const Eigen::Matrix3Xd& along, Eigen::Ref<MatX> rows) const {
  HAZUMI_ASSERT(method_ == EquationsMethod::kDense);
  equations_->dense_.AddRootToRows(layout(), along, rows);
}

V3 AssembledEquations::RootAcceleration(const double* x) const {
  if (method_ == EquationsMethod::kTree) {
    return (-1.0 / equations_->model_->mass) * state_.kinematics.AskedForce();
  }
  return V3(equations_->dense_.RootAcceleration(layout(), state_.kinematics.motion(), x));
}

void AssembledEquations::FindRule(const ForceLaw& rule, VecX* added) const {
  added->setConstant(-0.0);  // which leaves the sign of any zero that is added
  rule.AddAccelerations(state_, added->data());
  const RegionModel& model = *equations_->model_;
  if (model.root_answers && model.nodes[0].role == Role::kFree) KeepAngularMomentum(added);
}

void AssembledEquations::AddRules(const RegionLaws& laws, double* x) const {
  if (!laws.any_rules()) return;
  VecX& added = equations_->added_;
  for (const auto& law : laws.all()) {
    if (!law->is_rule()) continue;
    FindRule(*law, &added);
    for (int i = 0; i < layout().num_dofs(); ++i) x[i] += added[i];
  }
}

void AssembledEquations::KeepAngularMomentum(VecX* added) const {
  if (layout().node(0).num_dofs == 0) return;
  Vec3 moment = Vec3::Zero();
  if (method_ == EquationsMethod::kTree) {
    const Mat3 M_rr = equations_->InertiaOfRoot(state_, *added, &moment);
    added->head<3>() = M_rr.ldlt().solve(moment);
    return;
  }
  const MatX& M = equations_->dense_.equations().M;
  for (int j = 3; j < layout().num_dofs(); ++j) moment -= M.block<3, 1>(0, j) * (*added)[j];
  const Mat3 M_rr = M.topLeftCorner<3, 3>();
  added->head<3>() = M_rr.ldlt().solve(moment);
}

// Returns the inertia of all bodies about their centre c along the root's directions, and minus the
// moment that their accelerations need. Bodies' m, h, I are their own.
Mat3 EquationsOfMotion::InertiaOfRoot(const RegionState& state, const VecX& added,
                                      Vec3* moment_along) {
  const auto& motion = state.kinematics.motion();
  alpha_.assign(motion.size(), V3());
  a_.assign(motion.size(), V3());
  V3 force, moment, sum;
  S3 I;
  for (int i = 0; i < state.kinematics.size(); ++i) {
    const NodeMotion& own = motion[i];
    const int parent = model_->nodes[i].parent;
    if (parent >= 0) {
      alpha_[i] = alpha_[parent];
      a_[i] = a_[parent] + Cross(alpha_[parent], own.r);
      const RegionLayout::Node& where = state.layout.node(i);
      for (int k = 0; k < where.num_dofs; ++k) alpha_[i] += added[where.dof + k] * own.axis[k];
    }
    if (!model_->nodes[i].is_dynamic) continue;
    const V3 f = own.m * a_[i] + Cross(alpha_[i], own.h);
    force += f;
    moment += own.I * alpha_[i] + Cross(own.h, a_[i]) + Cross(own.p, f);
    sum += own.m * own.p + own.h;
    const V3 g = own.h + own.m * own.p;
    I += own.I;
    I += Diagonal(Dot(own.p, own.h) + Dot(own.p, g));
    I += S3{-own.p.x * own.h.x - g.x * own.p.x, -own.p.x * own.h.y - g.x * own.p.y,
            -own.p.x * own.h.z - g.x * own.p.z, -own.p.y * own.h.y - g.y * own.p.y,
            -own.p.y * own.h.z - g.y * own.p.z, -own.p.z * own.h.z - g.z * own.p.z};
  }
  if (model_->coupling == RootCoupling::kFlight) {
    const V3 c = (1.0 / model_->mass) * sum;
    moment = moment - Cross(c, force);
    I += Diagonal(-Dot(c, sum));
    I += S3{c.x * sum.x, c.x * sum.y, c.x * sum.z, c.y * sum.y, c.y * sum.z, c.z * sum.z};
  }
  Mat3 M_rr;
  for (int k = 0; k < 3; ++k) {
    const V3& axis = motion[0].axis[k];
    (*moment_along)[k] = -Dot(axis, moment);
    const V3 turned = I * axis;
    for (int l = 0; l < 3; ++l) M_rr(l, k) = Dot(motion[0].axis[l], turned);
  }
  return M_rr;
}

void AssembledEquations::PrepareRows() const {
  if (method_ == EquationsMethod::kDense) return;
  equations_->tree_.bodies().FactorJoints(layout(), state_.kinematics.motion());
}

void SolvedEquations::FinishHalves(Eigen::Ref<MatX> columns) const {
  if (method_ == EquationsMethod::kDense) equations_->dense_.SolveLower(layout(), columns);
}

VecX SolvedEquations::Respond(VecX half) const {
  if (method_ == EquationsMethod::kDense) {
    equations_->dense_.SolveUpper(layout(), half);
    return half;
  }
  VecX x(layout().num_dofs());
  equations_->tree_.bodies().FinishHalf(layout(), state_.kinematics.motion(), half.data(),
                                        x.data());
  return x;
}

}  // namespace hazumi
