// Inertia J about the origin o of a joint. The bodies beyond the joint have the mass m, the centre
// of mass c and the inertia I about c:
//   J = I + m (|c - o|^2 1 - (c - o)(c - o)^T),    about the axis a of a hinge:   a . J a.
// Bodies beyond the joint that carry the share s of the figure's weight give, with J_all of all
// bodies,
//   (1 - s) J + s (J_all - J).

#include "engine/bake/handover/region_start.h"

#include <algorithm>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/support.h"
#include "engine/region/ball_axes.h"

namespace hazumi {

namespace {

// By joint, of all that lies beyond it, in the world. Needs ComputePositions.
std::vector<RigidInertia> BodiesBeyond(const Figure& figure, const DynamicsWorkspace& ws) {
  std::vector<RigidInertia> beyond(figure.joints().size());
  for (int j = figure.num_joints() - 1; j >= 0; --j) {
    const BodyScratch& at = ws.body(JointIndex(j));
    beyond[j] = Combine(Moved(figure.body(JointIndex(j)), {at.R, at.p}), beyond[j]);
    const JointIndex parent = figure.joints()[j].parent;
    if (!parent.is_valid()) continue;
    beyond[parent.value()] = Combine(beyond[parent.value()], beyond[j]);
  }
  return beyond;
}

RigidInertia WholeFigure(const Figure& figure, const std::vector<RigidInertia>& beyond,
                         const DynamicsWorkspace& ws) {
  const BodyScratch& root = ws.body(JointIndex());
  RigidInertia all = Moved(figure.root_body(), {root.R, root.p});
  for (size_t j = 0; j < beyond.size(); ++j) {
    if (!figure.joints()[j].parent.is_valid()) all = Combine(all, beyond[j]);
  }
  return all;
}

Mat3 AboutPoint(const RigidInertia& bodies, const Vec3& point) {
  return bodies.I_com + PointInertia(bodies.mass, bodies.com - point);
}

bool IsSpring(const Drive& drive) { return drive.kind == DriveKind::kSpring; }

}  // namespace

RegionStart StartOf(const DynamicsRegion& region, const Figure& figure, const FigureMotion& motion,
                    const std::vector<SceneObject>* scene, DynamicsWorkspace* ws) {
  RegionStart start;
  if (std::none_of(region.drives.begin(), region.drives.end(), IsSpring)) return start;
  ComputePositions(figure, motion.X_WR, motion.q, ws);
  const std::vector<RigidInertia> beyond = BodiesBeyond(figure, *ws);
  std::vector<double> carried(beyond.size(), 0.0);
  if (scene) carried = CarriedShares(figure, FindSupport(figure, *scene, *ws), *ws);
  const RigidInertia all = WholeFigure(figure, beyond, *ws);
  for (const JointIndex j : region.joints) {
    const double share = carried[j.value()];
    Mat3 inertia = AboutPoint(beyond[j.value()], ws->body(j).p);
    if (share > 0.0) {
      inertia = (1.0 - 2.0 * share) * inertia + share * AboutPoint(all, ws->body(j).p);
    }
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
