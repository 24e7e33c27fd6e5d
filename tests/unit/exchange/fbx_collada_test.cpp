// What the axes, units and pivots of FBX and Collada become.

#include <gtest/gtest.h>

#include "engine/spatial/degrees.h"
#include "tests/unit/exchange/small_files.h"

namespace hazumi {
namespace {

Mat3 About(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix();
}

TEST(Fbx, SaysUpAxisAndUnitOfTheFile) {
  const Character c = test::ReadSmall("a.fbx", test::SmallFbx());
  EXPECT_EQ(c.up, UpAxis::kZ);
  ASSERT_TRUE(c.metres_per_unit.has_value());
  EXPECT_NEAR(*c.metres_per_unit, 1.0, 1e-6);
  EXPECT_EQ(c.name, "a");
}

TEST(Fbx, PreRotationIsAPartOfTheBone) {
  const Character c = test::ReadSmall("a.fbx", test::SmallFbx());
  ASSERT_EQ(c.bones.size(), 1u);
  EXPECT_EQ(c.bones[0].name, "Hips");
  EXPECT_TRUE(c.bones[0].rest.p.isApprox(Vec3(0, 0, 1), 1e-6));
  const Mat3 rest = About(Vec3::UnitZ(), 90) * About(Vec3::UnitX(), 10);
  EXPECT_TRUE(c.bones[0].rest.R.isApprox(rest, 1e-6)) << c.bones[0].rest.R;
  // A child that nothing moves says where the bone ends.
  ASSERT_TRUE(c.bones[0].end_site.has_value());
  EXPECT_TRUE(c.bones[0].end_site->isApprox(Vec3(0.5, 0, 0), 1e-6));
}

TEST(Fbx, FramesAreThoseOfTheCurve) {
  const Character c = test::ReadSmall("a.fbx", test::SmallFbx());
  ASSERT_EQ(c.clips.size(), 1u);
  EXPECT_NEAR(c.clips[0].seconds_per_frame, 1.0 / 30.0, 1e-9);
  ASSERT_EQ(c.clips[0].num_frames, 31);
  const BoneTrack& track = c.clips[0].tracks[0];
  EXPECT_TRUE(track.translations.empty());
  ASSERT_EQ(track.rotations.size(), 31u);
  for (const int frame : {0, 15, 30}) {
    const Mat3 R = About(Vec3::UnitZ(), 90) * About(Vec3::UnitX(), 10 + 2.0 * frame);
    EXPECT_TRUE(track.rotations[static_cast<size_t>(frame)].toRotationMatrix().isApprox(R, 1e-5))
        << frame;
  }
}

// A pivot makes assimp split the node, in rest and animation: T Rp Rpre R Rp^-1.
TEST(Fbx, PivotsAreMultipliedOut) {
  const Character c = test::ReadSmall(
      "a.fbx",
      test::SmallFbx("\t\t\tP: \"RotationPivot\", \"Vector3D\", \"Vector\", \"\",0,0.2,0\n"));
  ASSERT_EQ(c.bones.size(), 1u);
  ASSERT_EQ(c.clips.size(), 1u);
  const Vec3 pivot(0, 0.2, 0);
  const BoneTrack& track = c.clips[0].tracks[0];
  ASSERT_EQ(track.rotations.size(), 31u);
  ASSERT_EQ(track.translations.size(), 31u);
  for (const int frame : {0, 30}) {
    const Mat3 R = About(Vec3::UnitZ(), 90) * About(Vec3::UnitX(), 10 + 2.0 * frame);
    const Vec3 p = Vec3(0, 0, 1) + pivot - R * pivot;
    const auto f = static_cast<size_t>(frame);
    EXPECT_TRUE(track.rotations[f].toRotationMatrix().isApprox(R, 1e-5)) << frame;
    EXPECT_TRUE(track.translations[f].isApprox(p, 1e-5)) << track.translations[f].transpose();
  }
}

TEST(Collada, KeepsItsOwnAxesAndUnit) {
  const Character c = test::ReadSmall("a.dae", test::SmallCollada());
  EXPECT_EQ(c.up, UpAxis::kZ);
  ASSERT_TRUE(c.metres_per_unit.has_value());
  EXPECT_NEAR(*c.metres_per_unit, 0.01, 1e-8);
  ASSERT_EQ(c.bones.size(), 1u);
  EXPECT_TRUE(c.bones[0].rest.p.isApprox(Vec3(0, 0, 100), 1e-5));
  EXPECT_TRUE(c.bones[0].rest.R.isIdentity(1e-6));
  EXPECT_EQ(c.bones[0].rest_scale, Vec3::Ones());
  ASSERT_TRUE(c.bones[0].end_site.has_value());
  EXPECT_TRUE(c.bones[0].end_site->isApprox(Vec3(0, 0, 50), 1e-5));
}

TEST(Collada, RotatesAlongTheSphereBetweenKeys) {
  const Character c = test::ReadSmall("a.dae", test::SmallCollada());
  ASSERT_EQ(c.clips.size(), 1u);
  ASSERT_EQ(c.clips[0].num_frames, 31);
  const BoneTrack& track = c.clips[0].tracks[0];
  ASSERT_EQ(track.rotations.size(), 31u);
  EXPECT_TRUE(track.rotations[10].toRotationMatrix().isApprox(About(Vec3::UnitZ(), 30), 1e-5));
}

}  // namespace
}  // namespace hazumi
