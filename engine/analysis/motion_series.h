#pragma once

#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/figure/figure.h"
#include "engine/spatial/types.h"

namespace hazumi {

// A foot, or whatever else the figure stands on: the points that carry it (ball, heel, ankle).
struct FootTrack {
  std::string name;
  std::vector<std::vector<Vec3>> points;  // each by frame, world, z up [m]
};

// What the analysis knows of a motion, wherever it comes from: series by frame, all as long as
// `com`, world axes, z up.
struct MotionSeries {
  double frame_time = 1.0 / 30.0;      // as stated by the clip [s], > 0
  int first_frame = 0;                 // number of the first frame
  std::vector<Vec3> com;               // [m]
  std::vector<Vec3> angular_momentum;  // about the CoM [kg m^2/s]; empty: not known
  // Where the CoM would be with another mass of some bodies: share (p - com), p the CoM of a body
  // and share that of the figure's mass, summed over bodies of one mass (left and right), which a
  // table gets wrong together. By such class and frame [m]; empty: masses are taken for certain.
  std::vector<std::vector<Vec3>> mass_shifts;
  std::vector<FootTrack> feet;
  double stature = 1.7;  // height of the figure, upright [m]: what tolerances are measured in
  // The unit of length was stated, not guessed from the figure's height.
  bool scale_known = true;
};

// The series of a baked motion. Feet are the figure's ends that come lowest. A foot with a toe
// joint stands on that joint (the ball), not on the tip of its toes: tips of captured skeletons
// are extended from what was measured and dip into the floor.
MotionSeries SeriesOf(const Figure& figure, const Motion& motion);

// The value that a share of 0 to 1 of all lies below. `values` must not be empty.
double Quantile(std::vector<double> values, double share);

}  // namespace hazumi
