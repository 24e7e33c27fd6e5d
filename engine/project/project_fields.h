#pragma once

// Internal. The .kfa format: each object's fields, named once for reading and writing (those of the
// scene in scene_fields.h).
//   Required  must be there
//   Stated    may be missing, is always written
//   Optional  may be missing, is written unless it has its default value

#include "engine/project/json/field_reader.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/read_value.h"
#include "engine/project/scene_fields.h"

namespace hazumi {

inline constexpr const char* kProjectFormat = "hazumi-project";

// What a key's fields are called.
struct KeyFieldNames {
  const char* value;
  const char* rate;
};
inline constexpr KeyFieldNames kAngleKey = {"angle_deg", "rate_deg_s"};
inline constexpr KeyFieldNames kPositionKey = {"position_m", "rate_m_s"};

// By RootCurve.
inline constexpr const char* kRootCurveNames[kNumRootCurves] = {"x",       "y",       "z",
                                                                "angle_z", "angle_y", "angle_x"};

inline const KeyFieldNames& KeyFieldsOf(int root_curve) {
  return root_curve <= kRootZ ? kPositionKey : kAngleKey;
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectRate> rate) {
  ar.Required("num", rate.num);
  ar.Required("den", rate.den);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectFrames> frames) {
  ar.Required("first", frames.first);
  ar.Required("last", frames.last);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSolver> solver) {
  ar.Required("method", solver.method);
  ar.Optional("step_s", solver.step_s);
  ar.Optional("tolerance_deg", solver.tolerance_deg);
  ar.Required("version", solver.version);
}

template <typename Ar>
void DescribeCurve(Ar& ar, Ref<Ar, ProjectCurve> curve, const KeyFieldNames& names) {
  ar.List("keys", curve.keys, [&](auto& item, auto& key) {
    item.Required("frame", key.frame);
    item.Required(names.value, key.value);
    item.Optional(names.rate, key.rate);
    item.Optional("interpolation", key.interpolation, Interpolation::kCubic);
  });
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectRoot> root) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    ar.Nested(kRootCurveNames[i], root.curves[i],
              [i](auto& item, auto& curve) { DescribeCurve(item, curve, KeyFieldsOf(i)); });
  }
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectFriction> friction) {
  ar.Required("default", friction.default_factor);
  ar.Optional("joints", friction.joints);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectRegion> region) {
  ar.Required("name", region.name);
  ar.Required("first_frame", region.first_frame);
  ar.Required("last_frame", region.last_frame);
  ar.Required("joints", region.joints);
  ar.Stated("friction", region.friction);
  ar.Optional("method", region.method);
  ar.Optional("step_s", region.step_s);
  ar.Optional("tolerance_deg", region.tolerance_deg);
  ar.Optional("limit_tangents", region.limit_tangents);
  ar.Optional("blend_frames", region.blend_frames);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectPlacement> placement) {
  ar.Required("kind", placement.kind);
  if (placement.kind == PlacementKind::kPinned) ar.Required("joint", placement.pin);
  if (placement.kind == PlacementKind::kGravity) {
    ar.Optional("pin", placement.pin);
    ar.Optional("landing_pin", placement.landing_pin);
  }
  ar.Required("first_frame", placement.first_frame);
  ar.Required("last_frame", placement.last_frame);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectHold> hold) {
  ar.Required("joint", hold.joint);
  ar.Optional("orientation", hold.orientation);
  ar.Optional("reach", hold.reach);
  ar.Required("first_frame", hold.first_frame);
  ar.Required("last_frame", hold.last_frame);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectMarker> marker) {
  ar.Required("frame", marker.frame);
  ar.Required("name", marker.name);
}

// A reference to a figure file, or the figure itself.
void ReadValue(const Json& json, const Site& site, ProjectFigure& figure);
Json ToJson(const ProjectFigure& figure);
// Arrays of numbers are base64 of their little-endian bytes.
void ReadValue(const Json& json, const Site& site, ProjectSkin& skin);
Json ToJson(const ProjectSkin& skin);

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, Project> project) {
  ar.Literal("format", kProjectFormat);
  ar.Literal("version", 1);
  ar.Optional("name", project.name);
  ar.Required("fps", project.fps);
  ar.Required("frames", project.frames);
  ar.Required("solver", project.solver);
  ar.Required("figure", project.figure);
  ar.Optional("skin", project.skin);
  ar.Optional("size_is_guessed", project.size_is_guessed);
  ar.Stated("scene", project.scene);
  ar.Optional("root", project.root);
  ar.Map("joints", project.joints,
         [](auto& item, auto& curve) { DescribeCurve(item, curve, kAngleKey); });
  ar.Optional("regions", project.regions);
  ar.Optional("placements", project.placements);
  ar.Optional("holds", project.holds);
  ar.Optional("held_objects", project.held_objects);
  ar.Optional("camera", project.camera);
  ar.Optional("markers", project.markers);
  ar.Optional("preview", project.preview);
}

}  // namespace hazumi
