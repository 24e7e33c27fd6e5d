// Impacts of contacts: their term of the energy account, separate from that of limits, and their
// events. Changes of energy without a force: released objects, and joints without mass.

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

constexpr double kDrop = 1.0;  // height of a fall [m]

Motion BakeWithEnergy(const Animation& animation) {
  BakeOptions options;
  options.energy = true;
  return BakeOrFail(animation, options);
}

const EnergyBalance& AccountOf(const Motion& motion) { return motion.regions[0].energy.value(); }

Animation FallingCapsule() {
  Animation animation = Loose(FreeCapsule(0.3, kBallRadius), 30);
  SetRootAt(&animation, {0.0, 0.0, kBallRadius + kDrop});
  AddFloor(&animation);
  animation.scene[0].name = "floor";
  return animation;
}

TEST(Impact, ImpactOfACapsuleOnTheFloor_IsBookedToContacts) {
  const Motion motion = BakeWithEnergy(FallingCapsule());
  const EnergyBalance& energy = AccountOf(motion);
  EXPECT_NEAR(energy.impacts, -kMass * kG * kDrop, 1e-6);
  EXPECT_NEAR(energy.limits, 0.0, 1e-7);
  EXPECT_NEAR(energy.residual(), 0.0, 1e-6);
}

TEST(TouchDown, IsOneEventThatNamesWhatTouches) {
  const Motion motion = BakeOrFail(FallingCapsule());
  const std::vector<MotionEvent> touches = EventsOf(motion, EventKind::kTouchDown);
  ASSERT_EQ(touches.size(), 1);
  EXPECT_NEAR(touches[0].time, std::sqrt(2.0 * kDrop / kG), 1e-8);
  EXPECT_EQ(touches[0].link, "rod");
  EXPECT_EQ(touches[0].joint, "rod");
  EXPECT_EQ(touches[0].on, "floor");
  EXPECT_EQ(touches[0].count, 1);
}

// Lands with its far end so high above the floor [m]; whether its motion is one of several then.
bool IsUnsureWhenLandingBy(double height) {
  Animation animation = FallingCapsule();
  animation.root_keys[kRootAngleY] = {{0, std::asin(height / 0.6), 0.0, kHold}};
  const Motion motion = BakeOrFail(animation);
  const std::optional<double> from = motion.regions[0].branches_from;
  const double landed = animation.rate.FrameAt(std::sqrt(2.0 * kDrop / kG));
  if (from) EXPECT_NEAR(*from, landed, 0.1);
  return from.has_value();
}

// Whether both ends hit together, or one and then the other, makes two motions. Where the second
// hit is within 1e-9 to 1e-7 m of the first a solution cannot tell.
TEST(Impact, ImpactsThatAreNextToSimultaneous_MakeTheMotionUnsure) {
  EXPECT_FALSE(IsUnsureWhenLandingBy(0.0));
  EXPECT_TRUE(IsUnsureWhenLandingBy(5e-9));
  EXPECT_TRUE(IsUnsureWhenLandingBy(2e-8));
  EXPECT_FALSE(IsUnsureWhenLandingBy(1e-3));
}

// Two rods in a line with a hinge about y between them, which bends up to 0.1 rad. The floor stops
// the lower end, and the impact drives the hinge to its limit.
TEST(Impact, ImpactThatDrivesAHingeToItsLimit_IsSharedWithTheLimit) {
  FigureSpec spec;
  spec.name = "rods";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), 0.5 * Vec3::UnitX())};
  JointSpec hinge;
  hinge.name = "hinge";
  hinge.parent = "base";
  hinge.hinges = {{"", Vec3::UnitY(), 0.0, 0.1, 0.0}};
  hinge.links = {Rod("arm", Vec3::Zero(), -0.5 * Vec3::UnitX())};
  spec.joints = {hinge};
  Animation animation = Loose(BuildFigure(spec).value(), 20, {"hinge"});
  SetRootAt(&animation, {0.0, 0.0, 0.5});
  animation.root_keys[kRootAngleY] = {{0, 0.5, 0.0, kHold}};
  AddFloor(&animation);
  const Motion motion = BakeWithEnergy(animation);
  const EnergyBalance& energy = AccountOf(motion);
  EXPECT_LT(energy.impacts, -0.1);
  EXPECT_LT(energy.limits, -0.001);
  const double lost = EnergyOf(animation, motion.frames.front().after) -
                      EnergyOf(animation, motion.frames.back().before);
  EXPECT_NEAR(energy.impacts + energy.limits + energy.WorkOf("contact"), -lost, 1e-5 * lost);
}

// Impact at the start of a region. The energy account begins before the impact.
TEST(Impact, ImpactAtTheStartOfARegion_IsBookedToContacts) {
  Animation animation = Loose(FreeCapsule(0.3, kBallRadius), 10);
  constexpr double kSpeed = 2.0;  // [m/s]
  SetRootAt(&animation, {0.0, 0.0, kBallRadius});
  animation.root_keys[kRootZ] = {{0, kBallRadius, -kSpeed, Interpolation::kCubic}};
  AddFloor(&animation);
  const EnergyBalance energy = AccountOf(BakeWithEnergy(animation));
  EXPECT_NEAR(energy.impacts, -0.5 * kMass * kSpeed * kSpeed, 1e-6);
  EXPECT_NEAR(energy.kinetic_start, 0.5 * kMass * kSpeed * kSpeed, 1e-6);
  EXPECT_NEAR(energy.residual(), 0.0, 1e-6);
}

// Rod that swings about z and releases a stick from its end.
Animation Swinging(bool has_mass) {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), 0.1 * Vec3::UnitX())};
  JointSpec joint;
  joint.name = "pivot";
  joint.parent = "base";
  joint.hinges = {{"", Vec3::UnitZ(), -1e3, 1e3, 0.0}};
  joint.links = {Rod("rod", Vec3::Zero(), kLength * Vec3::UnitX())};
  if (!has_mass) joint.links[0].mass = 0.0;
  spec.joints = {joint};
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  HeldObject stick;
  stick.name = "stick";
  stick.shape = BoxShape{Vec3(0.1, 0.02, 0.02)};
  stick.mass = 0.5;
  Holder holder;
  holder.joint = GroupOf(animation, "pivot");
  holder.offset = kLength * Vec3::UnitX();
  holder.last_frame = 10;
  stick.holders = {holder};
  animation.held_objects = {stick};
  animation.joint_keys[0] = {{0, 0.5, 3.0}};
  DynamicsRegion& region = AddRegion(&animation, "swing", 0, 30, {"pivot"});
  region.method = Method::kExact;
  Drive spring;
  spring.kind = DriveKind::kSpring;
  spring.target = SpringTarget::kRest;
  spring.frequency = 2.0;
  spring.joints = region.joints;
  region.drives = {spring};
  return animation;
}

TEST(Energy, ReleasedObject_HasATermOfItsOwn) {
  const EnergyBalance energy = AccountOf(BakeWithEnergy(Swinging(true)));
  EXPECT_LT(energy.WorkOf("handover"), -0.1);
  EXPECT_NEAR(energy.limits, 0.0, 1e-7);
  EXPECT_NEAR(energy.residual(), 0.0, 1e-8);
}

TEST(WeightlessJoint, ClosesItsAccountAndIsWarnedOf) {
  const Motion motion = BakeWithEnergy(Swinging(false));
  const EnergyBalance& energy = AccountOf(motion);
  EXPECT_GT(std::abs(energy.WorkOf("weightless joints")), 0.01);
  EXPECT_NEAR(energy.residual(), 0.0, 1e-8);
  const auto is_warned = [](const Warning& warning) {
    return warning.message.find("\"pivot\" carries has mass from frame 10 on") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(motion.warnings.begin(), motion.warnings.end(), is_warned), 1);
}

// Bounds the evaluations: steps of 1/64 ms would take two million.
TEST(Impact, ImpactWithoutGravity_CostsNoMoreThanWithGravity) {
  Animation animation = Loose(FreeCapsule(0.5, 0.02), 30);
  animation.gravity = 0.0;
  animation.root_keys[kRootX] = {{0, -1.0, 100.0}};
  animation.root_keys[kRootZ] = {{0, 0.2, 0.0, kHold}};
  animation.root_keys[kRootAngleY] = {{0, -70.0 * kDegree, 0.0, kHold}};
  SceneObject wall;
  wall.name = "wall";
  wall.shape = Box{{Mat3::Identity(), Vec3::Zero()}, Vec3(0.001, 1.0, 1.0)};
  animation.scene = {wall};
  animation.solver.tolerance = 0.01 * kDegree;
  EXPECT_LT(BakeOrFail(animation).regions[0].evaluations, 30'000);
}

// Landing of a figure with a keyed root orientation on a leg with contacts. The contact and the
// landing are simultaneous.
TEST(Landing, LandingOnALimbWithContacts_PrecedesItsContact) {
  FigureSpec spec;
  spec.name = "legged";
  spec.root_name = "trunk";
  spec.root_links = {Rod("trunk", Vec3::Zero(), 0.3 * Vec3::UnitZ())};
  JointSpec hip;
  hip.name = "hip";
  hip.parent = "trunk";
  hip.hinges = {{"", Vec3::UnitY(), -1.0, 1.0, 0.0}};
  hip.links = {Rod("leg", Vec3::Zero(), -kLength * Vec3::UnitZ())};
  spec.joints = {hip};
  const Figure figure = BuildFigure(spec).value();
  for (int i = 0; i < 40; ++i) {
    const double height = 0.1 + 0.0173 * i;
    Animation animation = Exact(figure, kG);
    animation.solver.tolerance = 0.01 * kDegree;
    AddGravity(&animation, 0, 30);
    AddFloor(&animation);
    SetRootAt(&animation, {0.0, 0.0, kLength + 0.5 * kThickness + height});
    animation.joint_keys[0] = {{0, 0.2, 0.5}};
    DynamicsRegion& region = AddRegion(&animation, "leg", 0, 30, {"hip"});
    region.method = Method::kExact;
    region.touches_scene = true;
    const Motion motion = BakeOrFail(animation);
    const std::vector<MotionEvent> touches = EventsOf(motion, EventKind::kTouchDown),
                                   landings = EventsOf(motion, EventKind::kLanding);
    ASSERT_FALSE(landings.empty()) << height;
    if (touches.empty()) continue;
    EXPECT_LE(landings[0].time, touches[0].time) << height;
  }
}

}  // namespace
}  // namespace hazumi::test
