#pragma once

// The fields of fills; see project_fields.h.

#include "engine/project/enum_names.h"
#include "engine/project/fields/curve_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

template <>
inline constexpr StructInfo kStructInfo<ProjectFill> = {
    "fill",
    "Joints that are filled in between their keys. The program writes keys of the type generated, "
    "and makes them anew when other keys change; the motion is that of all keys."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectFill> fill) {
  ar.Required(kNameField, fill.name);
  ar.Required(kFirstField, fill.first_frame);
  ar.Required({.name = "last_frame",
               .parameter = "last",
               .label = "Last frame",
               .help = "last frame",
               .details = "Its keys count, too."},
              fill.last_frame);
  ar.Required({.name = "joints",
               .label = "Joints",
               .help = "the joints that are filled; the root: its place, too",
               .details = "A joint, or with + everything beyond it.",
               .thing = Thing::kJointOrRoot,
               .is_filled = true},
              fill.joints);
  ar.Optional(
      {.name = "relative_to",
       .label = "Relative to",
       .help = "world or body",
       .details = "World: hands move smoothly in the world while the body moves. Body: along "
                  "with the body that carries them, as if it stood still."},
      fill.relative_to, FillFrame::kWorld);
  ar.Optional(
      {.name = "ends",
       .label = "Ends",
       .help = "rest or free",
       .details = "At the first key and at the last one, where the joint has no keys beyond and "
                  "states no rate. Rest: it stands still there, as automatic tangents do. "
                  "Free: it is in the middle of a motion, as in a capture."},
      fill.ends, FillEnds::kRest);
  ar.Optional({.name = "snap",
               .label = "Snap",
               .help = "-1 lazy: swings through its keys; 1 snappy: slows down at them",
               .range = {-1.0, 1.0}},
              fill.snap);
  ar.Optional({.name = "tolerance_deg",
               .parameter = "tolerance",
               .label = "Tolerance",
               .help = "how far the keys that are written may be off the motion that was found",
               .details = "The root: 1 cm per degree.",
               .unit = "°",
               .range = {1e-3, 10.0}},
              fill.tolerance_deg, kDefaultFillToleranceDeg);
}

}  // namespace hazumi
