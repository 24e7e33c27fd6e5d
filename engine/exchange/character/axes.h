#pragma once

#include "engine/exchange/character/character.h"

namespace hazumi {

// From Hazumi's axes (x forward, y left, z up) and metres to those of a file. For y up the cyclic
// permutation x -> z, y -> x, z -> y: forward is z, left is x. Nothing but lengths is rounded.
class FileAxes {
 public:
  FileAxes(UpAxis up, double metres_per_unit)
      : shift_(up == UpAxis::kY ? 1 : 0), metres_per_unit_(metres_per_unit) {}

  // The axis of the file (0 x, 1 y, 2 z) that Hazumi's axis `k` becomes.
  int Axis(int k) const { return (k + 3 - shift_) % 3; }
  template <typename T>
  Vec3Of<T> Direction(const Vec3Of<T>& v) const {
    return {v[From(0)], v[From(1)], v[From(2)]};
  }
  template <typename T>
  Vec3Of<T> Point(const Vec3Of<T>& p) const {
    return Direction(p) / static_cast<T>(metres_per_unit_);
  }
  Mat3 Turned(const Mat3& R) const {
    Mat3 turned;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) turned(i, j) = R(From(i), From(j));
    }
    return turned;
  }
  Eigen::Quaterniond Turned(const Eigen::Quaterniond& q) const {
    const Vec3 v = Direction(Vec3(q.vec()));
    return {q.w(), v.x(), v.y(), v.z()};
  }
  Pose Turned(const Pose& X) const { return {Turned(X.R), Point(X.p)}; }

 private:
  int From(int file_axis) const { return (file_axis + shift_) % 3; }

  int shift_;
  double metres_per_unit_;
};

}  // namespace hazumi
