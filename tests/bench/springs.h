#pragma once

// An arm that springs hold in a pose, and ways to let it swing about it.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/figure/figure.h"
#include "tests/bench/subject.h"

namespace hazumi::bench {

// tau = inertia (rate^2 (angle - q) - 2 damping_ratio rate q'): linear in q and q'. [METHOD 2.6]
struct HingeSpring {
  double inertia;  // about the hinge, of all that lies beyond it at the start [kg m^2]
  double rate;     // 2 pi times its frequency [rad/s]
  double damping_ratio;
  double angle;  // that it pulls to [rad]

  double stiffness() const { return inertia * rate * rate; }               // [N m/rad]
  double damping() const { return 2.0 * damping_ratio * inertia * rate; }  // [N m s/rad]
  double Torque(double q, double qd) const { return stiffness() * (angle - q) - damping() * qd; }
};

// The arm of the test figures with its third hinge halfway down the upper arm: nowhere do three
// meet, so that it is hinges, and springs of hinges, in every program.
struct SpringArm {
  Figure figure;
  VecX q, qd;                        // at the start [rad, rad/s]
  std::vector<HingeSpring> springs;  // by JointIndex; they pull to the start

  // Kinetic, of gravity and of the springs, above that of the start at rest [J].
  double EnergyAbove(const VecX& at_q, const VecX& at_qd) const;
};
SpringArm MakeSpringArm(double frequency, double damping_ratio);

struct SpringRun {
  VecX q, qd;            // at the end
  long evaluations = 0;  // of the equations of motion
  bool finished = false;
};

struct SpringMethod {
  std::string name;
  std::string unit;  // of a setting, e.g. "s a step"
  bool has_steps;    // a setting is a step [s], else a tolerance; the larger the coarser
  std::vector<double> settings;  // from coarse to fine
  double coarsest, finest;       // that are tried where only survival counts
  std::function<SpringRun(double seconds, double setting)> run;  // from the start
  std::function<void()> set_up;  // from the arm to what run() has ready
};

// An arm that a program has made, asked by what it accelerates with.
template <typename Arm>
class SpringSubject : public Subject {
 public:
  explicit SpringSubject(std::shared_ptr<Arm> arm) : arm_(std::move(arm)) {}
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    arm_->Accelerate(at, qdd);
    return true;
  }

 private:
  std::shared_ptr<Arm> arm_;
};

// A program with one arm, which outlives it.
struct SpringProgram {
  std::string name;
  std::unique_ptr<Subject> subject;  // forward dynamics with the springs' torques and no others
  std::vector<SpringMethod> methods;
};
SpringProgram HazumiSprings(const SpringArm& arm);
SpringProgram MujocoSprings(const SpringArm& arm);
SpringProgram SimbodySprings(const SpringArm& arm);

// All three. Ends the program if one answers with other accelerations than the others.
std::vector<SpringProgram> SpringPrograms(const SpringArm& arm);

}  // namespace hazumi::bench
