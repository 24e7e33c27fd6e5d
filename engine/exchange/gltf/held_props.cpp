#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/base/assert.h"
#include "engine/exchange/gltf/gltf_of_motion.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

namespace {

// "#rrggbb", sRGB, as linear RGB.
std::array<float, 4> LinearColorOf(const std::string& text) {
  std::array<float, 4> color = {0.8f, 0.8f, 0.8f, 1.0f};
  for (size_t i = 0; i < 3 && text.size() == 7; ++i) {
    const double c = std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    color[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return color;
}

void AddVertex(const Vec3& p, const Vec3& normal, const FileAxes& axes, SkinMesh* mesh) {
  mesh->positions.push_back(axes.Point(p).cast<float>());
  mesh->normals.push_back(axes.Direction(normal).cast<float>());
}

// Rings from pole to pole; a vertex for each slice also at the poles.
void AddSphere(double radius, const FileAxes& axes, SkinMesh* mesh) {
  constexpr uint32_t kRings = 12, kSlices = 24;
  for (uint32_t ring = 0; ring <= kRings; ++ring) {
    const double down = std::numbers::pi * ring / kRings;
    for (uint32_t slice = 0; slice < kSlices; ++slice) {
      const double round = 2.0 * std::numbers::pi * slice / kSlices;
      const Vec3 out(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round),
                     std::cos(down));
      AddVertex(radius * out, out, axes, mesh);
    }
  }
  for (uint32_t ring = 0; ring < kRings; ++ring) {
    for (uint32_t slice = 0; slice < kSlices; ++slice) {
      const uint32_t a = ring * kSlices + slice, b = ring * kSlices + (slice + 1) % kSlices;
      if (ring + 1 < kRings) mesh->triangles.push_back({a, a + kSlices, b + kSlices});
      if (ring > 0) mesh->triangles.push_back({a, b + kSlices, b});
    }
  }
}

// Four vertices of its own on each side.
void AddBox(const Vec3& half, const FileAxes& axes, SkinMesh* mesh) {
  for (int side = 0; side < 6; ++side) {
    const int k = side / 2;
    const double out = side % 2 == 0 ? 1.0 : -1.0;
    const Vec3 normal = out * Vec3::Unit(k);
    const Vec3 u = out * half[(k + 1) % 3] * Vec3::Unit((k + 1) % 3);
    const Vec3 v = half[(k + 2) % 3] * Vec3::Unit((k + 2) % 3);
    const auto first = static_cast<uint32_t>(mesh->positions.size());
    const Vec3 middle = half[k] * normal;
    for (const Vec3& corner : {Vec3(-u - v), Vec3(u - v), Vec3(u + v), Vec3(-u + v)}) {
      AddVertex(middle + corner, normal, axes, mesh);
    }
    mesh->triangles.push_back({first, first + 1, first + 2});
    mesh->triangles.push_back({first, first + 2, first + 3});
  }
}

// In the axes of the file, about the thing's origin.
SkinMesh PartOf(const SkinMesh& part, const std::string& name, const FileAxes& axes) {
  SkinMesh mesh;
  mesh.name = name;
  mesh.triangles = part.triangles;
  mesh.texture_coordinates = part.texture_coordinates;
  mesh.colors = part.colors;
  for (size_t v = 0; v < part.positions.size(); ++v) {
    const Eigen::Matrix4d M = part.BindOf(v);
    AddVertex(PointBy(M, part.positions[v]), NormalBy(M, part.normals[v]), axes, &mesh);
  }
  return mesh;
}

// A mesh of its own, stretched as it is drawn; its materials and textures go to the character's.
std::vector<SkinMesh> OwnMeshes(const HeldObject& object, const FileAxes& axes,
                                Character* character) {
  const Skin skin = Stretched(*object.mesh, BoxAround(object));
  const int material = static_cast<int>(character->materials.size());
  const int texture = static_cast<int>(character->textures.size());
  std::vector<SkinMesh> meshes;
  for (const SkinMesh& part : skin.meshes) {
    meshes.push_back(PartOf(part, object.name, axes));
    if (part.material >= 0) meshes.back().material = material + part.material;
  }
  for (Material each : skin.materials) {
    if (each.texture >= 0) each.texture += texture;
    character->materials.push_back(std::move(each));
  }
  character->textures.insert(character->textures.end(), skin.textures.begin(), skin.textures.end());
  return meshes;
}

SkinMesh ShapeOf(const HeldObject& object, const FileAxes& axes) {
  SkinMesh mesh;
  mesh.name = object.name;
  if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
    AddSphere(sphere->radius, axes, &mesh);
  } else {
    AddBox(std::get<BoxShape>(object.shape).half_size, axes, &mesh);
  }
  return mesh;
}

// Object i of the motion.
void Place(const HeldObject& object, size_t i, const Motion& motion, const FileAxes& axes,
           GltfProp* prop) {
  const bool is_held = std::all_of(motion.frames.begin(), motion.frames.end(),
                                   [&](const MotionFrame& f) { return f.objects[i].holder == 0; });
  if (is_held) {
    prop->bone = 1 + object.holders[0].joint.value();
    prop->rest = axes.Turned(Pose{object.holders[0].rotation, object.holders[0].offset});
    return;
  }
  prop->rest = axes.Turned(motion.frames.front().objects[i].X_WO);
  for (const MotionFrame& frame : motion.frames) {
    const Pose X_WO = axes.Turned(frame.objects[i].X_WO);
    prop->track.rotations.emplace_back(X_WO.R);
    prop->track.translations.push_back(X_WO.p);
  }
}

}  // namespace

std::vector<GltfProp> HeldProps(const Animation& animation, const Motion& motion,
                                const FileAxes& axes, Character* character) {
  std::vector<GltfProp> props;
  if (motion.frames.empty()) return props;
  for (size_t i = 0; i < animation.held_objects.size(); ++i) {
    HAZUMI_DEMAND(i < motion.frames.front().objects.size());
    const HeldObject& object = animation.held_objects[i];
    std::vector<SkinMesh> meshes;
    if (object.mesh) {
      meshes = OwnMeshes(object, axes, character);
    } else {
      meshes = {ShapeOf(object, axes)};
      meshes[0].material = static_cast<int>(character->materials.size());
      character->materials.push_back({object.name, LinearColorOf(object.color), -1});
    }
    for (SkinMesh& mesh : meshes) {
      GltfProp prop;
      prop.mesh = std::move(mesh);
      Place(object, i, motion, axes, &prop);
      props.push_back(std::move(prop));
    }
  }
  return props;
}

}  // namespace hazumi
