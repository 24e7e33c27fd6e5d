#pragma once

// Small figures made of capsules, for tests of placement and bake. Metres, kilograms.

#include "engine/figure/figure.h"

namespace hazumi::test {

// A root sphere of 0.1 m and 4 kg over a foot: joint "foot" 0.5 m below, with a sphere of 0.05 m
// and 1 kg centred on it. The lowest point is 0.55 m below the root.
Figure Pogo();

// A root sphere of 3 kg, "knee" 0.4 m below it carrying a shank of 2 kg, "foot" 0.4 m below that
// with a sphere of 0.05 m and 1 kg. Both hinges about y; zero is straight.
Figure TwoLinks();

// Hip (y x z), knee (y), ankle (y x), 0.4 m thigh and shank; "toe" sits 0.1 m below and 0.15 m
// before the ankle. Six hinges lie between root and toe.
Figure Leg();

// Shoulder (x y z), elbow (y z), wrist (x y), then "tip": seven hinges for three or six
// constraints. 0.3 m upper arm, 0.25 m forearm, 0.1 m hand.
Figure Arm();

// 37 hinges: waist, chest and neck of three, arms of seven ("r_shoulder", "r_elbow", "r_wrist",
// and "l_"), legs of seven ("r_hip", "r_knee", "r_ankle", "r_toe"). Pelvis 0.95 m above the soles.
Figure Human();

}  // namespace hazumi::test
