#include "tests/unit/project/skin_sample.h"

#include "engine/project/project_writer.h"

namespace hazumi::testing {

Skin SampleSkin() {
  SkinMesh mesh;
  mesh.name = "shin";
  mesh.binds.resize(2);
  mesh.binds[0].bone = 1;
  mesh.binds[1].inverse_bind.topRows<3>() << 0.5, 0.25, 0, 1, 0, 1, 0.125, 2, 0, 0, 1, 1.0 / 3.0;
  mesh.positions = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 1e-7f}};
  mesh.normals.assign(3, Eigen::Vector3f::UnitZ());
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0.3f, 1}};
  mesh.bind_indices = {{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0}};
  mesh.weights = {{0.75f, 0.25f, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.material = 0;
  Skin skin;
  skin.bones = {"r_knee", "r_ankle"};
  skin.meshes = {mesh};
  skin.materials = {{"skin", {0.5f, 0.25f, 0.1f, 1.0f}, 0}};
  skin.textures = {{"picture", {0x89, 'P', 'N', 'G', 0, 255}}};
  return skin;
}

Json WithSkin(const Changes& changes) {
  Project project = ParseGood(SampleProject());
  project.skin.skin = std::make_shared<const Skin>(SampleSkin());
  return Changed(Json::parse(WriteProject(project)), changes);
}

}  // namespace hazumi::testing
