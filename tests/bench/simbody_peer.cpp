// The figure in Simbody: one mobilizer a group, Pin, Universal, and Gimbal or Ball.

#include "tests/bench/peer_joints.h"
#include "tests/bench/simbody_bodies.h"
#include "tests/bench/springs.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subject.h"
#include "tests/bench/swing_method.h"

namespace hazumi::bench {

namespace {

// A body for each group. `springs`: by JointIndex, of hinges; or none.
std::vector<SimbodyTree::Body> Bodies(const Figure& figure, Threes threes,
                                      const std::vector<HingeSpring>& springs) {
  const VecX signs = CoordinateSigns(figure, threes);
  std::vector<SimbodyTree::Body> bodies = SimbodyBodies(figure, threes);
  for (size_t i = 0; i < bodies.size() && !springs.empty(); ++i) {
    const JointGroup& group = figure.groups()[i];
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      const HingeSpring& own = springs[j];
      bodies[i].springs.push_back({own.stiffness(), own.damping(), signs[j] * own.angle});
    }
  }
  return bodies;
}

// SimbodyTree in the figure's coordinates.
class SimbodyFigure {
 public:
  SimbodyFigure(const Figure& figure, Threes threes, const std::vector<HingeSpring>& springs = {})
      : tree_(Bodies(figure, threes, springs), kGravity), signs_(CoordinateSigns(figure, threes)) {
    if (threes == Threes::kBall) balls_ = BallJoints(figure);
    for (const BallJoint& ball : balls_) {
      body_of_ball_.push_back(figure.joints()[ball.first()].group.value());
    }
  }

  SimbodyTree& tree() { return tree_; }
  const VecX& signs() const { return signs_; }
  const std::vector<BallJoint>& balls() const { return balls_; }

  void SetState(const VecX& q, const VecX& qd) {
    q_ = signs_.cwiseProduct(q);
    u_ = signs_.cwiseProduct(qd);
    tree_.SetState(q_, u_);
    for (size_t i = 0; i < balls_.size(); ++i) {
      tree_.SetBall(body_of_ball_[i], balls_[i].Rotation(q), balls_[i].AngularVelocity(q, qd));
    }
  }
  VecX EndRates() const { return signs_.cwiseProduct(tree_.EndRates()); }  // not of balls
  VecX EndAngles() const {
    VecX q = signs_.cwiseProduct(tree_.EndCoordinates());
    for (size_t i = 0; i < balls_.size(); ++i) {
      balls_[i].SetHingeAngles(tree_.EndRotation(body_of_ball_[i]), &q);
    }
    return q;
  }

 private:
  SimbodyTree tree_;
  VecX signs_, q_, u_;
  std::vector<BallJoint> balls_;
  std::vector<int> body_of_ball_;
};

class Simbody : public Subject {
 public:
  Simbody(const Figure& figure, Threes threes)
      : figure_(figure, threes), zero_(VecX::Zero(figure.num_joints())) {}

  bool InverseDynamics(const Question& at, VecX* tau) override {
    figure_.SetState(at.q, at.qd);
    in_ = figure_.signs().cwiseProduct(at.qdd);
    figure_.tree().InverseDynamics(in_, tau);
    tau->array() *= figure_.signs().array();
    return true;
  }
  bool Bias(const Question& at, VecX* b) override {
    figure_.SetState(at.q, at.qd);
    figure_.tree().InverseDynamics(zero_, b);
    b->array() *= figure_.signs().array();
    return true;
  }
  bool InertiaMatrix(const Question& at, MatX* H) override {
    figure_.SetState(at.q, at.qd);
    figure_.tree().ComputeMassMatrix();
    if (H == nullptr) return true;
    const auto signs = figure_.signs().asDiagonal();
    *H = signs * figure_.tree().MassMatrix() * signs;
    return true;
  }
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    in_ = figure_.signs().cwiseProduct(at.tau);
    for (const BallJoint& ball : figure_.balls()) {
      in_.segment<3>(ball.first()) = ball.Moment(at.q, at.tau);
    }
    figure_.SetState(at.q, at.qd);
    figure_.tree().SetForces(in_);
    figure_.tree().ForwardDynamics(qdd);
    qdd->array() *= figure_.signs().array();
    for (const BallJoint& ball : figure_.balls()) {
      const Vec3 alpha = qdd->segment<3>(ball.first());
      ball.SetHingeAccelerations(at.q, at.qd, alpha, qdd);
    }
    return true;
  }

 private:
  SimbodyFigure figure_;
  VecX zero_, in_;
};

SwingMethod Method(const char* name, SimbodyIntegrator integrator, int settings, const Figure& arm,
                   Threes threes) {
  const auto figure = std::make_shared<SimbodyFigure>(arm, threes);
  return {name,
          "accuracy",
          GeometricSettings(1e-1, 0.1, settings),
          threes == Threes::kHinges ? FreeWithHinges : FreeNearSingularity,
          [figure, integrator](const SwingCase& c, double accuracy) {
            figure->SetState(c.q, c.qd);
            figure->tree().Integrate(integrator, accuracy, c.seconds);
            return figure->EndAngles();
          },
          [&arm, threes](const SwingCase& c) {
            SimbodyFigure anew(arm, threes);
            anew.SetState(c.q, c.qd);
            KeepAlive(anew);
          }};
}

class SimbodySpringSubject : public Subject {
 public:
  explicit SimbodySpringSubject(std::shared_ptr<SimbodyFigure> figure)
      : figure_(std::move(figure)) {}
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    figure_->SetState(at.q, at.qd);
    figure_->tree().ForwardDynamics(qdd);
    qdd->array() *= figure_->signs().array();
    return true;
  }

 private:
  std::shared_ptr<SimbodyFigure> figure_;
};

SpringRun Swing(SimbodyFigure* figure, SimbodyIntegrator integrator, const SpringArm& arm,
                double seconds, double setting) {
  figure->SetState(arm.q, arm.qd);
  try {
    figure->tree().Integrate(integrator, setting, seconds);
  } catch (const std::exception&) {
    return {};
  }
  return {figure->EndAngles(), figure->EndRates(), figure->tree().evaluations(), true};
}

}  // namespace

SpringProgram SimbodySprings(const SpringArm& arm) {
  const auto make = [&arm] {
    return std::make_shared<SimbodyFigure>(arm.figure, Threes::kHinges, arm.springs);
  };
  const auto figure = make();
  SpringProgram program{"simbody", std::make_unique<SimbodySpringSubject>(figure), {}};
  const auto add = [&](const char* name, SimbodyIntegrator by, std::vector<double> settings) {
    const bool has_steps = by == SimbodyIntegrator::kSemiExplicitEuler;
    program.methods.push_back({name, has_steps ? "s a step" : "accuracy", has_steps,
                               std::move(settings), 0.1, has_steps ? 1e-5 : 1e-12,
                               [=, &arm](double seconds, double setting) {
                                 return Swing(figure.get(), by, arm, seconds, setting);
                               },
                               [make] { KeepAlive(make()); }});
  };
  add("simbody_semi_explicit_euler", SimbodyIntegrator::kSemiExplicitEuler,
      GeometricSettings(1.0 / 48, 0.25, 6));
  add("simbody_merson", SimbodyIntegrator::kMerson, GeometricSettings(1e-1, 0.1, 11));
  add("simbody_fehlberg", SimbodyIntegrator::kFehlberg, GeometricSettings(1e-1, 0.1, 12));
  add("simbody_implicit", SimbodyIntegrator::kImplicit, GeometricSettings(1e-1, 0.1, 8));
  return program;
}

std::unique_ptr<Subject> MakeSimbody(const Figure& figure) {
  return std::make_unique<Simbody>(figure, Threes::kHinges);
}

std::unique_ptr<Subject> MakeSimbodyWithBalls(const Figure& figure) {
  return std::make_unique<Simbody>(figure, Threes::kBall);
}

std::vector<SwingMethod> SimbodyMethods(const Figure& arm) {
  return {Method("simbody_merson", SimbodyIntegrator::kMerson, 11, arm, Threes::kHinges),
          Method("simbody_fehlberg", SimbodyIntegrator::kFehlberg, 12, arm, Threes::kHinges),
          Method("simbody_merson_ball", SimbodyIntegrator::kMerson, 11, arm, Threes::kBall)};
}

}  // namespace hazumi::bench
