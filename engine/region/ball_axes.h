#pragma once

#include <array>
#include <optional>

#include "engine/figure/figure.h"
#include "engine/region/hinge_triple.h"

namespace hazumi {

// A frame that the hinges of a ball joint tell by themselves, whoever describes them: at angles
// zero its columns are the first axis, the second, and what is perpendicular to both; it turns with
// the child.
inline Mat3 BallFrame(const Vec3& first, const Vec3& second) {
  Mat3 frame;
  frame << first, second, first.cross(second);
  return frame;
}

// A joint of a figure whose three hinges are a ball's.
struct BallAxes {
  HingeTriple triple;             // all in the ball's frame
  Mat3 R_JB;                      // that frame, in the frame of the last hinge
  bool is_third_against = false;  // the last hinge's axis is against the frame's third one
};
std::optional<BallAxes> BallAxesOf(const Figure& figure, const JointGroup& group);

}  // namespace hazumi
