#pragma once

// Everything about a motion that an animator would not want: one list and one sentence each, for
// the window, the command line and scripts.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/analysis/flights.h"
#include "engine/analysis/held_turn.h"
#include "engine/analysis/missing_support.h"
#include "engine/analysis/problems/sinking.h"
#include "engine/bake/motion.h"
#include "engine/base/warning.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Beside a flight, where it stands on a pin before and after it, the figure is thrown forward or
// braked harder than legs can.
struct ContactJerk {
  int frame = 0;              // the hardest, of the animation's
  bool is_landing = false;    // else its take-off
  double acceleration = 0.0;  // of the centre of mass, horizontal [m/s^2]
};

// One for each take-off and landing at most, of flights by gravity from one pin to another. Of a
// motion at the animation's frame rate.
std::vector<ContactJerk> ContactJerks(const Animation& animation, const Motion& motion);

// An object that nobody holds goes into an object of the scene: nothing stops it but keys.
struct FallThrough {
  int object = 0;  // of the animation's held objects
  int frame = 0;   // the first, of those that an animation numbers
  std::string obstacle;
  Vec3 outside = Vec3::Zero();  // where its centre would touch, world [m]
  Vec3 normal = Vec3::UnitZ();  // of what it touches there
};

// The first of each object. A box counts as the sphere in it.
std::vector<FallThrough> FallsThrough(const Animation& animation, const Motion& motion);

// A foot that slides far while it is on the ground.
struct SlidingFoot {
  std::string foot;
  FootSlide slide;
};

// A problem of a motion, with its numbers.
using Finding = std::variant<PlacementJump, Warning, HeldTurn, OutlastingConstraint, Sinking,
                             SlidingFoot, FallThrough, ContactJerk, MissingSupport, TimeScale>;

// Analyses of a motion that take long: a window makes them one after the other.
struct Analyses {
  std::vector<HeldTurn> turns;
  std::vector<OutlastingConstraint> outlasting;
  std::vector<Sinking> sinkings;
  std::vector<FootSkate> skates;
  TimeScale time;  // of flights WithoutGravity
  std::vector<MissingSupport> missing;
};

// Makes all of them at once, except those of which the command line warns. `effort` is that of the
// motion.
Analyses AnalysesOf(const Animation& animation, const Motion& motion, const Effort& effort,
                    bool size_is_guessed);

// Removes flights by gravity, which are right by themselves and say nothing about the rest.
FlightAnalysis WithoutGravity(FlightAnalysis analysis,
                              const std::vector<PlacementSpan>& placements);
// The common frame rate that the clip should be played at [1/s]; none if no such rate is near, or
// if lengths are wrong.
std::optional<int> RateToSet(const TimeScale& time);

// Returns the problems in the order in which they are shown. `motion` is at the animation's frame
// rate.
std::vector<Finding> FindProblems(const Animation& animation, const Motion& motion,
                                  const Analyses& analyses);

// Whether the command line tells it as a warning.
bool IsAWarning(const Finding& finding);
// The frame that shows a problem; none if it is about all frames.
std::optional<int> FrameOf(const Finding& finding);

// Returns the translation of an English text.
using Translate = const char* (*)(const char* english);
inline const char* Untranslated(const char* english) { return english; }

// Sentence about a wrong time or length of a clip, as its flights show it; empty if nothing is
// wrong.
std::string AlarmText(const TimeScale& time, Translate translate);
// A sentence with the frames, the numbers, and for some problems the remedy.
std::string TextOf(const Finding& finding, const Animation& animation,
                   Translate translate = Untranslated);

}  // namespace hazumi
