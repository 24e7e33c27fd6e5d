#pragma once

#include "engine/dynamics/lane_plan.h"

namespace hazumi {

// The sweeps over a plan, for one instruction set. `scratch` as LanePlan lays it out, 32-byte
// aligned, with the root's motion set. Pointers of joint vectors have one entry a joint.
struct LaneKernels {
  // Angles, rates and accelerations to the motion of every body and the moment and force that its
  // own inertia asks for, about its origin, in B. qdd null: zero.
  void (*start)(const LanePlan& plan, const double* q, const double* qd, const double* qdd,
                double* scratch);
  // From there to joint torques.
  void (*torques)(const LanePlan& plan, double* tau, double* scratch);
  // Or from there, with qdd zero, to the accelerations that torques tau cause. False if some joint
  // moves no mass: the last of its pivot's fields is then set.
  bool (*accelerations)(const LanePlan& plan, const double* tau, double* qdd, double* scratch);
};

LaneKernels BaselineKernels(int width);
LaneKernels Avx2Kernels(int width);
bool CpuHasAvx2();

}  // namespace hazumi
