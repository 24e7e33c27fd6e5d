#pragma once

#include <vector>

namespace hazumi {

// Of the lower foot's clearance, by frame: peaks that rise above the valleys on both sides. What
// they are for stands in flights.cpp.

// Frames that a flight has at least.
constexpr int kFewestFrames = 5;

struct Heights {
  double contact = 0.0;  // a foot this high is off the ground [m]
  double hill = 0.0;     // what a peak has at least over its valleys [m]
};

// A peak with the valleys on both sides, as indices of frames.
struct Hill {
  int left = 0, peak = 0, right = 0;
};

// The hills of a clearance, in order; one for a flight with several peaks. The ends count as
// valleys.
std::vector<Hill> HillsOf(const std::vector<double>& clearance, const Heights& heights);

// The hill's foot on one side: where, between frames, the clearance comes down to `contact` above
// the ground beside the hill.
struct Edge {
  double at = 0.0;
  double ground = 0.0;  // [m]
  double touch = 0.0;   // where, beyond, the foot reaches the ground or is slowed down by it
};

// From the peak towards the valley at `end`, by `step`, 1 or -1. A box on which the figure stands
// goes before the ground. A peak that is not `contact` above it is its own foot.
Edge EdgeOf(const std::vector<double>& clearance, int peak, int end, int step,
            const Heights& heights);

}  // namespace hazumi
