#include "engine/region/ball_axes.h"

namespace hazumi {

std::optional<BallAxes> BallAxesOf(const Figure& figure, const JointGroup& group) {
  if (group.size != 3) return std::nullopt;
  std::array<Vec3, 3> axes;
  Mat3 R_PJ = Mat3::Identity();
  for (int i = 0; i < 3; ++i) {
    const Joint& joint = figure.joints()[group.first.value() + i];
    R_PJ = R_PJ * joint.X_PJ.R;
    axes[i] = R_PJ * joint.axis;
  }
  if (!HingeTriple::Fits(axes[0], axes[1], axes[2])) return std::nullopt;
  const Mat3 R_PB = BallFrame(axes[0], axes[1]);
  const auto in_ball = [&](const Vec3& axis) -> Vec3 { return R_PB.transpose() * axis; };
  return BallAxes{{in_ball(axes[0]), in_ball(axes[1]), in_ball(axes[2])},
                  R_PJ.transpose() * R_PB,
                  axes[2].dot(R_PB.col(2)) < 0.0};
}

}  // namespace hazumi
