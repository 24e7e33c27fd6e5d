// A thing that is held looks like a mesh of another program.

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/timeline/scene_object.h"
#include "render/mesh/linear_blend.h"
#include "render/motion/motion_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

// Four corners, 0.2 to the left, 0.1 high and 0.3 ahead.
constexpr const char* kWedge =
    "mtllib wedge.mtl\nusemtl red\nv 0 0 0\nv 0.2 0 0\nv 0 0.1 0\nv 0 0 0.3\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
constexpr const char* kRed = "newmtl red\nKd 0.9 0.1 0.1\n";

class HeldMesh : public testing::Test {
 protected:
  std::string Write(const char* name, const std::string& text) {
    const std::string path = folder_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  void AddWedge() {
    Write("wedge.mtl", kRed);
    Do(&session_, "file.add_mesh", {{"path", Write("wedge.obj", kWedge)}, {"joint", "r_wrist"}});
  }
  const ProjectHeldObject& Thing() { return session_.project().held_objects.back(); }
  Vec3 SizeOfBox() { return std::get<ProjectBoxShape>(Thing().shape).size_m; }

  // Of what is drawn on the first frame, in the thing's own axes.
  render::Extent Drawn() {
    const Motion& motion = *session_.WholeMotion().value();
    const Animation& animation = *session_.animation();
    const auto things = things_.Of(animation.held_objects);
    EXPECT_TRUE(things.ok()) << things.error().ToString();
    render::MotionScene scene(animation, motion, motion, {}, {}, {}, things.value());
    const render::Scene shown = scene.At(0);
    render::Extent extent;
    if (shown.skins.empty()) return extent;
    std::vector<render::SkinnedVertex> vertices;
    PoseSkin(shown.skins.back(), &vertices);
    const Pose X_OW = motion.frames[0].objects.back().X_WO.Inverse();
    for (const render::SkinnedVertex& v : vertices) {
      extent.Include(X_OW * Vec3(v.position[0], v.position[1], v.position[2]));
    }
    return extent;
  }

  TemporaryFolder folder_;
  Session session_;
  render::ThingCache things_;
};

TEST_F(HeldMesh, AnObjIsPutIntoTheHandAsLargeAsItIs) {
  AddWedge();
  EXPECT_EQ(Thing().name, "wedge");
  EXPECT_EQ(Thing().joint, "r_wrist");
  EXPECT_LE((SizeOfBox() - Vec3(0.3, 0.2, 0.1)).norm(), 1e-6);
  const Skin& mesh = *Thing().mesh.skin;
  ASSERT_EQ(mesh.meshes.size(), 1u);
  EXPECT_EQ(mesh.meshes[0].triangles.size(), 4u);
  ASSERT_EQ(mesh.materials.size(), 1u);
  EXPECT_NEAR(mesh.materials[0].base_color[0], 0.9, 1e-6);
}

TEST_F(HeldMesh, ItFillsTheBoxAroundItsShape) {
  AddWedge();
  EXPECT_LE((Drawn().half_size() - Vec3(0.15, 0.1, 0.05)).norm(), 1e-6);
  EXPECT_LE(Drawn().center().norm(), 1e-6);
  Do(&session_, "held.set", {{"object", "wedge"}, {"size_x", 0.5}});
  EXPECT_LE((Drawn().half_size() - Vec3(0.25, 0.1, 0.05)).norm(), 1e-6);
  EXPECT_LE(Drawn().center().norm(), 1e-6);
}

TEST_F(HeldMesh, IsSavedUndoneAndReadAgain) {
  const Project before = session_.project();
  AddWedge();
  const std::string path = folder_ / "wedge.kfa";
  Do(&session_, "file.save", {{"path", path}});
  std::filesystem::remove(std::string(folder_ / "wedge.obj"));
  Session other;
  Do(&other, "file.open", {{"path", path}});
  EXPECT_TRUE(other.project().held_objects == session_.project().held_objects);
  ASSERT_TRUE(other.project().held_objects[0].mesh);
  Do(&session_, "edit.undo");
  EXPECT_TRUE(session_.project() == before);
}

TEST_F(HeldMesh, AUnitThatIsNotSaidIsTakenForOneThatMakesItAThing) {
  std::string in_centimetres = kWedge;
  in_centimetres.replace(in_centimetres.find("0 0 0.3"), 7, "0 0 30.");
  in_centimetres.replace(in_centimetres.find("0.2 0 0"), 7, "20. 0 0");
  Do(&session_, "file.add_mesh",
     {{"path", Write("large.obj", in_centimetres)}, {"joint", "r_wrist"}});
  EXPECT_LE((SizeOfBox() - Vec3(0.3, 0.2, 0.001)).norm(), 1e-6);
}

// The figure of a project, as a statue.
TEST_F(HeldMesh, AGlbWithASkeletonIsReadAsItStands) {
  const std::string path = folder_ / "statue.glb";
  Do(&session_, "file.export", {{"path", path}});
  Do(&session_, "file.add_mesh", {{"path", path}});
  EXPECT_GT(SizeOfBox().z(), 1.5);
  EXPECT_LT(SizeOfBox().z(), 2.0);
  EXPECT_EQ(Thing().joint, "");
  EXPECT_NEAR(Drawn().half_size().z(), 0.5 * SizeOfBox().z(), 1e-6);
}

TEST_F(HeldMesh, IsExportedAsItIsDrawn) {
  AddWedge();
  Do(&session_, "held.set", {{"object", "wedge"}, {"size_x", 0.6}});
  const std::string path = folder_ / "wedge.gltf";
  Do(&session_, "file.export", {{"path", path}});
  const auto gltf = nlohmann::json::parse(std::ifstream(path));
  int found = 0;
  for (const auto& node : gltf["nodes"]) {
    if (node.value("name", "") != "wedge" || !node.contains("mesh")) continue;
    ++found;
    const auto& primitive = gltf["meshes"][node["mesh"].get<int>()]["primitives"][0];
    const auto& positions = gltf["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    // A file's y is up, its z ahead.
    EXPECT_NEAR(positions["max"][2].get<double>() - positions["min"][2].get<double>(), 0.6, 1e-6);
    EXPECT_NEAR(positions["max"][1].get<double>() - positions["min"][1].get<double>(), 0.1, 1e-6);
    const auto& material = gltf["materials"][primitive["material"].get<int>()];
    EXPECT_EQ(material["name"], "red");
  }
  EXPECT_EQ(found, 1);
}

TEST_F(HeldMesh, FilesWithoutAMeshAreRefusedByName) {
  const auto refused = [&](const std::string& path) {
    return Refused(&session_, "file.add_mesh", {{"path", path}}).ToString();
  };
  EXPECT_NE(refused(Write("walk.bvh", "HIERARCHY\nROOT a\n")).find("is BVH, which has no meshes"),
            std::string::npos);
  EXPECT_NE(refused(folder_ / "nothing.obj").find("nothing.obj"), std::string::npos);
  EXPECT_NE(refused(Write("empty.obj", "# nothing\n")).find("empty.obj"), std::string::npos);
  EXPECT_NE(refused(Write("thing.stl", "solid a\n")).find("is an STL mesh"), std::string::npos);
  EXPECT_TRUE(session_.project().held_objects.empty());
}

}  // namespace
}  // namespace hazumi::test
