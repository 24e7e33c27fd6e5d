#include "tests/unit/exchange/made_characters.h"

#include <gtest/gtest.h>

#include "engine/bake/bake.h"
#include "engine/project/compile.h"

namespace hazumi::test {

namespace {

Bone RandomBone(Random* random, int index) {
  Bone bone;
  bone.name = "bone" + std::to_string(index);
  bone.parent = index == 0 ? -1 : index == 1 ? 0 : random->Integer(1, index - 1);
  bone.rest = {random->Rotation(), random->Vector3(0.4)};
  bone.rest_scale = Vec3::Constant(random->Uniform(0.5, 2.0));
  bone.is_joint = index > 0;
  return bone;
}

BoneTrack RandomTrack(Random* random, const Bone& bone, int num_frames) {
  BoneTrack track;
  const Vec3 axis = random->Rotation().col(0);
  const double reach = random->Uniform(0.2, 1.5), phase = random->Uniform(0.0, 6.0);
  for (int f = 0; f < num_frames; ++f) {
    const Eigen::AngleAxisd turn(reach * std::sin(phase + 0.2 * f), axis);
    track.rotations.emplace_back(Mat3(bone.rest.R * turn.toRotationMatrix()));
  }
  return track;
}

}  // namespace

Character RandomCharacter(Random* random, int num_bones, int num_frames) {
  Character character;
  character.name = "made";
  Clip clip;
  clip.name = "clip";
  clip.num_frames = num_frames;
  for (int b = 0; b < num_bones; ++b) {
    character.bones.push_back(RandomBone(random, b));
    clip.tracks.push_back(RandomTrack(random, character.bones[b], num_frames));
  }
  for (int f = 0; f < num_frames; ++f) {
    clip.tracks[1].translations.push_back({0.1 * f, std::sin(0.3 * f), 1.0});
  }
  character.clips.push_back(std::move(clip));
  character.up = random->Chance(0.5) ? UpAxis::kY : UpAxis::kZ;
  character.metres_per_unit = random->LogUniform(0.01, 1.0);
  return character;
}

void AddSkin(Random* random, Character* character) {
  const std::vector<BonePose> rest = PosesAt(*character, nullptr, 0);
  SkinMesh mesh;
  for (size_t b = 0; b < rest.size(); ++b) {
    Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
    X.topLeftCorner<3, 3>() = rest[b].R * rest[b].stretch;
    X.topRightCorner<3, 1>() = rest[b].p;
    mesh.binds.push_back({static_cast<int>(b), X.inverse()});
  }
  const int last = static_cast<int>(rest.size()) - 1;
  for (int v = 0; v < 200; ++v) {
    const int first = random->Integer(1, last), second = random->Integer(1, last);
    const float weight = static_cast<float>(random->Uniform(0.0, 1.0));
    mesh.positions.push_back((rest[first].p + random->Vector3(0.1)).cast<float>());
    mesh.normals.push_back(Eigen::Vector3f::UnitZ());
    mesh.bind_indices.push_back(
        {static_cast<uint16_t>(first), static_cast<uint16_t>(second), 0, 0});
    mesh.weights.push_back({weight, 1.0f - weight, 0.0f, 0.0f});
  }
  mesh.triangles.push_back({0, 1, 2});
  character->meshes.push_back(std::move(mesh));
}

Planned PlanOf(const Character& character, const ImportOptions& options) {
  Planned planned;
  Result<Skeleton> skeleton = SkeletonOf(character);
  EXPECT_TRUE(skeleton.ok());
  planned.skeleton = std::move(skeleton).value();
  const Clip* clip = character.clips.empty() ? nullptr : &character.clips[0];
  planned.world = WorldFrameOf(character, planned.skeleton, clip, options, &planned.report);
  planned.plan =
      PlanFigure(character, planned.skeleton, clip, planned.world, options, &planned.report);
  return planned;
}

Imported ImportWell(const Character& character, const ImportOptions& options) {
  Result<Imported> imported = ImportProject(character, options);
  if (imported.ok()) return std::move(imported).value();
  ADD_FAILURE() << imported.error().ToString();
  return {};
}

Character Hand() {
  Character character;
  character.up = UpAxis::kZ;
  character.metres_per_unit = 1.0;
  const auto add = [&](const std::string& name, int parent, const Vec3& p) {
    Bone bone;
    bone.name = name;
    bone.parent = parent;
    bone.rest.p = p;
    character.bones.push_back(bone);
  };
  add("LeftForeArm", -1, Vec3(0, 0, 1));
  add("LeftHand", 0, Vec3(0.25, 0, 0));
  add("LeftHandSame", 1, Vec3::Zero());
  for (int i = 0; i < 3; ++i) {
    add("LeftFinger" + std::to_string(i), 2, Vec3(0.08, 0.02 * (i - 1), 0));
    add("LeftFingerTip" + std::to_string(i), static_cast<int>(character.bones.size()) - 1,
        Vec3(0.03, 0, 0));
  }
  Clip clip;
  clip.num_frames = 31;
  clip.tracks.resize(character.bones.size());
  for (int f = 0; f < 31; ++f) {
    clip.tracks[0].rotations.emplace_back(Eigen::AngleAxisd(0.05 * f, Vec3::UnitY()));
  }
  character.clips = {clip};
  return character;
}

Motion BakeWell(const Project& project) {
  const Result<Compiled> compiled = CompileAnimation(project);
  if (!compiled.ok()) {
    ADD_FAILURE() << compiled.error().ToString();
    return {};
  }
  Result<Motion> motion = Bake(compiled.value().animation);
  if (!motion.ok()) {
    ADD_FAILURE() << motion.error().ToString();
    return {};
  }
  return std::move(motion).value();
}

}  // namespace hazumi::test
