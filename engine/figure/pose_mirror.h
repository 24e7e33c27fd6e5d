#pragma once

// The mirror image of a pose, of any figure: joints, and the root in the world.

#include <optional>
#include <vector>

#include "engine/figure/hinge_row.h"
#include "engine/figure/sides.h"

namespace hazumi {

// The angles of a partner whose joint turns as the mirror image of what it was made from.
struct MirroredJoint {
  std::vector<double> angles;  // by hinge [rad]
  double left_over = 0.0;      // what its hinges cannot show [rad]
};

// What a joint turns its body by is taken from the pose of all angles zero, which is supposed to be
// its own mirror image. A turn by t about an axis a becomes a turn by t about -M a, M = I - 2 n n^T
// the reflection; a rotation R becomes M R M.
class PoseMirror {
 public:
  explicit PoseMirror(const Figure& figure);

  const FigureSides& sides() const { return sides_; }

  // +1 or -1 by hinge of a joint, if each hinge, mirrored, is that of the same place in its
  // partner, turned by as much or by as much the other way. None if any is not.
  std::optional<std::vector<double>> SignsOf(GroupIndex joint) const;

  // For any joint: `angles` of its hinges; those of its partner nearest to `before` [rad].
  MirroredJoint Mirrored(GroupIndex joint, const std::vector<double>& angles,
                         const std::vector<double>& before) const;

  // Of the root's place in the world, reflected through the plane of that normal through the
  // world's origin: a figure as its root is turned has turned image and image of its pose.
  Pose Mirrored(const Pose& X_WR) const;
  // The root's x, y, z and angles z, y, x: +1 or -1 each, if the plane's normal is an axis.
  std::optional<std::vector<double>> SignsOfRoot() const;

 private:
  Mat3 Reflection() const;

  FigureSides sides_;
  std::vector<HingeRow> rows_;  // by joint; axes in the root's frame, all angles zero
};

}  // namespace hazumi
