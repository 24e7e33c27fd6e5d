#pragma once

#include <string>
#include <vector>

#include "engine/analysis/motion_series.h"

namespace hazumi {

// How high the lowest point of any foot is above where that point is when the figure stands (the
// height that a tenth of its frames lie below), by frame [m]. Empty without feet.
std::vector<double> FootClearance(const MotionSeries& series);

// Frames in a row in which a foot slides; a pause of a frame or two is passed over.
struct FootSlide {
  int first = 0, last = 0;  // frames, both inclusive
  double distance = 0.0;    // weighted [m]
};

// How far a foot slides while it is on the ground.
struct FootSkate {
  std::string foot;
  int frames = 0;                      // with a weighted speed above 0.1 m/s
  double distance = 0.0;               // weighted [m]
  double time_low = 0.0;               // during which the foot was low [s]
  std::vector<FootSlide> slides = {};  // in order of time
};

// The measure of [Zhang, Starke, Komura, Saito 2018]: horizontal steps of a foot's lowest point
// while it is lower than H = 2.5 cm, weighted 2 - 2^(h/H), so that contact counts in full and the
// threshold not at all. H goes with the stature (2.5 cm for 1.7 m).
std::vector<FootSkate> FootSkates(const MotionSeries& series);

}  // namespace hazumi
