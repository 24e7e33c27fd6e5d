#pragma once

// Poses of a throw that its keys propose. Names are those of the human that comes
// with Hazumi, for the hinges that do the same in other figures (FigureBody); angles are those of a
// right-handed throw, underarm.

#include <array>
#include <string_view>

namespace hazumi::makers {

enum ThrowPhase { kBackswing, kSwing, kFollowThrough, kNumThrowPhases };

// The region moves the shoulder of the throwing arm: only the shoulder's angles in the backswing
// count. Its wrist is bent back as it lets go and stays so: what flies off along the arm, for the
// arm goes round, comes off the fingers then instead of through them.
enum class ThrowLimb { kTrunk, kShoulder, kThrowingArm, kOtherArm, kLegs };

struct ThrowHinge {
  const char* name;  // without the side, or of the trunk
  ThrowLimb limb;
  // The trunk turns the other way if the left hand throws.
  bool is_mirrored;
  std::array<double, kNumThrowPhases> angles;  // by phase [degrees]
  double turns = 0.0;                          // its share of the way to the spot

  bool swings() const { return std::string_view(name) == "shoulder_flexion"; }

  void Scale(double by) {
    for (double& angle : angles) angle *= by;
    turns *= by;
  }
  void Add(const ThrowHinge& other) {
    for (size_t i = 0; i < angles.size(); ++i) angles[i] += other.angles[i];
    turns += other.turns;
  }
};

inline constexpr double kShoulderBack = -60.0;  // as far back as the arm swings [degrees]

// The feet are flat: ankle = knee - hip. The weight goes from over the feet towards the toes.
inline constexpr ThrowHinge kThrowHinges[] = {
    {"waist_flexion", ThrowLimb::kTrunk, false, {10.0, 12.0, 4.0}},
    {"waist_rotation", ThrowLimb::kTrunk, true, {-12.0, 2.0, 10.0}, 0.35},
    {"chest_flexion", ThrowLimb::kTrunk, false, {6.0, 4.0, 0.0}},
    {"chest_rotation", ThrowLimb::kTrunk, true, {-24.0, 2.0, 16.0}, 0.65},
    {"neck_flexion", ThrowLimb::kTrunk, false, {-10.0, -10.0, -4.0}},
    {"neck_rotation", ThrowLimb::kTrunk, true, {34.0, -2.0, -24.0}},
    {"shoulder_flexion", ThrowLimb::kOtherArm, false, {38.0, 14.0, -22.0}},
    {"shoulder_abduction", ThrowLimb::kOtherArm, false, {18.0, 24.0, 18.0}},
    {"elbow_flexion", ThrowLimb::kOtherArm, false, {35.0, 28.0, 24.0}},
    {"hip_flexion", ThrowLimb::kLegs, false, {24.0, 14.0, 2.0}},
    {"knee", ThrowLimb::kLegs, false, {44.0, 28.0, 14.0}},
    {"ankle_flexion", ThrowLimb::kLegs, false, {20.0, 14.0, 12.0}},
    {"shoulder_flexion", ThrowLimb::kShoulder, false, {kShoulderBack, 0.0, 0.0}},
    {"shoulder_rotation", ThrowLimb::kShoulder, false, {0.0, 0.0, 0.0}},
    {"shoulder_abduction", ThrowLimb::kShoulder, false, {10.0, 0.0, 0.0}},
    {"elbow_flexion", ThrowLimb::kThrowingArm, false, {14.0, 8.0, 12.0}},
    {"elbow_pronation", ThrowLimb::kThrowingArm, false, {-55.0, -65.0, -40.0}},
    {"wrist_flexion", ThrowLimb::kThrowingArm, false, {-20.0, -59.0, -61.0}},
    {"wrist_deviation", ThrowLimb::kThrowingArm, false, {0.0, 0.0, 0.0}}};

}  // namespace hazumi::makers
