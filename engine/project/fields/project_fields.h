#pragma once

// The fields of the .kfa format, each described once (those of the scene in scene_fields.h). An
// archive is told of them in the file's order by
//   Required  must be there
//   Stated    may be missing, is always written
//   Optional  may be missing, is written unless it has its default value
//   Literal   a constant
//   OneOf     one of some alternatives
//   Nested, List, Map  objects whose fields another function describes
// Archives are FieldReader, FieldWriter, FieldChecker and SchemaWriter of this folder's neighbours,
// and the editor's in ui/edit/fields.

#include <algorithm>

#include "engine/project/enum_names.h"
#include "engine/project/fields/constraint_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/fields/force_fields.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

inline constexpr const char* kProjectFormat = "hazumi-project";

inline constexpr int kNewestFormat = 2;

// Moves otherwise than any key of version 1 can.
inline bool IsNew(const ProjectKey& key) {
  return IsEased(key.interpolation) || key.rate_in || key.length_in || key.length_out;
}
template <typename Curves>
bool HasNewKeys(const Curves& curves) {
  return std::any_of(curves.begin(), curves.end(), [](const ProjectCurve& curve) {
    return std::any_of(curve.keys.begin(), curve.keys.end(), IsNew);
  });
}

// The oldest that says what the project says: what reads an older one alone would make another
// motion of it.
inline int FormatVersionOf(const Project& project) {
  const auto& objects = project.held_objects;
  const auto& regions = project.regions;
  const auto& joints = project.joints;
  const bool is_new =
      !project.forces.empty() || !project.constraints.empty() ||
      std::any_of(objects.begin(), objects.end(), ChangesHands) ||
      std::any_of(objects.begin(), objects.end(),
                  [](const auto& object) { return object.rotation_deg != Vec3::Zero(); }) ||
      std::any_of(regions.begin(), regions.end(),
                  [](const auto& region) { return region.mute || !region.drives.empty(); }) ||
      HasNewKeys(project.root.curves) ||
      std::any_of(objects.begin(), objects.end(),
                  [](const auto& object) { return HasNewKeys(object.position.curves); }) ||
      std::any_of(joints.begin(), joints.end(), [](const auto& joint) {
        return std::any_of(joint.value.keys.begin(), joint.value.keys.end(), IsNew);
      });
  return is_new ? 2 : 1;
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectRate> rate) {
  ar.Required({.name = "num", .label = "Frames", .help = "frames", .range = kPositive}, rate.num);
  ar.Required(
      {.name = "den", .label = "in seconds", .help = "in so many seconds", .range = kPositive},
      rate.den);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectFrames> frames) {
  ar.Required({.name = "first", .label = "First frame", .help = "first frame"}, frames.first);
  ar.Required({.name = "last",
               .label = "Last frame",
               .help = "last frame",
               .details = "It belongs to them."},
              frames.last);
}

// Of the solver and of regions.
inline constexpr Field kMethodField = {
    .name = "method",
    .label = "Method",
    .help = "exact or paper",
    .details =
        "Exact: in continuous time, to a tolerance. Paper: by the steps of the published "
        "method. Regions that share frames have the same, and so have those in which "
        "gravity places the figure and the solver. Of a region: default the solver's."};
inline constexpr Field kStepField = {.name = "step_s",
                                     .parameter = "step",
                                     .label = "Time step",
                                     .help = "length of a step of method paper",
                                     .details = "Default 1/30, of a region the solver's.",
                                     .unit = "s",
                                     .range = {1e-6, 1.0},
                                     .step = 0.0005};
inline constexpr Field kToleranceField = {.name = "tolerance_deg",
                                          .parameter = "tolerance",
                                          .label = "Tolerance",
                                          .help = "greatest error of an angle, by method exact",
                                          .details = "Default 0.01, of a region the solver's.",
                                          .unit = "°",
                                          .range = {1e-10, 5.0},
                                          .step = 0.0005};

template <>
inline constexpr StructInfo kStructInfo<ProjectSolver> = {
    "solver", "What the motion was made with, so that later defaults change nothing."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSolver> solver) {
  ar.Required(kMethodField, solver.method);
  ar.Optional(kStepField, solver.step_s);
  ar.Optional(kToleranceField, solver.tolerance_deg);
  ar.Required({.name = "version", .help = "of the solver", .range = kPositive}, solver.version);
}

// By RootCurve.
inline constexpr const char* kRootCurveNames[kNumRootCurves] = {"x",       "y",       "z",
                                                                "angle_z", "angle_y", "angle_x"};

inline const KeyFields& KeyFieldsOf(int root_curve) {
  return root_curve <= kRootZ ? kPositionKey : kAngleKey;
}

template <>
inline constexpr StructInfo kStructInfo<ProjectRoot> = {
    "root", "Position and the angles of R = Rz Ry Rx of the root."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectRoot> root) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    ar.Nested({kRootCurveNames[i]}, root.curves[i],
              [i](auto& item, auto& curve) { DescribeCurve(item, curve, KeyFieldsOf(i)); });
  }
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectFriction> friction) {
  ar.Required({.name = "default",
               .parameter = "friction",
               .label = "Friction",
               .help = "speed that is left after 1/30 s: 0 frozen, 1 no friction",
               .range = kShare},
              friction.default_factor);
  ar.Optional({.name = "joints",
               .help = "the same, of single joints and hinges: 0 frozen, 1 no friction",
               .range = kShare},
              friction.joints);
}

template <>
inline constexpr StructInfo kStructInfo<ProjectDrive> = {
    "drive",
    "Muscle of some of a region's joints; the others are limp. A joint has one drive at most, and "
    "the hinges of a ball joint share a spring."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectDrive> drive) {
  ar.Required({.name = "joints",
               .label = "Joints",
               .help = "joints of the region, with + behind the name all beyond too",
               .details = "Of those that are meant only the region's are driven.",
               .thing = Thing::kJoint,
               .is_filled = true},
              drive.joints);
  ar.Required({.name = "kind",
               .label = "Kind",
               .help = "spring, torque or keys",
               .details = "Torque: a curve over time. Spring: towards an angle. Keys: the joint "
                          "moves by its keys, and the others feel it."},
              drive.kind);
  if (drive.kind == DriveKind::kTorque) {
    static constexpr Field kKeys = {
        .name = "keys",
        .details =
            "In order of frames, no two on one frame. Positive accelerates the angle "
            "positively; before the first key and after the last one it is constant."};
    ar.List(kKeys, drive.torque.keys,
            [](auto& item, auto& key) { DescribeKey(item, key, kTorqueKey); });
  }
  if (drive.kind == DriveKind::kSpring) {
    ar.Optional({.name = "to",
                 .label = "Pulls to",
                 .help = "keys, start or rest: the angle it pulls to",
                 .details = "That of the joint's keys at the time; that on the region's first "
                            "frame; the figure's rest angle."},
                drive.to, SpringTarget::kKeys);
    ar.Required({.name = "frequency_hz",
                 .parameter = "frequency",
                 .label = "Frequency",
                 .help = "how often a second it would swing, undamped; the higher, the stiffer",
                 .details = "If nothing moved but what lies beyond the joint, as it is on the "
                            "region's first frame. A stiffer joint is one of kind keys.",
                 .unit = "Hz",
                 .range = {0.0, 30.0, true},
                 .step = 0.02},
                drive.frequency_hz);
    ar.Optional({.name = "damping_ratio",
                 .parameter = "damping",
                 .label = "Damping",
                 .help = "1 comes to rest without overshooting, 0 swings for ever",
                 .range = {0.0, 20.0}},
                drive.damping_ratio, 1.0);
    ar.Optional({.name = "max_torque_n_m",
                 .parameter = "max_torque",
                 .label = "Max. torque",
                 .help = "it never pulls harder; of a ball joint about any axis",
                 .details = "Default: as hard as it takes.",
                 .unit = "N m",
                 .range = kNotNegative,
                 .step = 0.2},
                drive.max_torque_n_m);
    ar.Optional({.name = "strength",
                 .label = "Strength",
                 .help = "share of what the joints' muscles can give, at their angle and rate",
                 .details = "Of figures whose hinges have a strength; hinges without one are not "
                            "limited by it. Of a ball joint what its hinges can give at rest.",
                 .range = {0.0, 10.0}},
                drive.strength);
  }
}

template <>
inline constexpr StructInfo kStructInfo<ProjectRegion> = {
    "region",
    "Frames x joints in which the joints swing by their own inertia. The joints' keys inside it "
    "are kept but not used; an automatic tangent at a key on which the region begins is that of a "
    "parabola, so that the joint is let go with the speed its keys built up. Friction is the "
    "share of speed kept in 1/30 s, whatever the step."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectRegion> region) {
  ar.Required(kNameField, region.name);
  ar.Required(kFirstField, region.first_frame);
  ar.Required(kLastField, region.last_frame);
  ar.Required({.name = "joints",
               .label = "Joints",
               .help = "its joints, with + behind the name all beyond too",
               .details = "Hinges, or joints and all their hinges. With method exact also the "
                          "root, by its own name or as root: its orientation swings too.",
               .thing = Thing::kJoint,
               .is_filled = true},
              region.joints);
  ar.Stated({.name = "friction", .details = "Default: no friction."}, region.friction);
  ar.Optional(kMethodField, region.method);
  ar.Optional(kStepField, region.step_s);
  ar.Optional(kToleranceField, region.tolerance_deg);
  ar.Optional({.name = "limit_tangents",
               .label = "Limit tangents",
               .help = "curves after it stay inside the joints' limits",
               .details = "They start no faster than they can without leaving them."},
              region.limit_tangents);
  ar.Optional(
      {.name = "blend_frames",
       .parameter = "blend",
       .label = "Blend",
       .help = "frames in which joints come back to their keys after it",
       .details =
           "After the region each joint runs, from the angle and rate that the dynamics left, in "
           "one cubic to its first key at least this many frames behind the region (behind the "
           "last key: to the angle at which the keys rest), and arrives with the rate that its "
           "keys have there; the keys between are kept but not used. Whole turns that the joint "
           "has made are left behind where its limits permit. A region or hold that begins before "
           "takes the joint over on the way. 0: to the next key.",
       .range = kNotNegative},
      region.blend_frames);
  ar.Optional({.name = "mute",
               .label = "Mute",
               .help = "its joints follow their keys, as if it were not there",
               .details = "Needs version 2."},
              region.mute);
  ar.Optional({.name = "drives",
               .details = "What moves its joints besides their inertia; needs version 2."},
              region.drives);
}

// One member is the pin of both kinds that have one.
template <>
inline constexpr StructInfo kStructInfo<ProjectPlacement> = {
    "placement", "How the figure's position is found; frames without one are keyed."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectPlacement> placement) {
  ar.Required({.name = "kind",
               .label = "Kind",
               .help = "keyed, pinned or gravity",
               .details = "Keyed: by the root's position curves. Pinned: a joint stays where it "
                          "is. Gravity: gravity and contact."},
              placement.kind);
  if (placement.kind == PlacementKind::kPinned) {
    ar.Required({.name = "joint",
                 .parameter = "pin",
                 .label = "Pinned joint",
                 .help = "the pinned joint",
                 .thing = Thing::kJoint},
                placement.pin);
  }
  if (placement.kind == PlacementKind::kGravity) {
    ar.Optional({.name = "pin",
                 .label = "Pinned joint",
                 .help = "the pinned joint",
                 .details = "It stays in place while touching before the first take-off; default: "
                            "the nearest to the contact.",
                 .thing = Thing::kJoint},
                placement.pin);
    ar.Optional({.name = "landing_pin",
                 .label = "Landing joint",
                 .help = "with gravity: the joint pinned after a landing",
                 .thing = Thing::kJoint},
                placement.landing_pin);
  }
  ar.Required(kFirstField, placement.first_frame);
  ar.Required(kLastField, placement.last_frame);
}

template <>
inline constexpr StructInfo kStructInfo<ProjectHold> = {
    "hold", "Inverse kinematics: the joint stays where it was at first_frame."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectHold> hold) {
  ar.Required({.name = "joint", .label = "Joint", .help = "a joint", .thing = Thing::kJoint},
              hold.joint);
  ar.Optional({.name = "orientation",
               .label = "Keep orientation",
               .help = "true: also how it is turned",
               .details = "The orientation of the body that the joint sits on."},
              hold.orientation);
  ar.Optional({.name = "reach",
               .label = "Moves",
               .help = "what moves to hold it: limb or body",
               .details = "Its limb ends before a joint that carries others too; the body is all "
                          "joints up to the root."},
              hold.reach);
  ar.Required(kFirstField, hold.first_frame);
  ar.Required(kLastField, hold.last_frame);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectMarker> marker) {
  ar.Required({.name = "frame",
               .label = "Frame",
               .help = "its frame",
               .details = "May lie outside the project's frames."},
              marker.frame);
  ar.Required(kNameField, marker.name);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSelectionSet> set) {
  ar.Required(kNameField, set.name);
  ar.Required({.name = "joints",
               .details = "Hinges, joints with all their hinges, or the root.",
               .thing = Thing::kJointOrHinge,
               .is_filled = true},
              set.joints);
}

template <>
inline constexpr StructInfo kStructInfo<Project> = {
    "project",
    "Keys, dynamics regions, placements and the solver they were made for. Metres, degrees, "
    "frames; z up, right-handed. Unknown fields are allowed and kept."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, Project> project) {
  ar.Literal("format", kProjectFormat);
  ar.Version(FormatVersionOf(project));
  ar.Optional({.name = "name", .label = "Name", .help = "its name"}, project.name);
  ar.Required({.name = "fps", .details = "Frames per second = num / den."}, project.fps);
  ar.Required({"frames"}, project.frames);
  ar.Required({"solver"}, project.solver);
  ar.Required({.name = "figure",
               .details = "A figure file, relative to this file's folder, or the figure itself."},
              project.figure);
  ar.Optional({"skin"}, project.skin);
  ar.Optional({.name = "size_is_guessed",
               .details = "The figure comes from a file that states no unit of length: its size "
                          "is a guess."},
              project.size_is_guessed);
  ar.Stated({"scene"}, project.scene);
  ar.Optional({"root"}, project.root);
  ar.Map({.name = "joints",
          .details = "Curves by the name of their hinge; a hinge without one rests."},
         project.joints, [](auto& item, auto& curve) { DescribeCurve(item, curve, kAngleKey); });
  ar.Optional({"regions"}, project.regions);
  ar.Optional({"placements"}, project.placements);
  ar.Optional({"holds"}, project.holds);
  ar.Optional({"held_objects"}, project.held_objects);
  ar.Optional({"camera"}, project.camera);
  ar.Optional({"audio"}, project.audio);
  ar.Optional({"reference"}, project.reference);
  ar.Optional({.name = "markers", .details = "Frames with a name, for people; in any order."},
              project.markers);
  ar.Optional({.name = "preview", .details = "The part that the editor plays; default: all."},
              project.preview);
  ar.Optional({.name = "selection_sets", .details = "Joints that are selected together."},
              project.selection_sets);
  ar.Optional({.name = "forces", .details = "What acts from outside."}, project.forces);
  ar.Optional(
      {.name = "constraints", .details = "What keeps things together while dynamics moves them."},
      project.constraints);
}

}  // namespace hazumi
