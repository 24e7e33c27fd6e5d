#include "engine/exchange/character/from_motion.h"

#include <gtest/gtest.h>

#include "engine/dynamics/kinematics.h"
#include "engine/exchange/bvh/bvh_file.h"
#include "engine/figure/figure_bone.h"
#include "engine/spatial/euler_angles.h"
#include "tests/support/figures.h"
#include "tests/unit/exchange/export_sample.h"

namespace hazumi::test {
namespace {

Character Made(const Figure& figure, const Motion& motion, const FromMotionOptions& options = {}) {
  auto character = CharacterFromMotion(figure, motion, options);
  EXPECT_TRUE(character.ok());
  return std::move(character).value();
}

// Forward z, left x, up y.
Vec3 YUp(const Vec3& p) { return {p.y(), p.z(), p.x()}; }

// The largest distance of any bone at any frame from the body it stands for [m].
double LargestError(const Figure& figure, const Motion& motion, const Character& character,
                    bool y_up, double metres_per_unit) {
  double error = 0.0;
  DynamicsWorkspace ws(figure);
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    const MotionFrame& frame = motion.frames[f];
    ComputePositions(figure, frame.X_WR, frame.q, &ws);
    const std::vector<Pose> poses = WorldPoses(character, static_cast<int>(f));
    for (size_t i = 0; i < poses.size(); ++i) {
      const JointIndex body = i == 0 ? JointIndex() : figure.groups()[i - 1].last();
      const Vec3 p = ws.body(body).p;
      error = std::max(error, (poses[i].p * metres_per_unit - (y_up ? YUp(p) : p)).norm());
    }
  }
  return error;
}

TEST(CharacterFromMotion, HasEveryBoneWhereTheBodyIs) {
  const Figure figure = Human37();
  const Motion motion = RandomMotion(figure, 20, 1);
  EXPECT_LT(LargestError(figure, motion, Made(figure, motion), true, 1.0), 1e-12);
  const Character z_up = Made(figure, motion, {"m", UpAxis::kZ, 0.01, nullptr});
  EXPECT_LT(LargestError(figure, motion, z_up, false, 0.01), 1e-12);
}

TEST(CharacterFromMotion, PermutesAxesWithoutRounding) {
  const Figure figure = Human37();
  const Motion motion = RandomMotion(figure, 1, 2);
  const Character character = Made(figure, motion);
  EXPECT_EQ(character.clips[0].tracks[0].translations[0], YUp(motion.frames[0].X_WR.p));
  for (size_t g = 0; g < figure.groups().size(); ++g) {
    const Joint& first = figure.joint(figure.groups()[g].first);
    EXPECT_EQ(character.bones[g + 1].rest.p, YUp(first.X_PJ.p));
    EXPECT_EQ(character.bones[g + 1].name, figure.groups()[g].name);
  }
}

TEST(CharacterFromMotion, KeepsTheHingesAngles) {
  const Figure figure = Human37();
  const Motion motion = RandomMotion(figure, 5, 3);
  const Character character = Made(figure, motion);
  const auto shoulder = figure.FindGroup("l_shoulder");
  ASSERT_TRUE(shoulder);
  const auto bone = static_cast<size_t>(1 + shoulder->value());
  const JointGroup& group = figure.group(*shoulder);
  const std::string& order = character.bones[bone].rotation_order;
  const BoneTrack& track = character.clips[0].tracks[bone];
  for (int i = 0; i < group.size; ++i) {
    const Vec3 axis = YUp(figure.joint(JointIndex(group.first.value() + i)).axis);
    const double sign = axis[order[static_cast<size_t>(i)] - 'X'];
    ASSERT_EQ(std::abs(sign), 1.0);
    EXPECT_EQ(track.angles[4][i], sign * motion.frames[4].q[group.first.value() + i]);
  }
  const Mat3 R = EulerRotation(*EulerAxesOf(order), track.angles[4]);
  EXPECT_LT((R - track.rotations[4].toRotationMatrix()).norm(), 1e-14);
}

// A skewed hinge is no rotation about coordinate axes, a turned frame no angle of a channel.
TEST(CharacterFromMotion, GivesNoAnglesWhereThereAreNone) {
  FigureSpec spec = Arm7Spec();
  spec.joints[0].orientation = Eigen::AngleAxisd(0.3, Vec3::UnitX()).toRotationMatrix();
  spec.joints[1].hinges[0].axis = Vec3(1, 1, 0).normalized();
  const Figure figure = Build(spec);
  const Motion motion = RandomMotion(figure, 4, 4);
  const Character character = Made(figure, motion);
  EXPECT_TRUE(character.clips[0].tracks[1].angles.empty());
  EXPECT_TRUE(character.clips[0].tracks[2].angles.empty());
  EXPECT_FALSE(character.clips[0].tracks[3].angles.empty());
  EXPECT_LT(LargestError(figure, motion, character, true, 1.0), 1e-12);
}

TEST(CharacterFromMotion, BeginsAtZeroAtTheMotionsRate) {
  const Figure figure = Arm7();
  Motion motion = RandomMotion(figure, 3, 5);
  motion.rate = {24000, 1001};
  const Character character = Made(figure, motion);
  EXPECT_EQ(character.clips[0].seconds_per_frame, 1001.0 / 24000.0);
  EXPECT_EQ(character.clips[0].num_frames, 3);
}

// Written in centimetres and read back: six decimals are what is lost.
TEST(CharacterFromMotion, SurvivesBvh) {
  const Figure figure = Human37();
  const Motion motion = RandomMotion(figure, 20, 6);
  const Character character = Made(figure, motion, {"m", UpAxis::kY, 0.01, nullptr});
  const auto read = ReadBvh(BvhText(character, character.clips[0]), "m.bvh");
  ASSERT_TRUE(read.ok());
  EXPECT_LT(LargestError(figure, motion, read.value(), true, 0.01), 1e-6);
  // What was read is written again to the same angles.
  const auto again = ReadBvh(BvhText(read.value(), read.value().clips[0]), "m.bvh");
  for (size_t i = 0; i < character.bones.size(); ++i) {
    EXPECT_EQ(read.value().bones[i].rotation_order, character.bones[i].rotation_order.empty()
                                                        ? "ZXY"
                                                        : character.bones[i].rotation_order);
    for (size_t f = 0; f < 20; ++f) {
      EXPECT_LT(
          (again.value().clips[0].tracks[i].angles[f] - read.value().clips[0].tracks[i].angles[f])
              .norm(),
          2e-8);
    }
  }
}

TEST(CharacterFromMotion, EndsWhereTheCapsuleEnds) {
  const Figure figure = Pendulum(1.0, 0.05, 0.8);
  const Character character = Made(figure, RandomMotion(figure, 1, 7));
  ASSERT_TRUE(character.bones[1].end_site);
  EXPECT_NEAR(character.bones[1].end_site->norm(), 0.8, 0.051);
  EXPECT_FALSE(character.bones[0].end_site);
}

// A vertex of the skin stays at its place on the body.
TEST(CharacterFromMotion, TakesTheSkinAlong) {
  const Figure figure = Arm7();
  const Motion motion = RandomMotion(figure, 3, 8);
  Skin skin;
  skin.bones = {figure.groups()[1].name};
  SkinMesh mesh;
  mesh.binds.resize(1);
  mesh.binds[0].inverse_bind(0, 3) = 0.25;
  mesh.positions = {Eigen::Vector3f(0.5f, 0.125f, -1.0f)};
  mesh.normals = {Eigen::Vector3f(0, 0, 1)};
  skin.meshes = {mesh};
  const Character character = Made(figure, motion, {"m", UpAxis::kY, 0.01, &skin});
  const SkinMesh& moved = character.meshes[0];
  EXPECT_EQ(moved.binds[0].bone, 2);
  EXPECT_EQ(moved.normals[0], Eigen::Vector3f(0, 1, 0));
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, motion.frames[2].X_WR, motion.frames[2].q, &ws);
  const auto& body = ws.body(figure.groups()[1].last());
  const Vec3 wanted = body.p + body.R * Vec3(0.75, 0.125, -1.0);
  const Pose X_WB = WorldPoses(character, 2)[2];
  const Eigen::Vector4d in_bone =
      moved.binds[0].inverse_bind * moved.positions[0].cast<double>().homogeneous();
  EXPECT_LT((X_WB * Vec3(in_bone.head<3>()) * 0.01 - YUp(wanted)).norm(), 1e-6);
}

// A bone that takes a share of a joint's angles is a bone of the file, which moves as in pictures.
TEST(CharacterFromMotion, HasABoneForEachShareOfAJoint) {
  const Figure figure = Arm7();
  const Motion motion = RandomMotion(figure, 3, 8);
  const std::string joint = figure.groups()[1].name;
  Skin skin;
  skin.bones = {joint, SkinBone(joint, 0.5)};
  const Character character = Made(figure, motion, {"m", UpAxis::kY, 1.0, &skin});
  ASSERT_EQ(character.bones.size(), figure.groups().size() + 2);
  EXPECT_EQ(character.bones.back().name, joint + "_50");
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, motion.frames[2].X_WR, motion.frames[2].q, &ws);
  const JointGroup& group = figure.groups()[1];
  const JointIndex parent = figure.joint(group.first).parent;
  const Mat3 R =
      ws.body(parent).R * TurnOf(figure, *FindBone(figure, skin.bones[1]), motion.frames[2].q);
  const Pose X_WB = WorldPoses(character, 2).back();
  EXPECT_LT((X_WB.p - YUp(ws.body(group.first).p)).norm(), 1e-9);
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    EXPECT_LT((X_WB.R * YUp(axis) - YUp(R * axis)).norm(), 1e-9);
  }
}

TEST(CharacterFromMotion, RefusesASkinOfAnotherFigure) {
  const Figure figure = Arm7();
  Skin skin;
  skin.bones = {figure.root_name(), "tail"};
  const auto made =
      CharacterFromMotion(figure, RandomMotion(figure, 1, 9), {"m", UpAxis::kY, 1.0, &skin});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().ToString(), "skin.bones[1]: the figure has no joint \"tail\"");
}

}  // namespace
}  // namespace hazumi::test
