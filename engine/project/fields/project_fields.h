#pragma once

// The fields of the .kfa format, each described once (those of regions in region_fields.h, of
// the scene in scene_fields.h). An
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
#include "engine/project/fields/fill_fields.h"
#include "engine/project/fields/force_fields.h"
#include "engine/project/fields/goal_fields.h"
#include "engine/project/fields/region_fields.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

inline constexpr const char* kProjectFormat = "hazumi-project";

inline constexpr int kNewestFormat = 2;

// Moves otherwise than any key of version 1 can.
inline bool IsNew(const ProjectKey& key) {
  return IsEased(key.interpolation) || IsOfRun(key.interpolation) || key.rate_in || key.length_in ||
         key.length_out;
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
                  [](const auto& object) {
                    return object.rotation_deg != Vec3::Zero() || object.contacts;
                  }) ||
      std::any_of(regions.begin(), regions.end(),
                  [](const auto& region) {
                    return region.mute || !region.drives.empty() || region.contacts.is_any();
                  }) ||
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

template <>
inline constexpr StructInfo kStructInfo<ProjectSolver> = {
    "solver", "What the motion was made with, so that later defaults change nothing."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSolver> solver) {
  ar.Required(kMethodField, solver.method);
  ar.Optional(kStepField, solver.step_s);
  ar.Optional(kToleranceField, solver.tolerance_deg);
  ar.Required({.name = "version",
               .label = "Version",
               .help = "of the solver",
               .details = "A file keeps the motion of the version that it states; later ones mend "
                          "faults.",
               .range = kPositive},
              solver.version);
}

// By RootCurve.
inline constexpr const char* kRootFieldNames[kNumRootCurves] = {"x",       "y",       "z",
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
    ar.Nested({kRootFieldNames[i]}, root.curves[i],
              [i](auto& item, auto& curve) { DescribeCurve(item, curve, KeyFieldsOf(i)); });
  }
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
inline constexpr StructInfo kStructInfo<ProjectSource> = {
    "source", "Where figure and keys were imported from; changed keys can be put back there."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSource> source) {
  ar.Required(
      {.name = "file", .details = "Its name, without a folder. It is never opened unasked."},
      source.file);
  ar.Optional({.name = "character", .details = "Which of several."}, source.character);
  ar.Optional({.name = "clip", .details = "Which of its clips the keys come from."}, source.clip);
  ar.Optional(
      {.name = "above",
       .details = "Nodes on which the skeleton hangs, as Rig/root; glTF is written with them."},
      source.above);
  ar.Optional({.name = "fps",
               .details = "Frames per second at which it was read; default: its own.",
               .range = kPositive},
              source.fps);
  ar.Optional({.name = "z_up", .details = "Of its axes z is up, else y."}, source.z_up);
  ar.Required({.name = "metres_per_unit", .details = "Its unit of length.", .range = kPositive},
              source.metres_per_unit);
  ar.Optional({.name = "reduce_deg",
               .details = "Keys are as few as keep angles so near; default: one a frame.",
               .range = kPositive},
              source.reduce_deg);
  ar.Optional(
      {.name = "file_hinges", .details = "Parts of a body turn about the file's axes, too."},
      source.file_hinges);
  ar.Optional({.name = "file_facing", .details = "It was not turned so that it faces x at rest."},
              source.file_facing);
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
  ar.Optional({"source"}, project.source);
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
  ar.Optional(
      {.name = "fills",
       .details = "What is filled in between keys, in the order in which it is made: a limb "
                  "after what carries it."},
      project.fills);
  ar.Optional(
      {.name = "goals", .details = "What has to come true while dynamics moves the figure."},
      project.goals);
}

}  // namespace hazumi
