#include "engine/figure/pose_mirror.h"

#include <cmath>

namespace hazumi {

namespace {

// Signs by hinge that make the mirror image of `from` the row `to`.
std::optional<std::vector<double>> SignsBetween(const HingeRow& from, const HingeRow& to,
                                                const Mat3& M) {
  constexpr double kSame = 1e-9;
  if (from.size() != to.size()) return std::nullopt;
  std::vector<double> signs;
  for (size_t i = 0; i < from.size(); ++i) {
    const Vec3 image = -M * from[i].axis;
    const double sign = image.dot(to[i].axis) < 0.0 ? -1.0 : 1.0;
    if ((image - sign * to[i].axis).norm() > kSame) return std::nullopt;
    if (to[i].is_fixed && !from[i].is_fixed) return std::nullopt;
    signs.push_back(sign);
  }
  return signs;
}

std::vector<HingeRow> RowsOf(const Figure& figure) {
  const std::vector<Pose> X_RJ = PosesAtZero(figure);
  std::vector<HingeRow> rows(figure.groups().size());
  for (size_t j = 0; j < X_RJ.size(); ++j) {
    const Joint& joint = figure.joints()[j];
    rows[joint.group.value()].push_back({X_RJ[j].R * joint.axis, joint.is_fixed()});
  }
  return rows;
}

}  // namespace

PoseMirror::PoseMirror(const Figure& figure) : sides_(figure), rows_(RowsOf(figure)) {}

Mat3 PoseMirror::Reflection() const {
  return Mat3::Identity() - 2.0 * sides_.normal() * sides_.normal().transpose();
}

std::optional<std::vector<double>> PoseMirror::SignsOf(GroupIndex joint) const {
  const HingeRow& to = rows_[sides_.OtherSideOf(joint).value()];
  return SignsBetween(rows_[joint.value()], to, Reflection());
}

MirroredJoint PoseMirror::Mirrored(GroupIndex joint, const std::vector<double>& angles,
                                   const std::vector<double>& before) const {
  MirroredJoint mirrored;
  mirrored.angles = before;
  if (const auto signs = SignsOf(joint)) {
    for (size_t i = 0; i < angles.size(); ++i) mirrored.angles[i] = (*signs)[i] * angles[i];
    return mirrored;
  }
  const Mat3 M = Reflection();
  const Mat3 R = M * RotationOf(rows_[joint.value()], angles) * M;
  mirrored.left_over = TurnTo(R, rows_[sides_.OtherSideOf(joint).value()], &mirrored.angles);
  return mirrored;
}

Pose PoseMirror::Mirrored(const Pose& X_WR) const {
  const Mat3 M = Reflection();
  return {M * X_WR.R * M, M * X_WR.p};
}

std::optional<std::vector<double>> PoseMirror::SignsOfRoot() const {
  const HingeRow axes = {{Vec3::UnitZ()}, {Vec3::UnitY()}, {Vec3::UnitX()}};
  const Mat3 M = Reflection();
  const auto turns = SignsBetween(axes, axes, M);
  if (!turns) return std::nullopt;
  std::vector<double> signs = {M(0, 0), M(1, 1), M(2, 2)};
  signs.insert(signs.end(), turns->begin(), turns->end());
  return signs;
}

}  // namespace hazumi
