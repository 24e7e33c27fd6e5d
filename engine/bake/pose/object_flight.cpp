// In the air, from p0 with v and w:  p = p0 + v t - g t^2 / 2 z,  R = exp(w t) R0.
//
// The hinges of the ball joint that it is are those of R = R0 Rz Ry Rx, far from their pole as it
// begins.

#include "engine/bake/pose/object_flight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "engine/bake/pose/contact_obstacles.h"
#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

constexpr int kHinges = 3;
constexpr int kAxisOf[kHinges] = {2, 1, 0};  // z, y, x
// One body costs next to nothing.
constexpr double kStepTolerance = 1e-10;  // [rad], and of places [m]
constexpr double kLongestStep = 0.1;      // so that nothing is passed by [s]
constexpr double kNever = 1e6;            // [s]

RegionModel ModelOf(double mass, double radius, const Mat3& R) {
  RegionModel model;
  ModelNode node;
  node.role = Role::kFree;
  node.num_hinges = kHinges;
  for (int i = 0; i < kHinges; ++i) {
    node.hinges[i] = {i, Vec3::Unit(kAxisOf[i]), kAxisOf[i], 1.0};
  }
  node.is_ball = node.is_dynamic = true;
  node.body = SolidSphere(Vec3::Zero(), radius, mass);
  model.nodes.push_back(node);
  model.R_root = R;
  model.coupling = RootCoupling::kFlight;
  model.root_answers = true;
  model.mass = mass;
  model.num_free = kHinges;
  model.num_bodies = 1;
  return model;
}

VecX Infinite() { return VecX::Constant(kHinges, std::numeric_limits<double>::infinity()); }

}  // namespace

BodyMotion Falling(const BodyMotion& start, double seconds, double gravity) {
  HAZUMI_ASSERT(std::isfinite(seconds));
  const double t = seconds;
  const Vec3 fall(0.0, 0.0, -0.5 * gravity * t * t);
  BodyMotion now = {{start.X_WB.R, start.X_WB.p + start.v * t + fall},
                    start.v - gravity * t * Vec3::UnitZ(),
                    start.w};
  const double turn = start.w.norm() * t;
  if (turn == 0.0) return now;
  now.X_WB.R = Eigen::AngleAxisd(turn, start.w.normalized()).toRotationMatrix() * start.X_WB.R;
  return now;
}

ObjectFlight::Run::Run(const RegionModel& model, double gravity, const ContactSpec& contacts)
    : dynamics(model, {}, gravity, {}, contacts), solver(&dynamics, -Infinite(), Infinite()) {
  nothing.angles.resize(kHinges);
  dynamics.kinematics().SetCurves(&nothing, 0.0, dynamics.layout());
  solver.SetTolerance(kStepTolerance);
  solver.SetLongestStep(kLongestStep);
}

ObjectFlight::ObjectFlight(const HeldObject& object, const std::vector<SceneObject>& scene,
                           double gravity, double start, const BodyMotion& from,
                           const SolverRules& rules)
    : gravity_(gravity), start_(start), from_(from) {
  const double radius = std::get<SphereShape>(object.shape).radius;
  model_ = ModelOf(object.mass, radius, from.X_WB.R);
  contacts_.rules = rules;
  contacts_.obstacles = ObstaclesOf(scene, object.friction);
  contacts_.capsules = {{0, Vec3::Zero(), Vec3::Zero(), radius, -1, object.restitution}};
  Begin();
}

void ObjectFlight::Begin() {
  HAZUMI_ASSERT(IsRotation(from_.X_WB.R) && IsFinite(from_.v) && IsFinite(from_.w));
  HAZUMI_ASSERT(model_.mass > 0.0);
  run_ = std::make_unique<Run>(model_, gravity_, contacts_);
  stuck_from_.reset();
  is_stopped_ = false;
  const Vec3 w = from_.X_WB.R.transpose() * from_.w;
  last_ = {VecX::Zero(kHinges), VecX(kHinges), {{from_.X_WB.p, from_.v}, {}}};
  for (int i = 0; i < kHinges; ++i) last_.qd[i] = w[kAxisOf[i]];
  run_->solver.Start(start_, last_);
}

BodyMotion ObjectFlight::At(double seconds) {
  if (seconds <= start_) return from_;
  ExactSolver* solver = &run_->solver;
  if (seconds < stuck_from_.value_or(solver->step_start())) {
    Begin();
    solver = &run_->solver;
  }
  while (solver->time() < seconds && !stuck_from_) Step();
  return MotionOf(stuck_from_ ? last_ : Sample(seconds));
}

// Takes a step, or stops a ball that jams where it is: where forces of time stepping [METHOD 12.4]
// of a ball that is wedged do not find together they would make it spin.
void ObjectFlight::Step() {
  constexpr double kSlack = 1e-3;
  ExactSolver& solver = run_->solver;
  const double t = solver.time();
  const bool has_failed = solver.Advance(start_ + kNever).has_value();
  if (!has_failed) {
    HingeState now = Sample(solver.time());
    const double weight = model_.mass * gravity_ * radius();
    const double slack = kSlack * (KineticOf(last_) + weight) + GainOfComingOut(DepthOf(last_));
    if (EnergyOf(now) <= EnergyOf(last_) + slack) {
      last_ = std::move(now);
      is_stopped_ = false;
      return;
    }
  }
  last_.qd.setZero();
  last_.outer.anchor.v.setZero();
  if (has_failed || is_stopped_) {
    stuck_from_ = t;
    return;
  }
  is_stopped_ = true;
  solver.Start(t, last_);
}

double ObjectFlight::DepthOf(const HingeState& state) const {
  MovingCapsule ball;
  ball.a = ball.b = small::V3(state.outer.anchor.p);
  ball.radius = radius();
  double depth = 0.0;
  for (const ContactObstacle& obstacle : contacts_.obstacles) {
    depth = std::max(depth, -LeastGap(ball, obstacle));
  }
  return depth;
}

// Returns the energy that one time step may add to a ball that begins inside something and is
// pushed out slowly.
double ObjectFlight::GainOfComingOut(double depth) const {
  constexpr double kShare = 100.0, kFastest = 0.1, kLongest = 8e-3;  // [1/s, m/s, s]
  constexpr double kWays = 4.0;  // that it may be pushed at once, amply
  const double v = std::min(kShare * depth, kFastest);
  return kWays * model_.mass * v * (0.5 * v + gravity_ * kLongest);
}

// Returns the state inside the present step.
HingeState ObjectFlight::Sample(double seconds) {
  HingeState state;
  run_->solver.Sample(seconds, &state);
  return state;
}

BodyMotion ObjectFlight::MotionOf(const HingeState& state) const {
  BodyMotion now;
  now.X_WB = {model_.R_root, state.outer.anchor.p};
  now.v = state.outer.anchor.v;
  for (int i = 0; i < kHinges; ++i) {
    const Vec3 axis = Vec3::Unit(kAxisOf[i]);
    now.w += state.qd[i] * (now.X_WB.R * axis);
    now.X_WB.R = now.X_WB.R * Eigen::AngleAxisd(state.q[i], axis).toRotationMatrix();
  }
  return now;
}

double ObjectFlight::KineticOf(const HingeState& state) const {
  const LooseBall ball = {model_.mass, model_.nodes[0].body.I_com(0, 0)};
  return ball.KineticEnergy(MotionOf(state));
}

double ObjectFlight::EnergyOf(const HingeState& state) const {
  return KineticOf(state) + model_.mass * gravity_ * state.outer.anchor.p.z();
}

}  // namespace hazumi
