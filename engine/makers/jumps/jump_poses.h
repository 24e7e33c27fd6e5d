#pragma once

// Poses of a jump that its keys propose. Names are those of the human that comes with
// Hazumi, for the hinges that do the same in other figures (FigureBody); left and right do the
// same.

#include <array>

namespace hazumi::makers {

enum JumpPhase { kCrouch, kTakeOff, kStretched, kApex, kLanding, kAbsorbed, kNumJumpPhases };

struct JumpHinge {
  const char* name;  // without the side, or of the trunk
  bool has_sides;
  bool bears;                                 // fastest as it pushes off and as it catches
  std::array<double, kNumJumpPhases> angles;  // by phase [degrees]

  void Scale(double by) {
    for (double& angle : angles) angle *= by;
  }
  void Add(const JumpHinge& other) {
    for (size_t i = 0; i < angles.size(); ++i) angles[i] += other.angles[i];
  }
};

// The feet of a standing figure are flat, but for heels a little off the floor in the
// crouch: ankle = knee - hip + lean - toe, and its CoM is over the ankles. At take-off it is on its
// toes, toe = -(hip - knee + ankle - lean), and goes on stretching.
inline constexpr JumpHinge kJumpHinges[] = {
    {"hip_flexion", true, true, {95.0, 20.0, 5.0, 75.0, 50.0, 106.0}},
    {"knee", true, true, {88.0, 30.0, 12.0, 90.0, 50.0, 90.0}},
    {"ankle_flexion", true, true, {20.0, -25.0, -38.0, -20.0, 15.0, 20.0}},
    {"toe", true, true, {5.0, 43.0, 10.0, 0.0, 0.0, 0.0}},
    {"shoulder_flexion", true, false, {-50.0, 110.0, 135.0, 80.0, 45.0, 25.0}},
    {"shoulder_abduction", true, false, {10.0, 15.0, 15.0, 20.0, 20.0, 10.0}},
    {"elbow_flexion", true, false, {25.0, 20.0, 20.0, 40.0, 35.0, 30.0}},
    {"waist_flexion", false, false, {20.0, 0.0, -2.0, 15.0, 10.0, 22.0}},
    {"chest_flexion", false, false, {10.0, -5.0, -5.0, 5.0, 5.0, 8.0}},
    {"neck_flexion", false, false, {-20.0, -5.0, -5.0, -10.0, -5.0, -15.0}}};
inline constexpr std::array<double, kNumJumpPhases> kJumpLean = {32.0, 8.0, 6.0, 10.0, 15.0, 36.0};

}  // namespace hazumi::makers
