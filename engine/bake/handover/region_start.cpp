// Beyond a joint with its origin at o lie bodies of mass m, inertia I about their centre of mass c:
//   J = sum I + m (|c - o|^2 1 - (c - o)(c - o)^T),    about a hinge's axis a   a . J a.

#include "engine/bake/handover/region_start.h"

#include <algorithm>

#include "engine/dynamics/kinematics.h"
#include "engine/passive/ball_axes.h"

namespace hazumi {

namespace {

// World axes. Needs ComputePositions.
Mat3 InertiaBeyond(const Figure& figure, JointIndex joint, const DynamicsWorkspace& ws) {
  const Vec3 origin = ws.body(joint).p;
  Mat3 sum = Mat3::Zero();
  for (int j = joint.value(); j < figure.joint(joint).subtree_end.value(); ++j) {
    const RigidInertia& body = figure.body(JointIndex(j));
    if (body.is_massless()) continue;
    const BodyScratch& at = ws.body(JointIndex(j));
    sum += at.R * body.I_com * at.R.transpose() +
           PointInertia(body.mass, at.p + at.R * body.com - origin);
  }
  return sum;
}

bool IsSpring(const Drive& drive) { return drive.kind == DriveKind::kSpring; }

}  // namespace

RegionStart StartOf(const DynamicsRegion& region, const Figure& figure, const FigureMotion& motion,
                    DynamicsWorkspace* ws) {
  RegionStart start;
  if (std::none_of(region.drives.begin(), region.drives.end(), IsSpring)) return start;
  ComputePositions(figure, motion.X_WR, motion.q, ws);
  for (const JointIndex j : region.joints) {
    const Mat3 inertia = InertiaBeyond(figure, j, *ws);
    const BodyScratch& at = ws->body(j);
    const JointGroup& group = figure.group(figure.joint(j).group);
    const auto ball = BallAxesOf(figure, group);
    const Mat3 R = ball ? Mat3(ws->body(group.last()).R * ball->R_JB) : Mat3::Zero();
    start.angles.push_back(motion.q[j.value()]);
    start.inertias.push_back(at.axis.dot(inertia * at.axis));
    start.of_balls.push_back(R.transpose() * inertia * R);
  }
  return start;
}

}  // namespace hazumi
