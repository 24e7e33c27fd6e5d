#include "engine/exchange/import/joint_plan.h"

#include <gtest/gtest.h>

#include "engine/exchange/import/figure_parts.h"
#include "engine/figure/skin.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/exchange/made_characters.h"

namespace hazumi::test {
namespace {

Mat3 About(double angle_deg, const Vec3& axis) {
  return Eigen::AngleAxisd(angle_deg * kDegree, axis).toRotationMatrix();
}

// Under an armature of scale 0.01, z up: "Hips" 1 m high, turned before it moves by 90 degrees
// about z; "Spine" half a metre along its x, turned before by 90 degrees about x.
Character TwoBones(double hips_deg, double spine_deg) {
  Character character;
  character.up = UpAxis::kZ;
  character.metres_per_unit = 1.0;
  Bone armature, hips, spine;
  armature.name = "Armature";
  armature.rest_scale = Vec3::Constant(0.01);
  armature.is_joint = false;
  hips.name = "Hips";
  hips.parent = 0;
  hips.rest = {About(90, Vec3::UnitZ()), Vec3(0, 0, 100)};
  spine.name = "Spine";
  spine.parent = 1;
  spine.rest = {About(90, Vec3::UnitX()), Vec3(50, 0, 0)};
  spine.end_site = Vec3(20, 0, 0);
  Clip clip;
  clip.num_frames = 1;
  clip.tracks.resize(3);
  clip.tracks[1].rotations.emplace_back(Mat3(hips.rest.R * About(hips_deg, Vec3::UnitX())));
  clip.tracks[2].rotations.emplace_back(Mat3(spine.rest.R * About(spine_deg, Vec3::UnitZ())));
  character.bones = {armature, hips, spine};
  character.clips = {clip};
  return character;
}

TEST(JointPlan, OfTwoBonesIsWhatTheyAreInWords) {
  const Planned planned = PlanOf(TwoBones(30.0, 40.0));
  const FigurePlan& plan = planned.plan;
  ASSERT_EQ(plan.joints.size(), 2u);
  EXPECT_EQ(plan.joints[0].name, "Hips");
  // The file's x of the hips is the world's y at rest: turning about it is turning about y.
  EXPECT_TRUE(plan.root_position[0].isApprox(Vec3(0, 0, 1), 1e-12));
  EXPECT_TRUE(plan.root_angles[0].isApprox(Vec3(0, 30 * kDegree, 0), 1e-12));
  EXPECT_TRUE(plan.joints[1].offset.isApprox(Vec3(0, 0.5, 0), 1e-12));
  const Mat3 rest = About(90, Vec3::UnitZ()) * About(90, Vec3::UnitX());
  EXPECT_TRUE(plan.joints[1].orientation.isApprox(rest, 1e-12));
  for (int h = 0; h < 3; ++h) {
    const double angle = plan.joints[1].axes[h] == 2 ? 40.0 * kDegree : 0.0;
    EXPECT_NEAR(plan.joints[1].angles[0][h], angle, 1e-12);
  }
}

TEST(JointPlan, KeepsEveryJointWhereTheFileHasIt) {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Character character = RandomCharacter(&random);
    const Planned planned = PlanOf(character);
    for (int f = 0; f < character.clips[0].num_frames; ++f) {
      const auto here = PositionsOf(planned.plan, f);
      const auto there =
          FilePositions(character, planned.skeleton, &character.clips[0], planned.world, f);
      for (size_t k = 0; k < here.size(); ++k) EXPECT_LE((here[k] - there[k]).norm(), 1e-9);
    }
  }
}

TEST(JointPlan, TakesTheMiddleOfATranslationAndSaysItsRange) {
  Character character = TwoBones(0.0, 0.0);
  character.clips[0].num_frames = 2;
  character.clips[0].tracks[1] = {};
  character.clips[0].tracks[2] = {};
  character.clips[0].tracks[2].translations = {Vec3(40, 0, 0), Vec3(60, 0, 0)};
  const Planned planned = PlanOf(character);
  EXPECT_TRUE(planned.plan.joints[1].offset.isApprox(Vec3(0, 0.5, 0), 1e-12));
  ASSERT_EQ(planned.report.warnings.size(), 1u);
  EXPECT_EQ(planned.report.warnings[0].place, "Spine");
  EXPECT_EQ(planned.report.warnings[0].message,
            "translation in its parent is dropped: x 40 to 60 cm; joints only turn");
}

TEST(JointPlan, NamesTheScaleOfWhatMovesTheRoot) {
  Character character = TwoBones(0.0, 0.0);
  character.clips[0].num_frames = 2;
  for (BoneTrack& track : character.clips[0].tracks) track = {};
  character.clips[0].tracks[0].scales = {Vec3::Constant(0.01), Vec3::Constant(0.02)};
  const Planned planned = PlanOf(character);
  ASSERT_EQ(planned.report.warnings.size(), 1u);
  EXPECT_EQ(planned.report.warnings[0].place, "Armature");
}

TEST(JointPlan, AnglesThatPassHalfATurnGoOn) {
  Character character;
  character.up = UpAxis::kZ;
  character.metres_per_unit = 1.0;
  Bone root, arm;
  root.name = "root";
  arm.name = "arm";
  arm.parent = 0;
  arm.rotation_order = "ZYX";
  arm.rest.p = Vec3(0, 0, 1);
  arm.end_site = Vec3(1, 0, 0);
  character.bones = {root, arm};
  Clip clip;
  clip.num_frames = 4;
  clip.tracks.resize(2);
  for (const double deg : {170.0, 179.0, -172.0, -163.0}) {
    clip.tracks[1].angles.push_back({deg * kDegree, 0.0, 0.0});
    clip.tracks[1].rotations.emplace_back(About(deg, Vec3::UnitZ()));
  }
  character.clips = {clip};
  const std::vector<Vec3> angles = PlanOf(character).plan.joints[1].angles;
  for (int f = 0; f < 4; ++f) {
    EXPECT_NEAR(angles[f][0], (170.0 + 9.0 * f) * kDegree, 1e-12);
  }
  EXPECT_EQ(angles[1][0], 179.0 * kDegree);  // as in the file
}

TEST(ImportSkin, AtRestIsTheMesh) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Character character = RandomCharacter(&random);
    AddSkin(&random, &character);
    character.clips.clear();
    const Planned planned = PlanOf(character);
    const Skin skin = SkinFor(character, planned.skeleton, planned.plan, planned.world);
    const std::vector<Pose> bodies = BodiesOf(planned.plan, 0);
    const SkinMesh& mesh = skin.meshes[0];
    EXPECT_TRUE(CheckSkin(skin).ok());
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const Eigen::Vector4d vertex = mesh.positions[v].cast<double>().homogeneous();
      Vec3 here = Vec3::Zero();
      for (int i = 0; i < 4; ++i) {
        const SkinMesh::Bind& bind = mesh.binds[mesh.bind_indices[v][i]];
        const Vec3 p_B = (bind.inverse_bind * vertex).head<3>();
        here += static_cast<double>(mesh.weights[v][i]) * (bodies[bind.bone] * p_B);
      }
      const Vec3 there = planned.world.Placed(mesh.positions[v].cast<double>());
      EXPECT_LE((here - there).norm(), 1e-6 * (1.0 + there.norm()));
    }
  }
}

}  // namespace
}  // namespace hazumi::test
