// The figure in DART: one joint a group, revolute, universal, and Euler or ball.

#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/EulerJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/UniversalJoint.hpp>

#include "tests/bench/peer_joints.h"
#include "tests/bench/subject.h"
#include "tests/bench/swing_method.h"

namespace hazumi::bench {

namespace {

namespace dd = dart::dynamics;

Eigen::Isometry3d Frame(const Mat3& R, const Vec3& p) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = R;
  T.translation() = p;
  return T;
}

class DartFigure {
 public:
  DartFigure(const Figure& figure, Threes threes);

  dd::Skeleton& skeleton() { return *skeleton_; }
  const std::vector<BallJoint>& balls() const { return balls_; }

  void SetState(const VecX& q, const VecX& qd);
  void SetTorques(const VecX& q, const VecX& tau);
  VecX Angles() const;
  // Between our coordinates and DART's.
  const VecX& Scaled(const VecX& x) { return scratch_ = signs_.cwiseProduct(x); }
  const VecX& signs() const { return signs_; }

 private:
  dd::BodyNode* Add(const Figure& figure, const JointGroup& group, Threes threes);
  dd::BodyNode* AddBall(dd::BodyNode* parent, const Joint& first, const dd::BodyNode::Properties&);

  dd::SkeletonPtr skeleton_ = dd::Skeleton::create("figure");
  std::vector<dd::BodyNode*> body_of_joint_;
  std::vector<BallJoint> balls_;
  VecX signs_, scratch_;
};

DartFigure::DartFigure(const Figure& figure, Threes threes)
    : body_of_joint_(figure.num_joints(), nullptr), signs_(CoordinateSigns(figure, threes)) {
  if (threes == Threes::kBall) balls_ = BallJoints(figure);
  skeleton_->setGravity(Vec3(0.0, 0.0, -kGravity));
  for (const JointGroup& group : figure.groups()) {
    body_of_joint_[group.last().value()] = Add(figure, group, threes);
  }
}

template <typename JointType>
dd::BodyNode* AddBody(dd::Skeleton* skeleton, dd::BodyNode* parent,
                      const typename JointType::Properties& joint,
                      const dd::BodyNode::Properties& body) {
  return skeleton->createJointAndBodyNodePair<JointType>(parent, joint, body).second;
}

dd::BodyNode* DartFigure::Add(const Figure& figure, const JointGroup& group, Threes threes) {
  const Joint& first = figure.joint(group.first);
  dd::BodyNode* parent = nullptr;
  if (first.parent.is_valid()) parent = body_of_joint_[first.parent.value()];
  const RigidInertia& inertia = figure.body(group.last());
  dd::BodyNode::Properties body;
  body.mName = group.name;
  body.mInertia = dd::Inertia(inertia.mass, inertia.com, inertia.I_com);
  dd::Joint::Properties frames;
  frames.mName = group.name;
  const Mat3 hinges = HingeFrame(figure, group);
  frames.mT_ParentBodyToJoint = Frame(first.X_PJ.R * hinges, first.X_PJ.p);
  frames.mT_ChildBodyToJoint = Frame(hinges, Vec3::Zero());
  dd::Skeleton* skeleton = skeleton_.get();
  if (group.size == 1) {
    return AddBody<dd::RevoluteJoint>(
        skeleton, parent,
        {dd::GenericJoint<dart::math::R1Space>::Properties(frames), {Vec3::UnitZ()}}, body);
  }
  if (group.size == 2) {
    return AddBody<dd::UniversalJoint>(
        skeleton, parent,
        {dd::GenericJoint<dart::math::R2Space>::Properties(frames), {Vec3::UnitX(), Vec3::UnitY()}},
        body);
  }
  if (threes == Threes::kBall) return AddBall(parent, first, body);
  return AddBody<dd::EulerJoint>(
      skeleton, parent,
      {dd::GenericJoint<dart::math::R3Space>::Properties(frames), {dd::EulerJoint::AxisOrder::XYZ}},
      body);
}

dd::BodyNode* DartFigure::AddBall(dd::BodyNode* parent, const Joint& first,
                                  const dd::BodyNode::Properties& body) {
  dd::Joint::Properties frames;
  frames.mName = body.mName;
  frames.mT_ParentBodyToJoint = Frame(first.X_PJ.R, first.X_PJ.p);
  return AddBody<dd::BallJoint>(
      skeleton_.get(), parent,
      dd::BallJoint::Properties(dd::GenericJoint<dart::math::SO3Space>::Properties(frames)), body);
}

void DartFigure::SetState(const VecX& q, const VecX& qd) {
  if (balls_.empty()) {
    skeleton_->setPositions(Scaled(q));
    skeleton_->setVelocities(Scaled(qd));
    return;
  }
  VecX positions = Scaled(q), rates = Scaled(qd);
  for (const BallJoint& ball : balls_) {
    const Mat3 R = ball.Rotation(q);
    positions.segment<3>(ball.first()) = dd::BallJoint::convertToPositions(R);
    rates.segment<3>(ball.first()) = R.transpose() * ball.AngularVelocity(q, qd);
  }
  skeleton_->setPositions(positions);
  skeleton_->setVelocities(rates);
}

void DartFigure::SetTorques(const VecX& q, const VecX& tau) {
  VecX& torques = scratch_ = signs_.cwiseProduct(tau);
  for (const BallJoint& ball : balls_) {
    torques.segment<3>(ball.first()) = ball.Rotation(q).transpose() * ball.Moment(q, tau);
  }
  skeleton_->setForces(torques);
}

VecX DartFigure::Angles() const {
  const VecX positions = skeleton_->getPositions();
  VecX q = signs_.cwiseProduct(positions);
  for (const BallJoint& ball : balls_) {
    const Vec3 turn = positions.segment<3>(ball.first());
    ball.SetHingeAngles(dd::BallJoint::convertToRotation(turn), &q);
  }
  return q;
}

class Dart : public Subject {
 public:
  Dart(const Figure& figure, Threes threes) : figure_(figure, threes) {}

  bool InverseDynamics(const Question& at, VecX* tau) override {
    figure_.SetState(at.q, at.qd);
    figure_.skeleton().setAccelerations(figure_.Scaled(at.qdd));
    figure_.skeleton().computeInverseDynamics();
    *tau = figure_.signs().cwiseProduct(figure_.skeleton().getForces());
    return true;
  }
  bool Bias(const Question& at, VecX* b) override {
    figure_.SetState(at.q, at.qd);
    *b = figure_.signs().cwiseProduct(figure_.skeleton().getCoriolisAndGravityForces());
    return true;
  }
  bool InertiaMatrix(const Question& at, MatX* H) override {
    figure_.SetState(at.q, at.qd);
    const MatX& M = figure_.skeleton().getMassMatrix();
    if (H != nullptr) *H = figure_.signs().asDiagonal() * M * figure_.signs().asDiagonal();
    return true;
  }
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    figure_.SetState(at.q, at.qd);
    figure_.SetTorques(at.q, at.tau);
    figure_.skeleton().computeForwardDynamics();
    *qdd = figure_.signs().cwiseProduct(figure_.skeleton().getAccelerations());
    for (const BallJoint& ball : figure_.balls()) {
      const Vec3 alpha = qdd->segment<3>(ball.first());
      ball.SetHingeAccelerations(at.q, at.qd, ball.Rotation(at.q) * alpha, qdd);
    }
    return true;
  }

 private:
  DartFigure figure_;
};

// What dart::simulation::World::step does without its constraint solver.
VecX Swing(DartFigure* figure, const SwingCase& c, double steps) {
  dd::Skeleton& skeleton = figure->skeleton();
  figure->SetState(c.q, c.qd);
  const double h = c.seconds / steps;
  for (int i = 0; i < steps; ++i) {
    skeleton.computeForwardDynamics();
    skeleton.integrateVelocities(h);
    skeleton.integratePositions(h);
  }
  return figure->Angles();
}

SwingMethod Method(const char* name, const std::shared_ptr<DartFigure>& figure) {
  return {name, "steps", GeometricSettings(16, 4, 6),
          figure->balls().empty() ? FreeWithHinges : FreeNearSingularity,
          [figure](const SwingCase& c, double steps) { return Swing(figure.get(), c, steps); }};
}

}  // namespace

std::unique_ptr<Subject> MakeDart(const Figure& figure) {
  return std::make_unique<Dart>(figure, Threes::kHinges);
}

std::unique_ptr<Subject> MakeDartWithBalls(const Figure& figure) {
  return std::make_unique<Dart>(figure, Threes::kBall);
}

std::vector<SwingMethod> DartMethods(const Figure& arm) {
  return {Method("dart", std::make_shared<DartFigure>(arm, Threes::kHinges)),
          Method("dart_ball", std::make_shared<DartFigure>(arm, Threes::kBall))};
}

}  // namespace hazumi::bench
