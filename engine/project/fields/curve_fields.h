#pragma once

// The fields of curves and spans; see project_fields.h.

#include "engine/project/fields/field.h"
#include "engine/project/project_curve.h"

namespace hazumi {

// What a key's fields are called.
struct KeyFields {
  Field value, rate, rate_in;
};
inline constexpr Field KeyValue(const char* name, const char* unit) {
  return {.name = name,
          .parameter = "value",
          .label = "Value",
          .help = "degrees, of root positions metres",
          .unit = unit};
}
inline constexpr Field KeyRate(const char* name, const char* unit) {
  return {.name = name,
          .parameter = "rate",
          .label = "Rate",
          .help = "per second",
          .details = "Default: an automatic tangent.",
          .unit = unit};
}
inline constexpr Field KeyRateIn(const char* name, const char* unit) {
  return {.name = name,
          .parameter = "rate_in",
          .label = "Rate before",
          .help = "with which the curve arrives, per second, if that is another one",
          .details = "Default: the rate of the key.",
          .unit = unit};
}
inline constexpr KeyFields kAngleKey = {KeyValue("angle_deg", "°"), KeyRate("rate_deg_s", "°/s"),
                                        KeyRateIn("rate_in_deg_s", "°/s")};
inline constexpr KeyFields kPositionKey = {KeyValue("position_m", "m"), KeyRate("rate_m_s", "m/s"),
                                           KeyRateIn("rate_in_m_s", "m/s")};
inline constexpr KeyFields kTorqueKey = {KeyValue("torque_n_m", "N m"),
                                         KeyRate("rate_n_m_s", "N m/s"),
                                         KeyRateIn("rate_in_n_m_s", "N m/s")};
// Of what springs read over time.
inline constexpr NumberRange kFrequencyRange = {0.0, 30.0}, kStrengthRange = {0.0, 10.0};
inline constexpr KeyFields kFrequencyKey = {{.name = "value",
                                             .parameter = "value",
                                             .label = "Value",
                                             .help = "how often a second it would swing, undamped",
                                             .unit = "Hz",
                                             .range = kFrequencyRange},
                                            KeyRate("rate_per_s", "Hz/s"),
                                            KeyRateIn("rate_in_per_s", "Hz/s")};
inline constexpr KeyFields kStrengthKey = {{.name = "value",
                                            .parameter = "value",
                                            .label = "Value",
                                            .help = "share of what the joints' muscles can give",
                                            .range = kStrengthRange},
                                           KeyRate("rate_per_s", "1/s"),
                                           KeyRateIn("rate_in_per_s", "1/s")};
inline constexpr NumberRange kTangentLength = {0.05, 0.9};

template <typename Ar>
void DescribeKey(Ar& ar, Ref<Ar, ProjectKey> key, const KeyFields& fields) {
  ar.Required({.name = "frame", .details = "May lie between frames."}, key.frame);
  ar.Required(fields.value, key.value);
  ar.Optional(fields.rate, key.rate);
  ar.Optional(
      {.name = "interpolation",
       .label = "Interpolation",
       .help = "from this key to the next one",
       .details = "Least acceleration and least jerk: smooth through all keys of a run of such "
                  "intervals, by the least integral of the square. From sine on the value is "
                  "eased along a curve of that kind, whatever the rates."},
      key.interpolation, Interpolation::kCubic);
  ar.Optional({.name = "easing",
               .label = "Easing",
               .help = "on which end of an eased interval its curve lies"},
              key.easing, Easing::kInOut);
  ar.Optional(fields.rate_in, key.rate_in);
  ar.Optional({.name = "length_in",
               .label = "Length before",
               .help = "how far its tangent reaches back, a share of the time from the key before",
               .details = "Of a cubic. Default: a third.",
               .range = kTangentLength},
              key.length_in);
  ar.Optional({.name = "length_out",
               .label = "Length after",
               .help = "how far its tangent reaches, a share of the time to the next key",
               .details = "Of a cubic. Default: a third.",
               .range = kTangentLength},
              key.length_out);
  ar.Optional(
      {.name = "type", .label = "Key type", .help = "what the key is to you; nothing moves by it"},
      key.type, KeyType::kKeyframe);
}
// As operators set it, whatever it is a key of.
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectKey> key) {
  DescribeKey(ar, key, kAngleKey);
}

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
  ar.List(kKeys, curve.keys, [&](auto& item, auto& key) { DescribeKey(item, key, fields); });
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
