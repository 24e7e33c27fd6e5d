#include "engine/region/exact/active_limits.h"

#include <gtest/gtest.h>

#include "tests/support/compare.h"
#include "tests/unit/region/model_case.h"

namespace hazumi::test {
namespace {

constexpr double kLeaving = 1e-10;  // slower than what counts as at rest [rad/s]

// All hinges at limits, at rest or leaving at `rate` [rad/s], but for the first, which goes out.
VecX RatesAfterImpact(const ModelCase& c, RegionDynamics* dynamics, double rate) {
  const VecX q = Gather(*dynamics, c.q);
  const auto n = q.size();
  const LimitRange range(VecX::Constant(n, -10.0), q);
  HingeState state(q, VecX::Constant(n, -rate));
  state.qd[0] = 1.0;
  ActiveLimits limits(dynamics, &range);
  ImpactLog log(static_cast<int>(n));
  limits.Begin();
  limits.Resolve(c.t, /*later=*/nullptr, &state, &log);
  return state.qd;
}

TEST(ActiveLimits, ImpactPushesOffWhatLeavesSlowlyLikeWhatIsAtRest) {
  Worst worst("rates after an impact, where others leave slowly");
  int pushed = 0;
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    const ModelCase c(seed, RootCoupling::kPrescribed, /*is_root_free=*/false);
    for (RegionDynamics& dynamics : c.Models()) {
      const VecX from_rest = RatesAfterImpact(c, &dynamics, 0.0);
      const VecX leaving = RatesAfterImpact(c, &dynamics, kLeaving);
      EXPECT_LE(worst((leaving - from_rest).lpNorm<Eigen::Infinity>()), 1e-6) << "seed " << seed;
      pushed += from_rest.minCoeff() < -1e-3;
    }
  }
  EXPECT_GT(pushed, kSamples / 10);
}

}  // namespace
}  // namespace hazumi::test
