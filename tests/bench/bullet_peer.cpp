// The figure in Bullet (btMultiBody, double precision): a revolute link a hinge, massless between
// the hinges of one group, or a spherical link. Its link frames have their origin at the centre of
// mass and the principal axes, so the frames here must be parallel and the inertias diagonal.
// Its inverse dynamics is a library of its own whose headers Debian does not ship.

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <Eigen/Geometry>

#include "engine/base/assert.h"
#include "tests/bench/peer_joints.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subject.h"
#include "tests/bench/swing_method.h"

namespace hazumi::bench {

namespace {

btVector3 ToBullet(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

class BulletFigure {
 public:
  BulletFigure(const Figure& figure, Threes threes);

  void SetState(const VecX& q, const VecX& qd);
  void SetTorques(const VecX& q, const VecX& tau);
  // Adds h times the accelerations to the rates.
  void AdvanceRates(double h) {
    body_->computeAccelerationsArticulatedBodyAlgorithmMultiDof(h, scratch_r_, scratch_v_,
                                                                scratch_m_, false, false, false);
  }
  void AdvancePositions(double h) { body_->stepPositionsMultiDof(h); }
  VecX Angles() const;
  // The rates of all degrees of freedom, a ball's in the axes of its body.
  const btScalar* rates() const { return body_->getVelocityVector() + 6; }
  const std::vector<BallJoint>& balls() const { return balls_; }

 private:
  void Add(const Figure& figure, JointIndex last, int hinges);
  bool IsBall(int link) const { return body_->getLink(link).m_dofCount == 3; }

  std::unique_ptr<btMultiBody> body_;
  std::vector<int> link_of_joint_;
  std::vector<int> first_joint_;  // of each link
  std::vector<BallJoint> balls_;
  btAlignedObjectArray<btScalar> scratch_r_;
  btAlignedObjectArray<btVector3> scratch_v_;
  btAlignedObjectArray<btMatrix3x3> scratch_m_;
};

BulletFigure::BulletFigure(const Figure& figure, Threes threes)
    : link_of_joint_(figure.num_joints(), -1) {
  const bool with_balls = threes == Threes::kBall;
  if (with_balls) balls_ = BallJoints(figure);
  const int links = figure.num_joints() - 2 * static_cast<int>(balls_.size());
  body_ = std::make_unique<btMultiBody>(links, 1.0, btVector3(1, 1, 1), true, false);
  for (const JointGroup& group : figure.groups()) {
    if (with_balls && group.size == 3) {
      Add(figure, group.last(), 3);
    } else {
      for (int h = 0; h < group.size; ++h) Add(figure, JointIndex(group.first.value() + h), 1);
    }
  }
  body_->finalizeMultiDof();
  body_->setLinearDamping(0.0);
  body_->setAngularDamping(0.0);
  body_->setMaxCoordinateVelocity(1e30);
  for (int i = 0; i < links; ++i) {
    body_->addLinkForce(i, btVector3(0, 0, -kGravity) * body_->getLinkMass(i));
  }
}

// A link for the last of `hinges` concentric hinges.
void BulletFigure::Add(const Figure& figure, JointIndex last, int hinges) {
  const Joint& first = figure.joints()[last.value() - hinges + 1];
  const RigidInertia& body = figure.body(last);
  HAZUMI_DEMAND(first.parallel_frame && body.I_com.isDiagonal(1e-14));
  const int link = static_cast<int>(first_joint_.size());
  first_joint_.push_back(last.value() - hinges + 1);
  link_of_joint_[last.value()] = link;
  int parent = -1;
  Vec3 parent_com = Vec3::Zero();
  if (first.parent.is_valid()) {
    parent = link_of_joint_[first.parent.value()];
    parent_com = figure.body(first.parent).com;
  }
  const btVector3 to_pivot = ToBullet(first.X_PJ.p - parent_com), to_com = ToBullet(body.com);
  const btVector3 inertia = ToBullet(body.I_com.diagonal());
  if (hinges == 3) {
    body_->setupSpherical(link, body.mass, inertia, parent, btQuaternion::getIdentity(), to_pivot,
                          to_com);
  } else {
    body_->setupRevolute(link, body.mass, inertia, parent, btQuaternion::getIdentity(),
                         ToBullet(first.axis), to_pivot, to_com);
  }
}

void BulletFigure::SetState(const VecX& q, const VecX& qd) {
  int ball = 0;
  for (int link = 0; link < body_->getNumLinks(); ++link) {
    if (IsBall(link)) {
      const BallJoint& joint = balls_[ball++];
      const Mat3 R = joint.Rotation(q);
      const Eigen::Quaterniond turn(R);
      const Vec3 w = R.transpose() * joint.AngularVelocity(q, qd);
      body_->setJointPosMultiDof(link, turn.coeffs().data());
      body_->setJointVelMultiDof(link, w.data());
    } else {
      body_->setJointPos(link, q[first_joint_[link]]);
      body_->setJointVel(link, qd[first_joint_[link]]);
    }
  }
}

void BulletFigure::SetTorques(const VecX& q, const VecX& tau) {
  int ball = 0;
  for (int link = 0; link < body_->getNumLinks(); ++link) {
    btScalar* out = body_->getLink(link).m_jointTorque;
    if (IsBall(link)) {
      const BallJoint& joint = balls_[ball++];
      Eigen::Map<Vec3>(out, 3) = joint.Rotation(q).transpose() * joint.Moment(q, tau);
    } else {
      out[0] = tau[first_joint_[link]];
    }
  }
}

VecX BulletFigure::Angles() const {
  VecX q(link_of_joint_.size());
  int ball = 0;
  for (int link = 0; link < body_->getNumLinks(); ++link) {
    const btScalar* position = body_->getLink(link).m_jointPos;
    if (IsBall(link)) {
      balls_[ball++].SetHingeAngles(Eigen::Quaterniond(position).toRotationMatrix(), &q);
    } else {
      q[first_joint_[link]] = position[0];
    }
  }
  return q;
}

class Bullet : public Subject {
 public:
  Bullet(const Figure& figure, Threes threes) : figure_(figure, threes) {}

  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    figure_.SetState(at.q, at.qd);
    figure_.SetTorques(at.q, at.tau);
    if (!figure_.balls().empty()) start_ = Rates(at.q.size());
    figure_.AdvanceRates(1.0);
    *qdd = Rates(at.q.size()) - (figure_.balls().empty() ? at.qd : start_);
    for (const BallJoint& ball : figure_.balls()) {
      const Vec3 alpha = qdd->segment<3>(ball.first());
      ball.SetHingeAccelerations(at.q, at.qd, ball.Rotation(at.q) * alpha, qdd);
    }
    return true;
  }

 private:
  Eigen::Map<const VecX> Rates(Eigen::Index size) const { return {figure_.rates(), size}; }

  BulletFigure figure_;
  VecX start_;
};

SwingMethod Method(const char* name, const Figure& arm, Threes threes) {
  const auto figure = std::make_shared<BulletFigure>(arm, threes);
  return {name,
          "steps",
          GeometricSettings(16, 4, 7),
          threes == Threes::kHinges ? FreeWithHinges : FreeNearSingularity,
          [figure](const SwingCase& c, double steps) {
            figure->SetState(c.q, c.qd);
            const double h = c.seconds / steps;
            for (int i = 0; i < steps; ++i) {
              figure->AdvanceRates(h);
              figure->AdvancePositions(h);
            }
            return figure->Angles();
          },
          [&arm, threes](const SwingCase&) { KeepAlive(BulletFigure(arm, threes)); }};
}

}  // namespace

std::unique_ptr<Subject> MakeBullet(const Figure& figure) {
  return std::make_unique<Bullet>(figure, Threes::kHinges);
}

std::unique_ptr<Subject> MakeBulletWithBalls(const Figure& figure) {
  return std::make_unique<Bullet>(figure, Threes::kBall);
}

std::vector<SwingMethod> BulletMethods(const Figure& arm) {
  return {Method("bullet", arm, Threes::kHinges), Method("bullet_ball", arm, Threes::kBall)};
}

}  // namespace hazumi::bench
