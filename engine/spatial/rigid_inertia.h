#pragma once

#include <tuple>

#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

// Mass [kg], centre of mass [m] and rotational inertia about the centre of mass [kg m^2] of a rigid
// body, all in one frame. A massless body is all zeros.
struct RigidInertia {
  double mass = 0.0;
  Vec3 com = Vec3::Zero();
  Mat3 I_com = Mat3::Zero();

  bool is_massless() const { return mass == 0.0 && I_com.isZero(0.0); }
};
inline auto MembersOf(const RigidInertia& body) {
  const auto& [mass, com, I_com] = body;
  return std::tie(mass, com, I_com);
}

// The same in the frame that X leads to from the body's.
RigidInertia Moved(const RigidInertia& body, const Pose& X);

// The inertia of both bodies fixed together. Both in the same frame.
RigidInertia Combine(const RigidInertia& a, const RigidInertia& b);

// A solid cylinder between two points (Arai 2.1 takes every link for one).
RigidInertia SolidCylinder(const Vec3& from, const Vec3& to, double radius, double mass);

// A solid sphere about `centre`.
RigidInertia SolidSphere(const Vec3& centre, double radius, double mass);

// A solid box whose axes are the columns of `axes`.
RigidInertia SolidBox(const Vec3& centre, const Vec3& half_size, double mass,
                      const Mat3& axes = Mat3::Identity());

// m (|c|^2 1 - c c^T): what the parallel-axis theorem adds about a point at distance c.
Mat3 PointInertia(double mass, const Vec3& c);

}  // namespace hazumi
