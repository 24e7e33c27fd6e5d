// With the composite body beyond node i (m, h = m c, I about its origin) every free direction e of
// it needs, per unit acceleration,
//   f = e x h,  n = I e;   M(e', e) = e' . n about the origin of e', for e' between i and the root
//   b(e) = e . n_i, n_i what everything beyond asks for with the free accelerations zero
// [Luh, Walker, Paul 1980] for b, composite rigid bodies [Featherstone 2008, 6.2] for M. With F the
// force on the root for unit accelerations of all e and u the root's own acceleration,
//   in flight  F x + f + m u = 0,     on a pin  u = -J x.

#include "engine/region/equations/dense_equations.h"

#include <algorithm>
#include <cmath>

#include "engine/matrix/dense_kernels.h"
#include "engine/matrix/semidefinite.h"
#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

DenseEquations::DenseEquations(const RegionModel& model)
    : p_pin_(model.p_pin),
      root_answers_(model.root_answers),
      is_pinned_(model.coupling == RootCoupling::kPinned),
      mass_(model.mass),
      num_free_(model.num_free) {
  for (const ModelNode& node : model.nodes) {
    const bool is_carried = node.parent >= 0 && model.nodes[node.parent].is_dynamic;
    nodes_.push_back({is_carried ? node.parent : -1, node.is_dynamic});
  }
  for (int i = model.pin_node; i >= 0; i = model.nodes[i].parent) to_pin_.push_back(i);
}

// At the first evaluation: a long chain may never need one.
void DenseEquations::MakeRoom() {
  if (L_.cols() == num_free_ && F_.cols() == num_free_) return;
  equations_.b.setZero(num_free_);
  for (MatX* matrix : {&equations_.M, &L_}) matrix->setZero(num_free_, num_free_);
  for (Eigen::Matrix3Xd* rows : {&F_, &J_}) rows->setZero(3, num_free_);
}

void DenseEquations::Assemble(const RegionLayout& layout, std::vector<NodeMotion>* motion) {
  HAZUMI_ASSERT(motion->size() >= nodes_.size());
  HAZUMI_ASSERT(layout.num_dofs() <= num_free_);
  MakeRoom();
  for (int i = 0; i < layout.num_dofs(); ++i) {
    std::fill_n(&equations_.M(0, i), layout.num_dofs(), 0.0);
  }
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    if (!nodes_[i].is_dynamic) continue;
    const RegionLayout::Node& where = layout.node(i);
    const NodeMotion& own = (*motion)[i];
    for (int k = 0; k < where.num_dofs; ++k) {
      AssembleColumn(layout, *motion, i, where.dof + k, own.axis[k]);
      equations_.b[where.dof + k] = Dot(own.axis[k], own.n);
    }
    PassToParent(i, motion);
  }
  if (!root_answers_) return;
  if (is_pinned_) {
    EliminatePin(layout, *motion);
  } else {
    EliminateFlight(layout, *motion);
  }
}

void DenseEquations::AssembleColumn(const RegionLayout& layout,
                                    const std::vector<NodeMotion>& motion, int node, int dof,
                                    const V3& axis) {
  MatX& M = equations_.M;
  const V3 f = Cross(axis, motion[node].h);
  V3 n = motion[node].I * axis;
  F_.col(dof) << f.x, f.y, f.z;
  for (int i = node;; i = nodes_[i].parent) {
    const RegionLayout::Node& where = layout.node(i);
    for (int k = 0; k < where.num_dofs; ++k) {
      M(where.dof + k, dof) = M(dof, where.dof + k) = Dot(motion[i].axis[k], n);
    }
    if (nodes_[i].parent < 0) return;
    n += Cross(motion[i].r, f);
  }
}

void DenseEquations::PassToParent(int node, std::vector<NodeMotion>* motion) const {
  if (nodes_[node].parent < 0) return;
  const NodeMotion& own = (*motion)[node];
  NodeMotion& to = (*motion)[nodes_[node].parent];
  const V3 &r = own.r, &h = own.h;
  const V3 g = h + own.m * r;  // of the composite about the parent's origin
  const double d = Dot(r, h) + Dot(r, g);
  to.f += own.f;
  to.n += own.n + Cross(r, own.f);
  to.m += own.m;
  to.h += g;
  to.I += own.I;
  to.I += S3{d - r.x * h.x - g.x * r.x, -r.x * h.y - g.x * r.y, -r.x * h.z - g.x * r.z,
             d - r.y * h.y - g.y * r.y, -r.y * h.z - g.y * r.z, d - r.z * h.z - g.z * r.z};
}

void DenseEquations::EliminateFlight(const RegionLayout& layout,
                                     const std::vector<NodeMotion>& motion) {
  const Vec3 f_root = motion[0].f.eigen();
  const DenseKernels& kernels = BestDenseKernels();
  F_across_ = F_.transpose();
  for (int j = 0; j < layout.num_dofs(); ++j) {
    const Vec3 column = F_.col(j) / mass_;
    kernels.subtract_three(F_across_.data(), F_across_.rows(), column.data(), layout.num_dofs(),
                           &equations_.M(0, j));
    equations_.b[j] -= column.dot(f_root);
  }
}

void DenseEquations::EliminatePin(const RegionLayout& layout,
                                  const std::vector<NodeMotion>& motion) {
  const Vec3 f_root = motion[0].f.eigen();
  const NodeMotion& pin = motion[to_pin_.front()];
  const V3 p_pin = pin.p + pin.R * V3(p_pin_);
  J_.leftCols(layout.num_dofs()).setZero();
  for (const int i : to_pin_) {
    const RegionLayout::Node& where = layout.node(i);
    for (int k = 0; k < where.num_dofs; ++k) {
      J_.col(where.dof + k) = Cross(motion[i].axis[k], p_pin - motion[i].p).eigen();
    }
  }
  const DenseKernels& kernels = BestDenseKernels();
  F_across_ = F_.transpose();
  J_across_ = J_.transpose();
  for (int j = 0; j < layout.num_dofs(); ++j) {
    const Vec3 push = mass_ * J_.col(j) - F_.col(j);
    kernels.add_threes(J_across_.data(), F_across_.data(), F_across_.rows(), push.data(), &J_(0, j),
                       layout.num_dofs(), &equations_.M(0, j));
    equations_.b[j] -= J_.col(j).dot(f_root);
  }
}

void DenseEquations::Solve(const RegionLayout& layout, double* x) {
  HAZUMI_ASSERT(L_.rows() == num_free_ && "assembled before");
  HAZUMI_ASSERT(IsSymmetric(equations_.M.topLeftCorner(layout.num_dofs(), layout.num_dofs())));
  const int k = layout.num_dofs();
  for (int j = 0; j < k; ++j) std::copy_n(&equations_.M(0, j), k, &L_(0, j));
  FactorSemidefinite(L_.topLeftCorner(k, k));
  Eigen::Map<VecX> solution(x, k);
  solution = -equations_.b.head(k);
  SolveSemidefinite(L_.topLeftCorner(k, k), solution);
}

void DenseEquations::SolveLower(const RegionLayout& layout, Eigen::Ref<MatX> X) const {
  const int k = layout.num_dofs();
  hazumi::SolveLower(L_.topLeftCorner(k, k), X);
}

void DenseEquations::SolveUpper(const RegionLayout& layout, Eigen::Ref<VecX> x) const {
  const int k = layout.num_dofs();
  hazumi::SolveUpper(L_.topLeftCorner(k, k), x);
}

namespace {

// Of what cancels, where its parts are of this size, rounding leaves nothing: a row without hold on
// a joint is told by zeros.
void AddRounded(double part, double size, double* sum) {
  constexpr double kRounding = 1e-14;
  *sum += part;
  if (std::abs(*sum) <= kRounding * size) *sum = 0.0;
}

}  // namespace

void DenseEquations::AddToRow(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                              int node, const V3& p, const V3& n, bool turns,
                              Eigen::Ref<VecX> row) const {
  HAZUMI_ASSERT(0 <= node && node < static_cast<int>(nodes_.size()));
  HAZUMI_ASSERT(row.size() == layout.num_dofs());
  for (int i = node; i >= 0; i = nodes_[i].parent) {
    const RegionLayout::Node& where = layout.node(i);
    const V3 r = p - motion[i].p, moment = turns ? n : Cross(r, n);
    const double size = turns ? 1.0 : std::sqrt(Dot(r, r));
    for (int k = 0; k < where.num_dofs; ++k) {
      AddRounded(Dot(motion[i].axis[k], moment), size, &row[where.dof + k]);
    }
  }
}

void DenseEquations::AddRootToRows(const RegionLayout& layout, const Eigen::Matrix3Xd& along,
                                   Eigen::Ref<MatX> rows) const {
  HAZUMI_ASSERT(along.cols() == rows.cols());
  if (!root_answers_ || rows.rows() == 0) return;  // no joint is free
  const double share = is_pinned_ ? 1.0 : 1.0 / mass_;
  const Eigen::MatrixX3d unit = (is_pinned_ ? J_ : F_).leftCols(layout.num_dofs()).transpose();
  const DenseKernels& kernels = BestDenseKernels();
  for (Eigen::Index row = 0; row < rows.cols(); ++row) {
    if (along.col(row).isZero(0.0)) continue;
    const Vec3 way = share * along.col(row);
    kernels.subtract_three_rounded(unit.data(), unit.rows(), way.data(), unit.rows(),
                                   &rows(0, row));
  }
}

Vec3 DenseEquations::RootAcceleration(const RegionLayout& layout,
                                      const std::vector<NodeMotion>& motion,
                                      const double* x) const {
  const Eigen::Map<const VecX> accelerations(x, layout.num_dofs());
  return -(F_.leftCols(layout.num_dofs()) * accelerations + motion[0].f.eigen()) / mass_;
}

// With Du = -v_pin - J Dy for the root:  H Dy + F^T Du = 0 along what keeps the pin still.
void DenseEquations::PinImpulse(const Vec3& v_pin, VecX* impulse) const {
  HAZUMI_ASSERT(impulse->size() == num_free_);
  HAZUMI_ASSERT(IsFinite(v_pin));
  for (int i = 0; i < num_free_; ++i) {
    (*impulse)[i] = (F_.col(i) - mass_ * J_.col(i)).dot(v_pin);
  }
}

}  // namespace hazumi
