#pragma once

// A tree of bodies in Simbody and in Simbody's terms. A file of its own, in C++17, because
// Simbody's headers are ambiguous in C++20: so it includes nothing of the engine that needs C++20.

#include <memory>
#include <vector>

#include "engine/spatial/types.h"

namespace hazumi::bench {

// Of its integrators the two that need the least time for a given error on the arm, the implicit
// one (CVODE's backward differences), and the one whose steps are equal.
enum class SimbodyIntegrator { kMerson, kFehlberg, kImplicit, kSemiExplicitEuler };

class SimbodyTree {
 public:
  // Turns about z, about x and y, or about x, y and z of a frame; or freely.
  enum class Mobilizer { kPin, kUniversal, kGimbal, kBall };
  // About the axes of the body.
  struct Inertia {
    double mass;
    Vec3 com;
    Mat3 I_origin;  // about the body's origin [kg m^2]
  };
  // Linear, of one coordinate.
  struct Spring {
    double stiffness, damping;  // [N m/rad, N m s/rad]
    double angle;               // that it pulls to [rad]
  };
  struct Body {
    int parent;  // -1: the ground
    Mobilizer mobilizer;
    Mat3 R_PB;  // at coordinates zero
    Vec3 p_PB;
    Mat3 R_BM;  // the mobilizer's frame; of a ball, that of the body
    Inertia inertia;
    std::vector<Spring> springs = {};  // by coordinate, if there are any
  };
  // Kept together: a point of one body and one of another, each in its body's axes from its origin;
  // body -1: the ground.
  struct Tie {
    int a;
    Vec3 p_a;
    int b;
    Vec3 p_b;
  };
  SimbodyTree(const std::vector<Body>& bodies, double gravity, const std::vector<Tie>& ties = {});
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

  // From the state set; then the coordinates and rotations below are those at the end. `setting`:
  // its accuracy, or the equal steps [s]. May throw where it cannot go on.
  void Integrate(SimbodyIntegrator integrator, double setting, double seconds);
  long evaluations() const;     // of the equations of motion, in the last Integrate
  VecX EndCoordinates() const;  // of a ball: unspecified
  VecX EndRates() const;
  Mat3 EndRotation(int body) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace hazumi::bench
