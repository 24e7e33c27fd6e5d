// The islands of a region are those that a bake solved (IslandHistory), with the same curves and
// forces; each is solved once more, to the tolerance of the derivatives, with its variational
// equations beside it (SensitivitySolver). From one to the next the joints keep angles and rates.

#include "engine/bake/sensitivity/region_sensitivity.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "engine/bake/island_curves.h"
#include "engine/bake/island_run.h"
#include "engine/bake/sensitivity/island_history.h"
#include "engine/base/assert.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

bool OverlapsRegion(const DynamicsRegion& region, int first, int last) {
  return first < region.last_frame && region.first_frame < last;
}

// Returns whether a hold solves joints that the region moves or carries.
bool IsCarried(const IkHold& hold, const DynamicsRegion& region, const Figure& figure) {
  for (const GroupIndex group : SolvedJoints(hold, figure)) {
    for (JointIndex j = figure.group(group).first; j.is_valid(); j = figure.joint(j).parent) {
      if (std::binary_search(region.joints.begin(), region.joints.end(), j)) return true;
    }
  }
  return !hold.joint.is_valid();
}

// Returns why the derivatives of a region's motion are unknown, as part of a sentence; nothing if
// they are known.
std::optional<std::string> FindUncovered(const Animation& animation, const DynamicsRegion& region) {
  if (region.method != Method::kExact) return "its method is paper; give it the method exact";
  if (region.moves_nothing()) return "it moves no joint";
  if (region.touches_scene || region.touches_self) return "it has contacts; take them off";
  for (const PlacementSpan& span : animation.placements) {
    const bool is_gravity = span.kind == PlacementKind::kGravity;
    if (is_gravity && OverlapsRegion(region, span.first_frame, span.last_frame)) {
      return "gravity places the figure meanwhile; key its position, or pin a joint";
    }
  }
  for (const Constraint& constraint : animation.constraints) {
    if (OverlapsRegion(region, constraint.first_frame, constraint.last_frame)) {
      return "the constraint " + constraint.name + " acts meanwhile; take it off";
    }
  }
  for (const OuterForce& force : animation.forces) {
    if (OverlapsRegion(region, force.first_frame, force.last_frame)) {
      return "the force " + force.name + " acts meanwhile; take it off";
    }
  }
  for (const IkHold& hold : animation.holds) {
    if (OverlapsRegion(region, hold.first_frame, hold.last_frame) &&
        IsCarried(hold, region, *animation.figure)) {
      return "a hold solves joints that it carries; take the hold off";
    }
  }
  return std::nullopt;
}

std::string CauseOf(SensitivityFailure::Cause cause) {
  using Cause = SensitivityFailure::Cause;
  switch (cause) {
    case Cause::kNoMotion:
      return "the motion cannot be solved further";
    case Cause::kAtPole:
      return "a ball joint is at a pole of its angles, which have no derivative there";
    case Cause::kOutside:
      return "a joint is outside its limits, which follow it";
    case Cause::kImpact:
      return "several limits are hit again and again";
    case Cause::kNotSmooth:
      return "forces are not smooth";
  }
  return "";
}

// The joint `hinge`, for messages.
std::string NameOfHinge(Coordinate hinge, const Figure& figure) {
  if (hinge >= figure.num_joints()) return "the root";
  return figure.joint(JointIndex(hinge)).name;
}

// Solves the islands of one region one after the other, and collects their derivatives.
class RegionDerivation {
 public:
  RegionDerivation(const Animation& animation, int region, const std::vector<int>& frames,
                   const SensitivitySolver::Tolerance& tolerance,
                   const std::vector<IslandHistory>& histories)
      : animation_(animation), index_(region), tolerance_(tolerance) {
    for (const IslandHistory& history : histories) {
      result_.hinges.insert(result_.hinges.end(), history.hinges.begin(), history.hinges.end());
    }
    std::sort(result_.hinges.begin(), result_.hinges.end());
    result_.hinges.erase(std::unique(result_.hinges.begin(), result_.hinges.end()),
                         result_.hinges.end());
    const auto n = static_cast<Eigen::Index>(result_.hinges.size());
    D_ = MatX::Identity(2 * n, 2 * n);
    q_ = qd_ = VecX::Zero(n);
    result_.one_sided_from.assign(2 * result_.hinges.size(),
                                  std::numeric_limits<double>::infinity());
    has_begun_.assign(result_.hinges.size(), 0);
    const MatX unknown = MatX::Constant(2 * n, 2 * n, std::numeric_limits<double>::quiet_NaN());
    for (const int frame : frames) result_.frames.push_back({frame, q_, qd_, unknown});
  }

  std::optional<Error> Solve(const IslandHistory& history);
  // After the last island: each frame is in one of each hinge.
  RegionSensitivity Take() {
    for (const auto& at : result_.frames) HAZUMI_DEMAND(!at.D.hasNaN());
    std::stable_sort(result_.events.begin(), result_.events.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
    return std::move(result_);
  }

 private:
  Eigen::Index RowOf(Coordinate hinge) const {
    const auto at = std::lower_bound(result_.hinges.begin(), result_.hinges.end(), hinge);
    return at - result_.hinges.begin();
  }
  Error ErrorAt(double time, const std::string& cause) const;
  std::optional<Error> CheckIsland(const IslandHistory& history) const;
  Result<HingeState> StartOf(const IslandHistory& history);
  std::optional<Error> SolvePiece(const IslandHistory& history, const IslandHistory::Piece& piece,
                                  SensitivitySolver* solver);
  std::optional<Error> Store(const IslandHistory& history, const SensitivitySolver& solver,
                             RegionSensitivity::AtFrame* at);

  const Animation& animation_;
  int index_;
  SensitivitySolver::Tolerance tolerance_;
  RegionSensitivity result_;
  // State that islands have reached, and its derivatives, by result_.hinges.
  VecX q_, qd_;
  MatX D_;
  std::vector<char> has_begun_;
};

Error RegionDerivation::ErrorAt(double time, const std::string& cause) const {
  return {ErrorCode::kSemantics, "", "regions[" + std::to_string(index_) + "]",
          "its motion has no known derivative from frame " +
              FormatShort(animation_.rate.FrameAt(time)) + " on: " + cause};
}

std::optional<Error> RegionDerivation::CheckIsland(const IslandHistory& history) const {
  const double t = history.pieces.front().start;
  const IslandTask& task = *history.task;
  if (task.model.coupling == RootCoupling::kFlight) return ErrorAt(t, "the figure flies");
  if (!task.contacts.empty() || !task.model.balls.empty()) return ErrorAt(t, "it has contacts");
  if (!task.constraints.empty()) return ErrorAt(t, "it has constraints");
  if (!history.start.pin_velocity.isZero(0.0)) {
    return ErrorAt(t, "a pin stops the root, which moves before");
  }
  return std::nullopt;
}

// The state that it begins with: the one that the island before has got to.
Result<HingeState> RegionDerivation::StartOf(const IslandHistory& history) {
  constexpr double kSame = 1e-3;  // errors of a bake are smaller [rad, rad/s / kRateScale]
  HingeState start = history.start;
  for (size_t i = 0; i < history.hinges.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const Eigen::Index row = RowOf(history.hinges[i]);
    char& has_begun = has_begun_[static_cast<size_t>(row)];
    if (has_begun) {
      const double turn = std::abs(start.q[at] - q_[row]);
      const double rate = std::abs(start.qd[at] - qd_[row]) / ExactStep::kRateScale;
      if (std::max(turn, rate) > kSame) {
        return ErrorAt(history.pieces.front().start,
                       "the joint " + NameOfHinge(history.hinges[i], *animation_.figure) +
                           " does not go on as it came");
      }
      start.q[at] = q_[row];
      start.qd[at] = qd_[row];
    }
    has_begun = 1;
  }
  return start;
}

std::optional<Error> RegionDerivation::Solve(const IslandHistory& history) {
  if (auto error = CheckIsland(history)) return error;
  Result<HingeState> start = StartOf(history);
  if (!start.ok()) return start.error();
  const IslandTask& task = *history.task;
  RegionDynamics dynamics(WithOwnCurves(task.model), MakeLaws(task.forces), task.gravity, {},
                          task.contacts);
  SensitivitySolver solver(&dynamics, task.lower, task.upper, tolerance_);
  const auto k = static_cast<Eigen::Index>(history.hinges.size()), n = q_.size();
  MatX D(2 * k, 2 * n);
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index row = RowOf(history.hinges[static_cast<size_t>(i)]);
    D.row(i) = D_.row(row);
    D.row(k + i) = D_.row(n + row);
  }
  for (const IslandHistory::Piece& piece : history.pieces) {
    const bool is_first = &piece == &history.pieces.front();
    dynamics.SetDriven(piece.curves.get(), piece.start, piece.end);
    const double longest = LongestStep(dynamics);
    solver.SetLongestStep(piece.curves->may_be_cut() ? std::min(longest, DrivenMotion::kLongestCut)
                                                     : longest);
    if (is_first) {
      if (auto failure = solver.Start(piece.start, piece.end, start.value(), D)) {
        return ErrorAt(failure->time, CauseOf(failure->cause));
      }
    } else {
      solver.Restart(piece.end);
    }
    if (auto error = SolvePiece(history, piece, &solver)) return error;
  }
  const std::optional<MatX> derivatives = solver.Derivatives();
  if (!derivatives) return ErrorAt(solver.time(), CauseOf(SensitivityFailure::Cause::kAtPole));
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index row = RowOf(history.hinges[static_cast<size_t>(i)]);
    q_[row] = solver.now().q[i];
    qd_[row] = solver.now().qd[i];
    D_.row(row) = derivatives->row(i);
    D_.row(n + row) = derivatives->row(k + i);
  }
  for (const SensitivityEvent& event : solver.events()) {
    const Coordinate hinge = history.hinges[static_cast<size_t>(event.hinge)];
    result_.events.push_back({event.time, event.kind, hinge, event.rate});
  }
  for (size_t c = 0; c < result_.one_sided_from.size(); ++c) {
    result_.one_sided_from[c] = std::min(result_.one_sided_from[c], solver.one_sided_from()[c]);
  }
  return std::nullopt;
}

// Advances to its end, and stores what is asked for at the frames on the way.
std::optional<Error> RegionDerivation::SolvePiece(const IslandHistory& history,
                                                  const IslandHistory::Piece& piece,
                                                  SensitivitySolver* solver) {
  const auto advance = [&](double t) -> std::optional<Error> {
    const std::optional<SensitivityFailure> failure = solver->AdvanceTo(t);
    if (failure) return ErrorAt(failure->time, CauseOf(failure->cause));
    return std::nullopt;
  };
  for (RegionSensitivity::AtFrame& at : result_.frames) {
    const double t = animation_.rate.SecondsAt(at.frame);
    if (t < piece.start + kSameTime || t > piece.end + kSameTime) continue;
    if (auto error = advance(std::min(t, piece.end))) return error;
    if (auto error = Store(history, *solver, &at)) return error;
  }
  return advance(piece.end);
}

std::optional<Error> RegionDerivation::Store(const IslandHistory& history,
                                             const SensitivitySolver& solver,
                                             RegionSensitivity::AtFrame* at) {
  const std::optional<MatX> derivatives = solver.Derivatives();
  if (!derivatives) return ErrorAt(solver.time(), CauseOf(SensitivityFailure::Cause::kAtPole));
  const auto k = static_cast<Eigen::Index>(history.hinges.size());
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index row = RowOf(history.hinges[static_cast<size_t>(i)]);
    at->q[row] = solver.now().q[i];
    at->qd[row] = solver.now().qd[i];
    at->D.row(row) = derivatives->row(i);
    at->D.row(q_.size() + row) = derivatives->row(k + i);
  }
  return std::nullopt;
}

}  // namespace

Result<RegionSensitivity> DeriveRegion(const Animation& animation, int index,
                                       const std::vector<int>& frames,
                                       const RegionSensitivityOptions& options) {
  const DynamicsRegion& region = animation.regions[static_cast<size_t>(index)];
  const int last_frame = std::min(region.last_frame, animation.last_frame);
  HAZUMI_ASSERT(!frames.empty() && std::is_sorted(frames.begin(), frames.end()));
  if (const std::optional<std::string> uncovered = FindUncovered(animation, region)) {
    return Error{ErrorCode::kSemantics, "", "regions[" + std::to_string(index) + "]",
                 "the derivatives of its motion are not known: " + *uncovered};
  }
  for (const int frame : frames) {
    if (frame > region.first_frame && frame <= last_frame) continue;
    return Error{ErrorCode::kSemantics, "", "regions[" + std::to_string(index) + "]",
                 "frame " + std::to_string(frame) + " is none of its frames after the first one"};
  }
  const Result<std::vector<IslandHistory>> histories =
      BakeHistories(animation, index, frames.back(), options.threads);
  if (!histories.ok()) return histories.error();
  RegionDerivation derivation(animation, index, frames, options.tolerance, histories.value());
  for (const IslandHistory& history : histories.value()) {
    if (auto error = derivation.Solve(history)) return *error;
  }
  return derivation.Take();
}

}  // namespace hazumi
