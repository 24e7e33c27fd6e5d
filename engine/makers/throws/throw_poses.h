#pragma once

// Poses of a throw that its keys propose. Names are those of the human that comes with Hazumi, for
// the hinges that do the same in other figures (FigureBody); angles are those of a right-handed
// throw.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/body/figure_body.h"
#include "engine/makers/keyed_moves.h"
#include "engine/timeline/goal_kind.h"

namespace hazumi::makers {

enum ThrowPhase { kWindUp, kRelease, kFollowThrough, kNumThrowPhases };
inline constexpr int kNumThrowStyles = 3;

// The throwing arm's angles at the release are only wanted; those of the follow-through it passes
// on its way back, so that it goes round the body.
enum class ThrowLimb { kTrunk, kThrowingArm, kOtherArm, kLegs };

using ThrowAngles = std::array<double, kNumThrowPhases>;  // [degrees]

struct ThrowHinge {
  const char* name;  // without the side, or of the trunk
  ThrowLimb limb;
  // The trunk turns and bends the other way if the left hand throws.
  bool is_mirrored;
  std::array<ThrowAngles, kNumThrowStyles> angles;  // by ThrowStyle
  // Of the throwing arm: how readily it turns as it lets go, by ThrowStyle [rad/s].
  std::array<double, kNumThrowStyles> ease = {};
  double turns = 0.0;  // its share of the way to the spot

  const ThrowAngles& At(ThrowStyle style) const { return angles[static_cast<size_t>(style)]; }
  double EaseAt(ThrowStyle style) const { return ease[static_cast<size_t>(style)]; }
  void Scale(double by) {
    for (ThrowAngles& of : angles) {
      for (double& angle : of) angle *= by;
    }
    for (double& rate : ease) rate *= by;
    turns *= by;
  }
  void Add(const ThrowHinge& other) {
    for (size_t s = 0; s < angles.size(); ++s) {
      for (size_t i = 0; i < angles[s].size(); ++i) angles[s][i] += other.angles[s][i];
      ease[s] += other.ease[s];
    }
    turns += other.turns;
  }
};

// Underarm, overarm, push; of each the wind-up, the release, the follow-through. The feet are flat:
// ankle = knee - hip.
inline constexpr ThrowHinge kThrowHinges[] = {
    {"waist_flexion", ThrowLimb::kTrunk, false, {{{10, 12, 6}, {-8, 10, 14}, {2, 8, 8}}}},
    {"waist_bend", ThrowLimb::kTrunk, true, {{{0, 0, 0}, {6, -10, -8}, {4, 0, 0}}}},
    {"waist_rotation",
     ThrowLimb::kTrunk,
     true,
     {{{-12, 2, 8}, {-15, 8, 12}, {-12, 8, 12}}},
     {},
     0.35},
    {"chest_flexion", ThrowLimb::kTrunk, false, {{{6, 4, 0}, {-6, 10, 14}, {0, 4, 4}}}},
    {"chest_bend", ThrowLimb::kTrunk, true, {{{0, 0, 0}, {8, -8, -6}, {4, 0, 0}}}},
    {"chest_rotation",
     ThrowLimb::kTrunk,
     true,
     {{{-24, 2, 14}, {-28, 14, 22}, {-26, 16, 22}}},
     {},
     0.65},
    {"neck_flexion", ThrowLimb::kTrunk, false, {{{-10, -10, -4}, {4, -12, -16}, {-2, -8, -6}}}},
    {"neck_rotation", ThrowLimb::kTrunk, true, {{{34, -2, -20}, {42, -20, -32}, {36, -22, -30}}}},
    {"shoulder_flexion",
     ThrowLimb::kOtherArm,
     false,
     {{{38, 14, -16}, {70, 4, -16}, {50, 0, -14}}}},
    {"shoulder_abduction",
     ThrowLimb::kOtherArm,
     false,
     {{{18, 24, 18}, {20, 26, 22}, {16, 22, 20}}}},
    {"elbow_flexion", ThrowLimb::kOtherArm, false, {{{35, 28, 24}, {20, 62, 50}, {40, 56, 44}}}},
    {"hip_flexion", ThrowLimb::kLegs, false, {{{24, 14, 4}, {14, 10, 12}, {22, 8, 6}}}},
    {"knee", ThrowLimb::kLegs, false, {{{44, 28, 14}, {30, 20, 22}, {40, 14, 12}}}},
    {"ankle_flexion", ThrowLimb::kLegs, false, {{{20, 14, 10}, {16, 10, 10}, {18, 6, 6}}}},
    {"shoulder_flexion",
     ThrowLimb::kThrowingArm,
     false,
     {{{-60, 40, 30}, {105, 40, 35}, {30, 80, 50}}},
     {12, 8, 6}},
    {"shoulder_rotation",
     ThrowLimb::kThrowingArm,
     false,
     {{{0, 0, 0}, {15, -20, 0}, {3, -5, 0}}},
     {2, 5, 3}},
    {"shoulder_abduction",
     ThrowLimb::kThrowingArm,
     false,
     {{{12, 6, 8}, {100, 120, 18}, {60, 25, 14}}},
     {2, 4, 3}},
    {"elbow_flexion",
     ThrowLimb::kThrowingArm,
     false,
     {{{14, 10, 28}, {105, 35, 50}, {132, 40, 50}}},
     {3, 8, 9}},
    {"elbow_pronation",
     ThrowLimb::kThrowingArm,
     false,
     {{{-45, -65, -30}, {20, 30, 20}, {60, 60, 20}}},
     {1, 2, 1}},
    {"wrist_flexion",
     ThrowLimb::kThrowingArm,
     false,
     {{{-25, -59, -20}, {-40, -40, 0}, {-60, -65, 0}}},
     {1, 3, 3}},
    {"wrist_deviation",
     ThrowLimb::kThrowingArm,
     false,
     {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
     {0.5, 1, 0.5}}};

using NamedThrowHinge = NamedHinge<ThrowHinge>;

// Returns every hinge of a figure that a throw by its right or left hand keys.
std::vector<NamedThrowHinge> HingesOfThrow(BodySide side, const Figure& figure);

// Habit of a hinge as the arm lets go.
struct ReleaseHabit {
  std::optional<double> angle;  // [rad]; nothing: none
  double ease = 4.0;            // rate that counts as 1 [rad/s]
};
// Returns habits by JointIndex. `joint`: of what has the object; of no arm: there are none.
std::vector<ReleaseHabit> HabitsOf(ThrowStyle style, JointIndex joint, const Figure& figure);

// Returns the side of the hand that has an object; none if what has it is no part of an arm.
std::optional<BodySide> SideOfHand(const std::string& holder, const Figure& figure);
// Returns the hand of an arm, or the forearm that ends in it; none: there is no such arm.
std::optional<GroupIndex> HandOf(const FigureBody& body, BodySide side);

}  // namespace hazumi::makers
