#pragma once

// The fields of curves and spans; see project_fields.h.

#include "engine/project/fields/field.h"
#include "engine/project/project_curve.h"

namespace hazumi {

// What a key's fields are called.
struct KeyFields {
  Field value, rate;
};
inline constexpr KeyFields kAngleKey = {
    {.name = "angle_deg", .unit = "°"},
    {.name = "rate_deg_s", .details = "Default: an automatic tangent.", .unit = "°/s"}};
inline constexpr KeyFields kPositionKey = {
    {.name = "position_m", .unit = "m"},
    {.name = "rate_m_s", .details = "Default: an automatic tangent.", .unit = "m/s"}};

template <typename Ar>
void DescribeCurve(Ar& ar, Ref<Ar, ProjectCurve> curve, const KeyFields& fields) {
  static constexpr Field kKeys = {
      .name = "keys",
      .details =
          "In order of frames, no two on one frame. Automatic tangents (no rate given) are flat at "
          "extremes and at the last key. At a key on which a region or, for the root's position, a "
          "placement begins, an automatic tangent is that of a parabola, because the keys inside "
          "it are kept but not used; where the keys before and after it are at most a frame away, "
          "it is the slope between those."};
  ar.List(kKeys, curve.keys, [&](auto& item, auto& key) {
    item.Required({.name = "frame", .details = "May lie between frames."}, key.frame);
    item.Required(fields.value, key.value);
    item.Optional(fields.rate, key.rate);
    item.Optional({.name = "interpolation", .help = "from this key to the next one"},
                  key.interpolation, Interpolation::kCubic);
  });
}

// Frames of regions, placements, holds and holders.
inline constexpr Field kFirstField = {
    .name = "first_frame", .parameter = "first", .label = "First frame", .help = "first frame"};
inline constexpr Field kLastField = {.name = "last_frame",
                                     .parameter = "last",
                                     .label = "Last frame",
                                     .help = "last frame",
                                     .details = "It ends here: spans may touch."};

}  // namespace hazumi
