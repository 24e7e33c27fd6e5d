#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "ui/edit/operators/pose/turned_hinges.h"

namespace hazumi::edit {

namespace {

constexpr double kMostLeft = 1e-6;  // what may be left of a turn that succeeds [rad]

bool IsOfLimb(const Link& link, const Limb& limb, const Figure& figure) {
  return link.joint.is_valid() && figure.IsBeyond(link.joint, figure.group(limb.first).first);
}

// Beyond the first joint's own body, which touches what it hangs on.
bool IsBetween(const Link& link, const Limb& limb, const Figure& figure) {
  return IsOfLimb(link, limb, figure) && figure.joint(link.joint).group != limb.first &&
         !figure.IsBeyond(link.joint, figure.group(limb.end).first);
}

// How deep the limb is inside of bodies that carry it, or that hang on these without a limb of
// their own, as a head does; less than 0: how far away it is [m].
double DepthInBody(const Limb& limb, const Figure& figure, const DynamicsWorkspace& ws) {
  const JointIndex carrier = figure.joint(figure.group(limb.first).first).parent;
  double depth = -1.0;
  for (const Link& link : figure.links()) {
    if (!IsBetween(link, limb, figure)) continue;
    for (const Link& other : figure.links()) {
      const bool is_carrier =
          !other.joint.is_valid() || (carrier.is_valid() && figure.IsBeyond(carrier, other.joint));
      const bool hangs_on_carrier =
          other.joint.is_valid() && !IsOfLimb(other, limb, figure) &&
          figure.joint(figure.group(figure.joint(other.joint).group).first).parent == carrier;
      if (!is_carrier && !hangs_on_carrier) continue;
      depth = std::max(depth, -SignedDistance(InWorld(link, ws), InWorld(other, ws)).value);
    }
  }
  return depth;
}

}  // namespace

double TurnLimb(double angle, const Limb& limb, const std::vector<JointIndex>& hinges,
                const Figure& figure, const DynamicsWorkspace& ws, VecX* q) {
  constexpr double kStep = 0.05;  // [rad]
  constexpr double kFine = 1e-6;  // to which the end is found [rad]
  const Vec3 line =
      (ws.body(figure.group(limb.end).first).p - ws.body(figure.group(limb.first).first).p)
          .normalized();
  const JointIndex body = figure.group(limb.first).last();
  const Mat3& R_WB = ws.body(body).R;
  double turned = 0.0, step = std::copysign(kStep, angle);
  while (std::abs(angle - turned) > 1e-12 && std::abs(step) > kFine) {
    if (std::abs(step) > std::abs(angle - turned)) step = angle - turned;
    VecX next = *q;
    const Mat3 R = Eigen::AngleAxisd(turned + step, line) * R_WB;
    if (TurnHinges(body, R, hinges, figure, ws, &next) > kMostLeft) {
      step *= 0.5;
      continue;
    }
    turned += step;
    *q = next;
  }
  return turned;
}

void TurnOutOfBody(const Limb& limb, const std::vector<JointIndex>& hinges, const Figure& figure,
                   const hazumi::Pose& X_WR, VecX* q) {
  constexpr double kDeep = 0.005;                    // [m]
  constexpr double kStep = std::numbers::pi / 90.0;  // [rad]
  constexpr double kFarthest = 2.0 * std::numbers::pi / 3.0;
  DynamicsWorkspace ws(figure), turned(figure);
  ComputePositions(figure, X_WR, *q, &ws);
  if (hinges.empty() || DepthInBody(limb, figure, ws) <= kDeep) return;
  VecX ways[] = {*q, *q};
  bool may_go_on[] = {true, true};
  for (double angle = kStep; angle <= kFarthest; angle += kStep) {
    for (const int way : {0, 1}) {
      const double wanted = way == 0 ? angle : -angle;
      if (!may_go_on[way]) continue;
      ways[way] = *q;
      may_go_on[way] = TurnLimb(wanted, limb, hinges, figure, ws, &ways[way]) == wanted;
      ComputePositions(figure, X_WR, ways[way], &turned);
      if (!may_go_on[way] || DepthInBody(limb, figure, turned) > kDeep) continue;
      *q = ways[way];
      return;
    }
  }
}

}  // namespace hazumi::edit
