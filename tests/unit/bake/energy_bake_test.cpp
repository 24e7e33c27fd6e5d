// The energy account of exact regions: what the bodies have, what friction, limits and keys did.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/momentum.h"

namespace hazumi::test {
namespace {

// Human37 with limbs that move by keys over one second.
Animation Moving(std::initializer_list<const char*> keyed) {
  Animation animation = Still(Human37());
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9 * kDegree;
  double angle = 0.3;
  for (const char* joint : keyed) {
    KeysOf(&animation, joint) = {{0, 0.0, 1.0}, {13, angle, {}}, {30, -0.1, {}}};
    angle = -1.3 * angle;
  }
  return animation;
}

DynamicsRegion& AddExact(Animation* animation, const std::vector<const char*>& joints,
                         double friction) {
  DynamicsRegion& region = AddRegion(animation, "swing", 0, 30, joints, friction);
  region.method = Method::kExact;
  double rate = 1.0;
  for (const JointIndex j : region.joints) {
    animation->joint_keys[j.value()] = {{0, 0.1 * rate, rate}};
    rate = std::fmod(2.7 * rate + 0.9, 3.0) - 1.0;
  }
  return region;
}

EnergyBalance Account(const Animation& animation, Motion* motion) {
  *motion = BakeOrFail(animation, {{}, nullptr, true});
  EXPECT_TRUE(motion->regions[0].energy.has_value());
  return motion->regions[0].energy.value_or(EnergyBalance());
}

void ExpectBalanced(const EnergyBalance& energy) {
  const double scale = energy.kinetic_start + energy.kinetic_end + std::abs(energy.keyed) + 1.0;
  EXPECT_LE(std::abs(energy.residual()), 1e-8 * scale);
}

double TotalEnergy(const Animation& animation, const MotionLimit& limit) {
  const Momentum momentum = MomentumOf(*animation.figure, limit);
  return momentum.kinetic + momentum.potential(kG);
}

TEST(Energy, OfArmsOnAMovingTrunkIsAccountedFor) {
  Animation animation = Moving({"spine_y", "chest_y", "neck_z"});
  animation.root_keys[kRootX] = {{0, 0.0, 2.0}, {30, 1.0, {}}};
  animation.root_keys[kRootAngleY] = {{0, 0.0, 2.0}, {30, 0.5, {}}};
  AddExact(&animation, {"r_shoulder", "l_shoulder"}, 0.9);
  Motion motion;
  const EnergyBalance energy = Account(animation, &motion);
  ExpectBalanced(energy);
  EXPECT_LT(energy.WorkOf("friction"), -0.1);
  EXPECT_GT(std::abs(energy.keyed), 0.1);
  EXPECT_EQ(motion.regions[0].islands, (std::vector<int>{7, 7}));
}

// A rod that rests on its stop takes long steps, in which what carries it turns to and fro.
TEST(Energy, IsAccountedForInStepsThatOutlastItsPower) {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  JointSpec joint;
  joint.name = "pivot";
  joint.parent = "base";
  joint.hinges = {{"", Vec3::UnitY(), -1.0, 0.0, 0.0}};
  joint.links.resize(1);
  joint.links[0].name = "rod";
  joint.links[0].to = 0.4 * Vec3::UnitX();
  joint.links[0].radius = 0.02;
  joint.links[0].mass = 1.0;
  spec.joints = {joint};
  Animation animation = Still(Build(spec));
  animation.solver.method = Method::kExact;
  KeysOf(&animation, "pivot") = {{0, 0.0, 0.0}};
  animation.root_keys[kRootAngleZ] = {{0, 0.0, 6.0}, {13, 2.0, {}}, {30, -2.0, {}}};
  animation.root_keys[kRootX] = {{0, 0.0, 2.0}, {30, 1.0, {}}};
  AddRegion(&animation, "rod", 0, 30, {"pivot"}).method = Method::kExact;
  Motion motion;
  ExpectBalanced(Account(animation, &motion));
  EXPECT_EQ(motion.frames[30].q[0], 0.0);
}

// The leg between root and pin swings, so that the whole figure moves: energy is the whole
// figure's.
TEST(Energy, OfAPinnedFigureIsAccountedFor) {
  Animation animation = Moving({"spine_y", "r_shoulder_y"});
  AddPin(&animation, 0, 30, "l_ankle");
  AddExact(&animation, {"l_knee"}, 0.95);
  Motion motion;
  const EnergyBalance energy = Account(animation, &motion);
  ExpectBalanced(energy);
  const double change = TotalEnergy(animation, motion.frames[30].before) -
                        TotalEnergy(animation, motion.frames[0].after);
  EXPECT_NEAR(change, energy.WorkOf("friction") + energy.limits + energy.keyed,
              1e-8 * std::abs(change));
}

// In flight keys do inner work only.
TEST(Energy, OfAFlyingFigureIsWhatItsKeysGaveIt) {
  Animation animation = Moving({"r_hip_y", "l_hip_y", "r_knee", "spine_y"});
  animation.root_keys[kRootZ] = {{0, 3.0, 4.0}};
  animation.root_keys[kRootAngleY] = {{0, 0.2, 3.0}};
  AddGravity(&animation, 0, 30);
  DynamicsRegion& region = AddExact(&animation, {"r_shoulder", "l_shoulder"}, 1.0);
  region.root = true;
  Motion motion;
  const EnergyBalance energy = Account(animation, &motion);
  ExpectBalanced(energy);
  EXPECT_NEAR(energy.WorkOf("friction"), 0.0, 1e-9);
  const double start = TotalEnergy(animation, motion.frames[0].after);
  const double change = TotalEnergy(animation, motion.frames[30].before) - start;
  EXPECT_NEAR(change, energy.limits + energy.keyed, 1e-8 * start);
}

TEST(Energy, IsNotAccountedForUnlessAskedFor) {
  Animation animation = Moving({});
  AddExact(&animation, {"r_shoulder"}, 1.0);
  EXPECT_FALSE(BakeOrFail(animation).regions[0].energy.has_value());
}

}  // namespace
}  // namespace hazumi::test
