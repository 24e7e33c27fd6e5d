#pragma once

#include <array>
#include <optional>

#include "engine/figure/figure.h"
#include "engine/figure/skin.h"

namespace hazumi {

// A bone of a skin on a figure.
struct FigureBone {
  JointIndex body;                              // the one whose hinges it takes; invalid: the root
  std::array<double, 3> shares = {1., 1., 1.};  // of the angles of the group's hinges
  bool is_body = true;                          // it moves as that body does
};

// None: the figure has no root, joint or hinge of that name.
std::optional<FigureBone> FindBone(const Figure& figure, const SkinBone& bone);

// How the bone is turned in the frame of the body before its joint. Not of the root.
Mat3 TurnOf(const Figure& figure, const FigureBone& bone, const VecX& q);

}  // namespace hazumi
