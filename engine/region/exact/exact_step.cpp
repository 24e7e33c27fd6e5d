#include "engine/region/exact/exact_step.h"

#include <algorithm>
#include <cmath>

#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

constexpr double kLeastStep = 1e-12;  // [s]
// Steps of a motion at rest would grow for ever [s].
constexpr double kMostStep = 1e9;
constexpr double kSafety = 0.9;    // of steps, so that few are rejected
constexpr double kMostGap = 1e-7;  // of what constraints keep together [m, rad]

}  // namespace

ExactStep::ExactStep(RegionDynamics* dynamics, const LimitRange* limits)
    : dynamics_(dynamics),
      limits_(limits),
      start_(dynamics->NewState()),
      now_(start_),
      inside_(start_) {
  const int n = dynamics->num_hinges();
  // The longest state: all in ball joints.
  const int longest = 2 * n + n / 3 + dynamics->outer_layout().size();
  for (VecX* x : {&y_, &scale_, &closed_}) x->resize(longest);
}

void ExactStep::Place(double t, const HingeState& state) {
  time_ = t;
  now_ = state;
  next_h_ = 0.0;
}

void ExactStep::Begin() {
  HAZUMI_ASSERT(IsFinite(now_.q) && IsFinite(now_.qd));
  dynamics_->mode().anchor = now_.outer.anchor;
  dynamics_->Pack(now_, y_.data());
  is_closed_ = false;
  gap_ = 0.0;
  if (closes_gaps()) {
    gap_ = dynamics_->CloseGaps(time_, y_.data());
    TakeState(y_.data());
  }
  step_.Resize(dynamics_->state_size());
  SetScale();
  step_.Start(time_, y_.data(), Field());
  last_error_ = 1.0;
}

void ExactStep::SetScale() {
  const RegionLayout& layout = dynamics_->layout();
  const int positions = layout.num_positions(), size = layout.state_size();
  for (int i = 0; i < size; ++i) {
    scale_[i] = i < positions ? (layout.is_quaternion(i) ? 0.5 : 1.0) * tolerance_
                              : kRateScale * tolerance_;
  }
  // A radian at the end of a metre is a metre.
  const OuterLayout& outer = dynamics_->outer_layout();
  for (int i = 0; i < outer.size(); ++i) {
    const OuterLayout::Part part = outer.PartAt(i);
    const double of_place = part == OuterLayout::Part::kQuaternion ? 0.5 : 1.0;
    scale_[size + i] = (part == OuterLayout::Part::kRate ? kRateScale : of_place) * tolerance_;
  }
}

// From how fast the motion is: a step of order 8 covers about this much of a turn.
double ExactStep::FirstStep(double end) const {
  const double* dy = step_.end_derivative();
  double speed = 1.0;
  const int positions = dynamics_->layout().num_positions();
  for (int i = 0; i < dynamics_->layout().state_size(); ++i) {
    const double size = std::abs(dy[i]);
    speed = std::max(speed, i < positions ? size : std::sqrt(size));
  }
  return std::min(end - time_, 1.5 * std::pow(tolerance_, 0.125) / speed);
}

// What the step may grow by. Errors that rise from step to step go on rising: proportional and
// integral control [Hairer, Wanner 1996, IV.2] sees that and saves most rejections, and so does
// slow growth, unless there is next to no error.
double ExactStep::Growth(double error) const {
  constexpr double kNone = 1e-5;
  const double trend = std::pow(std::max(last_error_, 1e-4), 0.04);
  const double grow = kSafety * std::pow(std::max(error, 1e-10), -0.1) * trend;
  return std::clamp(grow, 0.333, error < kNone ? 6.0 : 1.5);
}

std::optional<ExactFailure> ExactStep::Take(double end, bool is_near) {
  if (gap_ > kMostGap) return ExactFailure{worst_hinge(), ExactFailure::Cause::kEndsApart, gap_};
  if (is_closed_) step_.Start(time_, closed_.data(), Field());
  is_closed_ = false;
  start_ = now_;
  const double wanted = is_near ? end - time_ : next_h_ > 0.0 ? next_h_ : FirstStep(end);
  double h = std::min({longest_step_, kMostStep, wanted});
  for (;;) {
    const double rest = end - time_;
    // Equal steps to the end rather than a tiny last one.
    const double use =
        std::isfinite(rest) ? rest / std::max(1.0, std::ceil(rest / h * (1.0 - 1e-9))) : h;
    const double error = is_near ? step_.TryShort(use, scale_.data(), Field())
                                 : step_.Try(use, scale_.data(), Field());
    if (error <= 1.0) {
      if (!is_near && error * tolerance_ <= solution_tolerance_) step_.AddError(kControlError);
      step_.Accept(Field());
      if (is_near) break;  // which tells nothing of longer ones
      const double grow = Growth(error);
      next_h_ = std::max(h * 0.5, use * grow);
      if (use < h) next_h_ = std::max(next_h_, std::min(h, use * grow));
      last_error_ = error;
      break;
    }
    if (is_near) {  // order 8 may do in one step
      is_near = false;
      continue;
    }
    const double grow = kSafety * std::pow(error, -0.125);
    h = use * (std::isfinite(error) ? std::clamp(grow, 0.1, 0.9) : 0.1);
    if (h < kLeastStep) return ExactFailure{worst_hinge(), ExactFailure::Cause::kStepTooSmall};
  }
  time_ = step_.end_time();
  if (std::abs(time_ - end) < kSameTime) time_ = end;
  if (!closes_gaps()) {
    TakeState(step_.y());
    return std::nullopt;
  }
  std::copy_n(step_.y(), dynamics_->state_size(), closed_.data());
  gap_ = dynamics_->CloseGaps(time_, closed_.data());
  is_closed_ = true;
  TakeState(closed_.data());
  return std::nullopt;
}

// The branch is that of the state before, which is near by.
void ExactStep::TakeState(const double* y) {
  dynamics_->Unpack(y, limits_->lower(), limits_->upper(), &now_);
}

void ExactStep::EndAt(double t) {
  HAZUMI_ASSERT(start_time() <= t && t <= end_time() + kSameTime);
  Sample(t, &inside_);
  now_.swap(inside_);
  time_ = t;
}

double ExactStep::Defect() {
  MakeDense();
  const int size = dynamics_->state_size();
  if (size == 0) return 0.0;
  const double h = step_.end_time() - step_.start_time();
  const double t = 0.5 * (step_.start_time() + time_);
  VecX change(size), rate(size);
  step_.ChangeAt(t, change.data());
  step_.At(t, y_.data());
  dynamics_->Derivative(t, y_.data(), rate.data());
  return (change - h * rate).cwiseAbs().cwiseQuotient(scale_.head(size)).maxCoeff();
}

void ExactStep::TakeBack() {
  time_ = step_.start_time();
  now_ = start_;
  is_closed_ = false;
  gap_ = 0.0;
  std::copy_n(step_.start_y(), dynamics_->state_size(), y_.data());
  step_.Start(time_, y_.data(), Field());
}

void ExactStep::GoOn() {
  is_closed_ = false;
  step_.At(time_, y_.data());
  step_.Start(time_, y_.data(), Field());
}

void ExactStep::MakeDense() { step_.MakeDense(Field()); }

void ExactStep::Sample(double t, HingeState* state, Gaps gaps) {
  HAZUMI_ASSERT(start_time() - kSameTime <= t && t <= time_ + kSameTime);
  MakeDense();
  step_.At(t, y_.data());
  if (gaps == Gaps::kClosed && closes_gaps()) {
    dynamics_->CloseGaps(t, y_.data(), /*only_sampled=*/true);
  }
  const double length = time_ - step_.start_time();
  const double s = length > 0.0 ? (t - step_.start_time()) / length : 0.0;
  state->q = s < 0.5 ? start_.q : now_.q;  // nearby, to pick the branch
  state->qd.resize(state->q.size());
  state->outer.balls.resize(now_.outer.balls.size());
  dynamics_->Unpack(y_.data(), limits_->lower(), limits_->upper(), state);
}

void ExactStep::SampleNodes(double t, const std::vector<int>& nodes, HingeState* state) {
  step_.At(t, y_.data());
  for (const int node : nodes) {
    dynamics_->layout().UnpackNode(node, y_.data(), limits_->lower(), limits_->upper(), &state->q,
                                   &state->qd);
  }
}

VecX ExactStep::EvaluateAt(double t, Gaps gaps) {
  if (t >= time_) {
    inside_ = now_;
    dynamics_->Pack(now_, y_.data());
  } else {
    Sample(t, &inside_, gaps);
  }
  VecX dy(dynamics_->state_size());
  dynamics_->Evaluate(t, y_.data(), dy.data());
  return dy;
}

InstantReport ExactStep::Report(double t) {
  InstantReport report;
  const VecX dy = EvaluateAt(t, Gaps::kClosed);
  const RegionLayout& layout = dynamics_->layout();
  const RegionMode& mode = dynamics_->mode();
  report.qd = inside_.qd;
  layout.UnpackAccelerations(dy.data() + layout.num_positions(), inside_.q, inside_.qd,
                             &report.qdd);
  if (dynamics_->is_pushed_in_flight()) report.fall = dy.segment<3>(layout.state_size() + 3);
  report.constraints = ConstraintPushes();
  if (mode.contacts.is_possible()) {
    report.contacts = dynamics_->rows().ContactPushes(mode, dynamics_->PlacedAt(t, y_.data()));
  }
  report.spent = dynamics_->SpentDrives(t, inside_);
  return report;
}

// Forces of the latest evaluation. Each row pushes or turns along its n.
std::vector<ConstraintPush> ExactStep::ConstraintPushes() const {
  const std::vector<ConstraintRow>& rows = dynamics_->rows().rows();
  const VecX& forces = dynamics_->rows().forces();
  const ConstraintSet& constraints = dynamics_->mode().constraints;
  std::vector<ConstraintPush> pushes(constraints.specs().size());
  if (pushes.empty()) return pushes;
  const VecX sizes = constraints.SizesOf(rows, forces);
  for (size_t i = 0; i < pushes.size(); ++i) pushes[i].size = sizes[static_cast<Eigen::Index>(i)];
  for (size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].is_contact()) continue;
    Wrench& on_a = pushes[static_cast<size_t>(rows[k].constraint)].on_a;
    (rows[k].turns ? on_a.moment : on_a.force) +=
        forces[static_cast<Eigen::Index>(k)] * rows[k].n.eigen();
  }
  return pushes;
}

ConstraintSet::Overload ExactStep::WorstOverload(double t) {
  EvaluateAt(t, Gaps::kLeft);
  const RowSystem& rows = dynamics_->rows();
  return dynamics_->mode().constraints.WorstOverload(rows.rows(), rows.forces(),
                                                     /*are_impulses=*/false);
}

// Beside a singular pose, bent a little, the constraint has one more direction of full rank.
std::optional<int> ExactStep::SingularConstraint() {
  constexpr double kSingular = 1e-6, kLittle = 0.05;  // relative; [rad]
  EvaluateAt(time_, Gaps::kLeft);
  const std::vector<RowSystem::Eigenvalue> here = dynamics_->rows().Spectrum();
  for (Eigen::Index i = 0; i < inside_.q.size(); ++i) {
    inside_.q[i] += kLittle * std::sin(1.0 + static_cast<double>(i));
  }
  dynamics_->layout().Pack(inside_.q, inside_.qd, y_.data());
  VecX dy(dynamics_->state_size());
  dynamics_->Evaluate(time_, y_.data(), dy.data());
  const std::vector<RowSystem::Eigenvalue> bent = dynamics_->rows().Spectrum();
  for (size_t k = 0; k < std::min(here.size(), bent.size()); ++k) {
    if (here[k].value < kSingular && bent[k].value > 10.0 * kSingular) return here[k].constraint;
  }
  return std::nullopt;
}

RegionState ExactStep::Glance(double t) {
  MakeDense();
  step_.At(t, y_.data());
  return dynamics_->PlaceAt(t, y_.data());
}

RowSystem::Excess ExactStep::ContactExcess(double t) {
  EvaluateAt(t, Gaps::kLeft);
  return dynamics_->rows().ContactExcess(dynamics_->mode().contacts);
}

EnergyFlow ExactStep::Energy(double t) {
  MakeDense();
  step_.At(t, y_.data());
  return dynamics_->MeasureEnergy(t, y_.data());
}

}  // namespace hazumi
