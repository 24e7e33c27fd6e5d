#pragma once

// The document: what a .kfa file says, in the file's units (metres, degrees, frames) and with names
// instead of indices. It may be inconsistent while it is edited: CompileAnimation checks it.

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/warning.h"
#include "engine/project/item_id.h"
#include "engine/project/json/extra_fields.h"
#include "engine/project/project_figure.h"
#include "engine/project/project_scene.h"
#include "engine/timeline/animation.h"
#include "engine/timeline/fill_span.h"
#include "engine/timeline/goal_kind.h"

namespace hazumi {

struct ProjectRate {
  int num = 30, den = 1;  // frames per second = num / den
  ExtraFields extra;
  bool operator==(const ProjectRate&) const = default;
};

struct ProjectFrames {
  int first = 0, last = 0;  // both inclusive
  ExtraFields extra;
  bool operator==(const ProjectFrames&) const = default;
};

// What holds where the file states neither.
inline constexpr double kDefaultStep = 1.0 / 30.0;  // [s]
inline constexpr double kDefaultToleranceDeg = 0.01;
inline constexpr double kDefaultFillToleranceDeg = 0.05;
inline constexpr double kDefaultGoalToleranceDeg = 0.1;
inline constexpr double kDefaultGoalToleranceM = 0.005;

// Both numbers are kept whatever the method, so that trying the other one loses nothing.
struct ProjectSolver {
  Method method = Method::kExact;
  std::optional<double> step_s;         // kPaper
  std::optional<double> tolerance_deg;  // kExact: greatest error of an angle in a region
  int version = kSolverVersion;
  ExtraFields extra;
  bool operator==(const ProjectSolver&) const = default;
};

struct ProjectRoot {
  std::array<ProjectCurve, kNumRootCurves> curves;  // by RootCurve
  ExtraFields extra;
  bool operator==(const ProjectRoot&) const = default;
};

// An entry of a JSON object whose field names are names of the document.
template <typename T>
struct Named {
  std::string name;
  T value{};
  bool operator==(const Named&) const = default;
};

// Joints of a region: a hinge, a group (all its hinges), the root (its orientation), or any of them
// with everything beyond it. A file states the last as "r_shoulder+" or as {"beyond":
// "r_shoulder"}; `name` is what it states, so that the figure decides what a + means [Meant in
// joint_names.h].
struct JointRef {
  std::string name;
  bool beyond = false;
  ExtraFields extra;  // only if `beyond`
  bool operator==(const JointRef&) const = default;
};

// Factors in [0, 1] per 1/30 s: 0 frozen, 1 no friction.
struct ProjectFriction {
  double default_factor = 1.0;
  std::vector<Named<double>> joints;  // a hinge's own entry goes before its group's
  ExtraFields extra;
  bool operator==(const ProjectFriction&) const = default;
};

// What moves joints of a region that are not limp.
struct ProjectDrive {
  DriveKind kind = DriveKind::kSpring;
  std::vector<JointRef> joints;
  // kTorque
  ProjectCurve torque;    // [N m]
  std::string solved_by;  // the goal that it was found for; empty: the animator's
  // kSpring
  SpringTarget to = SpringTarget::kKeys;
  double frequency_hz = 2.0, damping_ratio = 1.0;
  ProjectCurve frequency_over_time;  // [Hz]; in place of frequency_hz, if it has keys
  std::optional<double> max_torque_n_m, strength;
  ProjectCurve strength_over_time;  // in place of strength, if it has keys
  bool feed_forward = false;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectDrive&) const = default;
};

// What the bodies that a region moves stay out of.
struct ProjectContacts {
  bool scene = false;  // its planes and boxes
  bool self = false;   // each other
  ExtraFields extra;
  bool operator==(const ProjectContacts&) const = default;

  bool is_any() const { return scene || self; }
};

struct ProjectRegion {
  std::string name;
  int first_frame = 0, last_frame = 0;  // half open
  std::vector<JointRef> joints;
  ProjectFriction friction;
  // Not given: the project's.
  std::optional<Method> method;
  std::optional<double> step_s, tolerance_deg;
  bool limit_tangents = false;
  int blend_frames = 0;
  bool mute = false;
  std::vector<ProjectDrive> drives;  // no joint has two
  ProjectContacts contacts;          // kExact
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectRegion&) const = default;
};

struct ProjectPlacement {
  PlacementKind kind = PlacementKind::kKeyed;
  std::string pin;                      // kPinned: the joint; kGravity: may be empty
  std::string landing_pin;              // kGravity only; may be empty
  int first_frame = 0, last_frame = 0;  // half open
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectPlacement&) const = default;
};

struct ProjectHold {
  std::string joint;
  bool orientation = false;
  HoldReach reach = HoldReach::kLimb;
  int first_frame = 0, last_frame = 0;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectHold&) const = default;
};

// A force that acts on the figure from outside.
struct ProjectForce {
  std::string name;
  ForceAction action = NewAction(ForceKind::kWind);
  std::string joint;                    // of an action at a point, which names none itself
  int first_frame = 0, last_frame = 0;  // half open; of a push the first one alone counts
  ExtraFields extra;
  Identity identity = {};

  ForceKind kind() const { return KindOf(action); }
  // Gives it another kind, with the values of a new force but for those that both kinds have.
  void Become(ForceKind other) {
    if (other == kind()) return;
    const ForcePoint* const before = ForcePointOf(action);
    const Vec3 offset = before ? before->offset : Vec3::Zero();
    action = NewAction(other);
    ForcePoint* const point = ForcePointOf(&action);
    if (point) point->offset = offset;
    if (!point) joint.clear();
    if (other == ForceKind::kPush) last_frame = 0;
  }
  bool operator==(const ProjectForce&) const = default;
};

// What a constraint is fixed to: a joint's body, an object, or, with neither, the world.
struct ProjectConstraintEnd {
  std::string joint;
  std::string object;                // of the scene, or held; not if there is a joint
  Vec3 offset_m = Vec3::Zero();      // in the joint's frame, along the object's axes, in the world
  Vec3 rotation_deg = Vec3::Zero();  // kWeld: of its axes there, angles z, y, x of R = Rz Ry Rx
  ExtraFields extra;
  bool operator==(const ProjectConstraintEnd&) const = default;
};

struct ProjectConstraint {
  std::string name;
  ConstraintKind kind = ConstraintKind::kPoint;
  ProjectConstraintEnd a, b;
  double length_m = 0.0;                // kDistance
  int first_frame = 0, last_frame = 0;  // half open
  std::optional<int> arrive_frames;
  std::optional<double> break_force_n, break_impulse_n_s;
  bool collides = false;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectConstraint&) const = default;
};

// Joints whose keys are filled in between: keys of the type generated, which the program writes
// from those that the animator sets.
struct ProjectFill {
  std::string name;
  int first_frame = 0, last_frame = 0;  // keys on both count
  std::vector<JointRef> joints;         // or the root: its place, too
  FillFrame relative_to = FillFrame::kWorld;
  FillEnds ends = FillEnds::kRest;
  double snap = 0.0;  // -1 lazy: swings through its keys; 1 snappy: slows down at them
  double tolerance_deg = kDefaultFillToleranceDeg;  // of the keys written
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectFill&) const = default;
};

// State that has to come true in a frame while a region moves the joints. A goal moves nothing by
// itself: an aim finds torques with which it comes true.
struct ProjectGoal {
  std::string name;
  GoalKind kind = GoalKind::kPose;
  int frame = 0;
  std::vector<JointRef> joints;  // kPose: they have the angles of their keys
  // kPoint
  std::string joint;
  Vec3 offset_m = Vec3::Zero();    // in the joint's frame
  Vec3 position_m = Vec3::Zero();  // in the world; kObject: of its centre
  bool rests = false;              // what moves there stands still
  // kObject: it is let go in `frame`
  std::string object;
  std::optional<double> height_m;  // its rise above where it is let go; nothing: the least speed
  ThrowStyle style = ThrowStyle::kUnderarm;
  double tolerance_deg = kDefaultGoalToleranceDeg;  // kPose
  double tolerance_m = kDefaultGoalToleranceM;      // kPoint, kObject
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectGoal&) const = default;
};

// A frame with a name, for people.
struct ProjectMarker {
  int frame = 0;
  std::string name;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectMarker&) const = default;
};

// Joints that are selected together. Nothing moves by it.
struct ProjectSelectionSet {
  std::string name;
  std::vector<JointRef> joints;
  ExtraFields extra;
  bool operator==(const ProjectSelectionSet&) const = default;
};

// What was odd about the file. No part of the document: never written, and always equal.
struct ReadReport {
  std::vector<Warning> warnings;
  // Unknown fields except remarks, with the nearest known names; at most 100.
  std::vector<Warning> unknown = {};
  bool operator==(const ReadReport&) const { return true; }
};

struct Project {
  std::string name;
  ProjectRate fps;
  ProjectFrames frames;
  ProjectSolver solver;
  ProjectFigure figure;
  ProjectSkin skin;
  bool size_is_guessed = false;  // no unit of length was stated where the figure comes from
  std::optional<ProjectSource> source;
  ProjectScene scene;
  ProjectRoot root;
  std::vector<Named<ProjectCurve>> joints;  // by hinge; a hinge not named rests
  std::vector<ProjectRegion> regions;
  std::vector<ProjectPlacement> placements;
  std::vector<ProjectHold> holds;
  std::vector<ProjectHeldObject> held_objects;
  std::optional<ProjectCamera> camera;
  std::optional<ProjectAudio> audio;
  std::optional<ProjectReference> reference;
  std::vector<ProjectMarker> markers;    // in any order
  std::optional<ProjectFrames> preview;  // the part that is played; not given: all
  std::vector<ProjectSelectionSet> selection_sets;
  std::vector<ProjectForce> forces;
  std::vector<ProjectConstraint> constraints;
  std::vector<ProjectFill> fills;  // in the order in which they are made
  std::vector<ProjectGoal> goals;
  ExtraFields extra;
  ReadReport read;
  bool operator==(const Project&) const = default;
};

// The parts of a project that an edit changes as a whole; curves of the root are compared one by
// one. Every member is named, so that a new one is not forgotten here.
template <typename AnyProject>
auto PartsOfProject(AnyProject& project) {
  auto& [name, fps, frames, solver, figure, skin, size_is_guessed, source, scene, root, joints,
         regions, placements, holds, held_objects, camera, audio, reference, markers, preview,
         selection_sets, forces, constraints, fills, goals, extra, read] = project;
  return std::tie(joints, name, fps, frames, solver, figure, skin, size_is_guessed, source, scene,
                  root.extra, regions, placements, holds, held_objects, camera, audio, reference,
                  markers, preview, selection_sets, forces, constraints, fills, goals, extra);
}

}  // namespace hazumi
