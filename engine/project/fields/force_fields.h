#pragma once

// The fields of forces from outside; see project_fields.h.

#include <array>
#include <variant>

#include "engine/project/enum_names.h"
#include "engine/project/fields/curve_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, WindForce> wind) {
  ar.Required({.name = "velocity_m_s",
               .parameter = "velocity_?",
               .label = "Velocity",
               .help = "of the air, along the world's axes",
               .unit = "m/s",
               .step = 0.05},
              wind.velocity);
  ar.Optional({.name = "density_kg_m3",
               .parameter = "density",
               .label = "Density",
               .help = "of the air",
               .unit = "kg/m³",
               .range = kNotNegative,
               .step = 0.005},
              wind.density, kDensityOfAir);
}
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ForcePoint> point) {
  ar.Optional({.name = "offset_m",
               .parameter = "offset_?",
               .label = "Offset",
               .help = "of the point where it acts, in the joint's frame",
               .unit = "m",
               .step = 0.005},
              point.offset, Vec3(Vec3::Zero()));
}
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, AttractForce> pull) {
  Describe(ar, pull.at);
  ar.Required({.name = "to_m",
               .parameter = "to_?",
               .label = "Towards",
               .help = "the place that it is pulled to",
               .unit = "m",
               .step = 0.005},
              pull.to);
  ar.Required({.name = "force_n",
               .parameter = "pull",
               .label = "Force",
               .help = "of the pull, from the radius on",
               .unit = "N",
               .range = kNotNegative,
               .step = 0.2},
              pull.force);
  ar.Required({.name = "radius_m",
               .parameter = "radius",
               .label = "Radius",
               .help = "about the place; inside it the pull falls to 0 in proportion",
               .unit = "m",
               .range = kPositive,
               .step = 0.005},
              pull.radius);
}
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, PushForce> push) {
  Describe(ar, push.at);
  ar.Required({.name = "impulse_n_s",
               .parameter = "impulse_?",
               .label = "Impulse",
               .help = "along the world's axes",
               .unit = "N s",
               .step = 0.1},
              push.impulse);
}

template <>
inline constexpr std::array kAddLabels<ProjectForce> = {"Add wind", "Add pull", "Add push"};
template <>
inline constexpr StructInfo kStructInfo<ProjectForce> = {
    "force",
    "What acts on the figure from outside, in regions of method exact: on the links that they move "
    "and, while their figure is in flight, on all of it. Needs version 2."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectForce> force) {
  ar.Required(kNameField, force.name);
  ForceKind kind = force.kind();
  ar.Required({.name = "kind",
               .label = "Kind",
               .help = "wind, attract or push",
               .details = "Wind: air that moves; without one there is no air. Attract: a pull "
                          "towards a place. Push: an impulse at the first instant of a frame."},
              kind);
  if constexpr (requires { force.Become(kind); }) force.Become(kind);
  if (ForcePointOf(force.action)) {
    ar.Required({.name = "joint",
                 .label = "Joint",
                 .help = "the joint on whose body it acts",
                 .details = "Or the root.",
                 .thing = Thing::kJointOrRoot,
                 .is_filled = true},
                force.joint);
  }
  std::visit([&](auto& action) { Describe(ar, action); }, force.action);
  if (force.kind() == ForceKind::kPush) {
    ar.Required({.name = "frame", .label = "Frame", .help = "its frame"}, force.first_frame);
  } else {
    ar.Required(kFirstField, force.first_frame);
    ar.Required(kLastField, force.last_frame);
  }
}

}  // namespace hazumi
