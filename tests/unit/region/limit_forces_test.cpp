// What limits do to a large island, found from those at a limit alone, against the dense way.

#include "engine/region/exact/limit_forces.h"

#include <gtest/gtest.h>

#include "tests/support/compare.h"
#include "tests/support/random.h"
#include "tests/unit/region/model_case.h"

namespace hazumi::test {
namespace {

constexpr double kForceTolerance = 1e-8;

// One island of a random model, some of whose hinges are at limits.
struct Stopped {
  Stopped(const ModelCase& c, const RegionDynamics& dynamics, uint64_t seed)
      : t(c.t), state(Gather(dynamics, c.q), Gather(dynamics, c.qd)) {
    Random random(seed);
    for (int i = 0; i < dynamics.num_hinges(); ++i) side.push_back(random.Integer(-1, 1));
    v_pin = random.Vector3(1.0);
  }
  std::vector<char> none() const { return std::vector<char>(side.size(), 0); }
  std::vector<char> at_limit() const {
    std::vector<char> held;
    for (const int s : side) held.push_back(s != 0);
    return held;
  }

  double t;
  HingeState state;
  Vec3 v_pin;
  std::vector<int> side;
};

struct Answers {
  VecX held, rested, after;  // torques, torques, rates
  std::vector<char> stays;
};

Answers Ask(const Stopped& s, bool with_pin, RegionDynamics* dynamics) {
  LimitForces limits(dynamics);
  Answers answers;
  limits.Hold(s.t, s.state, s.at_limit());
  answers.held = limits.T();
  answers.stays = s.none();
  limits.Rest(s.t, s.state, s.side, s.none(), &answers.stays);
  answers.rested = limits.T();
  HingeState after = s.state;
  if (with_pin) after.pin_velocity = s.v_pin;
  limits.Impact(s.t, s.side, s.none(), &after);
  answers.after = after.qd;
  return answers;
}

void ExpectSameForces(const char* claim, RootCoupling coupling) {
  Worst worst(claim);
  int struck = 0;
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    const ModelCase c(seed, coupling, /*is_root_free=*/false);
    for (RegionDynamics& dynamics : c.Models()) {
      const Stopped stopped(c, dynamics, seed);
      const bool with_pin = coupling == RootCoupling::kPinned;
      const Answers dense = Ask(stopped, with_pin, &dynamics);
      dynamics.SetMostDense(0);
      ASSERT_TRUE(dynamics.is_large());
      const Answers some = Ask(stopped, with_pin, &dynamics);
      EXPECT_LE(worst(RelativeDifference(some.held, dense.held)), kForceTolerance)
          << "seed " << seed;
      EXPECT_EQ(some.stays, dense.stays) << "seed " << seed;
      EXPECT_LE(worst(RelativeDifference(some.rested, dense.rested)), kForceTolerance)
          << "seed " << seed;
      EXPECT_LE(worst(RelativeDifference(some.after, dense.after)), kForceTolerance)
          << "seed " << seed;
      struck += (dense.after - stopped.state.qd).norm() > 0.0;
    }
  }
  EXPECT_GT(struck, kSamples / 2);
}

TEST(LimitForces, AreThoseOfTheDenseWayOnARootThatMovesAsItIsTold) {
  ExpectSameForces("limits, prescribed", RootCoupling::kPrescribed);
}

TEST(LimitForces, AreThoseOfTheDenseWayInFlight) {
  ExpectSameForces("limits, flight", RootCoupling::kFlight);
}

TEST(LimitForces, AreThoseOfTheDenseWayOnAPin) {
  ExpectSameForces("limits, pinned", RootCoupling::kPinned);
}

}  // namespace
}  // namespace hazumi::test
