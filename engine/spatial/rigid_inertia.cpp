#include "engine/spatial/rigid_inertia.h"

#include <Eigen/Geometry>

namespace hazumi {

Mat3 PointInertia(double mass, const Vec3& c) {
  return mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
}

RigidInertia Moved(const RigidInertia& body, const Pose& X) {
  return {body.mass, X * body.com, X.R * body.I_com * X.R.transpose()};
}

RigidInertia Combine(const RigidInertia& a, const RigidInertia& b) {
  if (a.is_massless()) return b;
  if (b.is_massless()) return a;
  RigidInertia sum;
  sum.mass = a.mass + b.mass;
  sum.com = sum.mass > 0.0 ? Vec3((a.mass * a.com + b.mass * b.com) / sum.mass) : Vec3::Zero();
  sum.I_com = a.I_com + PointInertia(a.mass, a.com - sum.com) + b.I_com +
              PointInertia(b.mass, b.com - sum.com);
  return sum;
}

RigidInertia SolidCylinder(const Vec3& from, const Vec3& to, double radius, double mass) {
  const Vec3 along = to - from;
  const double length = along.norm();
  const Vec3 axis = length > 0.0 ? Vec3(along / length) : Vec3::UnitZ();
  const double about_axis = 0.5 * mass * radius * radius;
  const double across = mass * (3.0 * radius * radius + length * length) / 12.0;
  const Mat3 along_axis = axis * axis.transpose();
  return {mass, 0.5 * (from + to),
          about_axis * along_axis + across * (Mat3::Identity() - along_axis)};
}

RigidInertia SolidSphere(const Vec3& centre, double radius, double mass) {
  return {mass, centre, 0.4 * mass * radius * radius * Mat3::Identity()};
}

RigidInertia SolidBox(const Vec3& centre, const Vec3& half_size, double mass, const Mat3& axes) {
  const Vec3 squares = half_size.cwiseAbs2();
  const Vec3 diagonal = (mass / 3.0) * (Vec3::Constant(squares.sum()) - squares);
  return {mass, centre, axes * diagonal.asDiagonal() * axes.transpose()};
}

}  // namespace hazumi
