// Forces from outside, whole bakes: motions in closed form, and what momentum and energy say.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "engine/dynamics/kinematics.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/momentum.h"
#include "tests/unit/bake/force_cases.h"

namespace hazumi::test {
namespace {

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

// v = v_end tanh(g t / v_end),  v_end = sqrt(2 m g / (rho A C_D)) = 3.0423 m/s
TEST(ForceBake, APlateThatFallsFlatReachesItsLastSpeed) {
  FigureSpec spec;
  spec.name = "plate";
  spec.root_name = "plate";
  spec.root_links = {Rod("plate", -0.1 * Vec3::UnitX(), 0.1 * Vec3::UnitX())};
  spec.root_links[0].mass = 0.1;
  LinkSurface surface;
  surface.area = 0.05;
  surface.normal = Vec3::UnitZ();
  surface.kind = LinkSurface::Kind::kTable;
  surface.lift = {0.0};
  surface.drag = {3.461};
  spec.root_links[0].surface = surface;
  JointSpec tip;
  tip.name = "tip";
  tip.parent = "plate";
  tip.hinges = {{"", Vec3::UnitY(), 0.0, 0.0, 0.0}};
  spec.joints = {tip};
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  animation.last_frame = 90;
  AddGravity(&animation, 0, 90);
  FreeAll(&animation);
  animation.regions[0].last_frame = 90;
  AddForce(&animation, 0, 90, WindForce{Vec3::Zero(), kAir});
  const Motion motion = BakeOrFail(animation);
  const double end = std::sqrt(2.0 * 0.1 * kG / (kAir * surface.area * 3.461));
  for (const MotionFrame& frame : motion.frames) {
    const double expected = -end * std::tanh(kG * frame.frame / 30.0 / end);
    EXPECT_NEAR(frame.before.root_v.z(), expected, 1e-8) << frame.frame;
  }
  EXPECT_NEAR(motion.frames[90].before.root_v.z(), -3.0423, 0.001 * 3.0423);
  RecordProperty("last_speed", std::to_string(-motion.frames[90].before.root_v.z()));
}

constexpr int kFramesOfBeat = 24, kBeats = 8;
constexpr double kBeatRate = 42.0, kStroke = 120.0 * kDegree, kSpan = 0.047;  // [Hz, rad, m]

// A heavy body with two wings that weigh next to nothing, each on a hinge that sweeps it and one
// along it that turns it over.
JointSpec SweepOf(const std::string& side) {
  JointSpec sweep;
  sweep.name = side + "_sweep";
  sweep.parent = "body";
  sweep.hinges = {{"", Vec3::UnitZ(), -2.0, 2.0, 0.0}};
  return sweep;
}
JointSpec PitchOf(const std::string& side) {
  JointSpec pitch;
  pitch.name = side + "_pitch";
  pitch.parent = side + "_sweep";
  pitch.hinges = {{"", Vec3::UnitY(), -2.0, 2.0, 0.0}};
  const Vec3 tip = (side == "l" ? kSpan : -kSpan) * Vec3::UnitY();
  LinkSpec wing = Rod((side + "_wing").c_str(), Vec3::Zero(), tip);
  wing.radius = 0.001;
  wing.mass = 1e-6;
  LinkSurface surface;
  surface.kind = LinkSurface::Kind::kWing;
  surface.area = 5.5e-4;
  surface.normal = Vec3::UnitZ();
  surface.center = 0.5 * tip;
  wing.surface = surface;
  pitch.links = {wing};
  return pitch;
}

// To and fro in a circle; turned over within a frame of where it turns back.
Keys SweepKeys(double sign) {
  Keys keys;
  for (int i = 0; i <= kFramesOfBeat * kBeats; ++i) {
    const double phase = 2.0 * M_PI * i / kFramesOfBeat, rate = 2.0 * M_PI * kBeatRate;
    keys.push_back({1.0 * i, 0.5 * sign * kStroke * std::sin(phase),
                    0.5 * sign * kStroke * rate * std::cos(phase), kCubic});
  }
  return keys;
}
Keys PitchKeys() {
  Keys keys = {{0, -45.0 * kDegree, 0.0, kCubic}};
  double pitch = -45.0 * kDegree;
  for (double turn = 0.25 * kFramesOfBeat; turn < kFramesOfBeat * kBeats;
       turn += 0.5 * kFramesOfBeat) {
    keys.push_back({turn - 0.5, pitch, 0.0, kCubic});
    pitch = -pitch;
    keys.push_back({turn + 0.5, pitch, 0.0, kCubic});
  }
  return keys;
}

// The mean lift, from what the body gains in eight beats:
//   rho C_L S (r_2 R)^2 (pi f Phi)^2 / 2 = 25.6 mN.
TEST(ForceBake, TwoWingsThatBeatLiftTheBodyTheyAreOn) {
  FigureSpec spec;
  spec.name = "fly";
  spec.root_name = "body";
  spec.root_links = {Rod("body", -0.2 * Vec3::UnitX(), 0.2 * Vec3::UnitX())};
  spec.root_links[0].mass = 10.0;
  LinkSurface none;  // no air presses on the body
  none.kind = LinkSurface::Kind::kTable;
  none.area = 1e-9;
  none.lift = none.drag = {0.0};
  spec.root_links[0].surface = none;
  spec.joints = {SweepOf("l"), PitchOf("l"), SweepOf("r"), PitchOf("r")};
  Animation animation = Exact(BuildFigure(spec).value(), 0.0);
  animation.solver.tolerance = 1e-6 * kDegree;
  animation.rate = FrameRate{static_cast<int>(kBeatRate) * kFramesOfBeat, 1};
  const int last = kFramesOfBeat * kBeats;
  animation.last_frame = last;
  AddGravity(&animation, 0, last);
  FreeAll(&animation);
  animation.regions[0].last_frame = last;
  KeysOf(&animation, "r_sweep") = SweepKeys(1.0);
  KeysOf(&animation, "l_sweep") = SweepKeys(-1.0);
  KeysOf(&animation, "r_pitch") = KeysOf(&animation, "l_pitch") = PitchKeys();
  AddForce(&animation, 0, last, WindForce{Vec3::Zero(), kAir});
  const Motion motion = BakeOrFail(animation);
  const double seconds = kBeats / kBeatRate;
  const double lift = animation.figure->total_mass() *
                      (motion.frames[last].before.root_v.z() - motion.frames[0].after.root_v.z()) /
                      seconds;
  const double C_L = 0.225 + 1.58 * std::sin((2.13 * 45.0 - 7.2) * kDegree);
  const double expected =
      kAir * C_L * 5.5e-4 * std::pow(0.5 * kSpan * M_PI * kBeatRate * kStroke, 2) / 2.0;
  std::printf("  mean lift %.3f mN, by its law %.3f mN\n", 1e3 * lift, 1e3 * expected);
  EXPECT_NEAR(expected, 25.6e-3, 0.005 * 25.6e-3);
  EXPECT_NEAR(lift, expected, 0.005 * expected);
}

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

// Into the radius and out of it again its energy stays, though the force has kinks there.
TEST(ForceBake, APullKeepsItsEnergyThroughItsRadius) {
  Animation animation = Flying(FreeRod(), 0.0);
  animation.solver.tolerance = 0.01 * kDegree;
  SetRoot(&animation, kRootX, 1.0, 0.0);
  AttractForce pull;
  pull.force = 40.0;
  pull.radius = 0.3;
  AddForce(&animation, 0, 30, pull);
  int inside = 0;
  for (const MotionFrame& frame : BakeOrFail(animation).frames) {
    const double distance = frame.X_WR.p.norm(), v = frame.after.root_v.norm();
    inside += distance < pull.radius;
    const double energy = 0.5 * kMass * v * v + PullEnergy(pull, distance);
    EXPECT_NEAR(energy, PullEnergy(pull, 1.0), 1e-6) << frame.frame;
  }
  EXPECT_GE(inside, 2);
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

// Forces of all kinds, edited and baked on: the same bits as baked anew.
TEST(ForceBake, AfterAnEditIsTheSameBits) {
  Animation animation = Exact(Human37(), kG);
  animation.solver.tolerance = 0.01 * kDegree;
  AddGravity(&animation, 2, 28);
  DynamicsRegion& region = AddRegion(&animation, "arm", 4, 24, {"r_shoulder"}, 0.9);
  region.method = Method::kExact;
  SetRoot(&animation, kRootZ, 5.0, 0.0);
  KeysOf(&animation, "r_knee") = {{0, 0.1, {}}, {12, 0.5, {}}, {30, 0.2, {}}};
  AttractForce pull;
  pull.at.joint = GroupOf(animation, "r_elbow");
  pull.force = 5.0;
  AddForce(&animation, 3, 20, WindForce{Vec3(9.0, 1.0, 0.0), kAir});
  AddForce(&animation, 6, 30, pull);
  AddForce(&animation, 10, 11, PushForce{{pull.at.joint, Vec3::Zero()}, Vec3(2.0, 1.0, 0.0)});
  IncrementalBake bake(animation);
  ExpectBakedAsAnew(&bake, animation);
  KeysOf(&animation, "r_knee")[1].value = 0.6;
  animation.regions[0].friction[0] = 0.7;
  bake.Update(animation);
  ExpectBakedAsAnew(&bake, animation);
  animation.forces[0].last_frame = 15;
  std::get<PushForce>(animation.forces[2].action).impulse.x() = 3.0;
  bake.Update(animation);
  ExpectBakedAsAnew(&bake, animation);
}

}  // namespace
}  // namespace hazumi::test
