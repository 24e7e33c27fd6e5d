#pragma once

// The fields of constraints; see project_fields.h.

#include <array>

#include "engine/project/enum_names.h"
#include "engine/project/fields/curve_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

// What the fields of one end are called.
struct ConstraintEndFields {
  Field end, joint, object, offset, rotation;
};
// How operators and panels call them, which do not nest.
struct ConstraintEndNames {
  const char *joint, *object, *offset, *rotation;
};
constexpr ConstraintEndFields FieldsOfEnd(const char* end, const ConstraintEndNames& parameters,
                                          const ConstraintEndNames& labels) {
  return {{.name = end, .details = "Left out: the world's origin."},
          {.name = "joint",
           .parameter = parameters.joint,
           .label = labels.joint,
           .help = "the joint to whose body this end is fixed",
           .details = "Or the root. Not with an object.",
           .thing = Thing::kJointOrRoot,
           .may_be_none = true},
          {.name = "object",
           .parameter = parameters.object,
           .label = labels.object,
           .help = "the object to which this end is fixed, of the scene or held",
           .details = "A held one is in the same hand all the time. With neither joint nor object "
                      "the end is fixed in the world.",
           .thing = Thing::kSceneOrHeldObject,
           .may_be_none = true},
          {.name = "offset_m",
           .parameter = parameters.offset,
           .label = labels.offset,
           .help = "of this end, in the joint's frame, along the object's axes, or in the world",
           .details = "From a box's or held object's centre; from a plane's point nearest to the "
                      "origin, along the world's axes.",
           .unit = "m",
           .step = 0.005},
          {.name = "rotation_deg",
           .parameter = parameters.rotation,
           .label = labels.rotation,
           .help = "its turn there about this axis, about x first and z last",
           .unit = "°",
           .step = 0.5,
           .axes = "zyx"}};
}
inline constexpr ConstraintEndFields kConstraintA =
    FieldsOfEnd("a", {"a_joint", "a_object", "a_offset_?", "a_angle_?"},
                {"A: joint", "A: object", "A: offset", "A: rotation"});
inline constexpr ConstraintEndFields kConstraintB =
    FieldsOfEnd("b", {"b_joint", "b_object", "b_offset_?", "b_angle_?"},
                {"B: joint", "B: object", "B: offset", "B: rotation"});

template <typename Ar>
void DescribeEnd(Ar& ar, Ref<Ar, ProjectConstraintEnd> end, const ConstraintEndFields& fields,
                 ConstraintKind kind) {
  ar.Optional(fields.joint, end.joint);
  ar.Optional(fields.object, end.object);
  ar.Optional(fields.offset, end.offset_m, Vec3(Vec3::Zero()));
  if (kind == ConstraintKind::kWeld) {
    ar.Optional(fields.rotation, end.rotation_deg, Vec3(Vec3::Zero()));
  }
}

template <>
inline constexpr std::array kAddLabels<ProjectConstraint> = {"Add point", "Add weld",
                                                             "Add distance"};
template <>
inline constexpr StructInfo kStructInfo<ProjectConstraint> = {
    "constraint",
    "What keeps two ends together while regions of method exact move at least one of them: joints, "
    "objects or places in the world. Needs version 2."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectConstraint> constraint) {
  ar.Required(kNameField, constraint.name);
  ar.Required({.name = "kind",
               .label = "Kind",
               .help = "point, weld or distance",
               .details = "Point: two points stay together. Weld: they are turned alike, too. "
                          "Distance: two points keep their distance, as on a rod."},
              constraint.kind);
  const ConstraintKind kind = constraint.kind;  // as it was read
  ar.Nested(kConstraintA.end, constraint.a,
            [kind](auto& item, auto& end) { DescribeEnd(item, end, kConstraintA, kind); });
  ar.Nested(kConstraintB.end, constraint.b,
            [kind](auto& item, auto& end) { DescribeEnd(item, end, kConstraintB, kind); });
  if (kind == ConstraintKind::kDistance) {
    ar.Required({.name = "length_m",
                 .parameter = "length",
                 .label = "Length",
                 .help = "the distance that is kept",
                 .unit = "m",
                 .range = kPositive,
                 .step = 0.005},
                constraint.length_m);
  }
  ar.Required(kFirstField, constraint.first_frame);
  ar.Required(kLastField, constraint.last_frame);
  ar.Optional({.name = "arrive_frames",
               .parameter = "arrive",
               .label = "Arrives in",
               .help = "a gap closes to 1 % in so many frames",
               .details = "Without an impulse. Default: there must not be a gap at first_frame.",
               .range = kPositive},
              constraint.arrive_frames);
  ar.Optional({.name = "break_force_n",
               .parameter = "break_force",
               .label = "Breaking force",
               .help = "it breaks under more, and is gone from then on",
               .details = "Default: no force breaks it.",
               .unit = "N",
               .range = kPositive,
               .step = 1.0},
              constraint.break_force_n);
  ar.Optional({.name = "break_impulse_n_s",
               .parameter = "break_impulse",
               .label = "Breaking impulse",
               .help = "it breaks under a greater one, and is gone from then on",
               .details = "Default: no impulse breaks it.",
               .unit = "N s",
               .range = kPositive,
               .step = 0.1},
              constraint.break_impulse_n_s);
  ar.Optional({.name = "collides",
               .label = "Ends collide",
               .help = "true: what it ties touches, as a hand that rests on a table",
               .details = "Default: what a point or a weld ties passes through each other, as a "
                          "hand does that grips a bar. Solver version 1 always collides."},
              constraint.collides);
}

}  // namespace hazumi
