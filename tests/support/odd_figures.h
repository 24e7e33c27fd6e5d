#pragma once

// Figures on which methods fail. z up, x forward; all frames parallel at angle zero.

#include <string>

#include "engine/figure/figure.h"

namespace hazumi::test {

// Angles of Arm7, bent and away from every pole [rad].
VecX BentArm();
// Arm7 with these limits [rad] and its hand's mass and inertia scaled.
Figure Arm7Within(const VecX& lower, const VecX& upper, double hand_scale = 1.0);
// Arm7 that turns as far as it likes.
Figure FreeArm7(double hand_scale = 1.0);
// The same arm with the shoulder's hinges about x, y, z from the base outwards: a pole of FreeArm7
// is an ordinary pose of it.
Figure FreeArm7WithShoulderXyz();

// `links` equal rods in a row, hinged about y, 1 m and 1 kg in all, hanging down at zero.
Figure Chain(int links);

// One such rod of 1 m with limits.
Figure RodWithin(double lower, double upper);

// Two such rods of 0.5 m each, the first with its upper limit at -pi/2, where it points to +x:
// there its weight presses it on the limit.
Figure RodsOnAStop();

// A rod of `length` without thickness, 1 kg, on three hinges y x z; hanging down at zero, so that
// the z hinge turns it about itself.
Figure ThinRod(double length);

// One body of 1 kg whose moment of inertia about its joint "ball", on three hinges y x z, is the
// same about every axis.
Figure RoundBall();

// A rod of 1 kg and 1 m that points along +x at zero, on a hinge about y ("hinge") whose muscles
// give so much either way [N m]. It rests at -90 degrees, pointing up.
Figure StrongRod(double torque);

// A body with a given CoM and moment of inertia about any axis.
LinkSpec Lump(const std::string& name, double mass, const Vec3& com, double moment);

// Two bodies hinged about y one after the other, balanced so that, with the first pressed on its
// upper limit and the second on its lower one, stopping one throws the other off. Both limits at 0,
// where the first body points to +x.
Figure LimitsThatKickEachOther();

// A bar hinged about y ("bar") with arms at both ends ("left", "right"), each hinged about y and
// hanging down at zero, mirror images of each other. Limits of the arms at +-`left`, +-`right`.
Figure MirrorArms(double left, double right);

}  // namespace hazumi::test
