#pragma once

// Internal: the frames of a jump, how the figure stands in each of its phases, and where
// (equations: jump_plan.cpp); how it leaves the ground and comes to it (jump_contacts.cpp); and how
// high it jumps.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/jumps/jump_poses.h"
#include "engine/makers/jumps/jumps.h"
#include "engine/makers/keyed_moves.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

inline constexpr double kStretchSeconds = 0.07;  // of going on to stretch after take-off

// A pose by hinge and the root's orientation.
struct Stance {
  VecX q;       // [rad]
  Vec3 angles;  // of the root: z, y, x [degrees]
};

// A stance after so many seconds at these rates.
inline Stance Going(const Stance& stance, double seconds, const Stance& rates) {
  return {stance.q + seconds * rates.q, stance.angles + seconds * rates.angles};
}

using NamedJumpHinge = NamedHinge<JumpHinge>;

// What of a figure jumps; hinges by side, right and left. A foot that stands on its ankle, without
// a toe, stays flat until take-off.
struct JumpBody {
  explicit JumpBody(const Figure& figure);

  std::vector<NamedJumpHinge> hinges;
  std::array<std::optional<JointIndex>, 2> hips, ankles, toes;
  std::array<std::string, 2> feet;  // joints that stand on the ground: toes, feet or shins
  // Hinges of the legs that do not jump: they turn a leg aside or about itself.
  std::vector<JointIndex> aside;

  const NamedJumpHinge* Find(JointIndex joint) const;
  // Errors: kSchema if it has not what a jump needs.
  std::optional<Error> Check(const Figure& figure) const;
};

// Stances of a figure, put onto the scene. The animation and the body must outlive it.
class Stage {
 public:
  Stage(const Animation& animation, const JumpBody& body);
  const JumpBody& body() const { return body_; }

  // Returns the place of the root where the middle of the toes is above `spot` and the figure, come
  // down from above, touches the scene [m]. Errors: kSchema if there is nothing to stand on.
  Result<Vec3> RootOn(const Stance& stance, const Vec3& spot);
  Vec3 ComOf(const Stance& stance, const Vec3& root);
  // Returns the middle of the toes.
  Vec3 ToesOf(const Stance& stance, const Vec3& root);
  // Returns the right one's and the left one's place.
  std::array<Vec3, 2> FeetOf(const Stance& stance, const Vec3& root);
  // Returns the CoM if the middle of the toes is there.
  Vec3 ComOver(const Vec3& toes, const Stance& stance);

 private:
  void Place(const Stance& stance, const Vec3& root);
  Vec3 Toes() const;

  const Animation& animation_;
  const Figure& figure_;
  std::array<JointIndex, 2> feet_;
  const JumpBody& body_;
  DynamicsWorkspace ws_;
};

using JumpFrames = std::array<int, kNumJumpPhases>;
using JumpStances = std::array<Stance, kNumJumpPhases>;

// Which frame each phase is on, and where the root is.
struct JumpPlan {
  int start = 0, end = 0;
  JumpFrames frames{};
  JumpStances stances;
  std::array<Vec3, kNumJumpPhases> roots;
  Stance before, after;          // how it stands on the first and on the last frame
  Vec3 root_before, root_after;  // and where
  // Rates of the stances at take-off and landing, per second; others have none.
  std::array<std::optional<Stance>, kNumJumpPhases> rates;
  size_t foot = 0;  // on which it stands until it takes off: 0 the right one, 1 the left one
};

JumpReport ReportOf(const JumpPlan& plan, double height);

// Durations of a jump besides its stretch, its flight and its landing.
struct JumpLengths {
  int crouch = 0, rise = 0;  // frames to the crouch, and from the lowest pose until it stands
};

// Whether the feet are about beside each other and equally high: else, as in a stride, it brings
// them together before it jumps.
bool StandsOnBothFeet(const Stance& stance, Stage* stage);

// Places of the middle of its toes until take-off, and from the landing on [m].
struct JumpSpots {
  Vec3 from, onto;
};

// Sets the roots of a plan with its stances. Errors: kSchema if there is nothing to stand on.
Result<Done> SetRoots(const JumpSpots& spots, Stage* stage, JumpPlan* plan);
// Sets the frames of a plan with its roots, for an apex so high above take-off [m]. Errors:
// kSchema.
Result<Done> SetTimes(const Animation& animation, double height, const JumpLengths& lengths,
                      Stage* stage, JumpPlan* plan);

// Whether every hinge that bears a jump has a key on this frame.
bool HasPose(int frame, const JumpBody& body, const Project& project);
// Whether the keys on these frames say how fast it takes off and lands.
bool HasContacts(const JumpFrames& frames, const JumpBody& body, const Project& project);

// The pins on which a jump stands before and after its flight; their frames are the plan's.
struct JumpPins {
  ProjectPlacement before, after;
};
// Keys where the root is (not its angles), and gives the flight to gravity. Nothing else places the
// figure then.
Result<Done> PutJump(const JumpPlan& plan, JumpPins pins, Project* project);

// Strength that a jump may ask of the legs.
enum class Push {
  kOfPeople,  // what people's can give and take
  kAny,       // whatever the flight needs; effort says how much that is
};

// Sets roots and frames as SetRoots and SetTimes do, leans at take-off and landing that suit the
// flight, and the rates there, of a plan whose stances are those of kJumpHinges. Errors: theirs,
// and kSchema if the legs cannot give or take that flight's speed.
Result<Done> PlanContacts(const Animation& animation, const JumpSpots& spots, double height,
                          const JumpLengths& lengths, Push push, Stage* stage, JumpPlan* plan);

// Keys the planned rates and leans at take-off and landing where keys there have rates. Other
// curves stay as they are.
void KeyContacts(const JumpPlan& plan, const JumpBody& body, const Figure& figure,
                 Project* project);

// A way to jump.
struct JumpTry {
  double height = 0.0;   // of the CoM above take-off [m]
  double stretch = 1.0;  // share of what the feet go on stretching after take-off
  Push push = Push::kOfPeople;
};
// Jumps so in a project, which it changes.
using JumpSo = std::function<Result<JumpReport>(const JumpTry& how, Project* project)>;
// Jumps as high as is given or, if no height is, as low as it gets there; with the next of the
// stretches where feet would touch the ground again; and, if no height is given, with legs that
// give more than people's where no other way is left.
Result<MadeJump> JumpAsLow(std::optional<double> height, const std::vector<double>& stretches,
                           const JumpSo& jump, const Project& project);

}  // namespace hazumi::makers
