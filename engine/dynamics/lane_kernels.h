#pragma once

#include "engine/dynamics/lane_plan.h"

namespace hazumi {

// The sweeps over a plan, for one instruction set. `scratch` as LanePlan lays it out, 32-byte
// aligned, with the root's motion set. Pointers of joint vectors have one entry a joint.
struct LaneKernels {
  // Angles, rates and accelerations to the motion of every body and the moment and force that its
  // own inertia asks for, about its origin, in B.
  void (*start)(const LanePlan& plan, const double* q, const double* qd, const double* qdd,
                double* scratch);
  // From there to joint torques.
  void (*torques)(const LanePlan& plan, double* tau, double* scratch);
};

LaneKernels BaselineKernels(int width);
LaneKernels Avx2Kernels(int width);
bool CpuHasAvx2();

}  // namespace hazumi
