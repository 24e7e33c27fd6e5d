// Random regions of random figures: does the exact method keep what it promises?

#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

#include "engine/bake/baker.h"
#include "tests/property/random_region.h"

namespace hazumi::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTolerance = 0.01 * kDegree;
constexpr double kChaos = 1e-4 * kDegree;  // references may differ by this much

// HAZUMI_CASES regions, else a hundred.
int NumCases() {
  const char* text = std::getenv("HAZUMI_CASES");
  return text ? std::atoi(text) : 100;
}

struct Tally {
  int cases = 0, failed = 0, set_aside = 0, too_far = 0, underestimated = 0;
  double worst = 0.0, worst_ratio = 1e300;  // error [rad]; estimate by error
};

Result<Motion> BakeAt(Animation animation, double tolerance) {
  animation.solver.tolerance = tolerance;
  return Bake(animation);
}

// Without another try where the estimate is above the tolerance.
Result<Motion> ReferenceAt(Animation animation, double tolerance) {
  animation.solver.tolerance = tolerance;
  return Baker(animation, {}, {1.0}).Run();
}

void Try(uint64_t seed, bool has_stops, Tally* tally) {
  const Animation animation = RandomRegion(seed, has_stops);
  ++tally->cases;
  const Result<Motion> motion = BakeAt(animation, kTolerance);
  const Result<Motion> one = ReferenceAt(animation, 1e-4 * kTolerance);
  const Result<Motion> two = ReferenceAt(animation, 1e-5 * kTolerance);
  if (!motion.ok() || !one.ok() || !two.ok()) {
    ++tally->failed;
    for (const auto* result : {&motion, &one, &two}) {
      if (!result->ok()) printf("seed %d: %s\n", int(seed), result->error().ToString().c_str());
    }
    return;
  }
  if (!(LargestError(animation, one.value(), two.value()) <= kChaos)) {
    ++tally->set_aside;
    printf("seed %d set aside: references differ by %g deg, estimates %g %g %g\n", int(seed),
           LargestError(animation, one.value(), two.value()) / kDegree,
           motion.value().regions[0].error_estimate / kDegree,
           one.value().regions[0].error_estimate / kDegree,
           two.value().regions[0].error_estimate / kDegree);
    return;
  }
  const double error = LargestError(animation, motion.value(), two.value());
  const double estimate = motion.value().regions[0].error_estimate;
  tally->worst = std::max(tally->worst, error);
  tally->worst_ratio = std::min(tally->worst_ratio, estimate / error);
  if (error > kTolerance) {
    ++tally->too_far;
    printf("seed %d: error %g deg\n", int(seed), error / kDegree);
  }
  if (estimate < 0.1 * error) {
    ++tally->underestimated;
    printf("seed %d: error %g deg, estimate %g deg\n", int(seed), error / kDegree,
           estimate / kDegree);
  }
}

TEST(ExactRegion, OfRandomFiguresKeepsItsToleranceAndKnowsItsError) {
  Tally tally;
  for (uint64_t seed = 1; tally.cases < NumCases(); ++seed) Try(seed, false, &tally);
  printf(
      "%d cases, %d failed, %d set aside, %d beyond the tolerance, %d underestimated, worst %g "
      "deg, worst ratio %g\n",
      tally.cases, tally.failed, tally.set_aside, tally.too_far, tally.underestimated,
      tally.worst / kDegree, tally.worst_ratio);
  EXPECT_EQ(tally.failed, 0);
  EXPECT_LE(tally.set_aside, tally.cases / 50);
  EXPECT_LE(tally.too_far, tally.cases / 1000);
  EXPECT_LE(tally.underestimated, tally.cases / 1000);
}

}  // namespace
}  // namespace hazumi::test
