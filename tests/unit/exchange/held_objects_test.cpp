// What a figure holds, in files for others.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "engine/exchange/export_motion.h"
#include "engine/exchange/read_character.h"
#include "tests/support/figures.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/exchange/export_sample.h"
#include "tests/unit/exchange/gltf/gltf_taken_apart.h"

namespace hazumi::test {
namespace {

constexpr int kFrames = 20, kRelease = 8;

Animation Holding() {
  Animation animation;
  animation.figure = std::make_shared<const Figure>(Human37());
  HeldObject ball, club;
  ball.name = "ball";
  ball.shape = SphereShape{0.1};
  const Vec3 offset(0.01, 0.02, -0.1);
  ball.holders = {
      {*animation.figure->FindGroup("r_wrist"), offset, Holder::kFromTheStart, kRelease}};
  ball.color = "#ff8000";
  club = ball;
  club.name = "club";
  club.shape = BoxShape{Vec3(0.01, 0.02, 0.3)};
  club.holders = {{*animation.figure->FindGroup("l_wrist"), offset}};
  animation.held_objects = {ball, club};
  return animation;
}

// Poses at random; the ball wherever, the club in the hand.
Motion MotionOf(const Animation& animation) {
  Motion motion = RandomMotion(*animation.figure, kFrames, 3);
  Random random(4);
  for (MotionFrame& frame : motion.frames) {
    const int holder = frame.frame < motion.frames.front().frame + kRelease ? 0 : -1;
    frame.objects = {{{random.Rotation(), random.Vector3(2.0)}, holder}, {Pose(), 0}};
  }
  return motion;
}

Gltf Exported(const Animation& animation, const Motion& motion) {
  MotionExportOptions options;
  options.format = MotionFormat::kGltf;
  const auto text = ExportMotion(animation, motion, options);
  EXPECT_TRUE(text.ok()) << (text.ok() ? "" : text.error().ToString());
  return TakenApart(text.value());
}

size_t NodeNamed(const Json& gltf, const std::string& name) {
  for (size_t i = 0; i < gltf["nodes"].size(); ++i) {
    if (gltf["nodes"][i]["name"] == name) return i;
  }
  ADD_FAILURE() << "no node " << name;
  return 0;
}

bool Has(const Json& list, size_t number) {
  return std::find(list.begin(), list.end(), number) != list.end();
}

// y up, facing z.
Vec3 InFile(const Vec3& p) { return {p.y(), p.z(), p.x()}; }

TEST(HeldObjects, WhatIsNeverLetGoIsACarriedNodeInGltf) {
  const Animation animation = Holding();
  const Gltf gltf = Exported(animation, MotionOf(animation));
  const size_t club = NodeNamed(gltf.json, "club");
  const Json& node = gltf.json["nodes"][club];
  EXPECT_TRUE(Has(gltf.json["nodes"][NodeNamed(gltf.json, "l_wrist")]["children"], club));
  EXPECT_FALSE(Has(gltf.json["scenes"][0]["nodes"], club));
  const Vec3 offset = InFile(animation.held_objects[1].holders[0].offset);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(node["translation"][i], offset[i]);
  EXPECT_EQ(gltf.Channel("club", "translation"), nullptr);
  EXPECT_EQ(gltf.Channel("club", "rotation"), nullptr);
}

TEST(HeldObjects, ItsTurnInTheHandIsTheNodes) {
  Animation animation = Holding();
  Random random(5);
  const Mat3 turn = random.Rotation();
  animation.held_objects[1].holders[0].rotation = turn;
  const Gltf gltf = Exported(animation, MotionOf(animation));
  const Json& q = gltf.json["nodes"][NodeNamed(gltf.json, "club")]["rotation"];
  ASSERT_EQ(q.size(), 4u);
  const Mat3 R = Eigen::Quaterniond(q[3].get<double>(), q[0].get<double>(), q[1].get<double>(),
                                    q[2].get<double>())
                     .toRotationMatrix();
  const Vec3 axis(0.3, -0.5, 0.8);
  EXPECT_LE((R * InFile(axis) - InFile(turn * axis)).norm(), 1e-6);
}

TEST(HeldObjects, WhatIsLetGoMovesInTheWorldFromTheFirstFrameOn) {
  const Animation animation = Holding();
  const Motion motion = MotionOf(animation);
  const Gltf gltf = Exported(animation, motion);
  EXPECT_TRUE(Has(gltf.json["scenes"][0]["nodes"], NodeNamed(gltf.json, "ball")));
  const Json* places = gltf.Channel("ball", "translation");
  const Json* turns = gltf.Channel("ball", "rotation");
  ASSERT_TRUE(places && turns);
  const std::vector<float> p = gltf.Floats((*places)["output"]);
  const std::vector<float> q = gltf.Floats((*turns)["output"]);
  ASSERT_EQ(p.size(), 3u * kFrames);
  for (size_t f = 0; f < kFrames; ++f) {
    const Pose& X_WO = motion.frames[f].objects[0].X_WO;
    const Vec3 there = InFile(X_WO.p);
    EXPECT_LE((Eigen::Map<const Eigen::Vector3f>(&p[3 * f]).cast<double>() - there).norm(), 1e-6);
    const Mat3 R = Eigen::Quaternionf(&q[4 * f]).cast<double>().toRotationMatrix();
    const Vec3 axis(0.3, -0.5, 0.8);
    EXPECT_LE((R * InFile(axis) - InFile(X_WO.R * axis)).norm(), 1e-6);
  }
}

// Its part after the release begins with the ball in the air.
TEST(HeldObjects, OfAPartTheMotionThereCounts) {
  const Animation animation = Holding();
  const Motion motion = MotionOf(animation);
  const int first = motion.frames.front().frame;
  const Gltf held = Exported(animation, PartOf(motion, first, first + kRelease - 1));
  EXPECT_EQ(held.Channel("ball", "translation"), nullptr);
  EXPECT_TRUE(Has(held.json["nodes"][NodeNamed(held.json, "r_wrist")]["children"],
                  NodeNamed(held.json, "ball")));
  const Gltf flying = Exported(animation, PartOf(motion, first + kRelease, first + kFrames));
  EXPECT_NE(flying.Channel("ball", "translation"), nullptr);
}

// Its corners are given counter-clockwise, and it is closed.
void ExpectOutwardMesh(const Gltf& gltf, const std::string& name, double volume, double error) {
  const Json& node = gltf.json["nodes"][NodeNamed(gltf.json, name)];
  const Json& primitive = gltf.json["meshes"][node["mesh"].get<size_t>()]["primitives"][0];
  const std::vector<float> p = gltf.Floats(primitive["attributes"]["POSITION"]);
  const std::vector<float> n = gltf.Floats(primitive["attributes"]["NORMAL"]);
  const Json& accessor = gltf.json["accessors"][primitive["indices"].get<size_t>()];
  const Json& view = gltf.json["bufferViews"][accessor["bufferView"].get<size_t>()];
  std::vector<uint16_t> corners(accessor["count"].get<size_t>());
  std::memcpy(corners.data(), gltf.buffer.data() + view["byteOffset"].get<size_t>(),
              2 * corners.size());
  const auto at = [](const std::vector<float>& list, size_t i) {
    return Vec3(Eigen::Map<const Eigen::Vector3f>(&list[3 * i]).cast<double>());
  };
  double sum = 0.0;
  for (size_t t = 0; t < corners.size(); t += 3) {
    const Vec3 a = at(p, corners[t]), b = at(p, corners[t + 1]), c = at(p, corners[t + 2]);
    const Vec3 outwards = (b - a).cross(c - a);
    EXPECT_GT(outwards.dot(at(n, corners[t])), 0.0) << name;
    sum += a.dot(b.cross(c)) / 6.0;
  }
  EXPECT_NEAR(sum, volume, error * volume) << name;
}

TEST(HeldObjects, AreClosedMeshesOfTheirSizeAndColour) {
  const Animation animation = Holding();
  const Gltf gltf = Exported(animation, MotionOf(animation));
  ExpectOutwardMesh(gltf, "ball", 4.0 / 3.0 * 3.14159265 * 1e-3, 0.04);
  ExpectOutwardMesh(gltf, "club", 8.0 * 0.01 * 0.02 * 0.3, 1e-5);
  const Json& color = gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_EQ(color[0], 1.0);
  EXPECT_NEAR(color[1].get<double>(), 0.2158605, 1e-6);  // 128 / 255 of sRGB
  EXPECT_EQ(color[2], 0.0);
}

// A triangle on each body.
Skin SkinOn(const Figure& figure) {
  Skin skin;
  skin.bones = {figure.root_name()};
  for (const JointGroup& joint : figure.groups()) skin.bones.push_back(joint.name);
  SkinMesh mesh;
  mesh.name = "body";
  for (size_t b = 0; b < skin.bones.size(); ++b) {
    SkinMesh::Bind bind;
    bind.bone = static_cast<int>(b);
    mesh.binds.push_back(bind);
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const Eigen::Vector3f& p : {Eigen::Vector3f(0, 0, 0), {0.1f, 0, 0}, {0, 0.1f, 0}}) {
      mesh.positions.push_back(p);
      mesh.normals.push_back(Eigen::Vector3f::UnitZ());
      mesh.bind_indices.push_back({static_cast<uint16_t>(b), 0, 0, 0});
      mesh.weights.push_back({1, 0, 0, 0});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  skin.meshes = {mesh};
  return skin;
}

// Read again the ball that flies by itself is no bone, and the club a part of the hand's skin.
TEST(HeldObjects, MakeNoBonesOfTheFileThatHoldsThem) {
  const Animation animation = Holding();
  const Skin skin = SkinOn(*animation.figure);
  MotionExportOptions options;
  options.skin = &skin;
  const auto bytes = ExportMotion(animation, MotionOf(animation), options);
  ASSERT_TRUE(bytes.ok());
  const TemporaryFolder folder;
  const std::string path = folder / "held.glb";
  std::ofstream(path, std::ios::binary) << bytes.value();
  const Result<Character> read = ReadCharacter(path);
  ASSERT_TRUE(read.ok()) << read.error().ToString();
  EXPECT_EQ(read.value().bones.size(), skin.bones.size());
  EXPECT_EQ(read.value().bones[0].name, animation.figure->root_name());
  std::vector<std::string> meshes;
  for (const SkinMesh& mesh : read.value().meshes) meshes.push_back(mesh.name);
  std::sort(meshes.begin(), meshes.end());
  EXPECT_EQ(meshes, (std::vector<std::string>{"body", "club"}));
  ASSERT_EQ(read.value().warnings.size(), 1u);
  EXPECT_EQ(read.value().warnings[0].message,
            "left out, because they are no part of the skeleton: ball");
}

TEST(HeldObjects, BvhLeavesThemOutAndSaysWhich) {
  const Animation animation = Holding();
  const std::vector<Warning> left_out = LeftOutOf(animation, MotionFormat::kBvh);
  ASSERT_EQ(left_out.size(), 2u);
  EXPECT_EQ(left_out[1].place, "held_objects[1]");
  EXPECT_EQ(left_out[1].message,
            "\"club\" is not written: BVH holds a skeleton alone; glTF holds it too");
  EXPECT_TRUE(LeftOutOf(animation, MotionFormat::kGlb).empty());
}

}  // namespace
}  // namespace hazumi::test
