#pragma once

// Figures that several tests share. z up, x forward, y left; all frames parallel at angle zero.

#include "engine/figure/figure.h"
#include "engine/figure/figure_spec.h"

namespace hazumi::test {

// Builds the figure; a wrong specification ends the test program with its error.
Figure Build(const FigureSpec& spec);

// A standing human of 70 kg and 1.70 m, arms hanging: 37 hinges, 20 of them massless.
Figure Human37();

// The right arm of that human on a fixed root: shoulder y x z, elbow y z, wrist x y.
Figure Arm7();
FigureSpec Arm7Spec();  // to be changed before it is built

// One hinge about y with a cylinder hanging from it.
Figure Pendulum(double mass, double radius, double length);

}  // namespace hazumi::test
