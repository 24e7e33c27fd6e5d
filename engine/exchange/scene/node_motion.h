#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// What a motion says of its node at a time; empty: as at rest.
struct NodeValue {
  std::optional<Vec3> translation, scale;
  std::optional<Eigen::Quaterniond> rotation;
  std::optional<Eigen::Matrix4d> matrix;  // in place of all three
};

// How a node moves in its parent's frame, by curves of one form or another. Curves are constant
// before their first key and after their last.
class NodeMotion {
 public:
  virtual ~NodeMotion() = default;
  // At a time [s]; a step that is at most `slack` [s] later has happened.
  virtual NodeValue At(double t, double slack) const = 0;
  // Times of keys [s], in any order. A single key says nothing of time and is left out.
  virtual void AddTimes(std::vector<double>* times) const = 0;
  // Whether all keys are finite and their times do not decrease.
  virtual bool IsSound() const = 0;
};

enum class KeyInterpolation { kStep, kLinear, kSpline };

// Keys whose numbers are interpolated together: 3, or 4 of a rotation (x, y, z, w).
//   kLinear    v0 + s (v1 - v0), of rotations along the sphere (slerp), s in [0, 1] of the segment
//   kSpline    Hermite: (2s^3 - 3s^2 + 1) v0 + d (s^3 - 2s^2 + s) b0 + (3s^2 - 2s^3) v1
//              + d (s^3 - s^2) a1, of d seconds, with the tangents a before and b behind a key;
//              rotations are normalized [glTF 2.0, appendix C]
struct JointKeys {
  KeyInterpolation interpolation = KeyInterpolation::kLinear;
  std::vector<double> times;  // [s]
  std::vector<Eigen::Vector4d> values;
  std::vector<Eigen::Vector4d> before, behind;  // tangents [1/s]; kSpline

  bool empty() const { return times.empty(); }
};

// Translation, rotation and scale by keys of their own.
class KeyedMotion : public NodeMotion {
 public:
  NodeValue At(double t, double slack) const override;
  void AddTimes(std::vector<double>* times) const override;
  bool IsSound() const override;

  JointKeys translation, rotation, scale;
};

}  // namespace hazumi
