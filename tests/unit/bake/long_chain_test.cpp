// Chains with more hinges than the dense solver takes, which fall on a floor and come to rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

constexpr double kLink = 0.1, kThin = 0.02, kDeepestLink = 5e-4;  // [m]

// Chain along x with hinges about y and z in turn.
Figure LongChain(int links, double limit) {
  FigureSpec spec;
  spec.name = "chain";
  spec.root_name = "base";
  const auto rod = [](const std::string& name) {
    LinkSpec link;
    link.name = name;
    link.to = kLink * Vec3::UnitX();
    link.radius = kThin;
    link.mass = 0.1;
    return link;
  };
  spec.root_links = {rod("l0")};
  for (int i = 1; i < links; ++i) {
    JointSpec joint;
    joint.name = "j" + std::to_string(i);
    joint.parent = i == 1 ? "base" : "j" + std::to_string(i - 1);
    joint.offset = kLink * Vec3::UnitX();
    joint.hinges = {{"", Vec3::Unit(1 + i % 2), -limit, limit, 0.0}};
    joint.links = {rod("l" + std::to_string(i))};
    spec.joints.push_back(joint);
  }
  return BuildFigure(spec).value();
}

// Chain above the floor with every fourth joint bent, turned a little.
Animation FallingChain(int links, int frames, double limit, int version) {
  Animation animation = Loose(LongChain(links, limit), frames, {"j1"});
  animation.solver.version = version;
  animation.solver.tolerance = 0.01 * kDegree;
  AddFloor(&animation);
  for (int i = 3; i < links; i += 4) {
    KeysOf(&animation, ("j" + std::to_string(i)).c_str()) = {{0, i % 8 < 4 ? 0.3 : -0.3, 0.0}};
  }
  SetRootAt(&animation, Vec3(0.0, 0.0, 0.6));
  return animation;
}

double DeepestLinkOf(const Animation& animation, const Motion& motion) {
  double depth = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    depth = std::max(depth, -ClearanceOf(animation, frame));
  }
  return depth;
}

void ExpectItFallsAndLies(const Animation& animation) {
  BakeOptions options;
  options.energy = true;
  const Motion motion = BakeOrFail(animation, options);
  EXPECT_LT(DeepestLinkOf(animation, motion), kDeepestLink);
  const EnergyBalance& energy = motion.regions[0].energy.value();
  EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * energy.potential_start);
  EXPECT_LT(energy.WorkOf("contact") + energy.impacts + energy.limits, 0.0);
  double before = HUGE_VAL;
  for (const MotionFrame& frame : motion.frames) {
    const double now = EnergyOf(animation, frame.after);
    EXPECT_LE(now, before + 1e-3) << "frame " << frame.frame;
    before = now;
  }
  const double lies = 0.1 * animation.figure->links().size() * kG * kThin;
  EXPECT_LT(EnergyOf(animation, motion.frames.back().after), 1.5 * lies);
}

TEST(LongChain, ChainOnTheFloor_LosesEnergyAndStaysOutside) {
  ExpectItFallsAndLies(FallingChain(120, 60, 1e3, kSolverVersion));
}

TEST(LongChain, ChainWithLimits_LosesEnergyAndStaysOutside) {
  ExpectItFallsAndLies(FallingChain(120, 60, 0.4, kSolverVersion));
}

// Flat chain that stops at once, with known height and energy loss.
TEST(LongChain, ChainDroppedFlat_StopsLikeTheDenseSolution) {
  for (const int version : {1, kSolverVersion}) {
    Animation animation = Loose(LongChain(100, 1e3), 20, {"j1"});
    animation.solver.version = version;
    AddFloor(&animation);
    SetRootAt(&animation, Vec3(0.0, 0.0, kThin + 0.05));
    BakeOptions options;
    options.energy = true;
    const Motion motion = BakeOrFail(animation, options);
    EXPECT_NEAR(motion.frames.back().X_WR.p.z(), kThin, 1e-6) << "version " << version;
    EXPECT_LT(DeepestLinkOf(animation, motion), 1e-6);
    const EnergyBalance& energy = motion.regions[0].energy.value();
    EXPECT_NEAR(energy.kinetic_end, 0.0, 1e-9);
    EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * energy.potential_start);
  }
}

}  // namespace
}  // namespace hazumi::test
