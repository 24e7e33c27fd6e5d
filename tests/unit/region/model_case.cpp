#include "tests/unit/region/model_case.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <limits>
#include <utility>

#include "engine/region/forces/force_spec.h"

namespace hazumi::test {

namespace {

Mat3 Turn(const Vec3& axis, double angle) {
  return AxisRotation<double>(axis, std::sin(angle), std::cos(angle));
}

}  // namespace

// R = Rz Ry Rx;  w = sum of axis_i rate_i;  alpha = sum of axis_i acc_i + w_i x axis_i rate_i.
RootHinges HingesOf(const MovingRoot& root) {
  const Mat3 R = root.X_WR().R;
  const RootMotion motion = root.Motion();
  RootHinges hinges;
  hinges.angle = {std::atan2(R(1, 0), R(0, 0)), std::asin(-R(2, 0)), std::atan2(R(2, 1), R(2, 2))};
  const Mat3 Rz = Turn(Vec3::UnitZ(), hinges.angle[0]);
  Mat3 axes;
  axes << Vec3::UnitZ(), Rz.col(1), Rz * Turn(Vec3::UnitY(), hinges.angle[1]).col(0);
  const Eigen::PartialPivLU<Mat3> lu(axes);
  hinges.rate = lu.solve(motion.w);
  Vec3 alpha = motion.alpha, w = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = axes.col(i);
    alpha -= w.cross(axis) * hinges.rate[i];
    w += axis * hinges.rate[i];
  }
  hinges.acceleration = lu.solve(alpha);
  return hinges;
}

DrivenCurve CurveThrough(double t, double value, double rate, double acceleration, Random* random) {
  DrivenCurve curve;
  const double s = random->Uniform(-1.0, 1.0);
  curve.start = t - s;
  curve.degree = random->Integer(2, 5);
  std::array<double, DrivenCurve::kMaxDegree + 1> about_t{};
  about_t[0] = value;
  about_t[1] = rate;
  about_t[2] = 0.5 * acceleration;
  for (int i = 3; i <= curve.degree; ++i) about_t[i] = random->Uniform(-20.0, 20.0);
  for (int i = curve.degree; i >= 0; --i) {  // c := c (x - s) + about_t[i]
    for (int p = curve.degree; p > 0; --p) curve.c[p] = curve.c[p - 1] - s * curve.c[p];
    curve.c[0] = about_t[i] - s * curve.c[0];
  }
  return curve;
}

ModelCase::ModelCase(uint64_t seed, RootCoupling coupling, bool is_root_free)
    : sample(seed, Root::kMoving, Vec3(0, 0, -kGravity)), t(sample.random.Uniform(0.0, 2.0)) {
  request.coupling = coupling;
  request.pin = JointIndex(sample.random.Integer(0, sample.figure.num_joints() - 1));
  ChooseRoles(is_root_free);
  const RootHinges root = HingesOf(sample.moving_root);
  const int n = sample.figure.num_joints();
  q.resize(n + kRootAngles);
  qd.resize(n + kRootAngles);
  q << sample.q, root.angle;
  qd << sample.qd, root.rate;
  request.angles = q;
  SetCurves();
  const MovingRoot& moving = sample.moving_root;
  sample.mujoco.SetState(MujocoFigure::Join(moving.p, moving.angle, sample.q),
                         MujocoFigure::Join(moving.v, moving.rate, sample.qd));
}

void ModelCase::ChooseRoles(bool is_root_free) {
  Random& random = sample.random;
  const int n = sample.figure.num_joints();
  const double free_share = random.Uniform(0.2, 1.0), driven_share = random.Uniform(0.0, 1.0);
  for (int j = 0; j < n; ++j) {
    Role role = random.Chance(driven_share) ? Role::kDriven : Role::kConstant;
    if (random.Chance(free_share)) role = Role::kFree;
    if (role == Role::kFree) free.emplace_back(j);
    if (role == Role::kConstant) sample.qd[j] = sample.qdd[j] = 0.0;
    request.roles.push_back(role);
  }
  if (free.empty()) {
    free.emplace_back(n - 1);
    request.roles.back() = Role::kFree;
  }
  Role root = random.Chance(0.3) ? Role::kConstant : Role::kDriven;
  if (root == Role::kConstant && !is_root_free) {
    sample.moving_root.rate.setZero();
    sample.moving_root.acceleration.setZero();
  }
  if (is_root_free) root = Role::kFree;
  request.roles.insert(request.roles.end(), kRootAngles, root);
}

void ModelCase::SetCurves() {
  Random& random = sample.random;
  const RootHinges root = HingesOf(sample.moving_root);
  VecX qdd(q.size());
  qdd << sample.qdd, root.acceleration;
  driven.angles.resize(q.size());
  for (int c = 0; c < q.size(); ++c) {
    if (request.roles[c] != Role::kDriven) continue;
    driven.angles[c] = CurveThrough(t, q[c], qd[c], qdd[c], &random);
  }
  const MovingRoot& moving = sample.moving_root;
  for (int i = 0; i < 3; ++i) {
    driven.root_position[i] = CurveThrough(t, moving.p[i], moving.v[i], moving.a[i], &random);
  }
}

PassiveState ModelCase::State() const {
  constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();
  PassiveState state{sample.moving_root.X_WR(), sample.moving_root.Motion(), sample.q, sample.qd,
                     sample.qdd};
  if (request.coupling != RootCoupling::kPrescribed) state.root.a.setConstant(kNotRead);
  for (const JointIndex j : free) state.qdd[j.value()] = kNotRead;
  return state;
}

std::vector<RegionDynamics> ModelCase::Models(const VecX* friction) const {
  std::vector<RegionDynamics> all;
  for (RegionModel& model : CompileRegionModels(sample.figure, request)) {
    RegionDynamics dynamics(model, ForceLaws(), kGravity);
    if (friction)
      dynamics = RegionDynamics(model, FrictionAlone(Gather(dynamics, *friction)), kGravity);
    dynamics.SetDriven(&driven, t - 0.05, t + 0.05);
    all.push_back(std::move(dynamics));
  }
  return all;
}

VecX ModelCase::FreeRows(const VecX& mujoco_coordinates) const {
  VecX rows(free.size());
  for (size_t i = 0; i < free.size(); ++i) {
    rows[i] = mujoco_coordinates[MujocoFigure::kRootDof + free[i].value()];
  }
  return rows;
}

VecX Gather(const RegionDynamics& dynamics, const VecX& all) {
  VecX some(dynamics.num_hinges());
  for (int i = 0; i < some.size(); ++i) some[i] = all[dynamics.hinges()[i].coordinate];
  return some;
}

VecX HingeAccelerations(RegionDynamics* dynamics, double t, const VecX& q, const VecX& qd) {
  const HingeEquations equations = dynamics->AssembleHinges(t, {q, qd});
  return equations.M().llt().solve(-equations.b());
}

VecX VelocityDerivatives(RegionDynamics* dynamics, double t, const VecX& q, const VecX& qd) {
  VecX y(dynamics->layout().state_size()), dy(dynamics->layout().state_size());
  dynamics->layout().Pack(q, qd, y.data());
  dynamics->Derivative(t, y.data(), dy.data());
  return dy.tail(dynamics->layout().num_dofs());
}

// With u_i the axes in the body's frame, w = sum of u_i rate_i and u_i' = -(sum over j > i of
// u_j rate_j) x u_i.
VecX MapToBalls(const RegionModel& model, const VecX& q, const VecX& qd, const VecX& qdd) {
  VecX mapped = qdd;
  int first = 0;
  for (const ModelNode& node : model.nodes) {
    if (node.role != Role::kFree) continue;
    if (node.is_ball) {
      Mat3 R = Mat3::Identity();
      Vec3 w = Vec3::Zero(), w_dot = Vec3::Zero();
      for (int h = 2; h >= 0; --h) {
        const Vec3 axis = R * node.hinges[h].axis;
        w_dot += axis * qdd[first + h] - w.cross(axis) * qd[first + h];
        w += axis * qd[first + h];
        R = R * Turn(node.hinges[h].axis, -q[first + h]);
      }
      mapped.segment<3>(first) = w_dot;
    }
    first += node.num_hinges;
  }
  return mapped;
}

}  // namespace hazumi::test
