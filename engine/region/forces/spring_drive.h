#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/figure/strength.h"
#include "engine/region/forces/force_law.h"

namespace hazumi {

// A spring and its damper, beside the angle that it pulls to.
struct Spring {
  double rate = 0.0;  // 2 pi times the frequency, if that changes the greatest [rad/s]; 0: none
  double damping_ratio = 0.0;                             // 1: does not overshoot
  double most = std::numeric_limits<double>::infinity();  // torque or moment, at most [N m]
  // The same as a share of what muscles can give; not given: as much as it takes.
  std::optional<JointStrength> muscles;  // of a hinge
  double share = 0.0;
  // Of a ball joint, along its frame's axes either way, with all of its strength [N m].
  Vec3 most_forward = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 most_backward = Vec3::Constant(std::numeric_limits<double>::infinity());
  double inertia = 0.0;         // of a hinge: about its axis [kg m^2]
  Mat3 of_ball = Mat3::Zero();  // of a ball joint: about its centre, in the ball's frame
  // Of a ball joint.
  bool is_limited() const {
    return std::isfinite(most) || most_forward.array().isFinite().any() ||
           most_backward.array().isFinite().any();
  }
  // Which of SpringCurves it reads.
  bool reads_frequency = false, reads_share = false, has_ahead = false;
  bool lists_strength_kinks = false;  // SpringDrive::AppendKinks does
};
inline auto MembersOf(const Spring& spring) {
  const auto& [rate, damping_ratio, most, muscles, share, most_forward, most_backward, inertia,
               of_ball, reads_frequency, reads_share, has_ahead, lists_strength_kinks] = spring;
  return std::tie(rate, damping_ratio, most, muscles, share, most_forward, most_backward, inertia,
                  of_ball, reads_frequency, reads_share, has_ahead, lists_strength_kinks);
}

// 2 pi times a frequency [rad/s, Hz].
double RateOfFrequency(double frequency);

// What of a spring may change over time.
struct SpringNow {
  double rate, share;
};
// `frequency`, `share`: what SpringCurves says of them, where the spring reads it.
SpringNow NowOf(const Spring& spring, double frequency, double share);

// Of a hinge: its angle and rate, or those that the spring pulls it to [rad, rad/s].
struct HingeMotion {
  double angle, rate;
};
// What the spring would give, and between what that is held [N m].
struct HingePull {
  double pull, least, most;
};
// `ahead`: added to the pull before it is limited [N m].
HingePull PullOf(const Spring& spring, const SpringNow& now, const HingeMotion& hinge,
                 const HingeMotion& reference, double ahead);
double TorqueOf(const Spring& spring, const SpringNow& now, const HingeMotion& hinge,
                const HingeMotion& reference, double ahead);
// The moment that the spring would give a ball joint turned by E from what it pulls it to, with w
// the angular velocity relative to that; all in the ball's frame (BallAxes).
Vec3 PullOf(const Spring& spring, const SpringNow& now, const Mat3& E, const Vec3& w,
            const Vec3& ahead);
// How many times too large that is.
double ExcessOf(const Spring& spring, const SpringNow& now, const Vec3& pull);
// What of it is given.
Vec3 MomentOf(const Spring& spring, const SpringNow& now, const Mat3& E, const Vec3& w,
              const Vec3& ahead);

class SpringDrive;
struct SpringSpec {
  using Law = SpringDrive;
  static constexpr bool kIsOuter = false;
  std::vector<Spring> springs;  // by free hinge; that of a ball joint is its first hinge's
};
inline auto MembersOf(const SpringSpec& spec) {
  const auto& [springs] = spec;
  return std::tie(springs);
}

// Springs to angles over time, DrivenMotion::drives. [METHOD 2.6]
class SpringDrive : public ForceLaw {
 public:
  explicit SpringDrive(SpringSpec spec) : springs_(std::move(spec.springs)) {}

  std::string_view name() const override { return "spring"; }
  void AddForces(const RegionState& state, NodeKinematics* kinematics) const override;
  bool has_kinks() const override;
  // Differences of what it would give and what it may, and, where it gives all that muscles can,
  // what changes sign where their strength has a kink: at rest, and where it becomes the least.
  void AppendKinks(const RegionState& state, std::vector<double>* kinks) const override;
  // In a layout that locks no hinge.
  void ListSpent(const RegionState& state, std::vector<SpentDrive>* spent) const override;
  double FastestRate() const override;
  bool is_spring() const override { return true; }
  void ListSprings(const RegionState& state, std::vector<JointSpring>* springs) const override;
  Vec3 Limit(const RegionState& state, int node, const Vec3& moment) const override;

 private:
  // Of a ball joint, in its frame.
  struct BallPull {
    Mat3 R_WB, E;    // the latter from what it is pulled to
    Vec3 w, moment;  // against that
  };

  SpringNow Now(int hinge, const RegionState& state) const;
  bool Pulls(int node, const RegionState& state) const;
  BallPull PullOnBall(int node, const RegionState& state) const;
  small::V3 MomentOnBall(int node, const RegionState& state) const;
  struct AtHinge {
    int free;  // among the node's hinges that are
    const Spring& spring;
    HingePull pull;
    HingeMotion now, off;  // off: from where it is to where it is pulled
  };
  // action(at) for each that has one.
  template <typename Action>
  void ForEachHinge(int node, const RegionState& state, Action&& action) const;
  small::V3 MomentOnHinges(int node, const RegionState& state) const;
  static void AppendStrengthKinks(const AtHinge& at, std::vector<double>* kinks);
  JointSpring SpringOnBall(int node, const RegionState& state) const;
  JointSpring SpringOnHinges(int node, const RegionState& state) const;

  std::vector<Spring> springs_;
};

}  // namespace hazumi
