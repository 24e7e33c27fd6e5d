#include "engine/exchange/character/character_bytes.h"

#include <gtest/gtest.h>

#include "engine/exchange/character/character_check.h"
#include "tests/support/random.h"

namespace hazumi {
namespace {

// One of everything.
Character Sample() {
  Character c;
  c.name = "sample";
  c.bones.resize(2);
  c.bones[0].name = "hips";
  c.bones[0].rest.p = {0.1, 0.9, -0.2};
  c.bones[0].rotation_order = "ZYX";
  c.bones[1].name = "knee";
  c.bones[1].parent = 0;
  c.bones[1].rest_scale = {1.0, 2.0, 1.0};
  c.bones[1].end_site = Vec3(0.0, -0.4, 0.0);
  c.bones[1].is_joint = false;
  c.bones[1].source.node = 7;
  c.bones[1].source.above(0, 3) = 2.0;
  Clip clip;
  clip.name = "walk";
  clip.seconds_per_frame = 1.0 / 24.0;
  clip.num_frames = 2;
  clip.tracks.resize(2);
  clip.tracks[0].rotations = {Eigen::Quaterniond::Identity(), Eigen::Quaterniond(0.6, 0.8, 0, 0)};
  clip.tracks[0].angles = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  clip.tracks[0].translations = {Vec3(0, 1, 0), Vec3(0, 2, 0)};
  clip.tracks[1].scales = {Vec3(1, 1, 1), Vec3(1, 1, 2)};
  clip.tracks[1].above.assign(2, Eigen::Matrix4d::Identity() * 3.0);
  clip.index = 4;
  clip.start_s = 0.5;
  c.clips = {clip};
  SkinMesh mesh;
  mesh.name = "body";
  mesh.binds = {{1, Eigen::Matrix4d::Identity() * 2.0}};
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  mesh.bind_indices.resize(3);
  mesh.weights.assign(3, {1.0f, 0.0f, 0.0f, 0.0f});
  mesh.triangles = {{0, 1, 2}};
  mesh.material = 0;
  c.meshes = {mesh};
  c.materials = {{"skin", {0.1f, 0.2f, 0.3f, 1.0f}, 0}};
  c.textures = {{"face.png", {1, 2, 3}}};
  c.up = UpAxis::kZ;
  c.metres_per_unit = 0.01;
  c.warnings = {{"bones", "a warning"}};
  return c;
}

TEST(CharacterBytes, RoundTripKeepsEverything) {
  const std::string bytes = CharacterToBytes(Sample());
  const Result<Character> back = CharacterFromBytes(bytes, "a.glb");
  ASSERT_TRUE(back.ok()) << back.error().ToString();
  const Character& c = back.value();
  EXPECT_EQ(CharacterToBytes(c), bytes);
  EXPECT_EQ(c.bones[1].name, "knee");
  EXPECT_EQ(c.bones[1].end_site, Vec3(0.0, -0.4, 0.0));
  EXPECT_FALSE(c.bones[1].is_joint);
  EXPECT_EQ(c.clips[0].tracks[0].rotations[1].x(), 0.8);
  EXPECT_EQ(c.meshes[0].binds[0].inverse_bind(2, 2), 2.0);
  EXPECT_EQ(c.materials[0].base_color[2], 0.3f);
  EXPECT_EQ(c.up, UpAxis::kZ);
  EXPECT_EQ(c.metres_per_unit, 0.01);
  EXPECT_EQ(c.warnings[0].message, "a warning");
}

TEST(CharacterBytes, ErrorsTravelToo) {
  const Error error = {ErrorCode::kSemantics, "a.fbx", "clip walk", "is broken; export it again"};
  const Result<Character> back = CharacterFromBytes(CharacterToBytes(error), "a.fbx");
  ASSERT_FALSE(back.ok());
  EXPECT_EQ(back.error().code, error.code);
  EXPECT_EQ(back.error().ToString(), error.ToString());
}

TEST(CharacterBytes, WhatIsCutShortOrTooLongIsAnError) {
  const std::string bytes = CharacterToBytes(Sample());
  for (size_t length = 0; length < bytes.size(); ++length)
    ASSERT_FALSE(CharacterFromBytes(bytes.substr(0, length), "a.glb").ok()) << length;
  EXPECT_FALSE(CharacterFromBytes(bytes + "x", "a.glb").ok());
}

// Up is told by two bytes: whether it is known, and whether it is z.
TEST(CharacterBytes, AnAxisThatIsNotKnownIsNotZ) {
  Character c = Sample();
  c.up.reset();
  c.metres_per_unit.reset();
  c.warnings.clear();
  std::string bytes = CharacterToBytes(c);
  ASSERT_TRUE(CharacterFromBytes(bytes, "a.glb").ok());
  constexpr size_t kBehind = 1 + sizeof(uint64_t);  // no metres, and no warnings
  bytes[bytes.size() - kBehind - 1] = 1;
  EXPECT_FALSE(CharacterFromBytes(bytes, "a.glb").ok());
}

// Whatever is accepted keeps what character.h promises; a huge count allocates nothing huge (the
// test would take hours).
TEST(CharacterBytes, RandomDamageIsAnErrorOrASoundCharacter) {
  const std::string bytes = CharacterToBytes(Sample());
  test::Random random(20);
  int refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string damaged = bytes;
    const int times = random.Integer(1, 3);
    for (int k = 0; k < times; ++k)
      damaged[static_cast<size_t>(random.Integer(0, static_cast<int>(bytes.size()) - 1))] =
          static_cast<char>(random.Chance(0.5) ? 0xff : random.Integer(0, 255));
    const Result<Character> back = CharacterFromBytes(damaged, "a.glb");
    if (back.ok()) {
      ASSERT_TRUE(CheckCharacter(back.value(), "a.glb").ok());
    } else {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5'000);
}

// What a check refuses, and the place that its error names.
TEST(CharacterCheck, NamesWhatIsWrong) {
  const double nan = std::nan("");
  const std::vector<std::pair<std::string, void (*)(Character*, double)>> cases = {
      {"knee", [](Character* c, double) { c->bones[1].parent = 1; }},
      {"hips", [](Character* c, double) { c->bones[1].name = "hips"; }},
      {"knee", [](Character* c, double n) { c->bones[1].rest.p.x() = n; }},
      {"hips", [](Character* c, double) { c->bones[0].rest.R *= 2.0; }},
      {"walk", [](Character* c, double) { c->clips[0].num_frames = 3; }},
      {"walk", [](Character* c, double n) { c->clips[0].seconds_per_frame = n; }},
      {"walk", [](Character* c, double n) { c->clips[0].tracks[0].rotations[0].w() = n; }},
      {"walk", [](Character* c, double) { c->clips[0].tracks.pop_back(); }},
      {"body", [](Character* c, double) { c->meshes[0].triangles[0][1] = 3; }},
      {"body", [](Character* c, double) { c->meshes[0].bind_indices[2][3] = 1; }},
      {"body", [](Character* c, double) { c->meshes[0].weights[0][0] = 0.5f; }},
      {"body", [](Character* c, double) { c->meshes[0].binds[0].bone = 2; }},
      {"body", [](Character* c, double) { c->meshes[0].material = 1; }},
      {"skin", [](Character* c, double) { c->materials[0].texture = 1; }},
      {"bones", [](Character* c, double) { *c = Character(); }},
  };
  ASSERT_TRUE(CheckCharacter(Sample(), "a.glb").ok());
  for (size_t i = 0; i < cases.size(); ++i) {
    Character c = Sample();
    cases[i].second(&c, nan);
    const Result<Done> checked = CheckCharacter(c, "a.glb");
    ASSERT_FALSE(checked.ok()) << i;
    EXPECT_NE(checked.error().place.find(cases[i].first), std::string::npos)
        << i << ": " << checked.error().ToString();
  }
}

}  // namespace
}  // namespace hazumi
