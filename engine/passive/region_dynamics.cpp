#include "engine/passive/region_dynamics.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

// Largest number of free hinges of an island whose contacts are solved with matrices.
constexpr int kMostByMatrices = 64;

}  // namespace

RegionDynamics::RegionDynamics(RegionModel model, ForceLaws laws, double gravity,
                               std::vector<ConstraintSpec> constraints, ContactSpec contacts)
    : model_(std::move(model)),
      layout_(model_, /*balls=*/true),
      hinge_layout_(model_, /*balls=*/false),
      kinematics_(model_),
      dense_(model_),
      tree_(model_),
      laws_(std::move(laws)),
      rows_(std::move(constraints)),
      contacts_(std::move(contacts)),
      has_rows_(rows_.any() || contacts_.is_possible()),
      outer_layout_(/*has_anchor=*/false, /*num_balls=*/0),
      gravity_(gravity) {
  while (!model_.nodes[first_moved_].is_dynamic) ++first_moved_;
  for (const auto& law : laws_) {
    (law->is_rule() ? has_rules_ : has_forces_) = true;
    has_outer_ |= law->is_outer();
    has_kinks_ |= law->has_kinks();
    has_other_kinks_ |= law->has_kinks() && !law->is_spring();
    has_springs_ |= law->is_spring();
  }
  const std::vector<char> weightless = WeightlessNodes(model_);
  has_weightless_ = std::find(weightless.begin(), weightless.end(), 1) != weightless.end();
  has_outer_ |= has_rows_;
  if (has_outer_) {
    places_.resize(model_.num_nodes());
    velocities_.resize(model_.nodes.size());
  }
  outer_layout_ = OuterLayout(is_pushed_in_flight(), static_cast<int>(model_.balls.size()));
  outer_.balls.resize(model_.balls.size());
  falls_.setZero(outer_layout_.num_jumps());
  added_.setZero(num_hinges());
  contacts_by_tree_ = SolvesContactsByTree();
}

double RegionDynamics::FastestRate() const {
  double rate = rows_.FastestRate();
  for (const auto& law : laws_) rate = std::max(rate, law->FastestRate());
  return rate;
}

void RegionDynamics::SetCurves(const DrivenMotion* driven, double start) {
  driven_ = driven;
  if (first_moved_ == 0) return;
  is_carrier_still_ = !has_rows_ && IsCarrierStill();
  if (is_carrier_still_) PlaceStillCarrier(start);
}

// Where it is, it stays: the nodes that move it are placed once.
void RegionDynamics::PlaceStillCarrier(double t) {
  kinematics_.Move(layout_, *driven_, t, nullptr, nullptr, 0, first_moved_);
  NodeMotion& carrier = kinematics_.motion()[model_.nodes[first_moved_].parent];
  carrier.a += BaseAcceleration(t);
}

bool RegionDynamics::IsCarrierStill() const {
  for (int i = 0; i < first_moved_; ++i) {
    if (model_.nodes[i].role == Role::kDriven) return false;
  }
  const auto& root = driven_->root_position;
  const auto accelerates = [](const DrivenCurve& curve) { return curve.degree > 1; };
  return model_.coupling == RootCoupling::kPinned ||
         std::none_of(root.begin(), root.end(), accelerates);
}

// A pinned root that answers couples every joint with the pin, which is solved the dense way unless
// that takes too long; with rows only that is written. So it is for rules that the root has to
// answer where nothing else acts on it.
bool RegionDynamics::UsesArticulatedBodies() const {
  if (!model_.root_answers) return true;
  const bool answers_rules = has_rules_ && model_.nodes[0].role == Role::kFree;
  if (model_.coupling == RootCoupling::kFlight) return has_rows_ || !answers_rules;
  return !has_any_rows() && !answers_rules && model_.num_free > most_dense_;
}

// Returns whether contacts are solved by the tree. Excludes islands in which rows couple two
// bodies: constraints, contacts of links with each other or with balls, and a pin whose root is
// dynamic.
bool RegionDynamics::SolvesContactsByTree() const {
  const bool has_pin = model_.root_answers && model_.coupling != RootCoupling::kFlight;
  const bool ties = rows_.any() || !contacts_.spec().own.empty() || !model_.balls.empty();
  return contacts_.rules().sweeps_large_islands && contacts_.is_possible() && !has_pin && !ties &&
         !has_implicit_springs() && model_.num_free > kMostByMatrices;
}

// x_0 of nodes that have been moved.
void RegionDynamics::SolveWithoutRows(const RegionLayout& layout, double* x) {
  by_bodies_ = UsesArticulatedBodies();
  if (by_bodies_) {
    tree_.Solve(layout, kinematics_.motion(), x);
  } else {
    dense_.Assemble(layout, &kinematics_.motion());
    dense_.Solve(layout, x);
  }
}

void RegionDynamics::Move(double t, const RegionLayout& layout, const double* positions,
                          const double* velocities) {
  const int count = kinematics_.size();
  if (has_rows_) {  // which may hang on more carriers than one
    kinematics_.Move(layout, *driven_, t, positions, velocities, 0, count);
    return AskForForces(BaseAcceleration(t), StateAt(t, layout, positions, velocities));
  }
  if (first_moved_ > 0 && !is_carrier_still_) MoveCarrier(t);
  kinematics_.Move(layout, *driven_, t, positions, velocities, first_moved_, count);
  AskForForces(first_moved_ > 0 ? V3() : BaseAcceleration(t),
               StateAt(t, layout, positions, velocities));
}

// What the nodes ask for, accelerated by `base` on top, what the laws give them taken off.
void RegionDynamics::AskForForces(const V3& base, const RegionState& state) {
  if (has_forces_ || has_rows_) kinematics_.ClearForces();  // of nodes that weigh nothing here too
  kinematics_.SetOwnForces(base);
  if (has_outer_) PlaceNodes(state.t);
  if (adds_rows_) AddRowForces(RowsOf::kAll);
  frozen_.AddTo(&kinematics_);
  AccelerateBalls();
  if (!has_forces_) return;
  frozen_.AddSpringsTo(&kinematics_);
  for (const auto& law : laws_) {
    if (!frozen_.holds_springs || !law->is_spring()) law->AddForces(state, &kinematics_);
  }
}

RegionState RegionDynamics::StateAt(double t, const RegionLayout& layout, const double* positions,
                                    const double* velocities) const {
  return {t, model_, layout, *driven_, kinematics_, positions, velocities, places_};
}

std::shared_ptr<const MovingBase> RegionDynamics::FitMovingBase(double start, double end) {
  return std::make_shared<const MovingBase>(start, end, SmoothUntil(end),
                                            [&](double t) { return CarrierAt(t); });
}

MovingBase::Frame RegionDynamics::CarrierAt(double t) {
  const NodeMotion& own = kinematics_.motion()[model_.nodes[first_moved_].parent];
  kinematics_.Move(layout_, *driven_, t, nullptr, nullptr, 0, first_moved_);
  return {own.R, own.w, own.alpha, own.a + BaseAcceleration(t)};
}

void RegionDynamics::MoveCarrier(double t) {
  // Laws that act from outside ask for more of the chain than a moving base knows.
  const bool is_fitted = !has_outer_ && moving_base_->Covers(t);
  const MovingBase::Frame frame = is_fitted ? moving_base_->At(t) : CarrierAt(t);
  NodeMotion& own = kinematics_.motion()[model_.nodes[first_moved_].parent];
  own.R = frame.R;
  own.w = frame.w;
  own.alpha = frame.alpha;
  own.a = frame.a;
}

// What every point of the figure has on top of its motion about the root: the root's acceleration
// minus gravity. In flight the figure falls freely, so it feels neither.
V3 RegionDynamics::BaseAcceleration(double t) const {
  const V3 up(0.0, 0.0, gravity_);
  if (model_.coupling == RootCoupling::kFlight) return {};
  if (model_.coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = kinematics_.motion()[model_.pin_node];
    const V3 r = pin.R * V3(model_.p_pin);
    return up - (pin.a + Cross(pin.alpha, r) + Cross(pin.w, Cross(pin.w, r)));
  }
  const auto& root = driven_->root_position;
  return up + V3(root[0].At(t).dd, root[1].At(t).dd, root[2].At(t).dd);
}

RegionState RegionDynamics::PlaceAt(double t, const double* y) {
  constexpr double kPlacing = 0.3;  // cost of a placement in evaluations
  other_work_.searches += kPlacing;
  SetOuterOf(y);
  const double* velocities = y + layout_.num_positions();
  Move(t, layout_, y, velocities);
  return StateAt(t, layout_, y, velocities);
}

RegionState RegionDynamics::PlaceHinges(double t, const VecX& q, const VecX& qd) {
  Move(t, hinge_layout_, q.data(), qd.data());
  return StateAt(t, hinge_layout_, q.data(), qd.data());
}

std::vector<SpentDrive> RegionDynamics::SpentDrives(double t, const VecX& q, const VecX& qd) {
  std::vector<SpentDrive> spent;
  if (!has_kinks_) return spent;  // what can be spent has a kink there
  const RegionState state = PlaceHinges(t, q, qd);
  for (const auto& law : laws_) law->ListSpent(state, &spent);
  return spent;
}

void RegionDynamics::Derivative(double t, const double* y, double* dy) {
  ++evaluations_;
  Look(t, y, dy);
}

void RegionDynamics::Look(double t, const double* y, double* dy) {
  SetOuterOf(y);
  const double* velocities = y + layout_.num_positions();
  double* x = dy + layout_.num_positions();
  if (has_rows_ && rows_.any_yielding() && is_any_locked()) YieldAsIfFree(t, y);
  Move(t, layout_, y, velocities);
  SolveWithoutRows(layout_, x);
  if (has_rules_ || has_rows_) {
    const RegionState state = StateAt(t, layout_, y, velocities);
    AddRules(state, x);
    if (has_rows_) KeepTogether(state, x);
  }
  if (outer_layout_.size() > 0) DeriveOuter(y, dy);
  for (const RegionLayout::Node& own : layout_.nodes()) {
    if (own.kind == RegionLayout::NodeKind::kHinges) {
      std::copy_n(velocities + own.dof, own.num_dofs, dy + own.position);
    }
    if (own.kind != RegionLayout::NodeKind::kBall) continue;
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

void RegionDynamics::AddRules(const RegionState& state, double* x) {
  for (const auto& law : laws_) {
    if (!law->is_rule()) continue;
    AddRule(*law, state);
    for (int i = 0; i < state.layout.num_dofs(); ++i) x[i] += added_[i];
  }
}

// Sets added_ to what a rule adds.
void RegionDynamics::AddRule(const ForceLaw& rule, const RegionState& state) {
  added_.setConstant(-0.0);  // which leaves the sign of any zero that is added
  rule.AddAccelerations(state, added_.data());
  if (model_.root_answers && model_.nodes[0].role == Role::kFree) AnswerRule(state.layout);
}

// What a rule does inside the figure leaves its angular momentum alone: the root is solved again.
void RegionDynamics::AnswerRule(const RegionLayout& layout) {
  if (layout.node(0).num_dofs == 0) return;
  Vec3 answer = Vec3::Zero();
  if (by_bodies_) {
    const Mat3 M_rr = AnswerOfBodies(layout, &answer);
    added_.head<3>() = M_rr.ldlt().solve(answer);
    return;
  }
  const MatX& M = dense_.equations().M;
  for (int j = 3; j < layout.num_dofs(); ++j) answer -= M.block<3, 1>(0, j) * added_[j];
  const Mat3 M_rr = M.topLeftCorner<3, 3>();
  added_.head<3>() = M_rr.ldlt().solve(answer);
}

// The same by what all bodies do together about their centre c: what their accelerations ask for,
// and their inertia, along the root's directions. Bodies' m, h, I are their own.
Mat3 RegionDynamics::AnswerOfBodies(const RegionLayout& layout, Vec3* answer) {
  const auto& motion = kinematics_.motion();
  std::vector<V3>& alpha = answer_alpha_;
  std::vector<V3>& a = answer_a_;
  alpha.assign(motion.size(), V3());
  a.assign(motion.size(), V3());
  V3 force, moment, sum;
  S3 I;
  for (int i = 0; i < kinematics_.size(); ++i) {
    const NodeMotion& own = motion[i];
    const int parent = model_.nodes[i].parent;
    if (parent >= 0) {
      alpha[i] = alpha[parent];
      a[i] = a[parent] + Cross(alpha[parent], own.r);
      const RegionLayout::Node& where = layout.node(i);
      for (int k = 0; k < where.num_dofs; ++k) alpha[i] += added_[where.dof + k] * own.axis[k];
    }
    if (!model_.nodes[i].is_dynamic) continue;
    const V3 f = own.m * a[i] + Cross(alpha[i], own.h);
    force += f;
    moment += own.I * alpha[i] + Cross(own.h, a[i]) + Cross(own.p, f);
    sum += own.m * own.p + own.h;
    const V3 g = own.h + own.m * own.p;
    I += own.I;
    I += Diagonal(Dot(own.p, own.h) + Dot(own.p, g));
    I += S3{-own.p.x * own.h.x - g.x * own.p.x, -own.p.x * own.h.y - g.x * own.p.y,
            -own.p.x * own.h.z - g.x * own.p.z, -own.p.y * own.h.y - g.y * own.p.y,
            -own.p.y * own.h.z - g.y * own.p.z, -own.p.z * own.h.z - g.z * own.p.z};
  }
  if (model_.coupling == RootCoupling::kFlight) {
    const V3 c = (1.0 / model_.mass) * sum;
    moment = moment - Cross(c, force);
    I += Diagonal(-Dot(c, sum));
    I += S3{c.x * sum.x, c.x * sum.y, c.x * sum.z, c.y * sum.y, c.y * sum.z, c.z * sum.z};
  }
  Mat3 M_rr;
  for (int k = 0; k < 3; ++k) {
    const V3& axis = motion[0].axis[k];
    (*answer)[k] = -Dot(axis, moment);
    const V3 turned = I * axis;
    for (int l = 0; l < 3; ++l) M_rr(l, k) = Dot(motion[0].axis[l], turned);
  }
  return M_rr;
}

void RegionDynamics::AssembleHinges(double t, const VecX& q, const VecX& qd) {
  ++evaluations_;
  ++num_assembled_;
  Move(t, hinge_layout_, q.data(), qd.data());
  dense_.Assemble(hinge_layout_, &kinematics_.motion());
  by_bodies_ = assembled_some_ = false;
  if (has_rows_) AssembleHingeRows(StateAt(t, hinge_layout_, q.data(), qd.data()));
}

void RegionDynamics::AssembleSome(const std::vector<int>& hinges, double t, const VecX& q,
                                  const VecX& qd) {
  ++evaluations_;
  Move(t, hinge_layout_, q.data(), qd.data());
  tree_.AssembleSome(hinge_layout_, kinematics_.motion(), hinges);
  assembled_some_ = true;
}

}  // namespace hazumi
