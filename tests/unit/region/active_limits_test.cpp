#include "engine/region/exact/active_limits.h"

#include <gtest/gtest.h>

#include "tests/support/compare.h"
#include "tests/unit/region/model_case.h"

namespace hazumi::test {
namespace {

constexpr double kLeaving = 1e-10;  // slower than what counts as at rest [rad/s]

// A blow to hinges that are at their limits on one side: the first hinge goes out, or has no room
// and moves either way.
struct Strike {
  int side;
  bool has_room;
  double rate;  // of the first hinge [rad/s]
};

// Rates after it, where the others are at rest or leave at `rate` [rad/s].
VecX RatesAfter(const Strike& strike, const ModelCase& c, RegionDynamics* dynamics, double rate) {
  const VecX q = Gather(*dynamics, c.q);
  const auto n = q.size();
  VecX far = VecX::Constant(n, -10.0 * strike.side);
  if (!strike.has_room) far[0] = q[0];
  const LimitRange range(strike.side > 0 ? far : q, strike.side > 0 ? q : far);
  HingeState state(q, VecX::Constant(n, -strike.side * rate));
  state.qd[0] = strike.rate;
  ActiveLimits limits(dynamics, &range);
  ImpactLog log(static_cast<int>(n));
  limits.Begin();
  limits.Resolve(c.t, /*later=*/nullptr, &state, &log);
  return state.qd;
}

TEST(ActiveLimits, ImpactPushesOffWhatLeavesSlowlyLikeWhatIsAtRest) {
  Worst worst("rates after an impact, where others leave slowly");
  for (const Strike& strike : {Strike{1, true, 1.0}, Strike{-1, true, -1.0}, Strike{1, false, 1.0},
                               Strike{1, false, -1.0}}) {
    int pushed = 0;
    for (uint64_t seed = 0; seed < kSamples; ++seed) {
      const ModelCase c(seed, RootCoupling::kPrescribed, /*is_root_free=*/false);
      for (RegionDynamics& dynamics : c.Models()) {
        const VecX from_rest = RatesAfter(strike, c, &dynamics, 0.0);
        const VecX leaving = RatesAfter(strike, c, &dynamics, kLeaving);
        EXPECT_LE(worst((leaving - from_rest).lpNorm<Eigen::Infinity>()), 1e-6) << "seed " << seed;
        pushed += (-strike.side * from_rest).maxCoeff() > 1e-3;
      }
    }
    EXPECT_GT(pushed, kSamples / 10);
  }
}

}  // namespace
}  // namespace hazumi::test
