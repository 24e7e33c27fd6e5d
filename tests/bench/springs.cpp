#include "tests/bench/springs.h"

#include <utility>

#include "engine/bake/handover/region_start.h"
#include "engine/region/forces/spring_drive.h"
#include "tests/bench/questions.h"
#include "tests/bench/swing_cases.h"
#include "tests/support/energy.h"
#include "tests/support/figures.h"

namespace hazumi::bench {

namespace {

// A link cut in half across its axis.
std::pair<LinkSpec, LinkSpec> Halves(const LinkSpec& whole) {
  LinkSpec near = whole, far = whole;
  const Vec3 half = 0.5 * (whole.to - whole.from);
  near.mass = far.mass = 0.5 * *whole.mass;
  near.to -= half;
  far.to -= half;  // its joint is in the middle
  return {near, far};
}

// Arm7 from the base outwards, with a joint "turn" of the shoulder's last hinge in the middle of
// the upper arm.
Figure ArmWithoutThrees() {
  FigureSpec spec = test::Arm7Spec();
  spec.name = "arm7_without_threes";
  JointSpec &shoulder = spec.joints[0], &elbow = spec.joints[1];
  JointSpec turn = shoulder;
  turn.name = "turn";
  turn.parent = shoulder.name;
  turn.offset = 0.5 * elbow.offset;
  turn.hinges.erase(turn.hinges.begin(), turn.hinges.end() - 1);
  shoulder.hinges.pop_back();
  std::tie(shoulder.links[0], turn.links[0]) = Halves(shoulder.links[0]);
  turn.links[0].name = turn.name;
  elbow.parent = turn.name;
  elbow.offset -= turn.offset;
  spec.joints.insert(spec.joints.begin() + 1, turn);
  return test::Build(spec);
}

// Of each hinge, as a region that begins in this pose has it [kg m^2].
std::vector<double> InertiasBeyond(const Figure& figure, const VecX& q) {
  DynamicsRegion region;
  Drive spring;
  spring.kind = DriveKind::kSpring;
  for (int j = 0; j < figure.num_joints(); ++j) region.joints.emplace_back(j);
  spring.joints = region.joints;
  region.drives = {spring};
  FigureMotion motion;
  motion.q = q;
  DynamicsWorkspace ws(figure);
  return StartOf(region, figure, motion, nullptr, &ws).inertias;
}

}  // namespace

SpringArm MakeSpringArm(double frequency, double damping_ratio) {
  const SwingCase smooth = SwingCases().front();
  SpringArm arm{ArmWithoutThrees(), smooth.q, smooth.qd, {}};
  const std::vector<double> inertias = InertiasBeyond(arm.figure, arm.q);
  for (int j = 0; j < arm.figure.num_joints(); ++j) {
    arm.springs.push_back({inertias[j], RateOfFrequency(frequency), damping_ratio, arm.q[j]});
  }
  return arm;
}

double SpringArm::EnergyAbove(const VecX& at_q, const VecX& at_qd) const {
  const VecX rest = VecX::Zero(q.size());
  double energy = test::EnergyOf(figure, at_q, at_qd, kGravity);
  energy -= test::EnergyOf(figure, q, rest, kGravity);
  for (int j = 0; j < q.size(); ++j) {
    const double turned = at_q[j] - springs[j].angle;
    energy += 0.5 * springs[j].stiffness() * turned * turned;
  }
  return energy;
}

std::vector<SpringProgram> SpringPrograms(const SpringArm& arm) {
  std::vector<SpringProgram> programs;
  programs.push_back(HazumiSprings(arm));
  programs.push_back(MujocoSprings(arm));
  programs.push_back(SimbodySprings(arm));
  std::vector<Question> questions = RandomQuestions(arm.figure, 5);
  for (Question& at : questions) {
    for (int j = 0; j < at.q.size(); ++j) at.tau[j] = arm.springs[j].Torque(at.q[j], at.qd[j]);
  }
  for (const SpringProgram& program : programs) {
    DemandForwardAgreement(program.name, program.subject.get(), arm.figure, questions);
  }
  return programs;
}

}  // namespace hazumi::bench
