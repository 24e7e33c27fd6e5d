#include <gtest/gtest.h>

#include <cmath>

#include "engine/figure/skin.h"

namespace hazumi::test {
namespace {

// One triangle on one bone.
Skin Triangle() {
  Skin skin;
  skin.bones = {"root"};
  SkinMesh mesh;
  mesh.binds.resize(1);
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, Eigen::Vector3f::UnitZ());
  mesh.bind_indices.resize(3);
  mesh.weights.assign(3, {1, 0, 0, 0});
  mesh.triangles = {{0, 1, 2}};
  skin.meshes = {mesh};
  return skin;
}

TEST(SkinCheck, NamesThePlaceOfWhatIsWrong) {
  const auto place_of = [](auto&& damage) {
    Skin skin = Triangle();
    damage(skin.meshes[0]);
    const Result<Done> checked = CheckSkin(skin);
    return checked.ok() ? std::string("good") : checked.error().place;
  };
  EXPECT_EQ(place_of([](SkinMesh&) {}), "good");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.weights[1][2] = -0.1f; }), "meshes[0].weights[1]");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.weights[1][2] = NAN; }), "meshes[0].weights[1]");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.weights[2][0] = 1.1f; }), "meshes[0].weights[2]");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.normals[1].x() = INFINITY; }), "meshes[0].positions[1]");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.texture_coordinates.resize(2); }),
            "meshes[0].texture_coordinates");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.binds[0].inverse_bind(1, 2) = NAN; }),
            "meshes[0].binds[0].inverse_bind");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.binds.clear(); }), "meshes[0].bind_indices[0]");
  EXPECT_EQ(place_of([](SkinMesh& m) { m.material = -2; }), "meshes[0].material");
}

}  // namespace
}  // namespace hazumi::test
