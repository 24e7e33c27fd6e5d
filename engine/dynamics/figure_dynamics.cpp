#include "engine/dynamics/figure_dynamics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "engine/base/assert.h"

namespace hazumi {

Instructions BestInstructions() {
  return CpuHasAvx2() ? Instructions::kAvx2 : Instructions::kBaseline;
}

FigureScratch::FigureScratch(const LanePlan& plan)
    : array(plan.scratch_size()), R_WB(plan.bodies.size()) {
#ifndef NDEBUG
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::fill(data(), data() + array.size(), kNaN);
#endif
  std::fill_n(data() + plan.empty_load(), LaneState::kLoadFields * plan.width, 0.0);
}

namespace {

LaneKernels KernelsFor(Instructions instructions, int width) {
  return instructions == Instructions::kAvx2 ? Avx2Kernels(width) : BaselineKernels(width);
}

std::vector<int> EndBodies(const Figure& figure, const LanePlan& plan) {
  std::vector<int> ends;
  for (int b = 0; b < static_cast<int>(plan.bodies.size()); ++b) {
    if (IsEndJoint(figure, plan.bodies[b].last())) ends.push_back(b);
  }
  return ends;
}

}  // namespace

FigureDynamics::FigureDynamics(const Figure& figure, Instructions instructions)
    : root_inertia_(figure.root_body()),
      plan_(figure),
      kernels_(KernelsFor(instructions, plan_.width)),
      end_bodies_(EndBodies(figure, plan_)) {}

void FigureDynamics::InverseDynamics(const Pose& X_WR, const RootMotion& root, const VecX& q,
                                     const VecX& qd, const VecX& qdd, const EndForces* ends,
                                     FigureScratch* scratch, VecX* tau) const {
  SetRoot(X_WR, root, scratch);
  kernels_.start(plan_, q.data(), qd.data(), qdd.data(), scratch->data());
  if (ends != nullptr) SubtractEndForces(X_WR, *ends, scratch);
  kernels_.torques(plan_, tau->data(), scratch->data());
}

Wrench FigureDynamics::RootWrench(const Pose& X_WR, const RootMotion& root,
                                  const FigureScratch& scratch) const {
  const Vec3 c = X_WR.R * root_inertia_.com;
  const Mat3 I = X_WR.R * root_inertia_.I_com * X_WR.R.transpose();
  Wrench wrench;
  wrench.force =
      root_inertia_.mass * (root.a + root.alpha.cross(c) + root.w.cross(root.w.cross(c)));
  wrench.moment = I * root.alpha + root.w.cross(I * root.w) + c.cross(wrench.force);
  for (const LaneBody& body : plan_.bodies) {
    if (body.parent >= 0) continue;
    const double* load =
        scratch.data() + plan_.state(body.step) + LaneState::kLoad * plan_.width + body.lane;
    const auto triple = [&](int first) {
      return Vec3(load[first * plan_.width], load[(first + 1) * plan_.width],
                  load[(first + 2) * plan_.width]);
    };
    wrench.moment += X_WR.R * triple(0);
    wrench.force += X_WR.R * triple(3);
  }
  return wrench;
}

void FigureDynamics::SetRoot(const Pose& X_WR, const RootMotion& root,
                             FigureScratch* scratch) const {
  double* at = scratch->data() + plan_.root_state();
  for (const Vec3* x : {&root.w, &root.alpha, &root.a}) {
    const Vec3 x_R = X_WR.R.transpose() * *x;
    for (int i = 0; i < 3; ++i, at += plan_.width) std::fill_n(at, plan_.width, x_R[i]);
  }
}

// F T1 T2 T3
Mat3 FigureDynamics::RotationFromParent(const LaneBody& body, const double* scratch) const {
  Mat3 R = body.F;
  for (const LaneHinge& hinge : body.hinges) {
    const int w = plan_.width;
    const double* row = scratch + plan_.joint_at[hinge.joint.value()];
    R = R * AxisRotation<double>(Vec3::Unit(hinge.axis), row[LaneRow::kSine * w],
                                 row[LaneRow::kCosine * w]);
  }
  return R;
}

void FigureDynamics::SubtractEndForces(const Pose& X_WR, const EndForces& ends,
                                       FigureScratch* scratch) const {
  for (size_t b = 0; b < plan_.bodies.size(); ++b) {
    const LaneBody& body = plan_.bodies[b];
    const Mat3& R_WP = body.parent < 0 ? X_WR.R : scratch->R_WB[body.parent];
    scratch->R_WB[b] = R_WP * RotationFromParent(body, scratch->data());
  }
  for (size_t e = 0; e < end_bodies_.size(); ++e) {
    const LaneBody& body = plan_.bodies[end_bodies_[e]];
    const Mat3 R_BW = scratch->R_WB[end_bodies_[e]].transpose();
    const Vec3 n = R_BW * ends.Kn.col(e), f = R_BW * ends.Kf.col(e);
    double* load =
        scratch->data() + plan_.state(body.step) + LaneState::kLoad * plan_.width + body.lane;
    for (int i = 0; i < 3; ++i) {
      load[i * plan_.width] -= n[i];
      load[(3 + i) * plan_.width] -= f[i];
    }
  }
}

}  // namespace hazumi
