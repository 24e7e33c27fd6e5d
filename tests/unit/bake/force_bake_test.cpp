// Forces from outside, whole bakes: motions in closed form, and what momentum and energy say.

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/momentum.h"

namespace hazumi::test {
namespace {

constexpr double kMass = 1.3, kLength = 0.8, kThickness = 0.05;  // of rods [kg, m]
constexpr double kAir = 1.225, kCrossFlow = 1.1;
constexpr Interpolation kHold = Interpolation::kHold;

LinkSpec Rod(const char* name, const Vec3& from, const Vec3& to) {
  LinkSpec link;
  link.name = name;
  link.from = from;
  link.to = to;
  link.radius = 0.5 * kThickness;
  link.mass = kMass;
  return link;
}

// A rod about whose middle, along x, the root sits.
Figure FreeRod() {
  FigureSpec spec;
  spec.name = "rod";
  spec.root_name = "rod";
  spec.root_links = {Rod("rod", -0.5 * kLength * Vec3::UnitX(), 0.5 * kLength * Vec3::UnitX())};
  JointSpec tip;  // gravity needs something to pin where it lands
  tip.name = "tip";
  tip.parent = "rod";
  tip.hinges = {{"", Vec3::UnitY(), 0.0, 0.0, 0.0}};
  spec.joints = {tip};
  return BuildFigure(spec).value();
}

// A rod along x that turns about z at its end, on a root that stays.
Figure TurningRod() {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), Vec3::Zero())};
  spec.root_links[0].radius = 0.1;
  JointSpec joint;
  joint.name = "pivot";
  joint.parent = "base";
  joint.hinges = {{"", Vec3::UnitZ(), -1e3, 1e3, 0.0}};
  joint.links = {Rod("rod", Vec3::Zero(), kLength * Vec3::UnitX())};
  spec.joints = {joint};
  return BuildFigure(spec).value();
}

Animation Exact(Figure figure, double gravity) {
  Animation animation = Still(std::move(figure));
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9 * kDegree;
  animation.gravity = gravity;
  return animation;
}

// The root's orientation swings too.
void FreeAll(Animation* animation, const std::vector<const char*>& joints = {}, int first = 0) {
  DynamicsRegion& region = AddRegion(animation, "free", first, 30, joints);
  region.method = Method::kExact;
  region.root = true;
}

// In flight from the first frame on.
Animation Flying(Figure figure, double gravity) {
  Animation animation = Exact(std::move(figure), gravity);
  AddGravity(&animation, 0, 30);
  FreeAll(&animation);
  return animation;
}

void AddForce(Animation* animation, int first, int last,
              std::variant<WindForce, AttractForce, PushForce> action) {
  animation->forces.push_back({"force", std::move(action), first, last});
}

void SetRoot(Animation* animation, RootCurve curve, double value, double rate) {
  animation->root_keys[curve] = {{0, value, rate, kHold}};
}

// ---- Air

// I w' = -rho C_D d L^4 w^2 / 8:  w = w0 / (1 + k w0 t),  k = rho C_D d L^4 / (8 I)
TEST(ForceBake, AirBrakesARodThatTurnsAboutItsEnd) {
  Animation animation = Exact(TurningRod(), 0.0);
  AddRegion(&animation, "spin", 0, 30, {"pivot"}).method = Method::kExact;
  AddForce(&animation, 0, 30, WindForce{Vec3::Zero(), kAir});
  const double w0 = 30.0;
  KeysOf(&animation, "pivot") = {{0, 0.0, w0, kHold}};
  const Motion motion = BakeOrFail(animation);
  const double I =
      animation.figure->body(JointIndex(0)).I_com(2, 2) + kMass * kLength * kLength / 4.0;
  const double k = kAir * kCrossFlow * kThickness * std::pow(kLength, 4) / (8.0 * I);
  for (const MotionFrame& frame : motion.frames) {
    const double t = frame.frame / 30.0;
    EXPECT_NEAR(frame.q[0], std::log(1.0 + k * w0 * t) / k, 1e-9) << frame.frame;
    if (frame.frame == 30) continue;
    EXPECT_NEAR(frame.after.qd[0], w0 / (1.0 + k * w0 * t), 1e-9) << frame.frame;
  }
  EXPECT_LT(motion.frames[29].after.qd[0], 0.9 * w0);
}

// A rod on its side is slowed down as v' = -k (v - u)^2, whatever it does along its axis.
TEST(ForceBake, WindCarriesARodAcrossItsAxisAndNotAlong) {
  Animation animation = Flying(FreeRod(), 0.0);
  const double u = -1.5, v0 = 6.0;
  SetRoot(&animation, kRootX, 0.0, 2.0);
  SetRoot(&animation, kRootZ, 0.0, v0);
  AddForce(&animation, 0, 30, WindForce{Vec3(7.0, 0.0, u), kAir});
  const Motion motion = BakeOrFail(animation);
  const double k = kAir * kCrossFlow * kThickness * kLength / (2.0 * kMass);
  const double t = 29.0 / 30.0;
  const MotionFrame& frame = motion.frames[29];
  EXPECT_NEAR(frame.after.root_v.z(), u + (v0 - u) / (1.0 + k * (v0 - u) * t), 1e-9);
  EXPECT_NEAR(frame.X_WR.p.z(), u * t + std::log(1.0 + k * (v0 - u) * t) / k, 1e-9);
  EXPECT_NEAR(frame.after.root_v.x(), 2.0, 1e-9);
  EXPECT_LT(frame.after.root_w.norm(), 1e-9);
}

TEST(ForceBake, AFigureThatDriftsWithTheWindFeelsNone) {
  Animation still = Flying(Human37(), 0.0);
  const Vec3 u(2.0, -1.0, 0.5);
  for (int i = 0; i < 3; ++i) SetRoot(&still, static_cast<RootCurve>(i), 0.0, u[i]);
  Animation windy = still;
  AddForce(&windy, 0, 30, WindForce{u, kAir});
  const Motion expected = BakeOrFail(still), motion = BakeOrFail(windy);
  const MotionFrame &a = motion.frames[30], &b = expected.frames[30];
  EXPECT_LT((a.X_WR.p - b.X_WR.p).norm(), 1e-9);
  EXPECT_LT((a.X_WR.R - b.X_WR.R).norm(), 1e-9);
}

// ---- Attraction

// At the centre of a body inside the radius: x'' = -f x / (r m).
TEST(ForceBake, APullInsideItsRadiusSwingsABodyAsASpringDoes) {
  Animation animation = Flying(FreeRod(), 0.0);
  SetRoot(&animation, kRootX, 0.4, 0.0);
  SetRoot(&animation, kRootY, -0.2, 0.0);
  AttractForce pull;
  pull.to = Vec3(0.1, 0.1, 0.3);
  pull.force = 40.0;
  pull.radius = 2.0;
  AddForce(&animation, 0, 30, pull);
  const Motion motion = BakeOrFail(animation);
  const double w = std::sqrt(pull.force / (pull.radius * kMass));
  for (const MotionFrame& frame : motion.frames) {
    const Vec3 start = Vec3(0.4, -0.2, 0.0) - pull.to;
    EXPECT_LT((frame.X_WR.p - pull.to - std::cos(w * frame.frame / 30.0) * start).norm(), 1e-9);
  }
}

double PullEnergy(const AttractForce& pull, double distance) {
  return distance < pull.radius ? pull.force * distance * distance / (2.0 * pull.radius)
                                : pull.force * (distance - 0.5 * pull.radius);
}

// From outside the radius into it, at a point beyond the joint.
TEST(ForceBake, TheWorkOfAPullIsTheEnergyOfItsWay) {
  Animation animation = Exact(Human37(), kG);
  DynamicsRegion& region = AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}, 0.95);
  region.method = Method::kExact;
  AttractForce pull;
  pull.at = {GroupOf(animation, "r_elbow"), Vec3(0.02, 0.01, -0.2)};
  pull.to = Vec3(0.3, -0.2, 0.3);
  pull.force = 15.0;
  pull.radius = 0.25;
  AddForce(&animation, 0, 30, pull);
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  const auto distance = [&](const MotionFrame& frame) {
    DynamicsWorkspace ws(*animation.figure);
    ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
    const BodyScratch& body = ws.body(animation.figure->group(*pull.at.joint).last());
    return (body.p + body.R * pull.at.offset - pull.to).norm();
  };
  double nearest = 1e9;
  for (const MotionFrame& frame : motion.frames) nearest = std::min(nearest, distance(frame));
  EXPECT_GT(distance(motion.frames[0]), pull.radius);
  EXPECT_LT(nearest, pull.radius);
  const double work =
      PullEnergy(pull, distance(motion.frames[0])) - PullEnergy(pull, distance(motion.frames[30]));
  const EnergyBalance energy = motion.regions[0].energy.value();
  EXPECT_NEAR(energy.WorkOf("attraction"), work, 1e-6);
  EXPECT_GT(std::abs(work), 0.5);
  EXPECT_LT(std::abs(energy.residual()), 1e-6);
}

// Before its first frame and behind its last one there is nothing of it: the fall is a parabola.
TEST(ForceBake, ActsInItsFramesAlone) {
  Animation animation = Flying(Human37(), kG);
  SetRoot(&animation, kRootZ, 5.0, 3.0);
  SetRoot(&animation, kRootAngleX, 0.1, 2.0);
  const Motion plain = BakeOrFail(animation);
  AddForce(&animation, 8, 14, WindForce{Vec3(20.0, 3.0, 0.0), kAir});
  const Motion motion = BakeOrFail(animation);
  EXPECT_LT((motion.frames[8].com - plain.frames[8].com).norm(), 1e-9);
  EXPECT_GT((motion.frames[14].com - plain.frames[14].com).norm(), 1e-3);
  const Momentum left = MomentumOf(*animation.figure, motion.frames[14].after);
  for (int frame = 14; frame <= 30; ++frame) {
    const double t = (frame - 14) / 30.0;
    const Vec3 com = left.com + t * left.com_v - 0.5 * kG * t * t * Vec3::UnitZ();
    EXPECT_LT((motion.frames[frame].com - com).norm(), 1e-9) << frame;
    const Momentum now = MomentumOf(*animation.figure, motion.frames[frame].before);
    EXPECT_LT((now.L - left.L).norm(), 1e-8 * left.L.norm()) << frame;
  }
}

// ---- Pushes

TEST(ForceBake, APushGivesAFreeRodVelocityAndSpin) {
  Animation animation = Flying(FreeRod(), 0.0);
  SetRoot(&animation, kRootAngleZ, 0.7, 0.0);
  SetRoot(&animation, kRootAngleY, -0.4, 0.0);
  SetRoot(&animation, kRootX, 0.1, 0.3);
  const PushForce push = {{{}, Vec3(0.3, 0.01, -0.02)}, Vec3(0.4, -1.1, 0.8)};
  AddForce(&animation, 12, 13, push);
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& hit = motion.frames[12];
  const Mat3 I = hit.X_WR.R * animation.figure->root_body().I_com * hit.X_WR.R.transpose();
  const Vec3 w = I.inverse() * (hit.X_WR.R * push.at.offset).cross(push.impulse);
  const Vec3 v = Vec3(0.3, 0.0, 0.0) + push.impulse / kMass;
  EXPECT_LT(hit.before.root_w.norm(), 1e-12);
  EXPECT_LT((hit.after.root_w - w).norm(), 1e-9);
  EXPECT_LT((hit.after.root_v - v).norm(), 1e-9);
  EXPECT_GT(w.norm(), 1.0);
  const MotionFrame& last = motion.frames[30];
  EXPECT_LT((last.X_WR.p - hit.X_WR.p - 0.6 * v).norm(), 1e-9);
}

// A human whose arms swing: what comes in is the impulse, and its moment about the centre of mass.
TEST(ForceBake, APushInFlightChangesMomentumByTheImpulseAndItsMoment) {
  Animation animation = Exact(Human37(), kG);
  AddGravity(&animation, 0, 30);
  FreeAll(&animation, {"r_shoulder", "l_shoulder"});
  SetRoot(&animation, kRootZ, 5.0, 3.0);
  SetRoot(&animation, kRootAngleY, 0.2, 3.0);
  double rate = 1.0;
  for (const JointIndex j : animation.regions[0].joints) {
    animation.joint_keys[j.value()] = {{0, 0.1 * rate, rate, kHold}};
    rate = std::fmod(2.7 * rate + 0.9, 3.0) - 1.0;
  }
  const PushForce push = {{GroupOf(animation, "r_elbow"), Vec3(0.0, 0.02, -0.2)},
                          Vec3(1.0, -2.0, 4.0)};
  AddForce(&animation, 9, 10, push);
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& hit = motion.frames[9];
  const Momentum before = MomentumOf(*animation.figure, hit.before);
  const Momentum after = MomentumOf(*animation.figure, hit.after);
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, hit.X_WR, hit.q, &ws);
  const BodyScratch& body = ws.body(animation.figure->group(*push.at.joint).last());
  const Vec3 arm = body.p + body.R * push.at.offset - before.com;
  EXPECT_LT((after.mass * (after.com_v - before.com_v) - push.impulse).norm(), 1e-9);
  EXPECT_LT((after.L - before.L - arm.cross(push.impulse)).norm(), 1e-9);
  const Momentum end = MomentumOf(*animation.figure, motion.frames[30].before);
  EXPECT_LT((end.L - after.L).norm(), 1e-7 * after.L.norm());
  const Vec3 fallen = after.com + 0.7 * after.com_v - 0.5 * kG * 0.49 * Vec3::UnitZ();
  EXPECT_LT((end.com - fallen).norm(), 1e-9);
}

// On links that hang on what stays: the energy that comes in is impulse times mean velocity.
TEST(ForceBake, TheWorkOfAPushIsItsImpulseTimesTheMeanVelocityOfItsPoint) {
  Animation animation = Exact(Human37(), kG);
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}, 0.95).method = Method::kExact;
  const PushForce push = {{GroupOf(animation, "r_elbow"), Vec3(0.0, 0.02, -0.2)},
                          Vec3(1.0, -0.5, 0.3)};
  AddForce(&animation, 11, 12, push);
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  const MotionFrame& hit = motion.frames[11];
  Vec3 sum = Vec3::Zero();
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, hit.X_WR, hit.q, &ws);
  for (const MotionLimit* side : {&hit.before, &hit.after}) {
    ComputeVelocities(*animation.figure, Vec3::Zero(), Vec3::Zero(), side->qd, &ws);
    const BodyScratch& body = ws.body(animation.figure->group(*push.at.joint).last());
    sum += body.v + body.w.cross(body.R * push.at.offset);
  }
  const double work = 0.5 * push.impulse.dot(sum);
  const EnergyBalance energy = motion.regions[0].energy.value();
  EXPECT_NEAR(energy.WorkOf("push"), work, 1e-8);
  EXPECT_GT(work, 0.1);
  EXPECT_LT(std::abs(energy.residual()), 1e-6);
}

// A knee on its limit is pushed against it: it stays, and the leg turns as one body.
TEST(ForceBake, APushDoesNotGoThroughALimit) {
  FigureSpec spec;
  spec.name = "leg";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), Vec3::Zero())};
  spec.root_links[0].radius = 0.1;
  JointSpec hip, knee;
  hip.name = "hip";
  hip.parent = "base";
  hip.hinges = {{"", Vec3::UnitZ(), -10.0, 10.0, 0.0}};
  hip.links = {Rod("thigh", Vec3::Zero(), kLength * Vec3::UnitX())};
  knee = hip;
  knee.name = "knee";
  knee.parent = "hip";
  knee.offset = kLength * Vec3::UnitX();
  knee.hinges = {{"", Vec3::UnitZ(), 0.0, 2.0, 0.0}};
  knee.links[0].name = "shank";
  spec.joints = {hip, knee};
  Animation animation = Exact(BuildFigure(spec).value(), 0.0);
  AddRegion(&animation, "leg", 0, 30, {"hip"}).method = Method::kExact;
  const double impulse = 0.7;
  AddForce(
      &animation, 10, 11,
      PushForce{{GroupOf(animation, "knee"), kLength * Vec3::UnitX()}, -impulse * Vec3::UnitY()});
  const Motion motion = BakeOrFail(animation);
  const double I_com = animation.figure->body(JointIndex(0)).I_com(2, 2);
  const double I = 2.0 * I_com + kMass * kLength * kLength * (0.25 + 2.25);
  const double w = -impulse * 2.0 * kLength / I;
  for (int frame = 11; frame < 30; ++frame) {
    EXPECT_NEAR(motion.frames[frame].q[1], 0.0, 1e-12);
    EXPECT_NEAR(motion.frames[frame].after.qd[0], w, 1e-9);
  }
}

TEST(ForceBake, APushOnWhatNoRegionMovesIsRefused) {
  Animation animation = Exact(Human37(), kG);
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}).method = Method::kExact;
  AddForce(&animation, 11, 12,
           PushForce{{GroupOf(animation, "l_elbow"), Vec3::Zero()}, Vec3::UnitX()});
  const Error error = BakeError(animation);
  EXPECT_EQ(error.place, "forces[0]");
  EXPECT_NE(error.message.find("no region moves \"l_elbow\" in frame 11"), std::string::npos);
}

}  // namespace
}  // namespace hazumi::test
