#include "engine/region/region_dynamics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/base/assert.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

// Largest number of free hinges of an island whose contacts are solved with matrices.
constexpr int kMostByMatrices = 64;

}  // namespace

RegionDynamics::RegionDynamics(RegionModel model, ForceLaws laws, double gravity,
                               std::vector<ConstraintSpec> constraints, ContactSpec contacts)
    : model_(std::make_shared<const RegionModel>(std::move(model))),
      laws_(std::move(laws)),
      has_rows_(!constraints.empty() || !contacts.empty()),
      mode_{RegionLayout(*model_, /*balls=*/true), ConstraintSet(std::move(constraints)),
            ContactSet(std::move(contacts))},
      hinge_layout_(*model_, /*balls=*/false),
      outer_layout_(is_pushed_in_flight(), static_cast<int>(model_->balls.size())),
      bodies_(model_.get(), gravity),
      kinematics_(model_.get(), gravity, {laws_.any_forces(), has_rows_, is_seen_in_world()}),
      equations_(model_.get()),
      rows_(model_.get(), bodies_),
      contacts_by_tree_(SolvesContactsByTree()) {
  outer_.balls.resize(model_->balls.size());
  const std::vector<char> weightless = WeightlessNodes(*model_);
  has_weightless_ = std::find(weightless.begin(), weightless.end(), 1) != weightless.end();
}

void RegionDynamics::SetDriven(const DrivenMotion* driven, double start, double end) {
  kinematics_.SetCurves(driven, start, layout());
  if (!kinematics_.needs_moving_base()) return;
  kinematics_.UseMovingBase(kinematics_.FitMovingBase(start, end, layout()));
}

double RegionDynamics::FastestRate() const {
  return std::max(mode_.constraints.FastestRate(), laws_.FastestRate());
}

bool RegionDynamics::is_large() const {
  if (contacts_by_tree_) return true;
  return !has_rows_ && model_->num_free > most_dense_ && MethodFor(mode_) == EquationsMethod::kTree;
}

// A pinned root that responds couples every joint with the pin, which is solved by matrix unless
// that takes too long. Rows need the matrix there, and so do rules that the root has to respond to
// where nothing else acts on it.
EquationsMethod RegionDynamics::MethodFor(const RegionMode& mode) const {
  const auto by_tree = [&] {
    if (!model_->root_answers) return true;
    const bool answers_rules = laws_.any_rules() && model_->nodes[0].role == Role::kFree;
    if (model_->coupling == RootCoupling::kFlight) return has_rows_ || !answers_rules;
    return !mode.any_rows() && !answers_rules && model_->num_free > most_dense_;
  };
  return by_tree() ? EquationsMethod::kTree : EquationsMethod::kDense;
}

// Excludes islands in which rows couple two bodies: constraints, contacts of links with each other
// or with balls, and a pin whose root is dynamic.
bool RegionDynamics::SolvesContactsByTree() const {
  const ContactSet& contacts = mode_.contacts;
  const bool has_pin = model_->root_answers && model_->coupling != RootCoupling::kFlight;
  const bool ties =
      mode_.constraints.any() || !contacts.spec().own.empty() || !model_->balls.empty();
  return contacts.rules().sweeps_large_islands && contacts.is_possible() && !has_pin && !ties &&
         !has_implicit_springs() && model_->num_free > kMostByMatrices;
}

HingeState RegionDynamics::NewState() const {
  return {num_hinges(), static_cast<int>(model_->balls.size())};
}

void RegionDynamics::Pack(const HingeState& state, double* y) const {
  HAZUMI_ASSERT(state.q.size() == num_hinges() && state.qd.size() == num_hinges());
  layout().Pack(state.q, state.qd, y);
  outer_layout_.Pack(state.outer, y + layout().state_size());
}

void RegionDynamics::Unpack(const double* y, const VecX& lower, const VecX& upper,
                            HingeState* state) const {
  HAZUMI_ASSERT(state->q.size() == num_hinges());
  layout().Unpack(y, lower, upper, &state->q, &state->qd);
  state->outer.anchor = mode_.anchor;
  outer_layout_.Unpack(y + layout().state_size(), &state->outer);
}

void RegionDynamics::TakeOuter(const RegionMode& mode, const double* y) {
  outer_.anchor = mode.anchor;
  outer_layout_.Unpack(y + mode.layout.state_size(), &outer_);
}

RegionState RegionDynamics::PlaceAt(double t, const double* y) {
  constexpr double kPlacing = 0.3;  // cost of a placement in evaluations
  other_work_.searches += kPlacing;
  TakeOuter(mode_, y);
  return kinematics_.Place(t, layout(), y, y + layout().num_positions(), outer_);
}

RegionState RegionDynamics::PlaceHinges(double t, const HingeState& state) {
  return kinematics_.Place(t, hinge_layout_, state.q.data(), state.qd.data(), state.outer);
}

std::vector<SpentDrive> RegionDynamics::SpentDrives(double t, const HingeState& state) {
  if (!laws_.any_kinks()) return {};  // the force of a drive that is spent has a kink
  return laws_.Spent(PlaceHinges(t, state));
}

SolvedEquations RegionDynamics::Evaluate(const RegionMode& mode, double t, const double* y,
                                         double* dy) {
  const RegionLayout& layout = mode.layout;
  TakeOuter(mode, y);
  if (mode.constraints.any_closing() && layout.is_any_locked()) FindComplianceUnlocked(mode, t, y);
  const RegionState state = kinematics_.Place(t, layout, y, y + layout.num_positions(), outer_);
  double* x = dy + layout.num_positions();
  const SolvedEquations solved = equations_.Solve(Load(mode, state), MethodFor(mode), x);
  solved.AddRules(laws_, x);
  if (has_rows_) rows_.Constrain(mode, solved, &kinematics_, x);
  if (outer_layout_.size() > 0) {
    const VecX* row_forces = has_rows_ ? &rows_.forces() : nullptr;
    outer_layout_.Derive(y + layout.state_size(),
                         bodies_.Accelerations(kinematics_.nodes(), rows_.rows(), row_forces),
                         dy + layout.state_size());
  }
  layout.DerivePositions(y, dy);
  return solved;
}

// Finds the compliance of rows as if limits locked no hinge.
void RegionDynamics::FindComplianceUnlocked(const RegionMode& mode, double t, const double* y) {
  const VecX none = VecX::Constant(num_hinges(), std::numeric_limits<double>::infinity());
  VecX q = VecX::Zero(num_hinges()), qd = q;
  mode.layout.Unpack(y, -none, none, &q, &qd);
  const RegionState state = kinematics_.Place(t, hinge_layout_, q.data(), qd.data(), outer_);
  const AssembledEquations assembled = equations_.Assemble(Load(mode, state));
  rows_.Measure(mode, state);
  const RowMatrices& matrices = rows_.Assemble(assembled);
  rows_.FindCompliance(mode, rows_.Respond(matrices, equations_.Factor(assembled)));
}

HingeEquations RegionDynamics::AssembleHinges(double t, const HingeState& at) {
  ++evaluations_;
  ++num_assembled_;
  const RegionState state = PlaceHinges(t, at);
  const AssembledEquations assembled = equations_.Assemble(Load(mode_, state));
  if (!has_rows_) return {&equations_.dense(), at.pin_velocity, nullptr, nullptr};
  rows_.Measure(mode_, state);
  VecX rules = VecX::Zero(num_hinges());
  assembled.AddRules(laws_, rules.data());
  rows_.AssembleForHinges(mode_, assembled, rules, &kinematics_, &equations_);
  if (!mode_.any_rows()) return {&equations_.dense(), at.pin_velocity, nullptr, nullptr};
  return {&equations_.dense(), at.pin_velocity, &rows_.for_forces(), &rows_.for_impulses()};
}

SomeHinges RegionDynamics::AssembleSome(const std::vector<int>& hinges, double t,
                                        const HingeState& at) {
  ++evaluations_;
  const RegionState state = PlaceHinges(t, at);
  equations_.AssembleSome(Load(mode_, state), hinges);
  return {&equations_.tree(), state, at.pin_velocity};
}

HingeTree RegionDynamics::AssembleByTree(double t, const HingeState& at) {
  ++evaluations_;
  const RegionState state = PlaceHinges(t, at);
  VecX x(num_hinges());
  const SolvedEquations solved =
      equations_.Solve(Load(mode_, state), EquationsMethod::kTree, x.data());
  HingeTree tree(&equations_.tree().bodies(), state, x);
  rows_.Measure(mode_, state);
  solved.AddRules(laws_, x.data());
  tree.of_rows_ = rows_.Errors(solved, x.data(), &kinematics_);
  return tree;
}

// Kinetic energy of the rates alone. The motion (w, v) of each node contributes m v v / 2 + v . (w
// x h) + w . I w / 2, and the energy of the centre of mass is subtracted.
double HingeTree::KineticEnergy(const VecX& qd) const {
  const RegionModel& model = state_.model;
  const auto& motion = state_.kinematics.motion();
  std::vector<V3> w(motion.size()), v(motion.size());
  V3 momentum;
  double energy = 0.0;
  for (int i = 0; i < state_.kinematics.size(); ++i) {
    if (!model.nodes[i].is_dynamic) continue;
    const NodeMotion& own = motion[i];
    const int parent = model.nodes[i].parent;
    if (parent >= 0) {
      w[i] = w[parent];
      v[i] = v[parent] + Cross(w[parent], own.r);
    }
    const RegionLayout::Node& where = state_.layout.node(i);
    for (int k = 0; k < where.num_dofs; ++k) w[i] += qd[where.dof + k] * own.axis[k];
    const V3 p = own.m * v[i] + Cross(w[i], own.h);
    momentum += p;
    energy += 0.5 * (Dot(v[i], p) + Dot(w[i], own.I * w[i] + Cross(own.h, v[i])));
  }
  const bool flies = model.root_answers && model.coupling == RootCoupling::kFlight;
  return flies ? energy - 0.5 * Dot(momentum, momentum) / model.mass : energy;
}

// Gaps e are closed by dy = -M^-1 J^T A^-1 e, rates by the same.
double RegionDynamics::CloseGaps(double t, double* y, bool only_sampled) {
  constexpr double kNone = 1e-12;
  constexpr int kMostTries = 8;
  const RegionLayout& layout = mode_.layout;
  double* velocities = y + layout.num_positions();
  double* outer = y + layout.state_size();
  VecX change(layout.num_dofs());
  for (int tries = 0;; ++tries) {
    ++evaluations_;
    TakeOuter(mode_, y);
    const RegionState state = kinematics_.Place(t, layout, y, velocities, outer_);
    const std::vector<ConstraintRow>& rows = rows_.Measure(mode_, state, /*may_slide=*/false);
    const SolvedEquations solved =
        equations_.Solve(Load(mode_, state), MethodFor(mode_), change.data());
    rows_.Assemble(solved);
    const RowResponse& response = rows_.Respond(rows_.LeaveClosed(), solved);
    VecX gaps = VecX::Zero(static_cast<Eigen::Index>(rows.size())), rates = gaps;
    for (size_t k = 0; k < rows.size(); ++k) {
      if (!rows[k].is_closed) continue;
      gaps[static_cast<Eigen::Index>(k)] = rows[k].gap;
      rates[static_cast<Eigen::Index>(k)] = rows[k].rate;
    }
    const bool is_last = gaps.lpNorm<Eigen::Infinity>() <= kNone || tries == kMostTries;
    const VecX impulses = rows_.Solve(mode_, response.A, is_last ? rates : gaps);
    change = solved.Respond(response.half * impulses);
    if (is_last) {
      Eigen::Map<VecX>(velocities, layout.num_dofs()) += change;
    } else {
      layout.Turn(change, y);
    }
    if (outer_layout_.size() > 0) {
      const VecX by = bodies_.VelocityChanges(rows, impulses);
      is_last ? outer_layout_.Jump(by, outer) : outer_layout_.MoveOn(by, outer);
    }
    if (is_last) return AllowWhatIsLeft(gaps, only_sampled);
  }
}

// Contacts without room are allowed the gaps that are left. Returns the largest other gap.
double RegionDynamics::AllowWhatIsLeft(const VecX& gaps, bool only_sampled) {
  double left = 0.0;
  for (Eigen::Index k = 0; k < gaps.size(); ++k) {
    const ConstraintRow& row = rows_.rows()[static_cast<size_t>(k)];
    if (!row.is_contact()) {
      left = std::max(left, std::abs(gaps[k]));
    } else if (gaps[k] != 0.0 && !only_sampled) {
      ContactSet& contacts = mode_.contacts;
      contacts.AllowGap(row.contact, contacts.pairs()[row.contact].allowed_gap + gaps[k]);
    }
  }
  return left;
}

EnergyFlow RegionDynamics::MeasureEnergy(double t, const double* y) {
  VecX dy(state_size());
  ++evaluations_;
  const SolvedEquations equations = Evaluate(t, y, dy.data());
  const EnergyMeter::Instant at = {
      *model_,   laws_,          mode_,  bodies_,
      rows_,     equations,      outer_, dy.segment(layout().num_positions(), layout().num_dofs()),
      has_rows_, has_weightless_};
  return EnergyMeter(at, &kinematics_).Measure();
}

Work RegionDynamics::work() const {
  constexpr double kSample = 0.4;  // cost of a contact point in evaluations of one body
  const double entries = static_cast<double>(num_hinges()) * num_hinges();
  Work work = other_work_;
  work.searches +=
      kSample / std::max(1, model_->num_bodies) * static_cast<double>(mode_.contacts.num_samples());
  work.motion += static_cast<double>(evaluations_);
  // The equations of all hinges, with limits, take about one more for each 250 entries of M.
  work.limits += entries / 250.0 * num_assembled_;
  return work;
}

}  // namespace hazumi
