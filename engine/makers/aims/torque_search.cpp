// The model of a limb gives torques u, a path, and S, the derivative of the path by the torques.
// The model is not exact, and an arm that is thrown is sensitive, so the baked motion leaves the
// path. The torques are corrected key by key. With r, the misses of the angles and rates at a key
// in tolerances, and shares of strength x = u / strength, the least change of the torques at the
// two keys around the interval is
//
//   dx = -S^T (S S^T + mu diag(S S^T))^-1 r
//
// In the frame of a goal, r are the misses of the goal. The last three keys are corrected, then the
// last six, then all, with the earlier goals in r. After each bake S takes in what the change did
// [Broyden 1965]:
//
//   S += (dr - S dx) dx^T / (dx^T dx)

#include "engine/makers/aims/torque_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/aims/aimed_limbs.h"
#include "engine/makers/aims/aimed_paths.h"
#include "engine/makers/trial_bakes.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr double kMostWork = 1e7;  // of bakes
constexpr int kLastKeys = 3;       // corrected first for a goal

// How misses are corrected.
struct Correction {
  int most_trials = 12;
  double enough = 0.5;    // largest miss that is left, in tolerances
  double damping = 1e-8;  // mu at least
};
constexpr Correction kOfPath = {2, 3.0, 1e-4}, kOfPathAtGoal = {1, 1.0, 1e-4}, kOfGoal = {};
constexpr double kMostDamping = 1.0;
constexpr double kPathAngle = 1.0 * kDegree, kPathRate = 30.0 * kDegree;  // [rad, rad/s]

constexpr LimbWay kWays[] = {{1.0, 0.01, 0}, {4.0, 0.01, 0}, {0.25, 0.01, 0}};
// Are tried if those go through something: farther from it, or round it on another side.
constexpr LimbWay kWaysRound[] = {{1.0, 0.03, 0}, {1.0, 0.02, 1},  {1.0, 0.02, -1},
                                  {1.0, 0.02, 3}, {1.0, 0.02, -3}, {4.0, 0.06, 0}};
constexpr double kDeep = 5e-4;  // in planes and boxes that counts as no touch [m]

// Angle or rate that a hinge has to have in a frame.
struct Asked {
  int frame = 0;
  JointIndex hinge;
  bool is_rate = false;
  double value = 0.0, tolerance = 1.0;
};

class TorqueSearch {
 public:
  TorqueSearch(const TorqueAim& aim, const Animation& animation, const std::atomic<bool>* cancel)
      : aim_(aim),
        trial_(animation),
        figure_(*animation.figure),
        cancel_(cancel),
        drives_(region().drives),
        limbs_(figure_) {
    for (const AimGoal& goal : aim.goals) last_ = std::max(last_, goal.frame);
  }

  Result<FoundTorques> Find() {
    paths_ = PathsOf(aim_.goals, region(), figure_);
    if (const auto error = BakeTo(last_, VecX())) return *error;
    if (AreMet()) return Finish(VecX());
    for (const AimedHinges& hinges : paths_) {
      auto limb = std::make_unique<AimedLimb>(hinges, region(), GoalsOf(hinges, aim_.goals),
                                              aim_.most, trial_, *motion_);
      if (limb->out_of_reach()) return OutOfReach(*limb->out_of_reach());
      limbs_.Add(std::move(limb));
    }
    // Another motion may arrive where one does not.
    for (const LimbWay& way : kWays) {
      if (auto error = Try(way)) return *error;
      if (is_found_ || IsTooMuch()) break;
    }
    for (const LimbWay& way : kWaysRound) {
      if (!was_deep_ || is_found_ || IsTooMuch()) break;
      if (auto error = Try(way)) return *error;
    }
    if (const auto error = BakeTo(last_, best_)) return *error;
    return Finish(best_);
  }

 private:
  static Error Interrupted() { return {ErrorCode::kInterrupted, "", "", "interrupted"}; }
  Error OutOfReach(const AimedLimb::OutOfReach& out) const {
    const JointGroup& group = figure_.group(figure_.joint(out.goal.joint).group);
    return {ErrorCode::kSemantics, "", "goal",
            "\"" + out.goal.name + "\" is out of reach in frame " + std::to_string(out.goal.frame) +
                ": " + group.name + " comes no nearer than " + FormatShort(100.0 * out.distance) +
                " cm"};
  }
  bool IsTooMuch() const { return bakes_.work() > kMostWork; }
  DynamicsRegion& region() { return trial_.regions[aim_.region]; }

  bool AreMet() {
    return std::all_of(aim_.goals.begin(), aim_.goals.end(), [&](const AimGoal& goal) {
      return MissOf(goal, region(), figure_, *motion_).IsMet(goal);
    });
  }

  // Keeps the torques found if they are the best so far. Errors: kInterrupted.
  std::optional<Error> Try(const LimbWay& way) {
    VecX u = limbs_.Solve(way);
    found_.iterations += limbs_.iterations();
    scale_ = limbs_.Strengths();
    if (best_.size() == 0) best_ = u;
    auto failed = Follow(&u);
    if (!failed) failed = BakeTo(last_, u);
    if (failed && failed->code == ErrorCode::kInterrupted) return failed;
    if (failed) return std::nullopt;
    const double depth = limbs_.DepthIn(*motion_);
    const double miss = std::max(Largest(GoalMisses(last_, true)), kOfGoal.enough) +
                        std::max(0.0, depth - kDeep) / kDeep;
    if (miss < least_) best_ = u;
    least_ = std::min(miss, least_);
    was_deep_ |= depth > kDeep;
    is_found_ = AreMet() && depth <= kDeep;
    return std::nullopt;
  }

  void Put(const VecX& u) {
    region().drives = drives_;
    torques_.clear();
    int at = 0;
    for (const auto& limb : limbs_) {
      if (u.size() == 0) break;
      for (size_t k = 0; k < limb->hinges().path.size(); ++k) {
        if (!limb->hinges().moves[k]) continue;
        Drive drive;
        drive.kind = DriveKind::kTorque;
        drive.joints = {limb->hinges().path[k]};
        for (const int frame : limb->knots()) {
          Key key;
          key.frame = frame;
          key.value = u[at++];
          key.interpolation = Interpolation::kLinear;
          drive.torque.push_back(key);
        }
        if (limb->knots().back() < region().last_frame) drive.torque.back().value = 0.0;
        torques_.push_back({drive.joints[0], drive.torque});
        region().drives.push_back(std::move(drive));
      }
    }
  }

  std::optional<Error> BakeTo(int frame, const VecX& u) {
    if (cancel_ && cancel_->load(std::memory_order_relaxed)) return Interrupted();
    if (!u.allFinite()) return Error{ErrorCode::kFailed, "", "", "no torques were found"};
    Put(u);
    ++found_.bakes;
    const Result<const Motion*> motion = bakes_.BakeTo(frame, trial_);
    if (!motion.ok()) return motion.error();
    motion_ = motion.value();
    return std::nullopt;
  }

  // Misses in tolerances.
  VecX MissesOf(const std::vector<Asked>& rows) const {
    VecX misses(static_cast<int>(rows.size()));
    int i = 0;
    for (const Asked& asked : rows) {
      const MotionLimit& at = ArrivalAt(asked.frame, *motion_);
      const int j = asked.hinge.value();
      misses[i++] = ((asked.is_rate ? at.qd[j] : at.q[j]) - asked.value) / asked.tolerance;
    }
    return misses;
  }

  // Goals in a frame, or up to it.
  std::vector<const AimGoal*> GoalsAt(int frame, bool with_earlier) const {
    std::vector<const AimGoal*> goals;
    for (const AimGoal& goal : aim_.goals) {
      if (goal.frame == frame || (with_earlier && goal.frame < frame)) goals.push_back(&goal);
    }
    return goals;
  }

  std::vector<Asked> RowsOf(const std::vector<const AimGoal*>& goals) {
    std::vector<Asked> rows;
    for (const AimGoal* goal : goals) {
      for (const auto& [j, angle] : goal->angles) {
        rows.push_back({goal->frame, j, false, angle, goal->tolerance});
      }
      for (const JointIndex j : RestingHinges(*goal, region(), figure_)) {
        rows.push_back({goal->frame, j, true, 0.0, kRestRate});
      }
    }
    return rows;
  }

  // Misses of goals: of angles and rates, then of points.
  VecX GoalMisses(int frame, bool with_earlier) {
    const std::vector<const AimGoal*> goals = GoalsAt(frame, with_earlier);
    VecX misses = MissesOf(RowsOf(goals));
    for (const AimGoal* goal : goals) {
      if (!goal->is_place()) continue;
      const ThrowPath path = PathOf(*goal, ArrivalAt(goal->frame, *motion_), figure_);
      misses.conservativeResize(misses.size() + 3);
      misses.tail(3) = OffPlace(*goal, path) / goal->tolerance;
    }
    return misses;
  }

  // Derivatives of misses by torques in shares of strengths, as the model has them.
  MatX ChangesOf(const std::vector<Asked>& rows) const {
    MatX changes(static_cast<int>(rows.size()), scale_.size());
    int i = 0;
    for (const Asked& asked : rows) {
      changes.row(i++) =
          limbs_.ChangeOf(asked.frame, asked.is_rate).row(asked.hinge.value()) / asked.tolerance;
    }
    return changes * scale_.asDiagonal();
  }

  MatX GoalChanges(int frame, bool with_earlier) {
    const std::vector<const AimGoal*> goals = GoalsAt(frame, with_earlier);
    MatX all = ChangesOf(RowsOf(goals));
    DynamicsWorkspace ws(figure_);
    for (const AimGoal* goal : goals) {
      if (!goal->is_place()) continue;
      const MatX change = limbs_.ChangeOf(goal->frame, false) * scale_.asDiagonal();
      const MotionLimit& at = ArrivalAt(goal->frame, *motion_);
      ComputePositions(figure_, at.X_WR, at.q, &ws);
      const Vec3 p = ws.body(goal->joint).p + ws.body(goal->joint).R * goal->offset;
      MatX longer = MatX::Zero(all.rows() + 3, all.cols());
      longer.topRows(all.rows()) = all;
      for (JointIndex j = goal->joint; j.is_valid(); j = figure_.joint(j).parent) {
        const Vec3 lever = ws.body(j).axis.cross(p - ws.body(j).p) / goal->tolerance;
        longer.bottomRows(3) += lever * change.row(j.value());
      }
      all = std::move(longer);
    }
    return all;
  }

  // Path of the limbs that have a key in a frame.
  std::vector<Asked> PathAt(int frame) const {
    std::vector<Asked> rows;
    for (const auto& limb : limbs_) {
      if (!std::binary_search(limb->knots().begin(), limb->knots().end(), frame)) continue;
      const VecX angles = limb->AnglesAt(frame), rates = limb->RatesAt(frame);
      for (size_t k = 0; k < limb->hinges().path.size(); ++k) {
        if (!limb->hinges().moves[k]) continue;
        const JointIndex j = limb->hinges().path[k];
        rows.push_back({frame, j, false, angles[static_cast<int>(k)], kPathAngle});
        rows.push_back({frame, j, true, rates[static_cast<int>(k)], kPathRate});
      }
    }
    return rows;
  }

  // Corrects torques of some numbers until the misses at a frame are small enough. A trial that
  // cannot be baked counts as a step too far.
  template <typename Misses>
  std::optional<Error> Correct(int frame, const std::vector<int>& numbers, MatX S,
                               const Correction& how, Misses misses, VecX* u) {
    if (numbers.empty()) return std::nullopt;
    if (auto error = BakeTo(frame, *u)) return error;
    VecX r = misses();
    double damping = how.damping;
    for (int trial = 0; trial < how.most_trials && !IsTooMuch(); ++trial) {
      if (Largest(r) <= how.enough || damping > kMostDamping) break;
      MatX A = S * S.transpose();
      A.diagonal() *= 1.0 + damping;
      const VecX dx = -S.transpose() * A.ldlt().solve(r);
      if (!dx.allFinite() || !(dx.squaredNorm() > 0.0)) break;
      VecX next = *u;
      for (size_t i = 0; i < numbers.size(); ++i) {
        next[numbers[i]] += scale_[numbers[i]] * dx[static_cast<int>(i)];
      }
      auto failed = BakeTo(frame, next);
      if (failed && failed->code == ErrorCode::kInterrupted) return failed;
      if (!failed) {
        const VecX there = misses();
        S += (there - r - S * dx) * dx.transpose() / dx.squaredNorm();
        if (there.norm() < r.norm()) {
          *u = next;
          r = there;
          damping = std::max(damping / 10.0, how.damping);
          continue;
        }
      }
      damping *= 100.0;
    }
    return BakeTo(frame, *u);
  }

  // Corrects the torques from key to key along the path, and onto each goal. Keys up to a goal
  // that is met stay.
  std::optional<Error> Follow(VecX* u) {
    std::set<int> frames;
    for (const auto& limb : limbs_) frames.insert(limb->knots().begin() + 1, limb->knots().end());
    int met = std::numeric_limits<int>::min();
    for (const int frame : frames) {
      const bool is_goal = !GoalsAt(frame, false).empty();
      const std::vector<Asked> rows = PathAt(frame);
      const std::vector<int> numbers = limbs_.TorquesBefore(frame, met, 2);
      if (auto error = Correct(
              frame, numbers, ChangesOf(rows)(Eigen::all, numbers),
              is_goal ? kOfPathAtGoal : kOfPath, [&] { return MissesOf(rows); }, u)) {
        return error;
      }
      if (!is_goal) continue;
      for (const int keys : {kLastKeys, 2 * kLastKeys, std::numeric_limits<int>::max()}) {
        // All keys: with the goals before.
        const bool are_all = keys == std::numeric_limits<int>::max();
        const std::vector<int> last =
            limbs_.TorquesBefore(frame, are_all ? std::numeric_limits<int>::min() : met, keys);
        const auto misses = [&] { return GoalMisses(frame, are_all); };
        if (auto error = Correct(frame, last, GoalChanges(frame, are_all)(Eigen::all, last),
                                 kOfGoal, misses, u)) {
          return error;
        }
        if (Largest(GoalMisses(frame, true)) <= kOfGoal.enough) break;
      }
      met = frame;
    }
    return std::nullopt;
  }

  static double Largest(const VecX& r) { return r.size() ? r.cwiseAbs().maxCoeff() : 0.0; }

  FoundTorques Finish(const VecX& u) {
    Put(u);
    found_.torques = torques_;
    return found_;
  }

  const TorqueAim& aim_;
  Animation trial_;
  const Figure& figure_;
  const std::atomic<bool>* cancel_;
  std::vector<Drive> drives_;  // of the region, without those that are looked for
  TrialBakes bakes_;
  const Motion* motion_ = nullptr;
  int last_ = 0;
  std::vector<AimedHinges> paths_;
  AimedLimbs limbs_;
  VecX scale_;                                              // strengths
  VecX best_;                                               // torques
  double least_ = std::numeric_limits<double>::infinity();  // of how far they miss
  bool is_found_ = false, was_deep_ = false;
  std::vector<HingeTorque> torques_;
  FoundTorques found_;
};

}  // namespace

Result<FoundTorques> FindTorques(const TorqueAim& aim, const Animation& animation,
                                 const std::atomic<bool>* cancel) {
  return TorqueSearch(aim, animation, cancel).Find();
}

}  // namespace hazumi::makers
