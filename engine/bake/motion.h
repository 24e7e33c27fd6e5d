#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/warning.h"
#include "engine/figure/figure.h"
#include "engine/region/contact/contact_push.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/wrench.h"
#include "engine/timeline/dynamics_region.h"
#include "engine/timeline/frame_time.h"

namespace hazumi {

// The figure's motion on one side of an instant.
struct MotionLimit {
  VecX q, qd;                  // by JointIndex [rad, rad/s]
  Pose X_WR;                   // root in the world [m]
  Vec3 root_w = Vec3::Zero();  // angular velocity of the root, world axes [rad/s]
  Vec3 root_v = Vec3::Zero();  // velocity of the root's origin [m/s]
  bool operator==(const MotionLimit&) const = default;
};

// And its accelerations there.
struct MotionAcceleration {
  VecX qdd;                        // by JointIndex [rad/s^2]
  Vec3 root_alpha = Vec3::Zero();  // of the root, world axes [rad/s^2]
  Vec3 root_a = Vec3::Zero();      // of the root's origin [m/s^2]
  bool operator==(const MotionAcceleration&) const = default;
};

// Where a held object is.
struct ObjectPose {
  Pose X_WO;
  int holder = 0;  // by index of HeldObject::holders; -1: nobody
  bool is_held() const { return holder >= 0; }
};

// What regions that keep out of the scene are pushed with there.
struct SceneContacts {
  std::vector<ContactPush> pushes;  // by indices of the figure's links and Animation::scene
  std::vector<char> is_known;       // by link: nothing else pushes it; empty: of none
  bool operator==(const SceneContacts&) const = default;
};

struct MotionFrame {
  int frame = 0;              // in frames of Motion::rate
  VecX q;                     // by JointIndex [rad]; as in `after`
  Pose X_WR;                  // root in the world [m]; as in `after`
  MotionLimit before, after;  // limits from the left and from the right
  Vec3 com = Vec3::Zero();    // of the figure with what it holds, world [m]
  std::optional<GroupIndex> pinned;
  std::vector<ObjectPose> objects;  // by index of Animation::held_objects
  std::vector<char> in_region;      // by JointIndex
  // As in `after`, of the last frame as in `before`: if BakeOptions::accelerations asks for them.
  std::optional<MotionAcceleration> acceleration = {};
  // By index of Animation::constraints: how strong each is from here on [N]; 0 where it acts on
  // nothing. None if there are no constraints.
  std::vector<double> constraint_forces = {};
  // The same with their directions, and what welds keep from turning: on the body at end a, at that
  // end's point, world axes; the opposite is on b.
  std::vector<Wrench> constraint_pushes = {};
  // From here on; of the last frame up to there.
  SceneContacts contacts = {};
};

enum class EventKind {
  kTakeOff,
  kApex,
  kLanding,
  kPinChange,
  kLimit,
  kRelease,
  kBreak,
  kTouchDown,  // a link or a ball with contacts touches down
};
const char* NameOf(EventKind kind);

struct MotionEvent {
  EventKind kind;
  double time = 0.0;  // since frame 0 [s]
  int frame = 0;      // the nearest for an apex, else the first at or after `time`
  std::string joint;  // pinned, stopped or letting go; empty if none; a constraint that breaks
  // Number of impacts that this event combines; the last one is at last_time. Repeated impacts on a
  // limit that are less than kChatterGap apart are one event, and so are repeated touch-downs of a
  // link on one object.
  long count = 1;
  double last_time = time;
  // Bodies of a kTouchDown: the link or ball, and the object of the scene, other link or ball that
  // it touches. `joint` is the joint of the link.
  std::string link = {}, on = {};
};

// Energy of the bodies that a region's model moves, and where it went [J].
struct EnergyBalance {
  double kinetic_start = 0.0, kinetic_end = 0.0;
  double potential_start = 0.0, potential_end = 0.0;
  // Of what acts on the region's joints and links, by name: negative where energy is lost.
  struct Work {
    std::string law;
    double joules = 0.0;
  };
  std::vector<Work> laws = {{"friction", 0.0}};
  double limits = 0.0;   // work of impacts on limits, and of a pin that is stopped
  double impacts = 0.0;  // work of contact impacts
  double keyed = 0.0;    // work of the keyed joints and the placement
  // What is left unexplained: 0 but for the error of the solution.
  double residual() const {
    double rest = kinetic_end + potential_end - kinetic_start - potential_start;
    for (const Work& work : laws) rest -= work.joules;
    return rest - limits - impacts - keyed;
  }
  // Energy that changed hands: the residual is compared with it [J].
  double turnover() const {
    double sum = std::max(kinetic_start, kinetic_end) + std::abs(potential_end - potential_start) +
                 std::abs(limits) + std::abs(impacts) + std::abs(keyed);
    for (const Work& work : laws) sum += std::abs(work.joules);
    return sum;
  }
  // Whether the residual exceeds a millionth of the turnover, and of a millionth of a joule.
  bool is_open() const {
    constexpr double kUnexplained = 1e-6, kLeastTurnover = 1e-6;
    return !(std::abs(residual()) <= kUnexplained * std::max(turnover(), kLeastTurnover));
  }
  // 0 if no such law acts.
  double WorkOf(std::string_view law) const {
    for (const Work& work : laws) {
      if (work.law == law) return work.joules;
    }
    return 0.0;
  }
  void AddWork(std::string_view law, double joules) {
    for (Work& work : laws) {
      if (work.law == law) return void(work.joules += joules);
    }
    laws.push_back({std::string(law), joules});
  }
};

struct RegionReport {
  std::string name;
  Method method;
  double step = 0.0;       // kPaper [s]
  double tolerance = 0.0;  // kExact [rad]
  int steps = 0;
  int evaluations = 0;        // of the equations of motion
  int solves = 0;             // of them for accelerations: more where limits were hit
  double microseconds = 0.0;  // differs from run to run; no part of the motion
  int free_joints = 0;
  int all_joints = 0;
  // kExact. What was modelled: free hinges of each island solved by itself, and bodies in all.
  std::vector<int> islands;
  int bodies = 0;
  double error_estimate = 0.0;  // of the angles, the largest at any frame [rad]
  // It covers the frames up to there, if not all: from there on what touches tumbles, and the least
  // difference grows.
  std::optional<double> estimated_until;
  // Frame from which the events of the control solution differ. The motion is then one of several
  // that begin nearly alike, and the error estimate does not apply.
  std::optional<double> branches_from = {};
  std::optional<EnergyBalance> energy;

  // Returns the frame from which the motion is one of several likely motions, if any.
  std::optional<double> OneOfSeveralFrom() const {
    if (!estimated_until || !branches_from)
      return estimated_until ? estimated_until : branches_from;
    return *estimated_until < *branches_from ? estimated_until : branches_from;
  }
};

// The root at a frame where a placement begins or ends, if it does not go on as it came.
struct PlacementJump {
  int placement = 0;      // index of Animation::placements
  int frame = 0;          // of the animation
  double speed = 0.0;     // by which its velocity jumps [m/s]
  double distance = 0.0;  // from where its keys have it, which it runs after from here on [m]
  double seconds = 0.0;   // that it has for this, up to its next key
};

// What a border is of, and what would take a seam away (engine/bake/handover/seam_finder.cpp).
enum class SeamOf { kRegion, kPlacement, kHold };
const char* NameOf(SeamOf border);
enum class SeamMend {
  kNothing,   // no position or rate jumps
  kKeyRate,   // a key states the rate from here on
  kFriction,  // friction 0 stops the joint
  kLimits,    // it is driven against its limit
  kKeyAfter,  // it moves but has no key after it
  kTangents,  // the region's limit_tangents
  kCurve,     // its curve goes on with a rate of its own
  kRest,      // it moves where it is to stand still
};

// Where a region, a placement or a hold begins or ends: by how much a hinge or the root does not go
// on as it came, the limit from the right less the one from the left. All zero: it does.
struct Seam {
  SeamOf of = SeamOf::kRegion;
  int index = 0;        // of Animation::regions, placements or holds
  bool begins = false;  // else it ends
  int frame = 0;        // of the animation
  JointIndex joint;     // invalid: the root
  // Of a hinge, with their signs; of the root lengths: of its turn.
  double angle = 0.0, rate = 0.0, acceleration = 0.0;  // [rad, rad/s, rad/s^2]
  // Of the root's origin, lengths.
  double distance = 0.0, speed = 0.0, push = 0.0;  // [m, m/s, m/s^2]
  SeamMend mend = SeamMend::kNothing;
};

// Puts events in order of time; events at one time stay as they are.
void SortByTime(std::vector<MotionEvent>* events);
// Of warnings that say the same of the same place, the first stays.
void DropRepeated(std::vector<Warning>* warnings);

// The result of a bake: the figure at every frame.
struct Motion {
  FrameRate rate;
  std::vector<MotionFrame> frames;
  std::vector<MotionEvent> events;  // in order of time
  std::vector<RegionReport> regions;
  std::vector<Warning> warnings;
  std::vector<PlacementJump> placement_jumps;  // in order of frames; each is a warning as well
  std::vector<Seam> seams = {};  // in order of frames, if BakeOptions::seams asks for them
};

}  // namespace hazumi
