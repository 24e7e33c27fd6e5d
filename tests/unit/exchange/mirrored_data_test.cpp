// Left and right of real captures and characters beside the repository, and their mirrored poses.

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "engine/dynamics/kinematics.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "engine/figure/figure_builder.h"
#include "engine/figure/pose_mirror.h"
#include "tests/support/data_folder.h"

namespace hazumi::test {
namespace {

// Pairs as counted by eye. One file has no names of bones; in another "Lefthand" is the partner of
// "RightHand", and "LeftHandRingPinky1" that of "RightHandPinky1".
const std::vector<std::pair<std::string, int>> kFiles = {
    {"jump/cmu_amc2bvh_16_01_jump_WRONGFPS.bvh", 12},
    {"jump/cmu_daz_13_39_jump.bvh", 19},
    {"jump/cmu_mb_02_04_jump_balance.bvh", 12},
    {"jump/fair_jumping_zup.bvh", 10},
    {"other/bvhtoolbox_walk01.bvh", 7},
    {"other/cmu_mb_02_01_walk.bvh", 12},
    {"other/pybvh_standard_skeleton.bvh", 8},
    {"throw/cmu_mb_124_01_baseball_pitch.bvh", 12},
    {"characters/khronos_cesium_man.gltf", 7},
    {"characters/ozz_pab_arnaud.fbx", 23},
    {"characters/kaykit_Knight.glb", 9}};

class MirroredData : public testing::Test {
 protected:
  void SetUp() override {
    for (const auto& [file, pairs] : kFiles) HAZUMI_NEED_DATA(file);
  }
};

Project ImportFile(const std::string& file) {
  const Result<Character> character = ReadCharacter(DataPath(file));
  EXPECT_TRUE(character.ok()) << character.error().ToString();
  if (!character.ok()) return {};
  Result<Imported> imported = ImportProject(character.value(), {});
  EXPECT_TRUE(imported.ok()) << imported.error().ToString();
  return imported.ok() ? std::move(imported).value().project : Project();
}

// What the keys say in the middle of the clip [rad].
VecX MiddlePose(const Project& project, const Figure& figure) {
  VecX q = figure.RestAngles();
  for (const Named<ProjectCurve>& curve : project.joints) {
    const auto hinge = figure.FindJoint(curve.name);
    const auto& keys = curve.value.keys;
    if (!hinge || keys.empty()) continue;
    q[hinge->value()] = keys[keys.size() / 2].value * std::numbers::pi / 180.0;
  }
  return q;
}

std::vector<double> AnglesOf(const JointGroup& group, const VecX& q) {
  const double* first = q.data() + group.first.value();
  return {first, first + group.size};
}

// Gives what no hinges could show [rad].
double MirrorInto(const Figure& figure, const PoseMirror& mirror, const VecX& q, VecX* image) {
  double left = 0.0;
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    const JointGroup& other = figure.group(mirror.sides().OtherSideOf(GroupIndex(g)));
    const MirroredJoint joint = mirror.Mirrored(GroupIndex(g), AnglesOf(figure.groups()[g], q),
                                                AnglesOf(other, VecX::Zero(q.size())));
    left = std::max(left, joint.left_over);
    for (size_t i = 0; i < joint.angles.size(); ++i) {
      (*image)[other.first.value() + static_cast<int>(i)] = joint.angles[i];
    }
  }
  return left;
}

// By joint: how far the bones from the root to it are from being the reflected ones of its
// partner's, all angles zero [m]. Turns alike change nothing of their lengths, so that a mirrored
// pose is at most as far from the reflected one.
std::vector<double> Unevenness(const Figure& figure, const PoseMirror& mirror, const Mat3& M) {
  const std::vector<Pose> X_RJ = PosesAtZero(figure);
  const auto bone = [&](const JointGroup& group) {
    const JointIndex parent = figure.joint(group.first).parent;
    const Vec3 from = parent.is_valid() ? X_RJ[parent.value()].p : Vec3(Vec3::Zero());
    return Vec3(X_RJ[group.first.value()].p - from);
  };
  std::vector<double> uneven;
  for (size_t g = 0; g < figure.groups().size(); ++g) {
    const JointGroup& group = figure.groups()[g];
    const JointGroup& other =
        figure.group(mirror.sides().OtherSideOf(GroupIndex(static_cast<int>(g))));
    const JointIndex parent = figure.joint(group.first).parent;
    const double above =
        parent.is_valid() ? uneven[static_cast<size_t>(figure.joint(parent).group.value())] : 0.0;
    uneven.push_back(above + (bone(other) - M * bone(group)).norm());
  }
  return uneven;
}

int NumPairs(const Figure& figure, const FigureSides& sides) {
  int num = 0;
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    num += sides.OtherSideOf(GroupIndex(g)).value() > g ? 1 : 0;
  }
  return num;
}

void ExpectMirrored(const std::string& file, const Project& project, const Figure& figure) {
  const PoseMirror mirror(figure);
  const Vec3 n = mirror.sides().normal();
  const Mat3 M = Mat3::Identity() - 2.0 * n * n.transpose();
  const VecX q = MiddlePose(project, figure);
  VecX image = VecX::Zero(q.size());
  EXPECT_LE(MirrorInto(figure, mirror, q, &image), 1e-6) << file;
  DynamicsWorkspace of_pose(figure), of_image(figure);
  ComputePositions(figure, Pose(), q, &of_pose);
  ComputePositions(figure, Pose(), image, &of_image);
  const std::vector<double> uneven = Unevenness(figure, mirror, M);
  for (size_t g = 0; g < figure.groups().size(); ++g) {
    const JointGroup& group = figure.groups()[g];
    const JointGroup& other =
        figure.group(mirror.sides().OtherSideOf(GroupIndex(static_cast<int>(g))));
    const Vec3 there = M * of_pose.body(group.last()).p;
    EXPECT_LE((of_image.body(other.last()).p - there).norm(), uneven[g] + 1e-6)
        << file << " " << group.name;
  }
}

TEST_F(MirroredData, PosesOfRealFilesAreMirroredAsFarAsTheirSkeletonsAreEven) {
  for (const auto& [file, num_pairs] : kFiles) {
    const Project project = ImportFile(file);
    const Figure figure = BuildFigure(project.figure.spec).value();
    EXPECT_EQ(NumPairs(figure, FigureSides(figure)), num_pairs) << file;
    const Vec3 n = FigureSides(figure).normal();
    EXPECT_EQ(n.cwiseAbs().maxCoeff(), 1.0) << file << ": " << n.transpose();
    EXPECT_EQ(n.z(), 0.0) << file;
    ExpectMirrored(file, project, figure);
  }
}

}  // namespace
}  // namespace hazumi::test
