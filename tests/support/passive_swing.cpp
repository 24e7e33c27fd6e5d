#include "tests/support/passive_swing.h"

#include <algorithm>
#include <cmath>

#include "engine/base/assert.h"
#include "engine/region/forces/force_spec.h"
#include "engine/region/paper_step.h"
#include "engine/region/region_system.h"
#include "tests/support/energy.h"

namespace hazumi::test {

namespace {

// Adds up what a course is judged by.
class Judge {
 public:
  explicit Judge(const Release& release)
      : release_(release),
        start_(EnergyOf(release.figure, release.q, release.qd, release.gravity)),
        scale_(EnergyScale(release.figure, release.q, release.qd, release.gravity)) {}

  // False if a number is not finite.
  bool Look(double time, const VecX& q, const VecX& qd, Course* course) const {
    course->q = q;
    course->qd = qd;
    course->largest_step = std::max(course->largest_step, time - course->time);
    course->time = time;
    ++course->steps;
    if (!q.allFinite() || !qd.allFinite()) return false;
    const double energy = EnergyOf(release_.figure, q, qd, release_.gravity);
    const double gain = (energy - start_) / scale_;
    course->energy_drift = std::max(course->energy_drift, std::abs(gain));
    course->energy_gain = std::max(course->energy_gain, gain);
    for (int j = 0; j < q.size(); ++j) {
      const Joint& joint = release_.figure.joints()[j];
      course->outside = std::max({course->outside, joint.lower - q[j], q[j] - joint.upper});
    }
    return std::isfinite(energy);
  }

 private:
  const Release& release_;
  double start_, scale_;
};

RegionModel WholeFigure(const Figure& figure) {
  ModelRequest request;
  request.roles.assign(figure.num_joints(), Role::kFree);
  request.roles.resize(figure.num_joints() + kRootAngles, Role::kConstant);
  request.angles = VecX::Zero(figure.num_joints() + kRootAngles);
  std::vector<RegionModel> models = CompileRegionModels(figure, request);
  HAZUMI_DEMAND(models.size() == 1);  // joints that feel each other
  return models[0];
}

void SetLimits(const Figure& figure, VecX* lower, VecX* upper) {
  lower->resize(figure.num_joints());
  upper->resize(figure.num_joints());
  for (int j = 0; j < figure.num_joints(); ++j) {
    (*lower)[j] = figure.joints()[j].lower;
    (*upper)[j] = figure.joints()[j].upper;
  }
}

}  // namespace

Course SwingExactly(const Release& release, double tolerance, long most_steps) {
  const int n = release.figure.num_joints();
  const DrivenMotion still{std::vector<DrivenCurve>(n + kRootAngles), {}};
  const VecX rates = VecX::Constant(n, -30.0 * std::log(release.friction));
  RegionDynamics dynamics(WholeFigure(release.figure), FrictionAlone(rates), release.gravity);
  dynamics.SetDriven(&still, 0.0, release.seconds);
  VecX lower, upper;
  SetLimits(release.figure, &lower, &upper);
  ExactSolver solver(&dynamics, lower, upper);
  solver.SetTolerance(tolerance);
  solver.Start(0.0, {release.q, release.qd});
  const Judge judge(release);
  Course course;
  bool good = true;
  while (good && solver.time() < release.seconds && course.steps < most_steps) {
    good = !solver.Advance(release.seconds) &&
           judge.Look(solver.time(), solver.now().q, solver.now().qd, &course);
  }
  course.finished = good && solver.time() >= release.seconds;
  course.evaluations = dynamics.evaluations();
  course.hits = solver.TakeEvents().hits;
  return course;
}

Course SwingByPaper(const Release& release, double step) {
  const int n = release.figure.num_joints();
  const int steps = std::max(1, static_cast<int>(std::lround(release.seconds / step)));
  const double h = release.seconds / steps;
  std::vector<JointIndex> all;
  for (int j = 0; j < n; ++j) all.emplace_back(j);
  DynamicsWorkspace ws(release.figure);
  RegionSystem system(release.figure, all);
  PaperStep paper(n);
  PaperStepInput input{
      &system.M(), &system.b(), VecX::Constant(n, FrictionOfStep(release.friction, h)), {}, {}};
  SetLimits(release.figure, &input.lower, &input.upper);
  PassiveState state{Pose(), RootMotion(), release.q, release.qd, VecX::Zero(n)};
  const Judge judge(release);
  Course course;
  bool good = true;
  for (int i = 1; i <= steps && good; ++i) {
    system.Evaluate(state, RootCoupling::kPrescribed, JointIndex(), release.gravity, &ws);
    good = paper.Advance(input, h, &state.q, &state.qd) == PaperStepStatus::kOk &&
           judge.Look(i * h, state.q, state.qd, &course);
  }
  course.finished = good;
  course.evaluations = course.steps;
  return course;
}

}  // namespace hazumi::test
