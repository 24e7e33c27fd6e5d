// An arm some of whose joints follow keys, one of which has a torque, and some of which are loose,
// beside MuJoCo: its equations for the loose joints, with all others moved as the keys say.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/compare.h"
#include "tests/support/mujoco_figure.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::test {
namespace {

// One cubic over the whole second.
struct Cubic {
  double from = 0.0, rate_from = 0.0, to = 0.0, rate_to = 0.0;  // [rad or m, 1/s]
  Keys Keyed() const { return {{0, from, rate_from, kCubic}, {30, to, rate_to, kCubic}}; }
  double c() const { return 3.0 * (to - from) - 2.0 * rate_from - rate_to; }
  double d() const { return 2.0 * (from - to) + rate_from + rate_to; }
  double At(double t) const { return from + t * (rate_from + t * (c() + t * d())); }
  double RateAt(double t) const { return rate_from + t * (2.0 * c() + t * 3.0 * d()); }
  double AccelerationAt(double t) const { return 2.0 * c() + 6.0 * t * d(); }
};

struct Mixed {
  Animation animation;
  Cubic root_x, root_angle_y;
  std::vector<Cubic> curves;  // by joint
  std::vector<int> loose;     // by joint index, those that have a torque too
  int with_torque = -1;

  double TorqueAt(double t) const { return 3.0 * std::sin(2.0 * std::numbers::pi * t); }
};

// Chest and shoulder of the right arm, or its elbow, are keyed within the region, which has all
// beyond the chest's hinges on that side; the trunk and the root move by keys of their own.
Mixed Arm(const std::vector<std::string>& loose, const char* with_torque, double friction) {
  Mixed mixed{Still(LimberHuman()), {}, {}, {}, {}};
  Animation& animation = mixed.animation;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-7 * kDegree;
  const Figure& figure = *animation.figure;
  double value = 0.2;
  const auto next = [&value](double size) {
    value = std::fmod(value * 7.3 + 0.37, 1.0);
    return size * (value - 0.5);
  };
  for (int j = 0; j < figure.num_joints(); ++j) {
    mixed.curves.push_back({next(0.6), next(3.0), next(0.6), next(3.0)});
    animation.joint_keys[j] = mixed.curves.back().Keyed();
  }
  mixed.root_x = {0.0, 1.0, 0.4, -0.5};
  mixed.root_angle_y = {0.1, 1.0, -0.2, 0.5};
  animation.root_keys[kRootX] = mixed.root_x.Keyed();
  animation.root_keys[kRootAngleY] = mixed.root_angle_y.Keyed();
  mixed.with_torque = JointOf(animation, with_torque).value();

  DynamicsRegion& region = AddRegion(&animation, "arm", 0, 30, {});
  region.method = Method::kExact;
  for (const char* held : {"chest", "r_shoulder", "r_elbow", "r_wrist"}) {
    const JointGroup& group = figure.group(GroupOf(animation, held));
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      const bool is_loose = std::find(loose.begin(), loose.end(), held) != loose.end();
      (is_loose ? region.joints : region.keyed).emplace_back(j);
      if (is_loose) mixed.loose.push_back(j);
    }
  }
  region.friction.assign(region.joints.size(), friction);
  Drive drive;
  drive.joints = {JointIndex(mixed.with_torque)};
  for (int i = 0; i <= 300; ++i) {
    const double t = i / 300.0, rate = 6.0 * std::numbers::pi;
    drive.torque.push_back(
        {i / 10.0, mixed.TorqueAt(t), rate * std::cos(2.0 * std::numbers::pi * t)});
  }
  region.drives = {drive};
  return mixed;
}

// The loose joints, by Runge and Kutta in equal steps.
class MujocoArm {
 public:
  MujocoArm(const Mixed& mixed, double retention)
      : mixed_(mixed),
        figure_(*mixed.animation.figure, Vec3(0, 0, -mixed.animation.gravity)),
        retention_(retention),
        n_(static_cast<int>(mixed.loose.size())),
        y_(2 * n_) {
    for (int i = 0; i < n_; ++i) {
      y_[i] = mixed.curves[mixed.loose[i]].from;
      y_[n_ + i] = mixed.curves[mixed.loose[i]].rate_from;
    }
  }

  VecX angles() const { return y_.head(n_); }

  void Go(double t, double seconds, int steps) {
    const double h = seconds / steps;
    for (int i = 0; i < steps; ++i, t += h) {
      const VecX k1 = Derivative(t, y_), k2 = Derivative(t + 0.5 * h, y_ + 0.5 * h * k1),
                 k3 = Derivative(t + 0.5 * h, y_ + 0.5 * h * k2),
                 k4 = Derivative(t + h, y_ + h * k3);
      y_ += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
  }

 private:
  // M_ff x_f = torque - b_f - M_fp x_p, and what friction takes off the accelerations.
  VecX Derivative(double t, const VecX& y) {
    constexpr int kRoot = MujocoFigure::kRootDof;
    const auto joints = static_cast<int>(mixed_.curves.size());
    VecX q(kRoot + joints), qd(kRoot + joints), qdd(kRoot + joints);
    q.setZero();
    qd.setZero();
    qdd.setZero();
    const auto put = [&](int at, const Cubic& curve) {
      q[at] = curve.At(t);
      qd[at] = curve.RateAt(t);
      qdd[at] = curve.AccelerationAt(t);
    };
    put(0, mixed_.root_x);
    put(4, mixed_.root_angle_y);
    for (int j = 0; j < joints; ++j) put(kRoot + j, mixed_.curves[j]);
    for (int i = 0; i < n_; ++i) {
      const int at = kRoot + mixed_.loose[i];
      q[at] = y[i];
      qd[at] = y[n_ + i];
      qdd[at] = 0.0;
    }
    figure_.SetState(q, qd);
    const MatX M = figure_.InertiaMatrix();
    const VecX rest = -figure_.Bias() - M * qdd;
    MatX M_ff(n_, n_);
    VecX f(n_);
    for (int i = 0; i < n_; ++i) {
      f[i] = rest[kRoot + mixed_.loose[i]];
      if (mixed_.loose[i] == mixed_.with_torque) f[i] += mixed_.TorqueAt(t);
      for (int k = 0; k < n_; ++k) M_ff(i, k) = M(kRoot + mixed_.loose[i], kRoot + mixed_.loose[k]);
    }
    VecX dy(2 * n_);
    dy << y.tail(n_), VecX(M_ff.ldlt().solve(f)) - retention_ * y.tail(n_);
    return dy;
  }

  const Mixed& mixed_;
  MujocoFigure figure_;
  double retention_;  // [1/s]
  int n_;
  VecX y_;
};

void ExpectAsMujoco(const Mixed& mixed, double friction, int frames, const char* claim) {
  const Motion motion = BakeOrFail(mixed.animation);
  EXPECT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  MujocoArm arm(mixed, -30.0 * std::log(friction));
  Worst worst(claim);
  double moved = 0.0;
  for (int frame = 1; frame <= frames; ++frame) {
    arm.Go((frame - 1) / 30.0, 1.0 / 30.0, 160);
    const VecX angles = arm.angles();
    for (size_t i = 0; i < mixed.loose.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      worst(std::abs(motion.frames[frame].before.q[mixed.loose[i]] - angles[at]));
      moved = std::max(moved, std::abs(angles[at] - mixed.curves[mixed.loose[i]].from));
    }
    for (int j = 0; j < static_cast<int>(mixed.curves.size()); ++j) {
      if (std::find(mixed.loose.begin(), mixed.loose.end(), j) != mixed.loose.end()) continue;
      EXPECT_NEAR(motion.frames[frame].before.q[j], mixed.curves[j].At(frame / 30.0), 1e-12);
    }
  }
  std::printf("  %s: %.2g rad, of up to %.1f that joints turn\n", claim, worst.value(), moved);
  EXPECT_LT(worst.value(), 1e-5) << claim;
  EXPECT_GT(moved, 1.0);
}

TEST(MixedDrive, AnElbowByTorqueAndALooseWristOnAKeyedShoulderMoveAsInMujoco) {
  for (const double friction : {1.0, 0.9}) {
    ExpectAsMujoco(Arm({"r_elbow", "r_wrist"}, "r_elbow_flexion", friction), friction, 30,
                   "elbow by torque, wrist loose");
  }
}

// The shoulder feels what the keys do beyond it. After that its hinges line up, where a torque
// about one of them is another thing than about that axis.
TEST(MixedDrive, AShoulderByTorqueAndALooseWristAroundAKeyedElbowMoveAsInMujoco) {
  ExpectAsMujoco(Arm({"r_shoulder", "r_wrist"}, "r_shoulder_flexion", 0.8), 0.8, 12,
                 "shoulder by torque, elbow by keys");
}

}  // namespace
}  // namespace hazumi::test
