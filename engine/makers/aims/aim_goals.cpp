#include "engine/makers/aims/aim_goals.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/makers/throws/release_pose.h"

namespace hazumi::makers {

namespace {

bool HasMass(JointIndex j, const Figure& figure) {
  for (int k = j.value(); k < figure.joint(j).subtree_end.value(); ++k) {
    if (!figure.body(JointIndex(k)).is_massless()) return true;
  }
  return false;
}

}  // namespace

std::vector<char> LimpHinges(const DynamicsRegion& region, const Figure& figure) {
  std::vector<char> limp(static_cast<size_t>(figure.num_joints()), 0);
  for (size_t i = 0; i < region.joints.size(); ++i) {
    const JointIndex j = region.joints[i];
    const bool may_move = region.friction[i] > 0.0 && HasMass(j, figure);
    limp[static_cast<size_t>(j.value())] = may_move ? 1 : 0;
  }
  for (const Drive& drive : region.drives) {
    for (const JointIndex j : drive.joints) limp[static_cast<size_t>(j.value())] = 0;
  }
  return limp;
}

std::vector<JointIndex> RestingHinges(const AimGoal& goal, const DynamicsRegion& region,
                                      const Figure& figure) {
  std::vector<JointIndex> hinges;
  if (!goal.rests) return hinges;
  for (const auto& [j, angle] : goal.angles) hinges.push_back(j);
  if (!goal.has_point()) return hinges;
  for (const JointIndex j : region.joints) {
    if (figure.IsBeyond(goal.joint, j)) hinges.push_back(j);
  }
  return hinges;
}

ThrowPath PathOf(const AimGoal& goal, const MotionLimit& at, const Figure& figure) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, at.X_WR, at.q, &ws);
  ComputeVelocities(figure, at.root_w, at.root_v, at.qd, &ws);
  const BodyScratch& body = ws.body(goal.joint);
  const Vec3 arm = body.R * goal.offset;
  return {body.p + arm, body.v + body.w.cross(arm), 0.0};
}

Vec3 OffPlace(const AimGoal& goal, const ThrowPath& path) {
  if (!goal.thrown) return path.from - goal.place;
  return MissOfSpot(path, goal.place, goal.thrown->height, goal.thrown->gravity);
}

bool GoalMiss::IsMet(const AimGoal& goal) const {
  return angle <= goal.tolerance && distance <= goal.tolerance && rate <= kRestRate;
}

GoalMiss MissOf(const AimGoal& goal, const DynamicsRegion& region, const Figure& figure,
                const Motion& motion) {
  const MotionLimit& at = ArrivalAt(goal.frame, motion);
  GoalMiss miss;
  for (const auto& [j, angle] : goal.angles) {
    const double off = std::abs(at.q[j.value()] - angle);
    if (off < miss.angle) continue;
    miss.angle = off;
    miss.joint = j;
  }
  if (goal.has_point()) miss.distance = OffPlace(goal, PathOf(goal, at, figure)).norm();
  for (const JointIndex j : RestingHinges(goal, region, figure)) {
    miss.rate = std::max(miss.rate, std::abs(at.qd[j.value()]));
  }
  return miss;
}

}  // namespace hazumi::makers
