#pragma once

// The fields of project_scene.h; see project_fields.h.

#include "engine/project/fields/curve_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/project_scene.h"

namespace hazumi {

inline constexpr Field kNameField = {
    .name = "name", .label = "Name", .help = "its name", .is_filled = true};
inline constexpr Field kColorField = {.name = "color",
                                      .label = "Color",
                                      .help = "#rrggbb",
                                      .details = "sRGB.",
                                      .thing = Thing::kColor};

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectPlane> plane) {
  ar.Required({.name = "normal",
               .parameter = "normal_?",
               .label = "Normal",
               .help = "out of the solid side; its length does not matter",
               .details = "In the file a unit vector."},
              plane.normal);
  ar.Required({.name = "offset_m",
               .parameter = "offset",
               .label = "Offset",
               .help = "from the origin along the normal",
               .unit = "m",
               .step = 0.005},
              plane.offset_m);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectBox> box) {
  ar.Required({.name = "center_m",
               .parameter = "?",
               .label = "Position",
               .help = "of its centre",
               .unit = "m",
               .step = 0.005},
              box.center_m);
  ar.Required({.name = "size_m",
               .parameter = "size_?",
               .label = "Size",
               .help = "length of its edges",
               .unit = "m",
               .range = kPositive,
               .step = 0.005},
              box.size_m);
  ar.Optional({.name = "rotation_deg",
               .parameter = "angle_?",
               .label = "Rotation",
               .help = "its turn about this axis, about x first and z last",
               .unit = "°",
               .step = 0.5,
               .axes = "zyx"},
              box.rotation_deg, Vec3(Vec3::Zero()));
}

template <>
inline constexpr StructInfo kStructInfo<ProjectSceneObject> = {"scene_object",
                                                               "Something to touch."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSceneObject> object) {
  ar.Required(kNameField, object.name);
  ar.OneOf({"plane", "box"}, object.shape);
  ar.Stated(kColorField, object.color);
  ar.Optional(
      {.name = "friction_coefficient",
       .label = "Friction",
       .help = "of its surface: the more, the less slides on it; 0: all that touches it does",
       .details =
           "Of what touches it in regions with contacts: a figure has 0.8, a held object its "
           "own, and the coefficient of both is the root of the product.",
       .range = kNotNegative},
      object.friction_coefficient, kDefaultFrictionCoefficient);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectScene> scene) {
  ar.Stated({.name = "gravity_m_s2",
             .parameter = "gravity",
             .label = "Gravity",
             .help = "downwards, along -z",
             .unit = "m/s²",
             .range = kNotNegative,
             .step = 0.02},
            scene.gravity_m_s2);
  ar.Optional({"objects"}, scene.objects);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSphereShape> sphere) {
  ar.Required({.name = "radius_m",
               .parameter = "radius",
               .label = "Radius",
               .help = "of the sphere",
               .unit = "m",
               .range = kPositive,
               .step = 0.001},
              sphere.radius_m);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectBoxShape> box) {
  ar.Required({.name = "size_m",
               .parameter = "size_?",
               .label = "Size",
               .help = "length of its edges",
               .details = "Along its own axes.",
               .unit = "m",
               .range = kPositive,
               .step = 0.005},
              box.size_m);
}

inline constexpr Field kHolderOffsetField = {.name = "offset_m",
                                             .parameter = "offset_?",
                                             .label = "Offset",
                                             .help = "of its centre, in the holder's frame",
                                             .unit = "m",
                                             .step = 0.005};
inline constexpr Field kHolderRotationField = {
    .name = "rotation_deg",
    .parameter = "angle_?",
    .label = "Rotation",
    .help = "its turn about this axis of the hand, about x first and z last",
    .details = "Needs version 2.",
    .unit = "°",
    .step = 0.5,
    .axes = "zyx"};

template <>
inline constexpr StructInfo kStructInfo<ProjectHolder> = {
    "holder", "A joint that takes an object over, and until when it has it."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectHolder> holder) {
  ar.Required({.name = "joint",
               .label = "Joint",
               .help = "the holder",
               .thing = Thing::kJoint,
               .is_filled = true},
              holder.joint);
  ar.Required(kFirstField, holder.first_frame);
  ar.Optional({.name = "last_frame",
               .parameter = "release",
               .label = "Release frame",
               .help = "let go on this frame; not given: never"},
              holder.last_frame);
  ar.Optional(kHolderOffsetField, holder.offset_m, Vec3(Vec3::Zero()));
  ar.Optional(kHolderRotationField, holder.rotation_deg, Vec3(Vec3::Zero()));
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectPosition> position) {
  constexpr const char* kNames[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    ar.Nested({kNames[i]}, position.curves[i],
              [](auto& item, auto& curve) { DescribeCurve(item, curve, kPositionKey); });
  }
}

template <>
inline constexpr StructInfo kStructInfo<ProjectHeldObject> = {
    "held_object",
    "Fixed to a joint's body until it is let go. Then it flies until the next holder has it or, "
    "if it has keys from then on, to the first of them."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectHeldObject> object) {
  ar.Required(kNameField, object.name);
  ar.OneOf({"sphere", "box"}, object.shape);
  ar.Required({.name = "mass_kg",
               .parameter = "mass",
               .label = "Mass",
               .help = "of the object",
               .unit = "kg",
               .range = kPositive,
               .step = 0.01},
              object.mass_kg);
  ar.Optional({.name = "joint",
               .label = "Joint",
               .help = "the holder from the first frame on",
               .details = "Not given: nobody has it at first.",
               .thing = Thing::kJoint},
              object.joint);
  ar.Optional(kHolderOffsetField, object.offset_m, Vec3(Vec3::Zero()));
  ar.Optional(kHolderRotationField, object.rotation_deg, Vec3(Vec3::Zero()));
  ar.Optional({.name = "release_frame",
               .parameter = "release",
               .label = "Release frame",
               .help = "let go on this frame; not given: never"},
              object.release_frame);
  ar.Optional(
      {.name = "holders",
       .details = "Who has it later, in order of time; each lets go before the next begins, "
                  "or where it does."},
      object.holders);
  ar.Optional(
      {.name = "position",
       .details = "Where it is while nobody holds it: of x, y and z all have keys, or none. "
                  "Keys while it is held or flies say nothing."},
      object.position);
  ar.Optional(
      {.name = "contacts",
       .label = "Touches the scene",
       .help = "true: let go, it bounces off planes and boxes, slides and rolls on them",
       .details = "Balls only, and where the solver's method is exact. It meets figures while "
                  "a region of theirs touches the scene. Needs version 2."},
      object.contacts);
  ar.Optional({.name = "friction_coefficient",
               .label = "Friction",
               .help = "of its surface, where it touches the scene; 0: it slides on everything",
               .details = "The coefficient of both is the root of the product with that of what it "
                          "touches.",
               .range = kNotNegative},
              object.friction_coefficient, kDefaultFrictionCoefficient);
  ar.Optional({.name = "restitution",
               .label = "Restitution",
               .help = "what is left of its speed as it bounces; 0: it does not bounce, 1: nothing "
                       "is lost",
               .details = "Of an impulse along the normal, so much again as it comes away "
                          "(Poisson).",
               .range = kShare},
              object.restitution);
  ar.Optional({.name = "mesh",
               .details = "Drawn in place of the shape, stretched to fill the box around it."},
              object.mesh);
  ar.Stated(kColorField, object.color);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectCamera> camera) {
  ar.Required({.name = "eye_m",
               .parameter = "eye_?",
               .label = "Position",
               .help = "where it stands",
               .unit = "m"},
              camera.eye_m);
  ar.Required({.name = "target_m",
               .parameter = "target_?",
               .label = "Target",
               .help = "what it looks at",
               .unit = "m"},
              camera.target_m);
  ar.Required({.name = "vertical_fov_deg",
               .parameter = "fov",
               .label = "Field of view",
               .help = "vertical field of view",
               .unit = "°",
               .range = {1.0, 179.0},
               .step = 0.2},
              camera.vertical_fov_deg);
}

template <>
inline constexpr StructInfo kStructInfo<ProjectAudio> = {
    "audio", "A sound that is heard with the motion and in videos of it; nothing moves by it."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectAudio> audio) {
  ar.Required({.name = "file",
               .label = "File",
               .help = "a sound file, or a video's sound",
               .details = "Relative to this file's folder. Whatever the program ffmpeg reads.",
               .is_filled = true},
              audio.file);
  ar.Optional({.name = "start_frame",
               .parameter = "start",
               .label = "Start frame",
               .help = "the frame on which it begins",
               .details = "May lie outside the project's frames."},
              audio.start_frame);
  ar.Optional({.name = "gain_db",
               .parameter = "gain",
               .label = "Gain",
               .help = "how much louder it is than its file",
               .unit = "dB",
               .range = {-60.0, 24.0},
               .step = 0.1},
              audio.gain_db);
  ar.Optional({.name = "mute", .label = "Mute", .help = "true: it is not heard"}, audio.mute);
}

template <>
inline constexpr StructInfo kStructInfo<ProjectReference> = {
    "reference", "A picture or a video to animate by; nothing moves by it."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectReference> reference) {
  ar.Required({.name = "file",
               .label = "File",
               .help = "a picture or a video",
               .details = "Relative to this file's folder. Whatever the program ffmpeg reads.",
               .is_filled = true},
              reference.file);
  ar.Optional({.name = "start_frame",
               .parameter = "start",
               .label = "Start frame",
               .help = "the frame on which it begins",
               .details = "Of a video; it is not seen outside of its time."},
              reference.start_frame);
  ar.Optional({.name = "view",
               .label = "View",
               .help = "background: behind everything; plane: in the scene"},
              reference.view, ReferenceView::kBackground);
  ar.Optional({.name = "center_m",
               .parameter = "center_?",
               .label = "Center",
               .help = "of the plane, metres",
               .unit = "m"},
              reference.center_m, Vec3(0.0, 0.0, 1.0));
  ar.Optional({.name = "turn_deg",
               .parameter = "turn",
               .label = "Turn",
               .help = "of the plane, about the vertical",
               .unit = "°",
               .step = 1.0},
              reference.turn_deg);
  ar.Optional({.name = "height_m",
               .parameter = "height",
               .label = "Height",
               .help = "of the plane",
               .unit = "m",
               .range = kPositive},
              reference.height_m, 2.0);
  ar.Optional({.name = "opacity",
               .label = "Opacity",
               .help = "0: not seen, 1: it hides what is behind it",
               .range = kShare},
              reference.opacity, 0.5);
  ar.Optional({.name = "mute", .label = "Hidden", .help = "true: it is not seen"}, reference.mute);
  ar.Optional({.name = "rendered",
               .label = "In pictures",
               .help = "true: it is in rendered pictures and videos too"},
              reference.rendered);
}

}  // namespace hazumi
