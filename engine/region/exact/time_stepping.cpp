// Time stepping with constant forces over a step of h seconds [Moreau 1988]. w = J v are the
// velocities of the nearby rows, each with a gap (or a hinge's distance to its limit) s >= 0:
//   impulses p at the beginning   w+ = w + A p         w+ >= -s / h,  p >= 0, complementary
//   forces l up to the end        w+ + h (J x_0 + c + A l)            likewise
// both within the friction cones. Springs in joints are implicit (ImplicitSprings). A row that
// would close within the step is slowed down to close at the end of the step. A penetrating row (s
// < 0) is depenetrated slowly. Restitution is zero in this mode.

#include "engine/region/exact/time_stepping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/region/exact/tree_step_problem.h"
#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

using Kind = ConeProblem::Kind;

constexpr double kNoBlow = 0.02, kNoBlowTurn = 0.1;  // is no impact [m/s, rad/s]
constexpr double kInside = 2e-5, kSunk = 2e-3;       // [m]
constexpr double kNearLimit = 0.02;                  // of a hinge to its limit [rad]
// What is inside comes out in about this time, but not faster than that.
constexpr double kWayOut = 0.02, kFastestOut = 0.1, kFastestTurnOut = 0.5;  // [s, m/s, rad/s]
constexpr double kGivesWay = 1e-4, kGivesMoreWay = 0.2;
// What contacts push with at most, as parts of the island's mass [m/s^2], and in a blow of that
// times the greatest speed of what may touch.
constexpr double kMostPush = 1e3, kMostBlow = 10.0;
constexpr int kCalm = 8, kCalmest = 128;  // steps
// Length of a step: until forces are off by so much, as bodies turn; and not much longer than that
// of the last step.
constexpr double kShortest = 1e-3, kLongest = 8e-3;  // [s]
constexpr double kHalved = kShortest / 64.0;         // at least [s]
constexpr double kOff = 1e-4, kMostTurn = 0.1;       // [m, rad]
constexpr double kSoon = 0.1;                        // [s]
constexpr double kSlides = 1e-3;                     // tangential speed of sliding [m/s]
constexpr double kGiven = 0.01;                      // largest gain of kinetic energy
constexpr double kAtRest = 1e-4;                     // largest speed of a body at rest [m/s]

// Returns the force of a contact's row on its end a, or, with a ball, on the ball.
StepForces::Push PushOf(const ConstraintRow& row, const V3& force, const ContactSet& contacts,
                        const RegionState& state) {
  const auto is_ball = [&](int node) { return state.kinematics.is_ball(node); };
  const auto on_node = [&](int node, const V3& r) -> Vec3 {
    if (node < 0) return Vec3::Zero();
    return (is_ball(node) ? r : TransposeTimes(state.kinematics.motion()[node].R, r)).eigen();
  };
  StepForces::Push push;
  push.node = row.a;
  push.p_N = on_node(row.a, row.r_a);
  push.force = force.eigen();
  push.on_other = row.b;
  push.p_other = on_node(row.b, row.r_b);
  if (is_ball(row.b)) {
    std::swap(push.node, push.on_other);
    std::swap(push.p_N, push.p_other);
    push.force = -push.force;
  }
  push.parts = contacts.PartsOf(contacts.pairs()[row.contact]);
  return push;
}

}  // namespace

// Returns the largest speed against a row with room s, or that far inside.
double TimeStepping::SpeedFor(double s, double fastest_out) const {
  return s >= 0.0 ? s / h_ : std::max(s / kWayOut, -fastest_out);
}

TimeStepping::TimeStepping(RegionDynamics* dynamics, const LimitRange* limits)
    : dynamics_(dynamics), limits_(limits) {
  if (dynamics->solves_contacts_by_tree()) {
    problem_ = std::make_unique<TreeStepProblem>(dynamics);
  } else {
    auto dense = std::make_unique<DenseStepProblem>(dynamics);
    dense_ = dense.get();
    problem_ = std::move(dense);
  }
  side_.assign(static_cast<size_t>(dynamics->num_hinges()), 0);
  torques_.setZero(dynamics->num_hinges());
}

void TimeStepping::Begin() {
  calm_enough_ = kCalm;
  left_ = -HUGE_VAL;
}

void TimeStepping::Enter(double t) {
  calm_enough_ = t - left_ < kSoon ? std::min(2 * calm_enough_, kCalmest) : kCalm;
  calm_steps_ = 0;
  least_compliance_ = RegionMode::kBlocked;
  start_ = t;
  longest_ = kLongest;
  is_inside_ = is_deep_ = has_no_room_ = false;
  pushing_.clear();
  torques_.setZero();
}

void TimeStepping::Leave(double t) {
  left_ = t;
  dynamics_->mode().constant.Clear();
}

// A little of the motion, and what lifts the bodies by what forces may be off by, is no matter; nor
// what lets them out.
bool TimeStepping::GivesTooMuch(double seconds, const RegionState& state) const {
  HAZUMI_ASSERT(seconds > 0.0 && h_ > 0.0);
  const double out = is_inside_ ? kFastestOut : 0.0;
  const double still = contacts().rules().rests_without_gravity ? kAtRest : 0.0;
  const double lift =
      dynamics_->gravity() * (kOff + out * h_) + 0.5 * out * out + 0.5 * still * still;
  const StepForces& constant = dynamics_->mode().constant;
  const double work = constant.WorkOfPushes(state) + 0.5 * seconds * constant.PowerOfMoments(state);
  return work > kGiven * kinetic_ + dynamics_->model().mass * lift;
}

bool TimeStepping::Halve() {
  if (0.5 * h_ < kHalved) return false;
  longest_ = 0.5 * h_;
  calm_steps_ = 0;
  return true;
}

void TimeStepping::GiveNothing() {
  dynamics_->mode().constant.Clear();
  torques_.setZero();
  pushing_.clear();
}

void TimeStepping::Set(double t, HingeState* state, ImpactLog* log) {
  dynamics_->mode().constant.Clear();
  dynamics_->mode().least_compliance = least_compliance_;
  log->AddWork({0.0, 0.0, /*has_contacts=*/true});
  ListNear(t, *state);
  problem_->Assemble(t, *state);
  problem_->Factor();
  const bool is_struck = Strike(t, state, log);
  if (is_struck) problem_->Assemble(t, *state);
  kinetic_ = problem_->KineticEnergy(state->qd) +
             0.5 * dynamics_->model().mass * state->outer.anchor.v.squaredNorm() +
             dynamics_->bodies().KineticEnergy(state->outer);
  Press(t, *state);
  dynamics_->mode().constant.Begin(dynamics_->PlacedHinges(t, *state));
  if (is_struck || is_inside_) calm_steps_ = 0;
  contacts().OpenAll();
}

bool TimeStepping::IsAnyInside(double t, const HingeState& state) {
  const RegionState places = dynamics_->PlaceHinges(t, state);
  contacts().FindPairs(places, kInside);
  for (int i = 0; i < static_cast<int>(contacts().pairs().size()); ++i) {
    const auto point = contacts().PointOf(i, places);
    const bool may_stay = contacts().MayStayInside(contacts().pairs()[i]);
    if (point && !may_stay && point->gap < -kInside) return true;
  }
  return false;
}

// The compliance of a contact is a share of its response to its own force, so that forces stay
// finite where there is no room. It is larger for what has been inside from the beginning, and is
// not deeper now.
void TimeStepping::AddCompliance() {
  // Response of a free body of the whole mass, at least.
  const double least = 1.0 / dynamics_->model().mass;
  for (const ConeProblem::Block& block : problem_->blocks()) {
    if (block.kind != Kind::kContact) continue;
    const ConstraintRow& row = rows()[static_cast<size_t>(block.row)];
    const double sunk = row.gap >= 0.0 ? std::clamp(-GapOf(row) / kSunk, 0.0, 1.0) : 0.0;
    const double hold = problem_->Response(block.row);
    const double more = (kGivesWay + kGivesMoreWay * sunk * sunk) * std::max(hold, least);
    problem_->SetResponse(block.row, hold + more);
  }
}

// Gives contacts with far more force than `most` a compliance that leaves about that much: forces
// would have no bound where keys or limits leave no room.
void TimeStepping::SweepUpTo(double most, const VecX& start) {
  constexpr int kMostTimes = 4;
  problem_->Sweep(start, !is_deep_);
  for (int i = 0; i < kMostTimes; ++i) {
    bool any = false;
    for (const ConeProblem::Block& block : problem_->blocks()) {
      const double push = problem_->forces()[block.row];
      if (block.kind != Kind::kContact || push <= 2.0 * most) continue;
      has_no_room_ = true;
      problem_->SetResponse(block.row, problem_->Response(block.row) * (push / most));
      any = true;
    }
    if (!any) return;
    problem_->Sweep(problem_->forces(), !is_deep_);
  }
}

void TimeStepping::ListNear(double t, const HingeState& state) {
  const RegionState places = dynamics_->PlaceHinges(t, state);
  const ContactSet::Speed fastest = contacts().Fastest(places);
  h_ = std::min({2.0 * (t - start_), std::sqrt(kOff / (fastest.turn * fastest.end + 1e-9)),
                 kMostTurn / (fastest.turn + 1e-9)});
  h_ = std::min(std::clamp(h_, kShortest, kLongest), longest_);
  longest_ = 2.0 * h_;
  start_ = t;
  fastest_ = fastest.end;
  const double reach = 2.0 * h_ * fastest.end + 1e-4;
  contacts().FindPairs(places, reach);
  contacts().TightenGaps(places);
  if (has_no_room_ || is_deep_) AllowMoreCompliance();
  is_inside_ = is_deep_ = has_no_room_ = false;
  for (int i = 0; i < static_cast<int>(contacts().pairs().size()); ++i) {
    const auto point = contacts().PointOf(i, places);
    const bool is_near = point && point->gap <= reach;
    const bool is_felt = is_near && !contacts().IsBuried(i, point->gap);
    contacts().SetMode(i, is_felt ? ContactMode::kStick : ContactMode::kOpen);
    is_inside_ |= is_near && point->gap < -kInside;
    is_deep_ |= is_felt && point->gap < -kSunk;
  }
  for (int i = 0; i < static_cast<int>(side_.size()); ++i) {
    side_[i] = 0;
    if (limits_->is_fixed(i)) continue;
    const double up = -limits_->Beyond(i, 1, state.q[i]),
                 down = -limits_->Beyond(i, -1, state.q[i]);
    const double near = kNearLimit + 2.0 * h_ * std::abs(state.qd[i]);
    if (std::min(up, down) < near) side_[i] = up < down ? 1 : -1;
  }
}

// Increases the compliance of constraints that conflict with contacts.
void TimeStepping::AllowMoreCompliance() {
  constexpr double kMore = 10.0, kMaxCompliance = 1e3;
  if (!contacts().rules().parts_what_is_tied) return;
  least_compliance_ = std::min(kMore * least_compliance_, kMaxCompliance);
}

double TimeStepping::RoomOf(int hinge, const VecX& q) const {
  return -limits_->Beyond(hinge, side_[hinge], q[hinge]);
}

// Where balls begin inside the figure they stay as deep as that until they leave.
double TimeStepping::GapOf(const ConstraintRow& row) const {
  const ContactPair& pair = contacts().pairs()[row.contact];
  return contacts().MayStayInside(pair) ? row.gap : row.gap + pair.allowed_gap;
}

bool TimeStepping::Strike(double t, HingeState* state, ImpactLog* log) {
  const VecX came = problem_->Rates();
  VecX rates = came;
  bool any = false;
  for (Eigen::Index k = 0; k < rates.size(); ++k) {
    const ConstraintRow& row = rows()[static_cast<size_t>(k)];
    if (!row.is_contact() || row.is_across) continue;
    rates[k] += std::max(0.0, GapOf(row)) / h_;
    any |= rates[k] < -kNoBlow;
  }
  const auto speed_left = [&](int hinge) {
    return std::max(0.0, RoomOf(hinge, state->q)) / h_ - side_[hinge] * state->qd[hinge];
  };
  for (int i = 0; i < static_cast<int>(side_.size()); ++i) {
    any |= side_[i] != 0 && speed_left(i) < -kNoBlowTurn;
  }
  if (!any) return false;
  problem_->SetUp(StepProblem::Acting::kImpulses, side_, rates, state->qd);
  VecX& b = problem_->b();
  for (size_t k = 0; k < problem_->limits().size(); ++k) {
    b[problem_->RowOfLimit(k)] = speed_left(problem_->limits()[k]);
  }
  AddCompliance();
  SweepUpTo(kMostBlow * dynamics_->model().mass * std::max(1.0, fastest_), VecX::Zero(b.size()));
  ConstraintSet& constraints = dynamics_->mode().constraints;
  const auto worst =
      constraints.WorstOverload(rows(), problem_->row_forces(), /*are_impulses=*/true);
  if (worst.excess > 0.0) {
    constraints.Break(worst.constraint, t);
    problem_->Assemble(t, *state);
    problem_->Factor();
    return Strike(t, state, log);
  }
  for (size_t k = 0; k < problem_->limits().size(); ++k) {
    const int hinge = problem_->limits()[k];
    if (problem_->forces()[problem_->RowOfLimit(k)] > 0.0 && speed_left(hinge) < -kNoBlowTurn) {
      log->AddHit(hinge, t);
    }
  }
  const VecX before = state->qd;
  state->qd += problem_->Jump();
  TellOfContacts(t, came, log);
  log->AddWork({problem_->WorkOfLimits(side_, before, state->qd), 0.0, /*has_contacts=*/true});
  state->outer.Jump(dynamics_->bodies().VelocityChanges(rows(), problem_->row_forces()));
  return true;
}

// Reports touch-downs: contacts that approached and received an impulse. `came`: velocities of the
// rows before the impact.
void TimeStepping::TellOfContacts(double t, const VecX& came, ImpactLog* log) const {
  for (const ConeProblem::Block& block : problem_->blocks()) {
    if (block.kind != Kind::kContact || came[block.row] > -kNoBlow) continue;
    if (problem_->forces()[block.row] <= 0.0) continue;
    const int pair = rows()[static_cast<size_t>(block.row)].contact;
    log->AddTouch(contacts().PartsOf(contacts().pairs()[pair]), contacts().BallOf(pair), t);
  }
}

// For rates after impacts.
void TimeStepping::Press(double t, const HingeState& state) {
  VecX x_0;
  const RegionState places = dynamics_->PlacedHinges(t, state);
  if (dynamics_->has_implicit_springs()) {
    VecX b = dense_->equations().b();
    MatX M = dense_->equations().M();
    springs_.List(dynamics_->laws(), places);
    springs_.AddTo(h_, places, &M, &b);
    dense_->FactorInstead(M, b);
  }
  VecX of_rows = problem_->Accelerations(&x_0);
  of_rows *= h_;
  for (Eigen::Index k = 0; k < of_rows.size(); ++k) {
    const ConstraintRow& row = rows()[static_cast<size_t>(k)];
    if (!row.is_contact()) continue;
    of_rows[k] += row.rate;
    if (!row.is_across) of_rows[k] += SpeedFor(GapOf(row), kFastestOut);
  }
  problem_->SetUp(StepProblem::Acting::kForces, side_, of_rows, state.qd + h_ * x_0);
  for (size_t k = 0; k < problem_->limits().size(); ++k) {
    const double room = RoomOf(problem_->limits()[k], state.q);
    problem_->b()[problem_->RowOfLimit(k)] += SpeedFor(room, kFastestTurnOut);
  }
  AddCompliance();
  SweepUpTo(kMostPush * dynamics_->model().mass * h_, h_ * LastForces());
  Keep(problem_->forces(), places);
  if (dynamics_->has_implicit_springs()) {
    springs_.Keep(h_, h_ * x_0 + problem_->Jump(), dynamics_->laws(), places,
                  &dynamics_->mode().constant);
  }
}

// Forces of the previous step, for contacts and limits that are there again.
VecX TimeStepping::LastForces() const {
  VecX forces = VecX::Zero(problem_->b().size());
  for (Eigen::Index k = 0; k < problem_->num_rows(); ++k) {
    const ConstraintRow& row = rows()[static_cast<size_t>(k)];
    if (row.is_contact()) {
      forces[k] = Dot(contacts().pairs()[row.contact].step_force, row.n);
    }
  }
  for (size_t k = 0; k < problem_->limits().size(); ++k) {
    const int hinge = problem_->limits()[k];
    forces[problem_->RowOfLimit(k)] = std::max(0.0, -side_[hinge] * torques_[hinge]);
  }
  return forces;
}

void TimeStepping::Keep(const VecX& impulses, const RegionState& state) {
  HAZUMI_ASSERT(IsFinite(impulses));
  const VecX w = problem_->Velocities();
  std::vector<Pushing> pushing;
  for (int i = 0; i < static_cast<int>(contacts().pairs().size()); ++i) {
    contacts().SetStepForce(i, V3());
  }
  for (const ConeProblem::Block& block : problem_->blocks()) {
    if (block.kind != Kind::kContact || impulses[block.row] <= 0.0) continue;
    const ConstraintRow& row = rows()[static_cast<size_t>(block.row)];
    V3 force;
    for (int k = block.row; k < block.row + 3; ++k) {
      force += (impulses[k] / h_) * rows()[static_cast<size_t>(k)].n;
    }
    contacts().SetStepForce(row.contact, force);
    const ContactPair& pair = contacts().pairs()[row.contact];
    dynamics_->mode().constant.pushes.push_back(PushOf(row, force, contacts(), state));
    const bool slides = w.segment<2>(block.row + 1).norm() > kSlides;
    pushing.emplace_back(PushingContact{pair.capsule, pair.partner, slides});
  }
  torques_.setZero();
  for (size_t k = 0; k < problem_->limits().size(); ++k) {
    const int hinge = problem_->limits()[k];
    const double impulse = impulses[problem_->RowOfLimit(k)];
    if (impulse <= 0.0) continue;
    torques_[hinge] = -side_[hinge] * impulse / h_;
    pushing.emplace_back(PushingLimit{hinge});
  }
  dynamics_->mode().constant.AddTorques(torques_, state);
  std::sort(pushing.begin(), pushing.end());
  pushing.erase(std::unique(pushing.begin(), pushing.end()), pushing.end());
  calm_steps_ = pushing == pushing_ ? calm_steps_ + 1 : 0;
  pushing_.swap(pushing);
}

}  // namespace hazumi
