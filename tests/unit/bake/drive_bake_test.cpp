// What drives do to a motion, beside motions in closed form.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/odd_figures.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFarAway = 1e6;  // no limit [rad]

// A figure let go without gravity for one second.
Animation Weightless(Figure figure, const std::vector<const char*>& joints, double friction = 1.0) {
  Animation animation = Still(std::move(figure));
  animation.gravity = 0.0;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-7 * kDegree;
  AddRegion(&animation, "driven", 0, 30, joints, friction).method = Method::kExact;
  return animation;
}

// One rod about its end.
Animation Rod(double friction = 1.0) {
  Animation animation = Weightless(RodWithin(-kFarAway, kFarAway), {}, friction);
  animation.regions[0].joints = {JointIndex(0)};
  animation.regions[0].friction = {friction};
  return animation;
}

double InertiaOfRod(const Animation& animation) {
  const RigidInertia& body = animation.figure->body(JointIndex(0));
  return body.I_com(1, 1) + body.mass * body.com.squaredNorm();
}

// sin(2 pi t) [N m], as cubics with the right values and rates at ten keys a frame.
Keys SineOfTime() {
  Keys keys;
  for (int i = 0; i <= 300; ++i) {
    const double angle = 2.0 * kPi * i / 300.0;
    keys.push_back({i / 10.0, std::sin(angle), 2.0 * kPi * std::cos(angle)});
  }
  return keys;
}

Drive& AddDrive(Animation* animation, DriveKind kind) {
  DynamicsRegion& region = animation->regions[0];
  Drive drive;
  drive.kind = kind;
  drive.joints = region.joints;
  region.drives.push_back(drive);
  return region.drives.back();
}

Drive& AddSpring(Animation* animation, SpringTarget target, double frequency, double damping) {
  Drive& drive = AddDrive(animation, DriveKind::kSpring);
  drive.target = target;
  drive.frequency = frequency;
  drive.damping_ratio = damping;
  return drive;
}

Mat3 RotationFromHinges(const VecX& q) {
  return (Eigen::AngleAxisd(q[0], Vec3::UnitY()) * Eigen::AngleAxisd(q[1], Vec3::UnitX()) *
          Eigen::AngleAxisd(q[2], Vec3::UnitZ()))
      .toRotationMatrix();
}

double LastAngle(const Motion& motion) { return motion.frames.back().q[0]; }

// theta(1) = (1 / I) / (2 pi).
TEST(TorqueDrive, TurnsARodAsTheCurveSays) {
  Animation animation = Rod();
  AddDrive(&animation, DriveKind::kTorque).torque = SineOfTime();
  const double expected = 1.0 / (2.0 * kPi * InertiaOfRod(animation));
  EXPECT_NEAR(expected / kDegree, 27.3567195834, 1e-2);  // a little thicker than a line
  EXPECT_NEAR(LastAngle(BakeOrFail(animation)) / kDegree, expected / kDegree, 1e-6);
}

// theta'' = sin(w t) / I - c theta',  theta(1) = (w / c) (1 - e^-c) / (I (c^2 + w^2)),  w = 2 pi.
TEST(TorqueDrive, WorksAgainstFriction) {
  Animation animation = Rod(0.8);
  AddDrive(&animation, DriveKind::kTorque).torque = SineOfTime();
  const double c = -30.0 * std::log(0.8), w = 2.0 * kPi;
  const double expected =
      w / c * (1.0 - std::exp(-c)) / (InertiaOfRod(animation) * (c * c + w * w));
  EXPECT_NEAR(expected / kDegree, 1.9115824114, 1e-3);
  EXPECT_NEAR(LastAngle(BakeOrFail(animation)) / kDegree, expected / kDegree, 1e-6);
}

// The same of a rod that is as thin as a line, I = 1/3 kg m^2.
TEST(TorqueDrive, TurnsALineByTheFiguresOfItsLaw) {
  FigureSpec spec;
  spec.name = "line";
  spec.root_name = "base";
  JointSpec end;
  end.name = "hinge";
  end.parent = "base";
  end.hinges = {{"", Vec3::UnitY(), -kFarAway, kFarAway, 0.0}};
  end.links = {Lump("rod", 1.0, 0.5 * Vec3::UnitX(), 1.0 / 12.0)};
  spec.joints = {end};
  for (const bool has_friction : {false, true}) {
    Animation animation = Weightless(Build(spec), {"hinge"}, has_friction ? 0.8 : 1.0);
    AddDrive(&animation, DriveKind::kTorque).torque = SineOfTime();
    EXPECT_NEAR(InertiaOfRod(animation), 1.0 / 3.0, 1e-15);
    const double expected = has_friction ? 1.9115824114 : 27.3567195834;
    const double angle = LastAngle(BakeOrFail(animation)) / kDegree;
    std::printf("  %.10f degrees, by the law %.10f\n", angle, expected);
    EXPECT_NEAR(angle, expected, 1e-6);
  }
}

// A step of torque at frame 7.5, off all frames: theta(1) = (1 / 2 I) 0.75^2.
TEST(TorqueDrive, StepsWhereItsKeysDo) {
  Animation animation = Rod();
  AddDrive(&animation, DriveKind::kTorque).torque = {{0, 0.0, {}, Interpolation::kHold},
                                                     {7.5, 1.0, {}, Interpolation::kHold}};
  const double expected = 0.5 * 0.75 * 0.75 / InertiaOfRod(animation);
  EXPECT_NEAR(LastAngle(BakeOrFail(animation)), expected, 1e-10);
}

// Any torques on arms that swing: their work is what the energy account says it is.
TEST(TorqueDrive, ItsWorkIsAccountedFor) {
  Animation animation = Still(Human37());
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9 * kDegree;
  AddRegion(&animation, "arms", 0, 30, {"r_shoulder_x"}, 0.9).method = Method::kExact;
  double torque = 3.0;
  for (const JointIndex j : animation.regions[0].joints) {
    Drive drive;
    drive.kind = DriveKind::kTorque;
    drive.joints = {j};
    drive.torque = {{0, torque, {}}, {11, -0.7 * torque, {}}, {22.5, 0.4 * torque, {}}};
    animation.regions[0].drives.push_back(drive);
    torque *= -0.4;
  }
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  const EnergyBalance energy = motion.regions[0].energy.value();
  ASSERT_EQ(energy.laws.size(), 2u);
  EXPECT_EQ(energy.laws[1].law, "torque");
  EXPECT_GT(std::abs(energy.laws[1].joules), 0.1);
  double turnover = std::abs(energy.kinetic_end) + std::abs(energy.limits);
  for (const auto& work : energy.laws) turnover += std::abs(work.joules);
  EXPECT_LE(std::abs(energy.residual()), 1e-6 * turnover);
}

// Of both arms of the shipped human, which hit their limits, by whatever curves.
TEST(TorqueDrive, ItsWorkIsAccountedForOverLimits) {
  const Figure human =
      BuildFigure(LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json").value()).value();
  size_t hits = 0;
  Worst worst("account_log10_of_the_turnover");
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    Animation animation = Still(human);
    animation.solver.method = Method::kExact;
    animation.solver.tolerance = 1e-9 * kDegree;
    AddRegion(&animation, "arms", 0, 30, {"r_shoulder", "l_shoulder"}, 0.9).method = Method::kExact;
    for (const JointIndex j : animation.regions[0].joints) {
      Drive drive;
      drive.joints = {j};
      for (const double frame : {0.0, 7.3, 16.0, 22.5, 30.0}) {
        drive.torque.push_back({frame, random.Uniform(-4.0, 4.0), {}});
      }
      animation.regions[0].drives.push_back(drive);
    }
    const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
    hits += EventsOf(motion, EventKind::kLimit).size();
    const EnergyBalance energy = motion.regions[0].energy.value();
    double turnover = std::abs(energy.kinetic_end) + std::abs(energy.limits);
    for (const auto& work : energy.laws) turnover += std::abs(work.joules);
    EXPECT_LE(worst(std::abs(energy.residual()) / turnover), 1e-6) << seed;
  }
  std::printf("  %zu limits hit, open by %.1g of the turnover\n", hits, worst.value());
  EXPECT_GT(hits, 20u);
}

// By the paper's steps: y' <- y' + T / I dt, y <- y + y' dt, with T at the start of each.
TEST(TorqueDrive, ActsInThePapersSteps) {
  Animation animation = Rod();
  animation.solver.method = Method::kPaper;
  animation.regions[0].method = Method::kPaper;
  AddDrive(&animation, DriveKind::kTorque).torque = SineOfTime();
  const double inertia = InertiaOfRod(animation), dt = 1.0 / 30.0;
  double angle = 0.0, rate = 0.0;
  for (int i = 0; i < 30; ++i) {
    rate += std::sin(2.0 * kPi * i * dt) / inertia * dt;
    angle += rate * dt;
  }
  EXPECT_NEAR(LastAngle(BakeOrFail(animation)), angle, 1e-9);
}

// q = e^(-z w t) (cos(d t) + z w / d sin(d t)) q_0,  d = w sqrt(1 - z^2).
TEST(SpringDrive, SwingsAsADampedOscillator) {
  Animation animation = Rod();
  KeysOf(&animation, animation.figure->joints()[0].name.c_str()) = {{0, 0.5, 0.0}};
  AddSpring(&animation, SpringTarget::kRest, 2.0, 0.3);
  const double w = 4.0 * kPi, z = 0.3, d = w * std::sqrt(1.0 - z * z);
  for (const MotionFrame& frame : BakeOrFail(animation).frames) {
    const double t = frame.frame / 30.0;
    const double expected =
        0.5 * std::exp(-z * w * t) * (std::cos(d * t) + z * w / d * std::sin(d * t));
    EXPECT_NEAR(frame.q[0] / kDegree, expected / kDegree, 1e-5) << frame.frame;
  }
}

// By the paper's steps one of more than 1 / (pi h) Hz, undamped, swings ever wider: 9.55 Hz here.
TEST(SpringDrive, IsUnstableInThePapersStepsAboveAFrequency) {
  const auto widest = [](double frequency) {
    Animation animation = Rod();
    animation.solver.method = animation.regions[0].method = Method::kPaper;
    KeysOf(&animation, animation.figure->joints()[0].name.c_str()) = {{0, 0.01, 0.0}};
    AddSpring(&animation, SpringTarget::kRest, frequency, 0.0);
    double most = 0.0;
    for (const MotionFrame& frame : BakeOrFail(animation).frames) {
      most = std::max(most, std::abs(frame.q[0]));
    }
    return most;
  };
  EXPECT_LT(widest(9.0), 0.05);
  EXPECT_GT(widest(10.0), 1.0);
}

// While it pulls as hard as it may: a parabola, q = q_0 - most t^2 / (2 I).
TEST(SpringDrive, PullsNoHarderThanItMay) {
  Animation animation = Rod();
  KeysOf(&animation, animation.figure->joints()[0].name.c_str()) = {{0, 2.0, 0.0}};
  AddSpring(&animation, SpringTarget::kRest, 5.0, 1.0).max_torque = 0.2;
  const double inertia = InertiaOfRod(animation);
  for (const MotionFrame& frame : BakeOrFail(animation).frames) {
    const double t = frame.frame / 30.0;
    EXPECT_NEAR(frame.q[0], 2.0 - 0.1 * t * t / inertia, 1e-8) << frame.frame;
  }
}

// To and fro, most of the way as hard as it may: its energy stays, though the torque has kinks.
TEST(SpringDrive, KeepsItsEnergyWhereItIsHeldDown) {
  constexpr double kMost = 2.0, kRate = 4.0 * kPi;
  Animation animation = Rod();
  animation.solver.tolerance = 0.01 * kDegree;
  KeysOf(&animation, animation.figure->joints()[0].name.c_str()) = {{0, 1.0, 0.0}};
  AddSpring(&animation, SpringTarget::kRest, 2.0, 0.0).max_torque = kMost;
  const double inertia = InertiaOfRod(animation), stiffness = inertia * kRate * kRate;
  const auto stored = [&](double q) {
    const double edge = kMost / stiffness, size = std::abs(q);
    return size < edge ? 0.5 * stiffness * q * q : kMost * (size - 0.5 * edge);
  };
  for (const MotionFrame& frame : BakeOrFail(animation).frames) {
    const double rate = frame.after.qd[0];
    EXPECT_NEAR(0.5 * inertia * rate * rate + stored(frame.q[0]), stored(1.0), 1e-6) << frame.frame;
  }
}

// A rod held level weighs m g l / 2 on its hinge: with muscles that give 1 % more it is lifted,
// with 1 % less it sinks, whatever the spring would pull. Half of twice the strength is the same.
TEST(SpringDrive, IsAsStrongAsItsMuscles) {
  for (const double share : {1.0, 0.5}) {
    for (const double of_weight : {0.99, 1.01}) {
      const double weight = 1.0 * kG * 0.5;  // [N m]
      Animation animation = Weightless(StrongRod(of_weight * weight / share), {"hinge"});
      animation.gravity = kG;
      animation.joint_keys[0] = {{0, 0.0, 0.0}};
      AddSpring(&animation, SpringTarget::kRest, 20.0, 1.0).strength = share;
      const Motion motion = BakeOrFail(animation);
      const double moved = motion.frames[6].q[0] * (of_weight > 1.0 ? -1.0 : 1.0);
      EXPECT_GT(moved, 1e-4) << of_weight << " " << share;
    }
  }
}

TEST(SpringDrive, ToTheStartStaysThere) {
  Animation animation = Rod();
  KeysOf(&animation, animation.figure->joints()[0].name.c_str()) = {{0, 0.5, 0.0}, {30, 2.0, {}}};
  AddSpring(&animation, SpringTarget::kStart, 2.0, 1.0);
  for (const MotionFrame& frame : BakeOrFail(animation).frames) EXPECT_NEAR(frame.q[0], 0.5, 1e-9);
}

// A stiff spring to keys lags behind them by 2 zeta q'' / w^2 at most or so; it starts with their
// rate, and a spring without anything to accelerate it from them would stay on them.
TEST(SpringDrive, ToKeysFollowsThemTheCloserTheStiffer) {
  double last = 1.0;
  for (const double frequency : {1.0, 3.0, 10.0, 30.0}) {
    Animation animation = Rod();
    Keys& keys = KeysOf(&animation, animation.figure->joints()[0].name.c_str());
    keys = {{0, 0.0, {}}, {10, 0.6, {}}, {20, -0.3, {}}, {30, 0.2, {}}};
    AddSpring(&animation, SpringTarget::kKeys, frequency, 1.0);
    Animation keyed = animation;
    keyed.regions.clear();
    const Motion spring = BakeOrFail(animation), truth = BakeOrFail(keyed);
    double furthest = 0.0;
    for (size_t i = 0; i < truth.frames.size(); ++i) {
      furthest = std::max(furthest, std::abs(spring.frames[i].q[0] - truth.frames[i].q[0]));
    }
    EXPECT_LT(furthest, 0.5 * last) << frequency;
    last = furthest;
  }
  EXPECT_LT(last, 0.01);
}

// All of a body of one moment of inertia swings about a fixed axis as a pendulum does,
//   theta'' = -w^2 sin theta,
// here from 170 degrees away: the quaternion's spring goes through half a turn smoothly.
TEST(SpringDrive, OfABallIsSmoothThroughHalfATurn) {
  Animation animation = Weightless(RoundBall(), {"ball"});
  Keys& keys = animation.joint_keys[1];  // the middle hinge
  keys = {{0, 170.0 * kDegree, 0.0}};
  animation.joint_keys[0] = animation.joint_keys[2] = {{0, 0.0, 0.0}};
  AddSpring(&animation, SpringTarget::kRest, 1.0, 0.0);
  const Motion motion = BakeOrFail(animation);
  const double w = 2.0 * kPi;
  double angle = 170.0 * kDegree, rate = 0.0;
  constexpr int kSteps = 300;  // in a frame
  const double h = 1.0 / 30.0 / kSteps;
  const auto pull = [w](double x) { return -w * w * std::sin(x); };
  for (const MotionFrame& frame : motion.frames) {
    for (int i = 0; i < kSteps && frame.frame > 0.0; ++i) {  // Runge and Kutta
      const double k1 = pull(angle), k2 = pull(angle + 0.5 * h * rate),
                   k3 = pull(angle + 0.5 * h * rate + 0.25 * h * h * k1),
                   k4 = pull(angle + h * rate + 0.5 * h * h * k2);
      angle += h * rate + h * h / 6.0 * (k1 + k2 + k3);
      rate += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    const Mat3 R = RotationFromHinges(frame.q);
    EXPECT_NEAR(0.5 * (R.trace() - 1.0), std::cos(angle), 1e-6) << frame.frame;
  }
}

// Both methods agree where the paper's steps are short.
TEST(SpringDrive, OfABallIsTheSameInThePapersSteps) {
  Animation animation = Weightless(FreeArm7(), {});
  for (int j = 0; j < 7; ++j) animation.regions[0].joints.emplace_back(j);
  animation.regions[0].friction.assign(7, 1.0);
  for (Keys& keys : animation.joint_keys) keys = {{0, 0.4, 0.5}, {30, 0.1, {}}};
  AddSpring(&animation, SpringTarget::kKeys, 1.5, 0.5);
  const Motion exact = BakeOrFail(animation);
  animation.solver.method = animation.regions[0].method = Method::kPaper;
  animation.solver.step = 1e-4;
  const Motion paper = BakeOrFail(animation);
  for (size_t j = 0; j < 7; ++j) {
    EXPECT_NEAR(exact.frames[10].q[j], paper.frames[10].q[j], 2e-3) << j;
  }
}

// As if the region did not hold those joints, bit by bit; and all of them: as if there were none.
TEST(KeysDrive, OfAllJointsOfAFigureIsTheKeyframeAnimation) {
  Animation animation = Still(Human37());
  animation.solver.method = Method::kExact;
  double value = 0.1;
  for (Keys& keys : animation.joint_keys) {
    value = std::fmod(5.3 * value + 0.29, 1.0);
    keys = {{0, 0.3 * value, {}}, {10, -0.2 * value, 1.0}, {20, 0.4 * value, {}}, {30, 0.1, {}}};
  }
  animation.root_keys[kRootX] = {{0, 0.0, 1.0}, {30, 0.5, {}}};
  AddPin(&animation, 8, 22, "l_ankle");
  AddGravity(&animation, 22, 30);
  const Motion without = BakeOrFail(animation);
  DynamicsRegion& region = AddRegion(&animation, "all", 5, 25, {});
  region.method = Method::kExact;
  for (int j = 0; j < animation.figure->num_joints(); ++j) region.keyed.emplace_back(j);
  const Motion keyed = BakeOrFail(animation);
  for (size_t i = 0; i < keyed.frames.size(); ++i) {
    EXPECT_TRUE(IsSame(keyed.frames[i], without.frames[i])) << i;
  }
}

TEST(KeysDrive, IsTheKeyframeAnimation) {
  Animation animation = Still(Human37());
  animation.solver.method = Method::kExact;
  for (const char* joint : {"r_shoulder_x", "r_shoulder_y", "r_elbow_y"}) {
    KeysOf(&animation, joint) = {{0, 0.0, 1.0}, {10, 0.6, {}}, {20, -0.3, {}}, {30, 0.2, {}}};
  }
  DynamicsRegion& region = AddRegion(&animation, "arm", 5, 20, {"r_shoulder_x"}, 0.8);
  region.method = Method::kExact;
  Animation all = animation, none = animation;
  all.regions[0].keyed = all.regions[0].joints;
  all.regions[0].joints.clear();
  all.regions[0].friction.clear();
  none.regions.clear();
  const Motion keyed = BakeOrFail(all), without = BakeOrFail(none);
  for (size_t i = 0; i < keyed.frames.size(); ++i) {
    EXPECT_TRUE(IsSame(keyed.frames[i], without.frames[i])) << i;
  }
}

}  // namespace
}  // namespace hazumi::test
