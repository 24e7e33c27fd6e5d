#include "engine/figure/figure_bone.h"

#include <Eigen/Geometry>

namespace hazumi {

std::optional<FigureBone> FindBone(const Figure& figure, const SkinBone& bone) {
  if (bone.joint == figure.root_name()) return FigureBone();
  const auto hinge = figure.FindJoint(bone.joint);
  const auto named = figure.FindGroup(bone.joint);
  if (!hinge && !named) return std::nullopt;
  const JointGroup& group = figure.group(hinge ? figure.joint(*hinge).group : *named);
  FigureBone found;
  found.body = hinge ? *hinge : group.last();
  found.is_body = bone.share == 1.0;
  const int first_shared = hinge ? hinge->value() - group.first.value() : 0;
  for (int i = first_shared; i < group.size; ++i) found.shares[i] = bone.share;
  return found;
}

Mat3 TurnOf(const Figure& figure, const FigureBone& bone, const VecX& q) {
  const int first = figure.group(figure.joint(bone.body).group).first.value();
  Mat3 turn = Mat3::Identity();
  for (int j = first; j <= bone.body.value(); ++j) {
    const Joint& hinge = figure.joint(JointIndex(j));
    turn = turn * hinge.X_PJ.R * Eigen::AngleAxisd(bone.shares[j - first] * q[j], hinge.axis);
  }
  return turn;
}

}  // namespace hazumi
