#pragma once

// Internal. The fields of a sweep file, described as those of a project are
// (engine/project/fields/project_fields.h).

#include "engine/project/fields/project_fields.h"
#include "engine/sweep/sweep_plan.h"

namespace hazumi {

inline constexpr const char* kSweepFormat = "hazumi-sweep";

template <>
struct EnumNames<SweepCombine> {
  static constexpr const char* kWhat = "way to combine";
  static constexpr EnumName<SweepCombine> kNames[] = {{SweepCombine::kGrid, "grid"},
                                                      {SweepCombine::kList, "list"},
                                                      {SweepCombine::kRandom, "random"}};
};
template <>
struct EnumNames<SweepSpacing> {
  static constexpr const char* kWhat = "spacing";
  static constexpr EnumName<SweepSpacing> kNames[] = {{SweepSpacing::kLinear, "linear"},
                                                      {SweepSpacing::kLog, "log"},
                                                      {SweepSpacing::kWhole, "whole"}};
};

// Any JSON: there is nothing to describe.
template <typename Ar>
void Describe(Ar&, Ref<Ar, JsonValue>) {}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, SweepAxis> axis) {
  ar.Required({.name = "field", .is_filled = true}, axis.field);
  ar.Optional({.name = "also"}, axis.also);
  ar.Optional({.name = "values"}, axis.values);
  ar.Optional({.name = "from"}, axis.from);
  ar.Optional({.name = "to"}, axis.to);
  ar.Optional({.name = "count", .range = kPositive}, axis.count);
  ar.Optional({.name = "spacing"}, axis.spacing, SweepSpacing::kLinear);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, SweepMeasure> measure) {
  ar.Optional({.name = "name"}, measure.name);
  ar.Required({.name = "quantity", .is_filled = true}, measure.quantity);
  ar.Optional({.name = "of"}, measure.of);
  ar.Optional({.name = "frame"}, measure.frame);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, SweepPicture> picture) {
  ar.Optional({.name = "frames"}, picture.frames);
  ar.Optional({.name = "video"}, picture.video);
  ar.Optional({.name = "options"}, picture.options);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, SweepPlan> plan) {
  ar.Literal("format", kSweepFormat);
  ar.Literal("version", 1);
  ar.Required({.name = "project", .is_filled = true}, plan.project);
  ar.Optional({.name = "combine"}, plan.combine, SweepCombine::kGrid);
  ar.Required({.name = "vary"}, plan.vary);
  ar.Optional({.name = "count", .range = kPositive}, plan.count);
  ar.Optional({.name = "seed", .range = kNotNegative}, plan.seed, 1);
  ar.Optional({.name = "measure"}, plan.measure);
  ar.Optional({.name = "picture"}, plan.picture);
}

}  // namespace hazumi
