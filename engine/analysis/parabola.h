#pragma once

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// A free flight fitted to the CoM by least squares: p(t) = apex + v (t - t_apex) - g (t - t_apex)^2
// / 2 z. Time t in seconds since the series' first frame.
struct Parabola {
  double apex_time = 0.0;  // [s]
  Vec3 apex = Vec3::Zero();
  Vec3 horizontal_v = Vec3::Zero();  // [m/s], z is 0
  double gravity = 0.0;              // implied, downward [m/s^2]
  double gravity_error = 0.0;        // standard error, for residuals correlated in time [m/s^2]
  double rms = 0.0;                  // of the heights' residuals [m]
  double horizontal_rms = 0.0;       // of the distances from uniform motion [m]
  double sagitta = 0.0;              // height of the arc over its chord [m]

  Vec3 PositionAt(double t) const;
  Vec3 VelocityAt(double t) const;
};

// Fits frames first..last of `com`, which are `frame_time` seconds apart; at least 4.
Parabola FitParabola(const std::vector<Vec3>& com, double frame_time, int first, int last);

}  // namespace hazumi
