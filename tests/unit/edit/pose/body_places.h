#pragma once

// Where the bodies of a session's figure are at its current frame.

#include <Eigen/Geometry>

#include "engine/dynamics/kinematics.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {

// By how much two bodies are turned differently [rad].
inline double TurnBetween(const Mat3& a, const Mat3& b) {
  return Eigen::AngleAxisd(Mat3(a.transpose() * b)).angle();
}

class BodyPlaces {
 public:
  explicit BodyPlaces(edit::Session* session)
      : figure_(session->figure()), ws_(figure_), q_(session->FrameNow().value()->q) {
    ComputePositions(figure_, session->FrameNow().value()->X_WR, q_, &ws_);
  }

  const Vec3& PlaceOf(const char* joint) const { return ws_.body(GroupOf(joint).first).p; }
  // Of the body beyond all its hinges.
  const Mat3& TurnOf(const char* joint) const { return ws_.body(GroupOf(joint).last()).R; }
  // Nothing is beyond its limits.
  bool IsWithinLimits() const {
    for (int j = 0; j < figure_.num_joints(); ++j) {
      const Joint& joint = figure_.joints()[static_cast<size_t>(j)];
      if (q_[j] < joint.lower - 1e-9 || q_[j] > joint.upper + 1e-9) return false;
    }
    return true;
  }
  const Figure& figure() const { return figure_; }
  const DynamicsWorkspace& ws() const { return ws_; }

 private:
  const JointGroup& GroupOf(const char* joint) const {
    return figure_.group(*figure_.FindGroup(joint));
  }

  const Figure& figure_;
  DynamicsWorkspace ws_;
  VecX q_;
};

}  // namespace hazumi::test
