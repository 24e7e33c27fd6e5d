// The figure in DART: one joint a group, revolute, universal, and Euler or ball.

#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/EulerJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/UniversalJoint.hpp>

#include "tests/bench/peer_joints.h"
#include "tests/bench/stopwatch.h"
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

// A body about to be added, by a joint of a kind that is still open.
struct NewBody {
  dd::Skeleton* skeleton;
  dd::BodyNode* parent;
  dd::Joint::Properties frames;
  dd::BodyNode::Properties body;

  template <typename JointType, typename Space, typename... Own>
  dd::BodyNode* With(const Own&... own) const {
    const typename dd::GenericJoint<Space>::Properties generic(frames);
    const typename JointType::Properties joint(generic, own...);
    return skeleton->createJointAndBodyNodePair<JointType>(parent, joint, body).second;
  }
};

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
  NewBody Describe(const Figure& figure, const JointGroup& group, Threes threes) const;

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

dd::BodyNode* DartFigure::Add(const Figure& figure, const JointGroup& group, Threes threes) {
  using dart::math::R1Space, dart::math::R2Space, dart::math::R3Space, dart::math::SO3Space;
  const NewBody added = Describe(figure, group, threes);
  if (group.size == 1) {
    const dd::detail::RevoluteJointUniqueProperties axis(Vec3::UnitZ());
    return added.With<dd::RevoluteJoint, R1Space>(axis);
  }
  if (group.size == 2) {
    const dd::detail::UniversalJointUniqueProperties axes(Vec3::UnitX(), Vec3::UnitY());
    return added.With<dd::UniversalJoint, R2Space>(axes);
  }
  if (threes == Threes::kBall) return added.With<dd::BallJoint, SO3Space>();
  const dd::detail::EulerJointUniqueProperties order(dd::EulerJoint::AxisOrder::XYZ);
  return added.With<dd::EulerJoint, R3Space>(order);
}

NewBody DartFigure::Describe(const Figure& figure, const JointGroup& group, Threes threes) const {
  const Joint& first = figure.joint(group.first);
  const RigidInertia& inertia = figure.body(group.last());
  NewBody added;
  added.skeleton = skeleton_.get();
  added.parent = first.parent.is_valid() ? body_of_joint_[first.parent.value()] : nullptr;
  added.body.mName = added.frames.mName = group.name;
  added.body.mInertia = dd::Inertia(inertia.mass, inertia.com, inertia.I_com);
  Mat3 R_JF = Mat3::Identity();
  if (threes == Threes::kHinges || group.size < 3) R_JF = HingeFrame(figure, group);
  added.frames.mT_ParentBodyToJoint = Frame(first.X_PJ.R * R_JF, first.X_PJ.p);
  added.frames.mT_ChildBodyToJoint = Frame(R_JF, Vec3::Zero());
  return added;
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

SwingMethod Method(const char* name, const Figure& arm, Threes threes) {
  const auto figure = std::make_shared<DartFigure>(arm, threes);
  return {name,
          "steps",
          GeometricSettings(16, 4, 6),
          threes == Threes::kHinges ? FreeWithHinges : FreeNearSingularity,
          [figure](const SwingCase& c, double steps) { return Swing(figure.get(), c, steps); },
          [&arm, threes](const SwingCase&) { KeepAlive(DartFigure(arm, threes)); }};
}

}  // namespace

std::unique_ptr<Subject> MakeDart(const Figure& figure) {
  return std::make_unique<Dart>(figure, Threes::kHinges);
}

std::unique_ptr<Subject> MakeDartWithBalls(const Figure& figure) {
  return std::make_unique<Dart>(figure, Threes::kBall);
}

std::vector<SwingMethod> DartMethods(const Figure& arm) {
  return {Method("dart", arm, Threes::kHinges), Method("dart_ball", arm, Threes::kBall)};
}

}  // namespace hazumi::bench
