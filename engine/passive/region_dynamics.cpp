#include "engine/passive/region_dynamics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/passive/semidefinite.h"

// For every node i with parent p, at accelerations zero of all free hinges:
//   outwards  R, p, w, alpha, a of the node (as kinematics.h)
//   body      f = m (a + alpha x c + w x (w x c)),  n = I alpha + w x I w + c x f
//   inwards   sums of f, n and of the composite body (m, h = m c, I about the node's origin)
// and for every free direction e of node i, the composite beyond it needs, per unit acceleration,
//   f = e x h,  n = I e;   M(e', e) = e' . n about the origin of e', for e' between i and the root
//   b(e) = e . n_i
// [Luh, Walker, Paul 1980] for b, composite rigid bodies [Featherstone 2008, 6.2] for M.

namespace hazumi {

namespace {

// R := R Rot(axis, angle). About a coordinate axis only two columns change.
void Turn(const NodeHinge& hinge, double angle, Mat3* R) {
  const double s = std::sin(angle), c = std::cos(angle);
  if (hinge.cardinal == 3) {
    *R = (*R * AxisRotation<double>(hinge.axis, s, c)).eval();
    return;
  }
  const int i = (hinge.cardinal + 1) % 3, j = (hinge.cardinal + 2) % 3;
  const Vec3 u = R->col(i), v = R->col(j);
  R->col(i) = c * u + s * v;
  R->col(j) = c * v - s * u;
}

// The rotation of a quaternion (w, x, y, z) of any length.
Mat3 RotationOf(const double* q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double s = 2.0 / (w * w + x * x + y * y + z * z);
  Mat3 R;
  R << 1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x),   //
      s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y);
  return R;
}

}  // namespace

RegionDynamics::RegionDynamics(RegionModel model, VecX friction, double gravity)
    : model_(std::move(model)),
      triple_of_(model_.nodes.size(), -1),
      friction_(std::move(friction)),
      gravity_(gravity),
      motion_(model_.nodes.size()) {
  for (int i = 0; i < static_cast<int>(model_.nodes.size()); ++i) {
    const ModelNode& node = model_.nodes[i];
    if (node.role != Role::kFree) continue;
    for (int h = 0; h < node.num_hinges; ++h) hinges_.push_back({node.hinges[h].coordinate, i, h});
    if (!node.is_ball) continue;
    triple_of_[i] = static_cast<int>(triples_.size());
    triples_.emplace_back(node.hinges[0].axis, node.hinges[1].axis, node.hinges[2].axis);
  }
  has_friction_ = !friction_.isZero(0.0);
  const std::vector<char> none(hinges_.size(), 0);
  const VecX zero = VecX::Zero(num_hinges());
  hinge_layout_ = MakeLayout(none, zero, /*balls=*/false);
  layout_ = MakeLayout(none, zero, /*balls=*/true);
  const int k = num_hinges();
  M_.resize(k, k);
  L_.resize(k, k);
  for (VecX* x : {&b_, &x_, &damping_, &scratch_}) x->resize(k);
  F_.setZero(3, k);
  J_.setZero(3, k);
}

RegionDynamics::Layout RegionDynamics::MakeLayout(const std::vector<char>& locked,
                                                  const VecX& angles, bool balls) const {
  Layout layout;
  layout.nodes.resize(model_.nodes.size());
  int hinge = 0;
  for (size_t i = 0; i < model_.nodes.size(); ++i) {
    const ModelNode& node = model_.nodes[i];
    NodeLayout& own = layout.nodes[i];
    if (node.role != Role::kFree) {
      own.kind = node.num_hinges > 0 ? NodeKind::kDriven : NodeKind::kStill;
      continue;
    }
    own.first_hinge = hinge;
    int num_locked = 0;
    for (int h = 0; h < node.num_hinges; ++h, ++hinge) {
      own.locked[h] = locked[hinge];
      own.angle[h] = angles[hinge];
      num_locked += own.locked[h];
    }
    const bool ball = balls && node.is_ball && num_locked == 0;
    own.kind = ball ? NodeKind::kBall : NodeKind::kHinges;
    own.position = layout.num_positions;
    own.dof = layout.num_dofs;
    own.num_dofs = node.num_hinges - num_locked;
    layout.num_positions += ball ? 4 : own.num_dofs;
    layout.num_dofs += own.num_dofs;
    layout.is_quaternion.resize(layout.num_positions, ball);
  }
  return layout;
}

void RegionDynamics::SetLocked(const std::vector<char>& locked, const VecX& angles) {
  layout_ = MakeLayout(locked, angles, /*balls=*/true);
}

void RegionDynamics::Pack(const VecX& q, const VecX& qd, double* y) const {
  for (size_t i = 0; i < model_.nodes.size(); ++i) {
    const NodeLayout& own = layout_.nodes[i];
    double* position = y + own.position;
    double* velocity = y + num_positions() + own.dof;
    if (own.kind == NodeKind::kBall) {
      const HingeTriple& triple = triples_[triple_of_[i]];
      const Vec3 angles = q.segment<3>(own.first_hinge);
      const Eigen::Quaterniond turn(triple.Rotation(angles));
      Eigen::Map<Eigen::Vector4d>(position) << turn.w(), turn.x(), turn.y(), turn.z();
      Eigen::Map<Vec3>(velocity, 3) = triple.AxesInBody(angles) * qd.segment<3>(own.first_hinge);
    } else if (own.kind == NodeKind::kHinges) {
      for (int h = 0; h < model_.nodes[i].num_hinges; ++h) {
        if (own.locked[h]) continue;
        *position++ = q[own.first_hinge + h];
        *velocity++ = qd[own.first_hinge + h];
      }
    }
  }
}

void RegionDynamics::Unpack(const double* y, const VecX& lower, const VecX& upper, VecX* q,
                            VecX* qd) const {
  for (size_t i = 0; i < model_.nodes.size(); ++i) {
    const NodeLayout& own = layout_.nodes[i];
    const double* position = y + own.position;
    const double* velocity = y + num_positions() + own.dof;
    const int first = own.first_hinge;
    if (own.kind == NodeKind::kBall) {
      const HingeTriple& triple = triples_[triple_of_[i]];
      const Vec3 near = q->segment<3>(first);
      const Vec3 angles = triple.Angles(RotationOf(position), near, lower.segment<3>(first),
                                        upper.segment<3>(first));
      q->segment<3>(first) = angles;
      qd->segment<3>(first) = triple.Rates(angles, Eigen::Map<const Vec3>(velocity));
    } else if (own.kind == NodeKind::kHinges) {
      for (int h = 0; h < model_.nodes[i].num_hinges; ++h) {
        (*q)[first + h] = own.locked[h] ? own.angle[h] : *position++;
        (*qd)[first + h] = own.locked[h] ? 0.0 : *velocity++;
      }
    }
  }
}

void RegionDynamics::Move(double t, const Layout& layout, const double* positions,
                          const double* velocities) {
  for (int i = 0; i < static_cast<int>(motion_.size()); ++i) {
    MoveNode(t, i, layout.nodes[i], positions, velocities);
  }
}

void RegionDynamics::MoveNode(double t, int i, const NodeLayout& layout, const double* positions,
                              const double* velocities) {
  const ModelNode& node = model_.nodes[i];
  NodeMotion& own = motion_[i];
  if (node.parent < 0) {
    own.R = model_.R_root;
    for (Vec3* x : {&own.p, &own.w, &own.alpha, &own.a}) x->setZero();
  } else {
    const NodeMotion& parent = motion_[node.parent];
    const Vec3 r = parent.R * node.p_P;
    own.R = parent.R;
    own.p = parent.p + r;
    own.w = parent.w;
    own.alpha = parent.alpha;
    own.a = parent.a + parent.alpha.cross(r) + parent.w.cross(parent.w.cross(r));
  }
  if (layout.kind == NodeKind::kDriven) TurnDriven(t, node, &own);
  if (layout.kind == NodeKind::kHinges) TurnHinges(node, layout, positions, velocities, &own);
  if (layout.kind == NodeKind::kBall) TurnBall(layout, positions, velocities, &own);
}

void RegionDynamics::TurnDriven(double t, const ModelNode& node, NodeMotion* motion) const {
  for (int h = 0; h < node.num_hinges; ++h) {
    const NodeHinge& hinge = node.hinges[h];
    const Jet q = driven_->angles[hinge.coordinate].At(t);
    const Vec3 axis = motion->R * hinge.axis;
    motion->alpha += axis * q.dd + motion->w.cross(axis) * q.d;
    motion->w += axis * q.d;
    Turn(hinge, q.v, &motion->R);
  }
}

void RegionDynamics::TurnHinges(const ModelNode& node, const NodeLayout& layout,
                                const double* positions, const double* velocities,
                                NodeMotion* motion) const {
  int free = 0;
  for (int h = 0; h < node.num_hinges; ++h) {
    const NodeHinge& hinge = node.hinges[h];
    if (layout.locked[h]) {
      Turn(hinge, layout.angle[h], &motion->R);
      continue;
    }
    const double rate = velocities[layout.dof + free];
    const Vec3 axis =
        hinge.cardinal == 3 ? Vec3(motion->R * hinge.axis) : Vec3(motion->R.col(hinge.cardinal));
    motion->axis[free] = axis;
    motion->alpha += motion->w.cross(axis) * rate;
    motion->w += axis * rate;
    Turn(hinge, positions[layout.position + free], &motion->R);
    ++free;
  }
}

void RegionDynamics::TurnBall(const NodeLayout& layout, const double* positions,
                              const double* velocities, NodeMotion* motion) const {
  motion->R = (motion->R * RotationOf(positions + layout.position)).eval();
  for (int k = 0; k < 3; ++k) motion->axis[k] = motion->R.col(k);
  const Vec3 w = motion->R * Eigen::Map<const Vec3>(velocities + layout.dof);
  motion->alpha += motion->w.cross(w);
  motion->w += w;
}

// What every point of the figure has on top of its motion about the root: the root's acceleration
// minus gravity. In flight the figure falls freely, so it feels neither.
Vec3 RegionDynamics::BaseAcceleration(double t) const {
  const Vec3 up(0.0, 0.0, gravity_);
  if (model_.coupling == RootCoupling::kFlight) return Vec3::Zero();
  if (model_.coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = motion_[model_.pin_node];
    const Vec3 r = pin.R * model_.p_pin;
    return up - (pin.a + pin.alpha.cross(r) + pin.w.cross(pin.w.cross(r)));
  }
  const auto& root = driven_->root_position;
  return up + Vec3(root[0].At(t).dd, root[1].At(t).dd, root[2].At(t).dd);
}

void RegionDynamics::StartForces(double t) {
  const Vec3 base = BaseAcceleration(t);
  for (size_t i = 0; i < motion_.size(); ++i) {
    NodeMotion& own = motion_[i];
    const RigidInertia& body = model_.nodes[i].body;
    if (!model_.nodes[i].is_dynamic) continue;
    own.m = body.mass;
    if (body.is_massless()) {
      for (Vec3* x : {&own.f, &own.n, &own.h}) x->setZero();
      own.I.setZero();
      continue;
    }
    const Vec3 c = own.R * body.com;
    const Mat3 RI = own.R * body.I_com;
    own.I.noalias() = RI * own.R.transpose();
    own.f = body.mass * (own.a + base + own.alpha.cross(c) + own.w.cross(own.w.cross(c)));
    own.n = own.I * own.alpha + own.w.cross(own.I * own.w) + c.cross(own.f);
    own.h = body.mass * c;
    own.I += PointInertia(body.mass, c);
  }
}

void RegionDynamics::Assemble(double t, const Layout& layout) {
  ++evaluations_;
  StartForces(t);
  M_.topLeftCorner(layout.num_dofs, layout.num_dofs).setZero();
  for (int i = static_cast<int>(motion_.size()) - 1; i >= 0; --i) {
    if (!model_.nodes[i].is_dynamic) continue;
    const NodeLayout& own = layout.nodes[i];
    for (int k = 0; k < own.num_dofs; ++k) {
      AssembleColumn(layout, i, own.dof + k, motion_[i].axis[k]);
      b_[own.dof + k] = motion_[i].axis[k].dot(motion_[i].n);
    }
    PassToParent(i);
  }
  if (model_.root_answers) Couple(layout);
}

void RegionDynamics::AssembleColumn(const Layout& layout, int node, int dof, const Vec3& axis) {
  const Vec3 f = axis.cross(motion_[node].h);
  Vec3 n = motion_[node].I * axis;
  Vec3 p = motion_[node].p;
  F_.col(dof) = f;
  for (int i = node; i >= 0 && model_.nodes[i].is_dynamic; i = model_.nodes[i].parent) {
    const NodeLayout& own = layout.nodes[i];
    if (own.num_dofs == 0) continue;
    n += (p - motion_[i].p).cross(f);
    p = motion_[i].p;
    for (int k = 0; k < own.num_dofs; ++k) {
      M_(own.dof + k, dof) = M_(dof, own.dof + k) = motion_[i].axis[k].dot(n);
    }
  }
}

void RegionDynamics::PassToParent(int node) {
  const int parent = model_.nodes[node].parent;
  if (parent < 0 || !model_.nodes[parent].is_dynamic) return;
  const NodeMotion& own = motion_[node];
  NodeMotion& to = motion_[parent];
  const Vec3 r = own.p - to.p;
  to.f += own.f;
  to.n += own.n + r.cross(own.f);
  to.m += own.m;
  to.h += own.h + own.m * r;
  const Mat3 rh = r * own.h.transpose();
  to.I += own.I - rh - rh.transpose() + PointInertia(own.m, r);
  to.I.diagonal().array() += 2.0 * r.dot(own.h);
}

// As RegionSystem: eliminates the root's translation.
void RegionDynamics::Couple(const Layout& layout) {
  if (model_.coupling == RootCoupling::kPinned) return ProjectOnPin(layout);
  const Vec3 f_root = motion_[0].f;
  for (int j = 0; j < layout.num_dofs; ++j) {
    const Vec3 column = F_.col(j) / model_.mass;
    for (int i = 0; i < layout.num_dofs; ++i) M_(i, j) -= F_.col(i).dot(column);
    b_[j] -= column.dot(f_root);
  }
}

void RegionDynamics::ProjectOnPin(const Layout& layout) {
  const Vec3 f_root = motion_[0].f;
  const NodeMotion& pin = motion_[model_.pin_node];
  const Vec3 p_pin = pin.p + pin.R * model_.p_pin;
  J_.leftCols(layout.num_dofs).setZero();
  for (int i = model_.pin_node; i >= 0; i = model_.nodes[i].parent) {
    const NodeLayout& own = layout.nodes[i];
    for (int k = 0; k < own.num_dofs; ++k) {
      J_.col(own.dof + k) = motion_[i].axis[k].cross(p_pin - motion_[i].p);
    }
  }
  for (int j = 0; j < layout.num_dofs; ++j) {
    const Vec3 push = model_.mass * J_.col(j) - F_.col(j);
    for (int i = 0; i < layout.num_dofs; ++i) {
      M_(i, j) += J_.col(i).dot(push) - F_.col(i).dot(J_.col(j));
    }
    b_[j] -= J_.col(j).dot(f_root);
  }
}

void RegionDynamics::Derivative(double t, const double* y, double* dy) {
  const int k = layout_.num_dofs;
  const double* velocities = y + num_positions();
  double* accelerations = dy + num_positions();
  Move(t, layout_, y, velocities);
  Assemble(t, layout_);
  L_.topLeftCorner(k, k) = M_.topLeftCorner(k, k);
  FactorSemidefinite(L_.topLeftCorner(k, k));
  x_.head(k) = -b_.head(k);
  SolveSemidefinite(L_.topLeftCorner(k, k), x_.head(k));
  if (has_friction_) Damp(y, x_.data());
  std::copy_n(x_.data(), k, accelerations);
  for (const NodeLayout& own : layout_.nodes) {
    if (own.kind == NodeKind::kHinges) {
      std::copy_n(velocities + own.dof, own.num_dofs, dy + own.position);
    }
    if (own.kind != NodeKind::kBall) continue;
    // q' = q (0, w) / 2
    const double* q = y + own.position;
    const double* w = velocities + own.dof;
    double* qd = dy + own.position;
    qd[0] = 0.5 * (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]);
    qd[1] = 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]);
    qd[2] = 0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]);
    qd[3] = 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
  }
}

void RegionDynamics::Damp(const double* y, double* x) {
  const int k = layout_.num_dofs;
  damping_.head(k).setZero();
  for (size_t i = 0; i < layout_.nodes.size(); ++i) {
    const NodeLayout& own = layout_.nodes[i];
    const double* v = y + num_positions() + own.dof;
    if (own.kind == NodeKind::kBall) {
      DampBall(static_cast<int>(i), own, y + own.position, v, damping_.data() + own.dof);
    } else if (own.kind == NodeKind::kHinges) {
      for (int h = 0, free = 0; h < model_.nodes[i].num_hinges; ++h) {
        if (own.locked[h]) continue;
        damping_[own.dof + free] = -friction_[own.first_hinge + h] * v[free];
        ++free;
      }
    }
  }
  if (model_.root_answers && model_.nodes[0].role == Role::kFree) AnswerDamping(damping_.head(k));
  for (int i = 0; i < k; ++i) x[i] += damping_[i];
}

// Equal factors: -c w. Unequal ones act on the hinges, but near the pole, where the hinges' rates
// have no bound, on the ball as their geometric mean. [METHOD 2]
void RegionDynamics::DampBall(int node, const NodeLayout& layout, const double* quaternion,
                              const double* w, double* x) const {
  constexpr double kFar = 10.0 * std::numbers::pi / 180.0;
  const Vec3 c = friction_.segment<3>(layout.first_hinge);
  const Eigen::Map<const Vec3> w_B(w);
  Eigen::Map<Vec3> damping(x);
  const double mean = c.mean();
  damping = -mean * w_B;
  if (c[0] == c[1] && c[1] == c[2]) return;
  const HingeTriple& triple = triples_[triple_of_[node]];
  const Vec3 ever = Vec3::Constant(1e9);
  const Vec3 q = triple.Angles(RotationOf(quaternion), Vec3::Zero(), -ever, ever);
  const double s = std::min(1.0, triple.FromPole(q[1]) / kFar);
  const double weight = s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
  if (weight == 0.0) return;
  const Vec3 rates = triple.Rates(q, w_B);
  damping -= weight * (triple.AxesInBody(q) * Vec3((c.array() - mean) * rates.array()));
}

// Friction inside the figure leaves its angular momentum alone: the root is solved again.
void RegionDynamics::AnswerDamping(const Eigen::Ref<const VecX>& damping) {
  const int k = static_cast<int>(damping.size());
  const int r = layout_.nodes[0].num_dofs;
  if (r == 0) return;
  Mat3 M_rr = M_.topLeftCorner<3, 3>();
  Vec3 answer = Vec3::Zero();
  for (int j = r; j < k; ++j) answer -= M_.block<3, 1>(0, j) * damping[j];
  damping_.head<3>() = M_rr.ldlt().solve(answer);
}

void RegionDynamics::AssembleHinges(double t, const VecX& q, const VecX& qd) {
  Move(t, hinge_layout_, q.data(), qd.data());
  Assemble(t, hinge_layout_);
}

// With Du = -v_pin - J Dy for the root:  H Dy + F^T Du = 0 along the motions that keep the pin
// still.
void RegionDynamics::PinBlow(const Vec3& v_pin, VecX* blow) const {
  for (int i = 0; i < num_hinges(); ++i) {
    (*blow)[i] = (F_.col(i) - model_.mass * J_.col(i)).dot(v_pin);
  }
}

void RegionDynamics::Distances(const VecX& q, const VecX& other, VecX* distances) const {
  *distances = (q - other).cwiseAbs();
  for (size_t i = 0; i < model_.nodes.size(); ++i) {
    if (triple_of_[i] < 0) continue;
    const HingeTriple& triple = triples_[triple_of_[i]];
    const int first = hinge_layout_.nodes[i].first_hinge;
    const Mat3 between =
        triple.Rotation(q.segment<3>(first)).transpose() * triple.Rotation(other.segment<3>(first));
    distances->segment<3>(first).setConstant(Eigen::AngleAxisd(between).angle());
  }
}

}  // namespace hazumi
