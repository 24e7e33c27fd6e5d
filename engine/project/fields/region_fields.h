#pragma once

// The fields of dynamics regions; see project_fields.h.

#include "engine/project/enum_names.h"
#include "engine/project/fields/curve_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

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
  ar.Required(
      {.name = "joints",
       .label = "Joints",
       .help = "joints of the region, with + behind the name all beyond too",
       .details = "Of those that are meant only the region's are driven: all of them, if the "
                  "root is named with +. The root itself has no muscles.",
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
    ar.Optional({.name = "solved_by",
                 .details = "The goal for which it was found: the next aim finds it anew. Default: "
                            "it is the animator's, and stays."},
                drive.solved_by);
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
    static constexpr Field kFrequencyKeys = {
        .name = "frequency_keys",
        .details =
            "The frequency over time, in place of frequency_hz: a curve between 0, where "
            "the joint is limp, and 30 Hz, between its keys too."};
    ar.OptionalList(kFrequencyKeys, drive.frequency_over_time.keys,
                    [](auto& item, auto& key) { DescribeKey(item, key, kFrequencyKey); });
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
                 .range = kStrengthRange},
                drive.strength);
    static constexpr Field kStrengthKeys = {
        .name = "strength_keys",
        .details =
            "The same over time, in place of strength: a curve between 0 and 10, between "
            "its keys too."};
    ar.OptionalList(kStrengthKeys, drive.strength_over_time.keys,
                    [](auto& item, auto& key) { DescribeKey(item, key, kStrengthKey); });
    ar.Optional({.name = "feed_forward",
                 .label = "Feed forward",
                 .help = "true: it gives what the motion it pulls to asks for, too",
                 .details = "The torques of inverse dynamics of the figure on its keys, weight and "
                            "friction included, before the limits of max_torque_n_m and strength: "
                            "a spring that is strong enough then stays on its keys."},
                drive.feed_forward);
  }
}

template <>
inline constexpr StructInfo kStructInfo<ProjectContacts> = {
    "contacts", "What the bodies that a region moves stay out of. Needs version 2."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectContacts> contacts) {
  ar.Optional({.name = "scene",
               .parameter = "contacts",
               .label = "Touches the scene",
               .help = "true: what it moves stays out of planes and boxes, by method exact",
               .details = "It slides on them or sticks, as the friction_coefficient of an object "
                          "has it. A root that the region moves while gravity places the figure "
                          "is placed by what touches too, and no joint is pinned. Balls with "
                          "contacts that fly meanwhile and the figure push each other."},
              contacts.scene);
  ar.Optional({.name = "self",
               .parameter = "contacts_self",
               .label = "Touches itself",
               .help = "true: what it moves stays out of the own body, by method exact",
               .details = "Links of which it moves one stay out of each other, with a coefficient "
                          "of friction of 0.8; but neither links of neighbouring joints nor those "
                          "that are inside each other when all angles are zero."},
              contacts.self);
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
               .thing = Thing::kJointOrRoot,
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
  ar.Optional({.name = "contacts",
               .details = "What its bodies stay out of; default: they pass through everything."},
              region.contacts);
}

}  // namespace hazumi
