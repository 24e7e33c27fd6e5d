#pragma once

// Internal. The fields of project_scene.h; see project_fields.h.

#include "engine/project/json/field_reader.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/project_scene.h"

namespace hazumi {

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectPlane> plane) {
  ar.Required("normal", plane.normal);
  ar.Required("offset_m", plane.offset_m);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectBox> box) {
  ar.Required("center_m", box.center_m);
  ar.Required("size_m", box.size_m);
  ar.Optional("rotation_deg", box.rotation_deg, Vec3(Vec3::Zero()));
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSceneObject> object) {
  ar.Required("name", object.name);
  ar.OneOf({"plane", "box"}, object.shape);
  ar.Stated("color", object.color);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectScene> scene) {
  ar.Stated("gravity_m_s2", scene.gravity_m_s2);
  ar.Optional("objects", scene.objects);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectSphereShape> sphere) {
  ar.Required("radius_m", sphere.radius_m);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectBoxShape> box) {
  ar.Required("size_m", box.size_m);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectHeldObject> object) {
  ar.Required("name", object.name);
  ar.OneOf({"sphere", "box"}, object.shape);
  ar.Required("mass_kg", object.mass_kg);
  ar.Required("joint", object.joint);
  ar.Optional("offset_m", object.offset_m, Vec3(Vec3::Zero()));
  ar.Optional("release_frame", object.release_frame);
  ar.Stated("color", object.color);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectCamera> camera) {
  ar.Required("eye_m", camera.eye_m);
  ar.Required("target_m", camera.target_m);
  ar.Required("vertical_fov_deg", camera.vertical_fov_deg);
}

}  // namespace hazumi
