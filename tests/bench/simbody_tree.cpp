#include "tests/bench/simbody_tree.h"

#include <Simbody.h>

namespace hazumi::bench {

namespace {

SimTK::Vec3 ToSimbody(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

SimTK::Rotation ToSimbody(const Mat3& R) {
  return SimTK::Rotation(SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0),
                                      R(2, 1), R(2, 2)));
}

SimTK::Body::Rigid RigidBody(const SimbodyTree::Inertia& body) {
  const Mat3& I = body.I_origin;
  return SimTK::Body::Rigid(
      SimTK::MassProperties(body.mass, ToSimbody(body.com),
                            SimTK::Inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2))));
}

void Copy(const VecX& x, SimTK::Vector* y) {
  for (int i = 0; i < x.size(); ++i) (*y)[i] = x[i];
}

void Copy(const SimTK::Vector& x, VecX* y) {
  for (int i = 0; i < y->size(); ++i) (*y)[i] = x[i];
}

}  // namespace

struct SimbodyTree::System {
  explicit System(double g) : gravity(forces, matter, SimTK::Vec3(0, 0, -g)) {}

  void Add(const Body& body);
  void AddSprings(const Body& body);
  void Tie(const SimbodyTree::Tie& tie);
  SimTK::MobilizedBody& Mobilized(int body);
  SimTK::MobilizedBody Mobilized(const Body& body);
  void Integrate(SimTK::Integrator* integrator, double seconds);

  SimTK::MultibodySystem multibody;
  SimTK::SimbodyMatterSubsystem matter{multibody};
  SimTK::GeneralForceSubsystem forces{multibody};
  SimTK::Force::Gravity gravity;
  SimTK::Force::DiscreteForces applied{forces, matter};
  SimTK::State state, end;
  std::vector<SimTK::MobilizedBody> bodies;
  std::vector<int> coordinate_of_rate;  // -1 in a ball
  int num_coordinates = 0;
  long evaluations = 0;
  SimTK::Vector in, out, none;
  SimTK::Matrix M;
};

SimTK::MobilizedBody SimbodyTree::System::Mobilized(const Body& body) {
  using SimTK::MobilizedBody;
  MobilizedBody& parent = Mobilized(body.parent);
  const SimTK::Body::Rigid rigid = RigidBody(body.inertia);
  const SimTK::Transform X_PB(ToSimbody(body.R_PB), ToSimbody(body.p_PB));
  const SimTK::Transform X_BM(ToSimbody(body.R_BM)), X_PF = X_PB * X_BM;
  switch (body.mobilizer) {
    case Mobilizer::kPin:
      return MobilizedBody::Pin(parent, X_PF, rigid, X_BM);
    case Mobilizer::kUniversal:
      return MobilizedBody::Universal(parent, X_PF, rigid, X_BM);
    case Mobilizer::kGimbal:
      return MobilizedBody::Gimbal(parent, X_PF, rigid, X_BM);
    case Mobilizer::kBall:
      break;
  }
  return MobilizedBody::Ball(parent, X_PB, rigid, SimTK::Transform());
}

void SimbodyTree::System::Add(const Body& body) {
  bodies.push_back(Mobilized(body));
  const bool ball = body.mobilizer == Mobilizer::kBall;
  const int rates = ball ? 3 : static_cast<int>(body.mobilizer) + 1;
  for (int i = 0; i < rates; ++i) coordinate_of_rate.push_back(ball ? -1 : num_coordinates + i);
  num_coordinates += ball ? 4 : rates;  // a ball's are a quaternion
  AddSprings(body);
}

void SimbodyTree::System::AddSprings(const Body& body) {
  for (int i = 0; i < static_cast<int>(body.springs.size()); ++i) {
    const Spring& spring = body.springs[i];
    SimTK::Force::MobilityLinearSpring(forces, bodies.back(), SimTK::MobilizerQIndex(i),
                                       spring.stiffness, spring.angle);
    SimTK::Force::MobilityLinearDamper(forces, bodies.back(), SimTK::MobilizerUIndex(i),
                                       spring.damping);
  }
}

SimTK::MobilizedBody& SimbodyTree::System::Mobilized(int body) {
  return body < 0 ? matter.updGround() : bodies[body];
}

void SimbodyTree::System::Tie(const SimbodyTree::Tie& tie) {
  SimTK::Constraint::Ball(Mobilized(tie.a), ToSimbody(tie.p_a), Mobilized(tie.b),
                          ToSimbody(tie.p_b));
}

SimbodyTree::SimbodyTree(const std::vector<Body>& bodies, double gravity,
                         const std::vector<Tie>& ties)
    : system_(std::make_unique<System>(gravity)) {
  for (const Body& body : bodies) system_->Add(body);
  for (const SimbodyTree::Tie& tie : ties) system_->Tie(tie);
  const int rates = static_cast<int>(system_->coordinate_of_rate.size());
  system_->in = SimTK::Vector(rates, 0.0);
  system_->out = SimTK::Vector(rates, 0.0);
  system_->state = system_->multibody.realizeTopology();
  system_->multibody.realizeModel(system_->state);
}

SimbodyTree::~SimbodyTree() = default;

void SimbodyTree::SetState(const VecX& q, const VecX& u) {
  SimTK::Vector& q_out = system_->state.updQ();
  for (int i = 0; i < q.size(); ++i) {
    const int coordinate = system_->coordinate_of_rate[i];
    if (coordinate >= 0) q_out[coordinate] = q[i];
  }
  Copy(u, &system_->state.updU());
}

void SimbodyTree::SetBall(int body, const Mat3& R, const Vec3& w) {
  system_->bodies[body].setQToFitRotation(system_->state, ToSimbody(R));
  system_->bodies[body].setUToFitAngularVelocity(system_->state, ToSimbody(w));
}

void SimbodyTree::SetForces(const VecX& forces) {
  Copy(forces, &system_->in);
  system_->applied.setAllMobilityForces(system_->state, system_->in);
}

void SimbodyTree::InverseDynamics(const VecX& udot, VecX* forces) {
  System& s = *system_;
  Copy(udot, &s.in);
  s.multibody.realize(s.state, SimTK::Stage::Velocity);
  s.matter.calcResidualForceIgnoringConstraints(s.state, s.none, s.gravity.getBodyForces(s.state),
                                                s.in, s.out);
  Copy(s.out, forces);
}

void SimbodyTree::ComputeMassMatrix() {
  system_->multibody.realize(system_->state, SimTK::Stage::Position);
  system_->matter.calcM(system_->state, system_->M);
}

MatX SimbodyTree::MassMatrix() const {
  const SimTK::Matrix& M = system_->M;
  MatX out(M.nrow(), M.ncol());
  for (int i = 0; i < M.nrow(); ++i) {
    for (int j = 0; j < M.ncol(); ++j) out(i, j) = M(i, j);
  }
  return out;
}

void SimbodyTree::ForwardDynamics(VecX* udot) {
  system_->multibody.realize(system_->state, SimTK::Stage::Acceleration);
  Copy(system_->state.getUDot(), udot);
}

void SimbodyTree::System::Integrate(SimTK::Integrator* integrator, double seconds) {
  const int before = multibody.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration);
  integrator->setFinalTime(seconds);
  integrator->initialize(state);
  while (integrator->getTime() < seconds) integrator->stepTo(seconds);
  evaluations = multibody.getNumRealizationsOfThisStage(SimTK::Stage::Acceleration) - before;
  end = integrator->getState();  // a copy forgets what was realized
  multibody.realize(end, SimTK::Stage::Position);
}

void SimbodyTree::Integrate(SimbodyIntegrator integrator, double setting, double seconds) {
  system_->state.updTime() = 0.0;
  const auto run = [&](SimTK::Integrator&& by) {
    if (integrator != SimbodyIntegrator::kSemiExplicitEuler) by.setAccuracy(setting);
    system_->Integrate(&by, seconds);
  };
  switch (integrator) {
    case SimbodyIntegrator::kMerson:
      return run(SimTK::RungeKuttaMersonIntegrator(system_->multibody));
    case SimbodyIntegrator::kFehlberg:
      return run(SimTK::RungeKuttaFeldbergIntegrator(system_->multibody));
    case SimbodyIntegrator::kImplicit:
      return run(SimTK::CPodesIntegrator(system_->multibody));
    case SimbodyIntegrator::kSemiExplicitEuler:
      return run(SimTK::SemiExplicitEulerIntegrator(system_->multibody, setting));
  }
}

long SimbodyTree::evaluations() const { return system_->evaluations; }

VecX SimbodyTree::EndRates() const {
  VecX u(system_->coordinate_of_rate.size());
  Copy(system_->end.getU(), &u);
  return u;
}

VecX SimbodyTree::EndCoordinates() const {
  VecX q = VecX::Zero(system_->coordinate_of_rate.size());
  for (int i = 0; i < q.size(); ++i) {
    const int coordinate = system_->coordinate_of_rate[i];
    if (coordinate >= 0) q[i] = system_->end.getQ()[coordinate];
  }
  return q;
}

Mat3 SimbodyTree::EndRotation(int body) const {
  const SimTK::Rotation& R = system_->bodies[body].getMobilizerTransform(system_->end).R();
  Mat3 out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out(i, j) = R[i][j];
  }
  return out;
}

}  // namespace hazumi::bench
