// Angles and rates that goals ask of a limb's motion, in their frames.

#include <algorithm>

#include "engine/dynamics/kinematics.h"
#include "engine/makers/aims/aimed_limb.h"
#include "engine/makers/aims/reach_pose.h"
#include "engine/makers/throws/throw_poses.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

// A point is asked for by a pose that brings it there: the least torques with all poses to choose
// from come from wild swings.
void AimedLimb::AskForPlace(const AimGoal& goal, int t) {
  const Pose& carrier = problem_.chain.carrier[static_cast<size_t>(t)];
  std::vector<ReachHinge> hinges;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    const Joint& joint = figure_.joint(hinges_.path[k]);
    const int at = static_cast<int>(k);
    const bool moves = hinges_.moves[k] != 0;
    const double now = start_(at, t);
    hinges.push_back({joint.X_PJ, joint.axis, moves ? joint.lower : now, moves ? joint.upper : now,
                      now, start_(at, 1)});
    if (hinges_.path[k] == goal.joint) break;
  }
  const auto depth = [&](const VecX& angles) {
    VecX all = start_.col(t);
    all.head(angles.size()) = angles;
    return DepthAt(t, all);
  };
  const Reach reach = ReachFor(carrier, hinges, goal.offset, goal.place, depth);
  if (reach.distance > goal.tolerance) out_of_reach_ = {goal, reach.distance};
  for (size_t k = 0; k < hinges.size(); ++k) {
    if (hinges_.moves[k]) {
      problem_.angles.push_back({t, static_cast<int>(k), reach.angles[static_cast<int>(k)]});
    }
  }
}

namespace {

// Rate at which a hinge still has some strength [rad/s].
double FastestOf(const Joint& joint) {
  constexpr double kShare = 0.8, kMost = 1000.0 * kDegree;
  double fastest = kMost;
  if (!joint.strength) return fastest;
  for (const StrengthCurve& curve : {joint.strength->positive, joint.strength->negative}) {
    if (curve.form != StrengthCurve::Form::kBell) continue;
    fastest = std::min(fastest, kShare * curve.fastest);
  }
  return fastest;
}

}  // namespace

// Asks for the angles and rates with which an object is let go.
void AimedLimb::AskForThrow(const AimGoal& goal, int t) {
  const MotionLimit& at = ArrivalAt(goal.frame, motion_);
  DynamicsWorkspace ws(figure_);
  ComputePositions(figure_, at.X_WR, at.q, &ws);
  ComputeVelocities(figure_, at.root_w, at.root_v, at.qd, &ws);
  const JointIndex base = figure_.joint(hinges_.path[0]).parent;
  const BodyScratch& body = base.is_valid() ? ws.body(base) : ws.bodies[0];
  const ReleaseCarrier carrier = {{body.R, body.p}, body.w, body.v};
  const std::vector<ReleaseHabit> habits = HabitsOf(goal.thrown->style, goal.joint, figure_);
  std::vector<ReleaseHinge> hinges;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    const JointIndex j = hinges_.path[k];
    const Joint& joint = figure_.joint(j);
    const int row = static_cast<int>(k);
    const ReleaseHabit& habit = habits[static_cast<size_t>(j.value())];
    ReleaseHinge hinge = {joint.X_PJ, joint.axis, joint.lower, joint.upper};
    hinge.moves = hinges_.moves[k] != 0;
    hinge.wanted = hinge.moves ? habit.angle.value_or(start_(row, 1)) : start_(row, t);
    hinge.ease = habit.ease;
    hinge.start = start_(row, 1);
    hinge.start_rate = problem_.hinges[k].start_rate;
    hinge.fastest = FastestOf(joint);
    hinges.push_back(hinge);
    if (j == goal.joint) break;
  }
  const ReleaseTarget target = {goal.offset,
                                goal.place,
                                goal.thrown->height,
                                goal.thrown->gravity,
                                (t - 1) * problem_.chain.step,
                                goal.thrown->firmness};
  release_ = ReleaseFor(carrier, hinges, target);
  const Release& release = release_;
  if (release.miss > goal.tolerance) out_of_reach_ = {goal, release.miss};
  for (int k = 0; k < static_cast<int>(hinges.size()); ++k) {
    if (!hinges_.moves[static_cast<size_t>(k)]) continue;
    problem_.angles.push_back({t, k, release.angles[k]});
    problem_.rates.push_back({t, k, release.rates[k]});
  }
}

void AimedLimb::AskForGoals() {
  const auto number = [&](JointIndex j) {
    const auto at = std::find(hinges_.path.begin(), hinges_.path.end(), j);
    return static_cast<int>(at - hinges_.path.begin());
  };
  for (const AimGoal& goal : goals_) {
    const int t = NumberOf(goal.frame);
    if (goal.is_place()) AskForPlace(goal, t);
    if (goal.thrown) AskForThrow(goal, t);
    for (const auto& [j, angle] : goal.angles) {
      const int k = number(j);
      if (!problem_.hinges[static_cast<size_t>(k)].moves) continue;
      problem_.angles.push_back({t, k, angle});
    }
    if (!goal.rests) continue;
    for (int k = 0; k < static_cast<int>(hinges_.path.size()); ++k) {
      const JointIndex j = hinges_.path[static_cast<size_t>(k)];
      const bool is_named = std::any_of(goal.angles.begin(), goal.angles.end(),
                                        [&](const auto& angle) { return angle.first == j; });
      const bool carries = goal.has_point() && figure_.IsBeyond(goal.joint, j);
      if (hinges_.moves[static_cast<size_t>(k)] && (is_named || carries)) {
        problem_.rates.push_back({t, k, 0.0});
      }
    }
  }
  if (goals_.size() == 1 && goals_[0].thrown) return SwingFromStart();
  // The search begins with the motion without torques, bent more and more towards each goal.
  const MatX passive = start_;
  for (int k = 0; k < static_cast<int>(hinges_.path.size()); ++k) {
    const solve::AimHinge& hinge = problem_.hinges[static_cast<size_t>(k)];
    int from = 1;
    double off = 0.0;  // there
    for (const solve::AimAngle& asked : problem_.angles) {
      if (asked.hinge != k) continue;
      const double there = asked.angle - passive(k, asked.frame);
      for (int t = from + 1; t < start_.cols(); ++t) {
        const double s = std::min(1.0, (t - from) / static_cast<double>(asked.frame - from));
        const double bent = passive(k, t) + off + s * s * (there - off);
        start_(k, t) = std::clamp(bent, hinge.lower, hinge.upper);
      }
      from = asked.frame;
      off = there;
    }
  }
}

}  // namespace hazumi::makers
