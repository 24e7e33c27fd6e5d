#include "tests/unit/exchange/export_sample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/random.h"

namespace hazumi::test {

Motion RandomMotion(const Figure& figure, int num_frames, unsigned seed) {
  Random random(seed);
  Motion motion;
  for (int i = 0; i < num_frames; ++i) {
    MotionFrame frame;
    frame.frame = 5 + i;
    frame.q.resize(figure.num_joints());
    for (int j = 0; j < figure.num_joints(); ++j) {
      const Joint& joint = figure.joint(JointIndex(j));
      frame.q[j] = random.Uniform(joint.lower, joint.upper);
    }
    frame.X_WR = {random.Rotation(), random.Vector3(3.0)};
    motion.frames.push_back(std::move(frame));
  }
  return motion;
}

std::vector<Pose> WorldPoses(const Character& character, int frame) {
  std::vector<Pose> poses;
  const auto f = static_cast<size_t>(frame);
  for (size_t i = 0; i < character.bones.size(); ++i) {
    const Bone& bone = character.bones[i];
    const BoneTrack& track = character.clips[0].tracks[i];
    Pose local = bone.rest;
    if (!track.rotations.empty()) local.R = track.rotations[f].toRotationMatrix();
    if (!track.translations.empty()) local.p = track.translations[f];
    poses.push_back(bone.parent < 0 ? local : poses[static_cast<size_t>(bone.parent)] * local);
  }
  return poses;
}

namespace {

// 2 x 2: red, green, blue, white.
const std::vector<uint8_t> kPng = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
    0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02, 0x00, 0x00, 0x00, 0xfd,
    0xd4, 0x9a, 0x73, 0x00, 0x00, 0x00, 0x12, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8,
    0xcf, 0xc0, 0xc0, 0x00, 0xc2, 0x0c, 0xff, 0x81, 0x00, 0x00, 0x1f, 0xee, 0x05, 0xfb, 0xf1,
    0xab, 0xba, 0x77, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

void AddRing(float y, SkinMesh* mesh) {
  const float lower = std::clamp((y - 0.8f) / 0.4f, 0.0f, 1.0f);  // of the lower arm
  for (int corner = 0; corner < 4; ++corner) {
    const float angle = static_cast<float>(std::numbers::pi / 2.0 * corner);
    const Eigen::Vector3f normal(std::cos(angle), 0.0f, -std::sin(angle));
    mesh->positions.push_back(0.1f * normal + Eigen::Vector3f(0.0f, y, 0.0f));
    mesh->normals.push_back(normal);
    mesh->texture_coordinates.emplace_back(0.25f * static_cast<float>(corner), 0.5f * y);
    mesh->bind_indices.push_back({0, 1, 0, 0});
    mesh->weights.push_back({1.0f - lower, lower, 0.0f, 0.0f});
  }
}

SkinMesh ArmMesh() {
  SkinMesh mesh;
  mesh.name = "arm skin";
  mesh.material = 0;
  mesh.binds.resize(2);
  mesh.binds[1].bone = 1;
  mesh.binds[1].inverse_bind(1, 3) = -1.0;
  constexpr uint32_t kRings = 11;
  for (uint32_t ring = 0; ring < kRings; ++ring) AddRing(0.2f * static_cast<float>(ring), &mesh);
  for (uint32_t ring = 0; ring + 1 < kRings; ++ring) {
    for (uint32_t i = 0; i < 4; ++i) {
      const uint32_t a = 4 * ring + i, b = 4 * ring + (i + 1) % 4;
      mesh.triangles.push_back({a, b, a + 4});
      mesh.triangles.push_back({b, b + 4, a + 4});
    }
  }
  return mesh;
}

}  // namespace

Character SkinnedArm() {
  Character character;
  character.name = "arm";
  character.bones.resize(2);
  character.bones[0].name = "upper arm";
  character.bones[1].name = "lower arm";
  character.bones[1].parent = 0;
  character.bones[1].rest.p = Vec3(0, 1, 0);
  character.meshes = {ArmMesh()};
  character.materials = {{"cloth", {1, 1, 1, 1}, 0}};
  character.textures = {{"colours", kPng}};
  Clip clip{"wave", 1.0 / 30.0, 31, std::vector<BoneTrack>(2)};
  for (int i = 0; i < clip.num_frames; ++i) {
    const double bend = 1.2 * std::sin(2.0 * std::numbers::pi * i / 30.0);
    clip.tracks[1].rotations.emplace_back(Eigen::AngleAxisd(bend, Vec3::UnitX()));
  }
  character.clips.push_back(std::move(clip));
  return character;
}

}  // namespace hazumi::test
