#pragma once

// Motions made of formulas, whose flights are known.

#include "engine/analysis/motion_series.h"

namespace hazumi::test {

// Somebody of 1.70 m stands, crouches and jumps: everything in natural time. The feet rise and fall
// with the CoM; the ball leaves the ground at take-off, the heel before.
struct Jump {
  double stand = 0.6;        // before the crouch [s]
  double v = 2.6;            // upward at take-off [m/s]
  double forward = 0.4;      // [m/s]
  double ground_before = 0;  // height of what the jump starts from [m]
  double gravity = 9.81;

  double take_off() const;  // [s]
  double apex() const;
  double landing() const;
  double end() const;  // standing again

  Vec3 Com(double t) const;
  double FootRise(double t) const;  // of the ball, over the floor
};

// `fps` frames a second of natural time, said to be `stated_fps`. Every coordinate has normal noise
// of `noise` [m] and, of the CoM, a third of that.
MotionSeries SeriesOf(const Jump& jump, double fps, double stated_fps, double noise = 0.0);

// Steps of 0.5 s: one foot stands while the other swings; the CoM rises and falls by 4 cm over the
// standing foot. Everything climbs by `slope` [m/s].
MotionSeries Walk(double fps, double seconds, double slope = 0.0, double noise = 0.0);

// Steps of 0.36 s, 0.12 s of which in the air.
MotionSeries Run(double fps, int steps);

// The same from the last frame to the first; one after the other.
MotionSeries Reversed(const MotionSeries& series);
MotionSeries Joined(const MotionSeries& first, const MotionSeries& second);

// Frames first to last of a series.
MotionSeries Cut(const MotionSeries& series, int first, int last);

}  // namespace hazumi::test
