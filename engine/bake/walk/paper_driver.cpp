// The joints y of all regions that are active, as one system M y'' = -b (RegionSystem), in steps of
// the smallest length that one of them asks for (PaperStep) [Arai 2.4].

#include "engine/bake/walk/paper_driver.h"

#include <algorithm>

namespace hazumi {

namespace {

std::vector<JointIndex> JointsOf(const Animation& animation, const std::vector<int>& active) {
  std::vector<JointIndex> joints;
  for (const int r : active) {
    const std::vector<JointIndex>& more = animation.regions[r].joints;
    joints.insert(joints.end(), more.begin(), more.end());
  }
  std::sort(joints.begin(), joints.end());
  return joints;
}

double LeastStep(const Animation& animation, const std::vector<int>& active) {
  double step = animation.solver.step;
  bool first = true;
  for (const int r : active) {
    const double own = animation.regions[r].step.value_or(animation.solver.step);
    step = first ? own : std::min(step, own);
    first = false;
  }
  return step;
}

}  // namespace

PaperDriver::PaperDriver(const Animation& animation, const Figure& figure, std::vector<int> active)
    : animation_(animation),
      active_(std::move(active)),
      step_(LeastStep(animation, active_)),
      system_(figure, JointsOf(animation, active_)),
      paper_(system_.size()),
      factors_(system_.size()),
      y_(system_.size()),
      yd_(system_.size()),
      on_limit_(system_.size(), 0) {
  input_ = {&system_.M(), &system_.b(), VecX(system_.size()), VecX(system_.size()),
            VecX(system_.size())};
  for (int i = 0; i < system_.size(); ++i) {
    const JointIndex j = system_.free()[i];
    input_.lower[i] = figure.joint(j).lower;
    input_.upper[i] = figure.joint(j).upper;
    for (const int r : active_) {
      const DynamicsRegion& region = animation.regions[r];
      const auto it = std::lower_bound(region.joints.begin(), region.joints.end(), j);
      if (it == region.joints.end() || *it != j) continue;
      factors_[i] = region.friction[it - region.joints.begin()];
    }
  }
}

bool PaperDriver::is_free(JointIndex j) const {
  return std::binary_search(system_.free().begin(), system_.free().end(), j);
}

std::optional<PaperDriver::Failure> PaperDriver::Advance(const FigureMotion& from,
                                                         const RootHold& hold, const VecX* torques,
                                                         double dt, DynamicsWorkspace* ws, VecX* q,
                                                         VecX* qd,
                                                         std::vector<JointIndex>* limits) {
  system_.Evaluate({from.X_WR, from.root, from.q, from.qd, from.qdd}, hold.coupling, hold.pin,
                   animation_.gravity, ws);
  input_.torques.resize(torques ? system_.size() : 0);
  for (int i = 0; i < system_.size(); ++i) {
    if (torques) input_.torques[i] = (*torques)[system_.free()[i].value()];
    input_.friction[i] = FrictionOfStep(factors_[i], dt);
    y_[i] = from.q[system_.free()[i].value()];
    yd_[i] = from.qd[system_.free()[i].value()];
  }
  const PaperStepStatus status = paper_.Advance(input_, dt, &y_, &yd_);
  if (status == PaperStepStatus::kSingular) {
    return Failure{system_.free()[paper_.failed_joint()],
                   "it moves no mass, so nothing determines its motion; leave it out of the "
                   "region"};
  }
  if (status == PaperStepStatus::kNotFinite) {
    return Failure{system_.free()[paper_.failed_joint()],
                   "its rate grows without bound; try a smaller step or more friction"};
  }
  for (int i = 0; i < system_.size(); ++i) {
    const JointIndex j = system_.free()[i];
    (*q)[j.value()] = y_[i];
    (*qd)[j.value()] = yd_[i];
    if (paper_.corrected()[i] && !on_limit_[i]) limits->push_back(j);
    on_limit_[i] = paper_.corrected()[i];
  }
  return std::nullopt;
}

bool PaperDriver::ApplyLanding(const FigureMotion& from, JointIndex pin, DynamicsWorkspace* ws,
                               VecX* qd) {
  VecX rates(system_.size());
  if (!system_.RatesAfterPinning({from.X_WR, from.root, from.q, from.qd, from.qdd}, pin, ws,
                                 &rates)) {
    return false;
  }
  for (int i = 0; i < system_.size(); ++i) (*qd)[system_.free()[i].value()] = rates[i];
  return true;
}

}  // namespace hazumi
