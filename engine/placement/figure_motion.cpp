#include "engine/placement/figure_motion.h"

#include <cmath>

namespace hazumi {

void SetRootOrientation(const RootAngles& angles, FigureMotion* motion) {
  const Vec3 axes[3] = {Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()};
  Mat3 R = Mat3::Identity();
  Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis_W = R * axes[i];
    alpha += axis_W * angles.acceleration[i] + w.cross(axis_W) * angles.rate[i];
    w += axis_W * angles.rate[i];
    Turn<double>(axes[i], std::sin(angles.angle[i]), std::cos(angles.angle[i]), &R);
  }
  motion->X_WR.R = R;
  motion->root.w = w;
  motion->root.alpha = alpha;
}

void PinRoot(const Figure& figure, JointIndex pin, const Vec3& p_W, DynamicsWorkspace* ws,
             FigureMotion* motion) {
  motion->X_WR.p.setZero();
  motion->root.v.setZero();
  motion->root.a.setZero();
  ComputeMotionTo(pin, figure, motion->X_WR, motion->root, motion->q, motion->qd, motion->qdd, ws);
  motion->X_WR.p = p_W - ws->body(pin).p;
  motion->root.v = -ws->body(pin).v;
  motion->root.a = -ws->body(pin).a;
}

void PlaceCenterOfMass(const Figure& figure, const Vec3& com, const Vec3& com_v,
                       DynamicsWorkspace* ws, FigureMotion* motion) {
  motion->X_WR.p.setZero();
  ComputePositions(figure, motion->X_WR, motion->q, ws);
  ComputeVelocities(figure, motion->root.w, Vec3::Zero(), motion->qd, ws);
  motion->X_WR.p = com - CenterOfMass(figure, *ws);
  motion->root.v = com_v - CenterOfMassVelocity(figure, *ws);
  motion->root.a.setZero();
}

}  // namespace hazumi
