// Balls that fly against a figure that a region moves: beside impacts in closed form, what both
// keep in flight, and where they lie.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

constexpr double kSize = 0.05, kWeighs = 0.5;        // radius and mass of a ball [m, kg]
constexpr double kOnRod = 0.5 * kThickness + kSize;  // of its centre over a rod's axis [m]
constexpr double kHandArm = 0.1;                     // [m]
constexpr int kLetGo = 1;

// A ball that a hand brings to a place in frame 1, and lets go of.
struct Thrown {
  Vec3 from = Vec3::Zero();
  double down = 0.0;  // its speed [m/s]
  double restitution = 0.0, friction = 0.0;
};

HeldObject BallOf(const Thrown& thrown) {
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{kSize};
  ball.mass = kWeighs;
  ball.touches_scene = true;
  ball.restitution = thrown.restitution;
  ball.friction = thrown.friction;
  return ball;
}

JointSpec AboutY(const char* name, const Vec3& offset, const LinkSpec& link) {
  JointSpec joint;
  joint.name = name;
  joint.offset = offset;
  joint.hinges = {{"", Vec3::UnitY(), -1e3, 1e3, 0.0}};
  joint.links = {link};
  return joint;
}

// Weighs nothing, and is out of the way.
JointSpec HandAt(const Vec3& place) {
  return AboutY("hand", place - kHandArm * Vec3::UnitX(), Rod("hand", Vec3::Zero(), Vec3::Zero()));
}

// A hand that keys turn about y, so that what it holds goes down.
void Throw(const Thrown& thrown, Animation* animation) {
  HeldObject ball = BallOf(thrown);
  ball.holders = {
      {GroupOf(*animation, "hand"), kHandArm * Vec3::UnitX(), Holder::kFromTheStart, kLetGo}};
  animation->held_objects = {ball};
  const double rate = thrown.down / kHandArm;
  KeysOf(animation, "hand") = {{0, -rate / 30.0, rate, kCubic}, {kLetGo, 0.0, rate, kCubic}};
}

void AddTouching(Animation* animation, const char* joint) {
  DynamicsRegion& region = AddRegion(animation, joint, 0, 30, {joint});
  region.method = Method::kExact;
  region.touches_scene = true;
}

// A rod along x that turns about y at its end, in a region with contacts.
Animation RodAndBall(const Thrown& thrown, double gravity) {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), Vec3::Zero())};
  spec.joints = {AboutY("pivot", Vec3::Zero(), Rod("rod", Vec3::Zero(), kLength * Vec3::UnitX())),
                 HandAt(thrown.from)};
  for (JointSpec& joint : spec.joints) joint.parent = "base";
  Animation animation = Exact(BuildFigure(spec).value(), gravity);
  AddTouching(&animation, "pivot");
  Throw(thrown, &animation);
  return animation;
}

const Vec3& PlaceOf(const MotionFrame& frame) { return frame.objects[0].X_WO.p; }

// Without gravity and friction the rod turns, and the ball flies on, as Poisson's impact says.
TEST(LooseBall, StrikesARodAsInClosedForm) {
  constexpr double kAt = 0.6 * kLength, kSpeed = 3.0, kWay = 0.5;
  for (const double e : {0.2, 0.5, 1.0}) {
    const Animation animation = RodAndBall({Vec3(kAt, 0.0, kOnRod + kWay), kSpeed, e}, 0.0);
    const Motion motion = BakeOrFail(animation);
    const int pivot = animation.figure->FindJoint("pivot")->value();
    const double I = InertiaAboutEnd();
    const double impulse = (1.0 + e) * kSpeed / (1.0 / kWeighs + kAt * kAt / I);
    const double since = 9.0 / 30.0 - kWay / kSpeed;
    const MotionFrame& frame = motion.frames[10];
    EXPECT_NEAR(frame.after.qd[pivot], impulse * kAt / I, 1e-8) << e;
    const Vec3 place(kAt, 0.0, kOnRod + (impulse / kWeighs - kSpeed) * since);
    EXPECT_LT((PlaceOf(frame) - place).norm(), 1e-8) << e;
    EXPECT_FALSE(motion.regions[0].estimated_until.has_value()) << e;
  }
}

TEST(LooseBall, ItsEnergyIsPartOfTheAccount) {
  const Animation animation = RodAndBall({Vec3(0.5, 0.0, kOnRod + 0.3), 3.0, 0.5, 0.8}, 0.0);
  BakeOptions options;
  options.energy = true;
  const Motion motion = BakeOrFail(animation, options);
  const EnergyBalance& energy = motion.regions[0].energy.value();
  EXPECT_LT(energy.impacts, -0.1);  // loss by impacts
  EXPECT_NEAR(energy.residual(), 0.0, 1e-7);
}

// How a ball that nothing touches moves between two frames.
BodyMotion MotionBetween(const MotionFrame& from, const MotionFrame& to, double gravity) {
  constexpr double kFrame = 1.0 / 30.0;
  const Pose &a = from.objects[0].X_WO, &b = to.objects[0].X_WO;
  const Eigen::AngleAxisd turn(Mat3(b.R * a.R.transpose()));
  return {a, (b.p - a.p) / kFrame + 0.5 * gravity * kFrame * Vec3::UnitZ(),
          turn.angle() / kFrame * turn.axis()};
}

// A rod and a hand that fly, and throw the ball at the rod's end.
TEST(LooseBall, WhatFliesKeepsItsMomentaWithTheBall) {
  for (const double e : {0.0, 0.7}) {
    const Thrown thrown = {Vec3(0.3, 0.01, kOnRod + 0.3), 4.0, e, 0.8};
    FigureSpec spec;
    spec.name = "flier";
    spec.root_name = "rod";
    spec.root_links = {Rod("rod", -0.4 * Vec3::UnitX(), 0.4 * Vec3::UnitX())};
    spec.joints = {HandAt(thrown.from)};
    spec.joints[0].parent = "rod";
    Animation animation = Exact(BuildFigure(spec).value(), kG);
    AddGravity(&animation, 0, 30);
    FreeAll(&animation);
    animation.regions[0].touches_scene = true;
    Throw(thrown, &animation);
    const Motion motion = BakeOrFail(animation);
    const auto all = [&](int f) {
      const MotionFrame& frame = motion.frames[f];
      Momentum sum = MomentumOf(*animation.figure, frame.after);
      const BodyMotion ball = MotionBetween(frame, motion.frames[f + 1], kG);
      const Vec3 p = sum.mass * sum.com_v + kWeighs * ball.v;
      const Vec3 spin = 0.4 * kWeighs * kSize * kSize * ball.w;
      // About the point that falls with what both together are.
      const Vec3 com = (sum.mass * sum.com + kWeighs * ball.X_WB.p) / (sum.mass + kWeighs);
      const Vec3 L = sum.L + (sum.com - com).cross(sum.mass * sum.com_v) +
                     (ball.X_WB.p - com).cross(kWeighs * ball.v) + spin;
      return std::make_pair(p, L);
    };
    const auto before = all(2), after = all(25);
    const double weight = (MomentumOf(*animation.figure, motion.frames[2].after).mass + kWeighs);
    const Vec3 fallen = weight * kG * 23.0 / 30.0 * Vec3::UnitZ();
    EXPECT_LT((after.first + fallen - before.first).norm(), 1e-7) << e;
    EXPECT_LT((after.second - before.second).norm(), 1e-7) << e;
    const double turned = (motion.frames[25].after.root_w - motion.frames[2].after.root_w).norm();
    EXPECT_GT(turned, 0.5) << e;
  }
}

// A rod falls onto a ball that lies on the floor, and lies on it level.
TEST(LooseBall, ARodComesToRestOnABall) {
  constexpr double kAt = 0.5;
  Animation animation = RodAndBall({Vec3(kAt, 0.0, -kOnRod), 0.0, 0.0, 0.8}, kG);
  SceneObject floor;
  floor.name = "floor";
  floor.shape = Plane{Vec3::UnitZ(), -kOnRod - kSize};
  animation.scene = {floor};
  KeysOf(&animation, "pivot") = {{0, -0.4, 0.0, kHold}};
  animation.regions[0].first_frame = kLetGo;
  BakeOptions options;
  options.energy = true;
  const Motion motion = BakeOrFail(animation, options);
  const EnergyBalance& energy = motion.regions[0].energy.value();
  EXPECT_LT(energy.impacts, -1.0);
  EXPECT_NEAR(energy.residual(), 0.0, 1e-7);
  const MotionFrame& last = motion.frames.back();
  const int pivot = animation.figure->FindJoint("pivot")->value();
  EXPECT_NEAR(last.q[pivot], 0.0, 1e-8);
  EXPECT_LT((PlaceOf(last) - Vec3(kAt, 0.0, -kOnRod)).norm(), 1e-8);
  ASSERT_EQ(last.contacts.pushes.size(), 1u);
  const ContactPush& push = last.contacts.pushes[0];
  EXPECT_EQ(animation.figure->links()[push.link].name, "rod");
  EXPECT_EQ(push.object, -1);
  EXPECT_EQ(push.by_link, -1);
  EXPECT_EQ(push.by_ball, 0);
  EXPECT_NEAR(push.force.z(), kMass * kG * 0.5 * kLength / kAt, 1e-6);
}

// Two balls that hands bring above each other, in a region with contacts. The upper one is faster.
Animation TwoBalls(double restitution, bool in_region) {
  constexpr double kApart = 4.0 * kSize;
  FigureSpec spec;
  spec.name = "hands";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3(3.0, 0.0, 0.0), Vec3(3.1, 0.0, 0.0))};
  spec.joints = {
      AboutY("pivot", Vec3(5.0, 0.0, 0.0), Rod("rod", Vec3::Zero(), kLength * Vec3::UnitX())),
      HandAt(Vec3::Zero()), HandAt(kApart * Vec3::UnitZ())};
  spec.joints.back().name = "upper_hand";
  for (JointSpec& joint : spec.joints) joint.parent = "base";
  Animation animation = Exact(BuildFigure(spec).value(), 0.0);
  if (in_region) AddTouching(&animation, "pivot");
  Throw({Vec3::Zero(), 1.0, restitution}, &animation);
  HeldObject upper = animation.held_objects[0];
  upper.name = "upper";
  upper.mass = 3.0 * kWeighs;
  upper.holders[0].joint = GroupOf(animation, "upper_hand");
  KeysOf(&animation, "upper_hand") = {{0, -4.0 / kHandArm / 30.0, 4.0 / kHandArm, kCubic},
                                      {kLetGo, 0.0, 4.0 / kHandArm, kCubic}};
  animation.held_objects.push_back(upper);
  return animation;
}

TEST(LooseBall, TwoBalls_CollideAsInClosedForm) {
  for (const double e : {0.0, 0.5, 1.0}) {
    const Motion motion = BakeOrFail(TwoBalls(e, /*in_region=*/true));
    // Down: 1 m/s for the lower ball, 4 m/s for the upper one, which weighs three times as much.
    const double common = (1.0 + 3.0 * 4.0) / 4.0;
    const double lower = common + 0.75 * e * 3.0, upper = common - 0.25 * e * 3.0;
    const double met = 2.0 * kSize / 3.0, since = 14.0 / 30.0 - met;
    const std::vector<ObjectPose>& at = motion.frames[15].objects;
    EXPECT_NEAR(at[0].X_WO.p.z(), -1.0 * met - lower * since, 1e-8) << e;
    EXPECT_NEAR(at[1].X_WO.p.z(), 4.0 * kSize - 4.0 * met - upper * since, 1e-8) << e;
  }
}

TEST(LooseBall, TwoBallsWithoutARegion_PassThroughEachOtherWithAWarning) {
  Animation animation = TwoBalls(0.5, /*in_region=*/false);
  const auto warned = [](const Motion& motion) {
    return std::count_if(motion.warnings.begin(), motion.warnings.end(), [](const Warning& of) {
      return of.message.find("fly through each other") != std::string::npos;
    });
  };
  EXPECT_EQ(warned(BakeOrFail(animation)), 1);
  EXPECT_EQ(warned(BakeOrFail(TwoBalls(0.5, /*in_region=*/true))), 0);
}

TEST(LooseBall, TwoBallsOfSolverVersionOne_PassThroughEachOther) {
  Animation animation = TwoBalls(0.5, /*in_region=*/true);
  animation.solver.version = 1;
  EXPECT_NEAR(BakeOrFail(animation).frames[15].objects[1].X_WO.p.z(),
              4.0 * kSize - 4.0 * 14.0 / 30.0, 1e-8);
}

// What lets a ball go that reaches into it lets it leave, and does not push it out.
TEST(LooseBall, LetGoInsideAHandItLeavesUnpushed) {
  Animation animation = RodAndBall({}, 0.0);
  HeldObject& ball = animation.held_objects[0];
  ball.friction = 0.8;
  ball.holders = {
      {GroupOf(animation, "pivot"), Vec3(0.7, 0.0, 0.6 * kOnRod), Holder::kFromTheStart, 10}};
  KeysOf(&animation, "pivot") = {{0, -1.0, 3.0, kHold}};
  const Motion motion = BakeOrFail(animation);
  EXPECT_FALSE(motion.regions[0].estimated_until.has_value());
  animation.regions[0].touches_scene = false;
  const Motion free = BakeOrFail(animation);
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    EXPECT_LT((PlaceOf(motion.frames[f]) - PlaceOf(free.frames[f])).norm(), 1e-7) << f;
  }
}

// Two rods in regions of their own, and one that keys hold, each under a ball.
TEST(LooseBall, MeetsAllLinksOfTheFigure) {
  FigureSpec spec;
  spec.name = "rods";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), Vec3::Zero())};
  const char* const names[] = {"left", "right", "keyed"};
  for (int i = 0; i < 3; ++i) {
    spec.joints.push_back(AboutY(names[i], static_cast<double>(i) * Vec3::UnitY(),
                                 Rod(names[i], Vec3::Zero(), kLength * Vec3::UnitX())));
  }
  const Thrown thrown = {Vec3(0.5, 0.0, kOnRod + 0.1), 0.0, 1.0, 0.0};
  spec.joints.push_back(HandAt(thrown.from));
  for (JointSpec& joint : spec.joints) joint.parent = "base";
  Animation animation = Exact(BuildFigure(spec).value(), 0.0);
  Throw(thrown, &animation);
  for (const char* name : {"left", "right"}) {
    AddTouching(&animation, name);
  }
  HeldObject ball = animation.held_objects[0];
  animation.held_objects.clear();
  for (int i = 0; i < 3; ++i) {
    ball.name = names[i];
    ball.holders[0].offset = kHandArm * Vec3::UnitX() + static_cast<double>(i) * Vec3::UnitY();
    animation.held_objects.push_back(ball);
  }
  KeysOf(&animation, "hand") = {{0, -0.6, 20.0, kCubic}, {kLetGo, 0.0, 20.0, kCubic}};
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& last = motion.frames.back();
  EXPECT_GT(last.after.qd[0], 1.0);
  EXPECT_NEAR(last.after.qd[1], last.after.qd[0], 1e-9);
  EXPECT_EQ(last.after.qd[2], 0.0);
  EXPECT_NEAR(last.objects[1].X_WO.p.z(), last.objects[0].X_WO.p.z(), 1e-9);
  const double since = 29.0 / 30.0 - 0.1 / 2.0;  // it came with 2 m/s, and leaves with these
  EXPECT_NEAR(last.objects[2].X_WO.p.z(), kOnRod + 2.0 * since, 1e-8);
}

// Outside of a region it flies on, and a hand may take it in one.
TEST(LooseBall, GoesOnWhereTheRegionEndsAndWhereItIsTaken) {
  Animation animation = RodAndBall({Vec3(0.5, 0.0, kOnRod + 0.3), 3.0, 1.0, 0.0}, kG);
  animation.last_frame = 40;
  const Motion motion = BakeOrFail(animation);
  const auto speed = [&](int f) {
    return MotionBetween(motion.frames[f], motion.frames[f + 1], kG).v.z() + kG * f / 30.0;
  };
  for (int f = 8; f < 40; ++f) EXPECT_NEAR(speed(f), speed(8), 1e-7) << f;
  HeldObject& ball = animation.held_objects[0];
  ball.holders.push_back({ball.holders[0].joint, ball.holders[0].offset, 20});
  const Motion taken = BakeOrFail(animation);
  for (int f = 0; f < 20; ++f) {
    EXPECT_LT((PlaceOf(taken.frames[f]) - PlaceOf(motion.frames[f])).norm(), 1e-9) << f;
  }
  EXPECT_EQ(taken.frames[20].objects[0].holder, 1);
  EXPECT_EQ(taken.frames[35].objects[0].holder, 1);
}

TEST(LooseBall, DoesNotDependOnWhatIsLookedAtOrWhatWasBefore) {
  Animation animation = RodAndBall({Vec3(0.5, 0.0, kOnRod + 0.3), 1.0, 0.5, 0.8}, kG);
  BakeOptions fine;
  fine.output_rate = FrameRate{60, 1};
  const Motion motion = BakeOrFail(animation), finer = BakeOrFail(animation, fine);
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    EXPECT_LT((PlaceOf(motion.frames[f]) - PlaceOf(finer.frames[2 * f])).norm(), 1e-9) << f;
  }
  IncrementalBake bake(animation, {});
  ExpectBakedAsAnew(&bake, animation);
  KeysOf(&animation, "hand")[0].rate = 12.0;
  bake.Update(animation);
  ExpectBakedAsAnew(&bake, animation);
}

}  // namespace
}  // namespace hazumi::test
