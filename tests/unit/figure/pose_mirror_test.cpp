// Every joint's partner, turned as the mirror says, is where the joint was, reflected.

#include "engine/figure/pose_mirror.h"

#include <gtest/gtest.h>

#include "engine/dynamics/kinematics.h"
#include "tests/support/capture_skeletons.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

std::vector<double> AnglesOf(const Figure& figure, GroupIndex joint, const VecX& q) {
  const JointGroup& group = figure.group(joint);
  const double* first = q.data() + group.first.value();
  return {first, first + group.size};
}

VecX MirroredPose(const Figure& figure, const PoseMirror& mirror, const VecX& q, double* left) {
  VecX mirrored = VecX::Zero(q.size());
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    const GroupIndex other = mirror.sides().OtherSideOf(GroupIndex(g));
    const MirroredJoint joint = mirror.Mirrored(GroupIndex(g), AnglesOf(figure, GroupIndex(g), q),
                                                AnglesOf(figure, other, mirrored));
    *left = std::max(*left, joint.left_over);
    for (size_t i = 0; i < joint.angles.size(); ++i) {
      mirrored[figure.group(other).first.value() + static_cast<int>(i)] = joint.angles[i];
    }
  }
  return mirrored;
}

// Poses and places at random.
void ExpectMirrorImages(const Figure& figure, uint64_t seed) {
  const PoseMirror mirror(figure);
  const Vec3 n = mirror.sides().normal();
  const Mat3 M = Mat3::Identity() - 2.0 * n * n.transpose();
  Random random(seed);
  DynamicsWorkspace of_pose(figure), of_image(figure);
  for (int i = 0; i < 20; ++i) {
    const VecX q = random.Vector(figure.num_joints(), 2.5);
    const Pose X_WR = {random.Rotation(), random.Vector3(2.0)};
    double left = 0.0;
    const VecX image = MirroredPose(figure, mirror, q, &left);
    EXPECT_LE(left, 1e-6);
    ComputePositions(figure, X_WR, q, &of_pose);
    ComputePositions(figure, mirror.Mirrored(X_WR), image, &of_image);
    for (const JointGroup& joint : figure.groups()) {
      const GroupIndex g = figure.joint(joint.first).group;
      const JointGroup& other = figure.group(mirror.sides().OtherSideOf(g));
      EXPECT_LE((of_image.body(other.last()).p - M * of_pose.body(joint.last()).p).norm(), 1e-9)
          << joint.name << " seed " << seed;
    }
  }
}

Mat3 AboutZ(double degrees) {
  return Eigen::AngleAxisd(degrees / 57.29577951308232, Vec3::UnitZ()).toRotationMatrix();
}

TEST(PoseMirror, AHumansHingesAreMirroredOneByOne) {
  const Figure figure = Human37();
  ExpectMirrorImages(figure, 1);
  const PoseMirror mirror(figure);
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    EXPECT_TRUE(mirror.SignsOf(GroupIndex(g))) << figure.groups()[g].name;
  }
}

TEST(PoseMirror, OfTwinsThatAFigureSaysAreMirroredAnglesAreEqual) {
  Random random(1);
  FigureSpec spec = CaptureSpec(Mat3::Identity(), &random);
  std::erase_if(spec.joints, [](const JointSpec& joint) {
    return !joint.name.starts_with("Left") || joint.name.find("Arm") == std::string::npos;
  });
  spec.joints[0].parent = spec.root_name;
  spec.mirror = MirrorSpec{"Left", "Right"};
  const Figure figure = Build(spec);
  ExpectMirrorImages(figure, 2);
  const auto signs = PoseMirror(figure).SignsOf(*figure.FindGroup("RightArm"));
  ASSERT_TRUE(signs);
  EXPECT_EQ(*signs, (std::vector<double>{1.0, 1.0, 1.0}));
}

// Whichever way a capture faces: its hinges, z, x, y on both sides, turn the same or the other way.
TEST(PoseMirror, HingesAlongTheSameAxesOnBothSides) {
  for (const double degrees : {0.0, 90.0, 180.0, -90.0}) {
    const Figure figure = Build(CaptureSpec(AboutZ(degrees)));
    ExpectMirrorImages(figure, 2);
    const bool along_x = std::abs(std::sin(degrees / 57.29577951308232)) > 0.5;
    const auto signs = PoseMirror(figure).SignsOf(*figure.FindGroup("LeftArm"));
    ASSERT_TRUE(signs);
    EXPECT_EQ(*signs, along_x ? (std::vector<double>{-1.0, 1.0, -1.0})
                              : (std::vector<double>{-1.0, -1.0, 1.0}));
  }
}

TEST(PoseMirror, AFigureAcrossTheAxesIsMirroredByItsJointsRotations) {
  const Figure figure = Build(CaptureSpec(AboutZ(30.0)));
  EXPECT_FALSE(PoseMirror(figure).SignsOf(*figure.FindGroup("LeftArm")));
  EXPECT_FALSE(PoseMirror(figure).SignsOfRoot());
  ExpectMirrorImages(figure, 3);
}

TEST(PoseMirror, BonesWithAxesOfTheirOwn) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    ExpectMirrorImages(Build(CaptureSpec(AboutZ(90.0), &random)), seed);
  }
}

TEST(PoseMirror, TheRootsCurvesChangeTheirSignsByThePlane) {
  const auto signs = [](double degrees) {
    return *PoseMirror(Build(CaptureSpec(AboutZ(degrees)))).SignsOfRoot();
  };
  EXPECT_EQ(signs(0.0), (std::vector<double>{1.0, -1.0, 1.0, -1.0, 1.0, -1.0}));
  EXPECT_EQ(signs(90.0), (std::vector<double>{-1.0, 1.0, 1.0, -1.0, -1.0, 1.0}));
}

TEST(PoseMirror, APartnerWithTooFewHingesComesAsNearAsItCanAndSaysHowFarItIs) {
  FigureSpec spec = CaptureSpec();
  for (JointSpec& joint : spec.joints) {
    if (joint.name == "RightLeg") joint.hinges = {{"", Vec3::UnitY(), -3.0, 3.0}};
  }
  const Figure figure = Build(spec);
  const PoseMirror mirror(figure);
  const GroupIndex leg = *figure.FindGroup("LeftLeg");
  const MirroredJoint bent = mirror.Mirrored(leg, {0.0, 0.0, 0.6}, {0.0});
  EXPECT_NEAR(bent.angles[0], 0.6, 1e-9);
  EXPECT_LE(bent.left_over, 1e-7);
  const MirroredJoint twisted = mirror.Mirrored(leg, {0.4, 0.0, 0.0}, {0.0});
  EXPECT_NEAR(twisted.angles[0], 0.0, 1e-9);
  EXPECT_NEAR(twisted.left_over, 0.4, 1e-7);
}

TEST(PoseMirror, AHingeThatIsFixedOnTheOtherSideIsNotTurned) {
  FigureSpec spec = CaptureSpec();
  for (JointSpec& joint : spec.joints) {
    if (joint.name == "RightLeg") joint.hinges[0].lower = joint.hinges[0].upper = 0.0;
  }
  const Figure figure = Build(spec);
  const MirroredJoint leg =
      PoseMirror(figure).Mirrored(*figure.FindGroup("LeftLeg"), {0.5, 0.0, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(leg.angles[0], 0.0);
  EXPECT_NEAR(leg.left_over, 0.5, 1e-7);
}

}  // namespace
}  // namespace hazumi::test
