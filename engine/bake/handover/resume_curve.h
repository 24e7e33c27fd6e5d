#pragma once

#include "engine/timeline/animation.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

// What a region left of a hinge: the curve goes on from there.
struct HingeEnd {
  int frame;
  double angle, rate;  // [rad, rad/s]
};

// Lets a curve go on after a region [METHOD 7.3], by a blend if the region asks for it
// [METHOD 7.5]. `joint`: whose limits a blend keeps; null: it has none.
void ResumeCurve(const HingeEnd& end, const DynamicsRegion& region, const Joint* joint,
                 CurveTrack* curve);

// As ResumeCurve with a rate that is limited, so that the curve stays inside the joint's limits.
void ResumeInside(const HingeEnd& end, const DynamicsRegion& region, const Joint& joint,
                  FrameRate rate, CurveTrack* curve);

// How far the curve from a frame on goes beyond the joint's limits on the way to its next key,
// beyond which neither end of the way is [rad].
double Overshoot(int frame, const Joint& joint, FrameRate rate, CurveTrack* curve);

}  // namespace hazumi
