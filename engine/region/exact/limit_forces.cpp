// Hinges that are at no limit follow freely, T = 0: without them the equations M x + b = T of a
// large island are those of the hinges at limits, with M and b as RegionDynamics::AssembleSome
// gives them.

#include "engine/region/exact/limit_forces.h"

namespace hazumi {

LimitForces::LimitForces(RegionDynamics* dynamics)
    : dynamics_(dynamics), solver_(dynamics->mode().contacts.rules().tells_motion_from_rounding) {
  const int n = dynamics->num_hinges();
  solver_.Resize(n);
  impulse_.setZero(n);
  T_.setZero(n);
  roundings_.setZero(n);
  some_.reserve(n);
}

template <typename IsWanted>
SomeHinges LimitForces::AssembleSome(double t, const HingeState& state, IsWanted&& is_wanted) {
  some_.clear();
  for (int i = 0; i < dynamics_->num_hinges(); ++i) {
    if (is_wanted(i)) some_.push_back(i);
  }
  solver_.Resize(static_cast<int>(some_.size()));
  held_.assign(some_.size(), 1);
  return dynamics_->AssembleSome(some_, t, state);
}

void LimitForces::Impact(double t, const std::vector<int>& side, const std::vector<char>& sticks,
                         HingeState* state, Strikes strikes) {
  dynamics_->AddWork({.limits = solver_.TakeWork()});  // work of the previous call
  VecX& qd = state->qd;
  const bool all_strikes = strikes == Strikes::kAll;
  if (!dynamics_->is_large()) {
    const HingeEquations equations = dynamics_->AssembleHinges(t, *state);
    const LimitRows* const rows = equations.for_impulses();
    if (all_strikes) {
      equations.StopPin(&impulse_);
      return solver_.Impact(equations.M(), impulse_, side, sticks, &qd, rows);
    }
    LimitRows kept = rows ? *rows : LimitRows();
    kept.c.setZero();
    impulse_.setZero();
    return solver_.Impact(equations.M(), impulse_, side, sticks, &qd, rows ? &kept : nullptr);
  }
  const SomeHinges equations = AssembleSome(t, *state, [&](int i) { return side[i] != 0; });
  if (all_strikes && equations.stops_pin()) qd += equations.RatesOfStop();
  const auto k = static_cast<Eigen::Index>(some_.size());
  VecX before(k), after(k);
  side_.clear();
  flags_.clear();
  for (Eigen::Index c = 0; c < k; ++c) {
    before[c] = after[c] = qd[some_[c]];
    side_.push_back(side[some_[c]]);
    flags_.push_back(sticks[some_[c]]);
  }
  solver_.Impact(equations.M(), VecX::Zero(k), side_, flags_, &after);
  qd += equations.RatesOf(equations.M() * (after - before));
  for (Eigen::Index c = 0; c < k; ++c) qd[some_[c]] = after[c];
}

void LimitForces::Rest(double t, const HingeState& state, const std::vector<int>& side,
                       const std::vector<char>& fixed, std::vector<char>* held) {
  dynamics_->AddWork({.limits = solver_.TakeWork()});  // work of the previous call
  if (!dynamics_->is_large()) {
    const HingeEquations equations = dynamics_->AssembleHinges(t, state);
    return solver_.Rest(equations.M(), equations.b(), side, fixed, held, equations.for_forces());
  }
  const SomeHinges equations = AssembleSome(t, state, [&](int i) { return side[i] != 0; });
  side_.clear();
  flags_.clear();
  for (const int i : some_) {
    side_.push_back(side[i]);
    flags_.push_back(fixed[i]);
  }
  solver_.Rest(equations.M(), equations.b(), side_, flags_, &held_);
  held->assign(side.size(), 0);
  for (size_t c = 0; c < some_.size(); ++c) (*held)[some_[c]] = held_[c];
  TakeTorques();
}

void LimitForces::Hold(double t, const HingeState& state, const std::vector<char>& held) {
  dynamics_->AddWork({.limits = solver_.TakeWork()});  // work of the previous call
  if (!dynamics_->is_large()) {
    const HingeEquations equations = dynamics_->AssembleHinges(t, state);
    return solver_.Solve(equations.M(), equations.b(), held, equations.for_forces());
  }
  const SomeHinges equations = AssembleSome(t, state, [&](int i) { return held[i] != 0; });
  solver_.Solve(equations.M(), equations.b(), held_);
  TakeTorques();
}

void LimitForces::TakeTorques() {
  T_.setZero();
  for (int c = 0; c < static_cast<int>(some_.size()); ++c) {
    T_[some_[c]] = solver_.T()[c];
    roundings_[some_[c]] = solver_.RoundingOf(c);
  }
}

}  // namespace hazumi
