#pragma once

// A figure in another program: the oracle of the dynamics tests.

#include <memory>
#include <string>

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/figure/figure.h"
#include "tests/support/random_tree.h"

struct mjModel_;
struct mjData_;

namespace hazumi::test {

// What MuJoCo makes of a text of its format, which it must read.
std::shared_ptr<mjModel_> LoadMujocoModel(const std::string& mjcf);

// `figure` in MuJoCo. The hinges of one group share a body, because MuJoCo refuses massless ones.
// Coordinates: first those of the root, if it moves (three slides along x, y, z, then three hinges
// about x, y, z), then the figure's joints in order.
class MujocoFigure {
 public:
  // On a root that stands still at X_WR.
  MujocoFigure(const Figure& figure, const Pose& X_WR, const Vec3& gravity);
  // On a root of six degrees of freedom. Its body must have mass.
  MujocoFigure(const Figure& figure, const Vec3& gravity);

  static constexpr int kRootDof = 6;
  // Coordinates (or rates, or accelerations) of a moving root followed by those of the joints.
  static VecX Join(const Vec3& translation, const Vec3& angles, const VecX& joints);

  // Everything below is at this state.
  void SetState(const VecX& q, const VecX& qd);

  VecX InverseDynamics(const VecX& qdd, const EndForces* ends);
  VecX Bias() const;
  // Rows of a moving root that map a moment about its origin, along the world's axes, to the
  // generalized forces of its three hinges.
  Mat3 RootAxes() const;
  MatX InertiaMatrix() const;
  VecX ForwardDynamics(const VecX& tau, const EndForces* ends);
  // Torques that balance forces on the end links, J^T (Kf, Kn).
  VecX EndForceTorques(const EndForces& ends);
  // Generalized forces J^T f of a force at p on the body of a joint; an invalid joint is the root.
  // World axes [N, m].
  VecX PointForce(JointIndex j, const Vec3& p, const Vec3& force);
  Eigen::Matrix3Xd OriginJacobian(JointIndex j) const;  // velocity of its origin for unit rates
  Vec3 OriginBiasAcceleration(JointIndex j);            // and its acceleration at qdd = 0

  // For timing MuJoCo itself.
  const mjModel_* model() const { return model_.get(); }
  mjData_* data() { return data_.get(); }

 private:
  void Load(const std::string& mjcf);
  int BodyOf(JointIndex j) const;
  int size() const;

  const Figure& figure_;
  int root_dof_;
  std::shared_ptr<mjModel_> model_;
  std::shared_ptr<mjData_> data_;
};

}  // namespace hazumi::test
