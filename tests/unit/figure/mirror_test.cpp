#include <gtest/gtest.h>

#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {
namespace {

const Mat3 kReflect = Vec3(1, -1, 1).asDiagonal();

// A random tree, every joint of it on the left ("l_j0" and so on), and its right twin.
FigureSpec RandomPair(uint64_t seed) {
  Random random(seed);
  FigureSpec spec = RandomTreeSpec(&random);
  for (JointSpec& joint : spec.joints) {
    joint.name = "l_" + joint.name;
    if (joint.parent != spec.root_name) joint.parent = "l_" + joint.parent;
    for (LinkSpec& link : joint.links) link.name = "l_rod";
  }
  spec.mirror = MirrorSpec{"l_", "r_"};
  return spec;
}

JointIndex TwinOf(const Figure& figure, const Joint& left) {
  return *figure.FindJoint("r_" + left.name.substr(2));
}

// The same angles on both sides.
VecX SymmetricAngles(const Figure& figure, uint64_t seed) {
  Random random(~seed);
  VecX q(figure.num_joints());
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (!figure.joints()[j].name.starts_with("l_")) continue;
    q[j] = q[TwinOf(figure, figure.joints()[j]).value()] = random.Uniform(-3.0, 3.0);
  }
  return q;
}

template <typename Check>
void ForEveryTwin(const Check& check) {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const Figure figure = Build(RandomPair(seed));
    ASSERT_EQ(figure.num_joints() % 2, 0);
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, Pose(), SymmetricAngles(figure, seed), &ws);
    for (int j = 0; j < figure.num_joints() / 2; ++j) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " joint " + std::to_string(j));
      check(figure, ws, JointIndex(j), TwinOf(figure, figure.joints()[j]));
    }
  }
}

TEST(Mirror, EqualAnglesGiveMirrorImagePoses) {
  ForEveryTwin([](const Figure&, const DynamicsWorkspace& ws, JointIndex l, JointIndex r) {
    EXPECT_LE((ws.body(r).p - kReflect * ws.body(l).p).norm(), 1e-13);
    EXPECT_LE((ws.body(r).R - kReflect * ws.body(l).R * kReflect).norm(), 1e-13);
  });
}

TEST(Mirror, TwinsHaveMirrorImageInertias) {
  ForEveryTwin([](const Figure& figure, const DynamicsWorkspace&, JointIndex l, JointIndex r) {
    EXPECT_EQ(figure.body(r).mass, figure.body(l).mass);
    EXPECT_LE((figure.body(r).com - kReflect * figure.body(l).com).norm(), 1e-14);
    EXPECT_LE((figure.body(r).I_com - kReflect * figure.body(l).I_com * kReflect).norm(), 1e-14);
  });
}

TEST(Mirror, TwinsHaveTheSameLimits) {
  ForEveryTwin([](const Figure& figure, const DynamicsWorkspace&, JointIndex l, JointIndex r) {
    EXPECT_EQ(figure.joint(r).lower, figure.joint(l).lower);
    EXPECT_EQ(figure.joint(r).upper, figure.joint(l).upper);
    EXPECT_EQ(figure.joint(r).rest, figure.joint(l).rest);
  });
}

TEST(Mirror, TheCenterOfMassOfASymmetricPoseIsInThePlane) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    FigureSpec spec = RandomPair(seed);
    spec.root_links.clear();
    const Figure figure = Build(spec);
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, Pose(), SymmetricAngles(figure, seed), &ws);
    EXPECT_NEAR(CenterOfMass(figure, ws).y(), 0.0, 1e-14) << "seed " << seed;
  }
}

TEST(Mirror, LeavesWhatHasNoPrefixAlone) {
  FigureSpec spec = RandomPair(1);
  JointSpec neck = spec.joints[0];
  neck.name = "neck";
  neck.parent = spec.root_name;
  spec.joints.push_back(neck);
  const FigureSpec both = WithMirroredTwins(spec);
  EXPECT_EQ(both.joints.size(), 2 * spec.joints.size() - 1);
  EXPECT_TRUE(Build(spec).FindGroup("neck").has_value());
}

TEST(Mirror, ReflectsAndRecoloursTheLooks) {
  FigureSpec spec = RandomPair(1);
  Look look;
  look.from = Vec3(1, 2, 3);
  look.center = Vec3(4, 5, 6);
  look.color = "#112233";
  look.mirror_color = "#445566";
  spec.joints[0].links[0].looks = {look};
  const FigureSpec both = WithMirroredTwins(spec);
  const LinkSpec& twin = both.joints[spec.joints.size()].links[0];
  EXPECT_EQ(twin.name, "r_rod");
  EXPECT_EQ(twin.looks[0].from, Vec3(1, -2, 3));
  EXPECT_EQ(twin.looks[0].center, Vec3(4, -5, 6));
  EXPECT_EQ(twin.looks[0].color, "#445566");
}

TEST(Mirror, WithoutAMirrorNothingIsAdded) {
  FigureSpec spec = RandomPair(1);
  spec.mirror.reset();
  EXPECT_EQ(WithMirroredTwins(spec).joints.size(), spec.joints.size());
}

}  // namespace
}  // namespace hazumi::test
