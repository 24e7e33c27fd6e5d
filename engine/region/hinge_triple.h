#pragma once

#include "engine/spatial/pose.h"

namespace hazumi {

// Three concentric hinges whose middle axis is perpendicular to the outer two turn a body as a ball
// joint does: R = Rot(a1, q1) Rot(a2, q2) Rot(a3, q3). Keyed and limited as hinges, simulated as a
// ball: only its coordinates are singular, at the two poles where the outer axes line up.
// [METHOD 4.1]
class HingeTriple {
 public:
  // Axes: unit vectors, all in the frame before the hinges at angle zero.
  static bool Fits(const Vec3& a1, const Vec3& a2, const Vec3& a3);
  HingeTriple(const Vec3& a1, const Vec3& a2, const Vec3& a3);

  Mat3 Rotation(const Vec3& q) const;

  // The angles of R [rad]. Two triples give the same R, each modulo whole turns, one for either
  // side of the poles that the middle hinge can be on. The one nearer to `near` is taken, so that a
  // motion past a pole goes on with the middle hinge and does not flip the outer ones.
  // `keeps_side`: the one on the side of `near`, as hinges move that turn all the way; past a pole
  // the outer ones whip round. At a pole itself, where only a sum or difference of the outer angles
  // is left, the first one stays.
  Vec3 Angles(const Mat3& R, const Vec3& near, bool keeps_side) const;

  // The angles at a pole, or next to it, of a motion from `before` that goes straight through it,
  // as far as that leaves the middle hinge inside its limits: it is on the other side from here on.
  Vec3 ThroughPole(const Mat3& R, const Vec3& before) const;

  // Proportional to how fast the nearer pole gets nearer: its sign changes at a pole.
  double Approach(const Vec3& q, const Vec3& qd) const;

  // Columns: the axes at angles q, in the turned body's frame.
  Mat3 AxesInBody(const Vec3& q) const;
  // Rates of the hinges for the angular velocity w, in the body's frame [rad/s]. At a pole the part
  // that no hinge can follow is left out.
  Vec3 Rates(const Vec3& q, const Vec3& w) const;

  // Accelerations of the hinges for rates qd and w', the rate of w in the body's frame [rad/s^2].
  Vec3 Accelerations(const Vec3& q, const Vec3& qd, const Vec3& w_rate) const;

  // How far the middle hinge is from the nearer pole [rad], from 0 to pi/2.
  double FromPole(double q2) const;

 private:
  Vec3 AtPole(const Mat3& R, const Vec3& near, double g) const;

  Vec3 a1_, a2_, a3_;
  Vec3 b1_, b3_;  // a2 x a1, a3 x a2
  double beta_;   // Rot(a2, beta) a1 = a3
};

}  // namespace hazumi
