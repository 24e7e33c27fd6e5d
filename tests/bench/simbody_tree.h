#pragma once

// A tree of bodies in Simbody and in Simbody's terms. A file of its own, in C++17, because
// Simbody's headers are ambiguous in C++20: so it includes nothing of the engine that needs C++20.

#include <memory>
#include <vector>

#include "engine/spatial/rigid_inertia.h"

namespace hazumi::bench {

// Of its integrators the two that need the least time for a given error on the arm.
enum class SimbodyIntegrator { kMerson, kFehlberg };

class SimbodyTree {
 public:
  // Turns about z, about x and y, or about x, y and z of a frame; or freely.
  enum class Mobilizer { kPin, kUniversal, kGimbal, kBall };
  struct Body {
    int parent;  // -1: the ground
    Mobilizer mobilizer;
    Mat3 R_PB;  // at coordinates zero
    Vec3 p_PB;
    Mat3 R_BM;  // the mobilizer's frame; of a ball, that of the body
    RigidInertia inertia;
  };
  SimbodyTree(const std::vector<Body>& bodies, double gravity);
  ~SimbodyTree();
  SimbodyTree(const SimbodyTree&) = delete;
  SimbodyTree& operator=(const SimbodyTree&) = delete;

  // Coordinates and rates, three of each for a ball too (then not read: see SetBall).
  void SetState(const VecX& q, const VecX& u);
  // Rotation and angular velocity in the parent's axes (of R_PB).
  void SetBall(int body, const Mat3& R, const Vec3& w);
  void SetForces(const VecX& forces);

  void InverseDynamics(const VecX& udot, VecX* forces);
  void ComputeMassMatrix();
  MatX MassMatrix() const;
  void ForwardDynamics(VecX* udot);

  // From the state set; then the coordinates and rotations below are those at the end.
  void Integrate(SimbodyIntegrator integrator, double accuracy, double seconds);
  VecX EndCoordinates() const;  // of a ball: unspecified
  Mat3 EndRotation(int body) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace hazumi::bench
