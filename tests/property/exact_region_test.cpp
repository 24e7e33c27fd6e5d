// Random regions of random figures: does the exact method keep what it promises?
//
// In 99.9 of 100 regions the error against a tight reference is within the tolerance, and the
// region's own estimate is at least a tenth of the error; none fails. Regions for which two tight
// references differ are told apart by nothing but rounding (grazed limits, chaos): they are set
// aside, two in a hundred at most. Figures whose limits are out of reach and figures with limits,
// the shipped human's own among them, are tried by themselves, as many of either, so that neither
// kind makes up for the other. A plain ctest tries a few; a thousand of each are tried by `ctest -C
// Slow -L slow -R region -V`, which shows the tallies. HAZUMI_CASES says how many of each,
// HAZUMI_FIRST_CASE from which seed on.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "engine/bake/bake.h"
#include "engine/spatial/degrees.h"
#include "tests/property/random_region.h"
#include "tests/support/from_environment.h"

namespace hazumi::test {
namespace {

constexpr double kTolerance = 0.01;  // [deg]
constexpr double kChaos = 1e-4;      // references may differ by this much [deg]

struct Tally {
  int cases = 0, failed = 0, set_aside = 0, too_far = 0, underestimated = 0;
  double worst = 0.0, worst_ratio = 1e300;  // error [deg]; estimate by error
};

// `tolerance` in degrees.
Result<Motion> BakeAt(Animation animation, double tolerance) {
  animation.solver.tolerance = tolerance * kDegree;
  return Bake(animation);
}

// Without another try where the estimate is above the tolerance.
Result<Motion> ReferenceAt(Animation animation, double tolerance) {
  animation.solver.tolerance = tolerance * kDegree;
  BakeOptions options;
  options.refine = false;
  return Bake(animation, options);
}

double LargestErrorInDegrees(const Animation& animation, const Motion& motion,
                             const Motion& reference) {
  return LargestError(animation, motion, reference) / kDegree;
}

void PrintError(int seed, double error, double estimate) {
  std::printf("seed %d: error %g deg, estimate %g deg\n", seed, error, estimate);
}

void Judge(int seed, double error, double estimate, Tally* tally) {
  const bool is_too_far = !(error <= kTolerance), is_underestimated = !(estimate >= 0.1 * error);
  tally->too_far += is_too_far;
  tally->underestimated += is_underestimated;
  tally->worst = std::max(tally->worst, error);
  tally->worst_ratio = std::min(tally->worst_ratio, estimate / error);
  if (is_too_far || is_underestimated) PrintError(seed, error, estimate);
}

void Try(int seed, bool has_limits, Tally* tally) {
  const Animation animation = RandomRegion(seed, has_limits);
  ++tally->cases;
  const Result<Motion> motion = BakeAt(animation, kTolerance);
  const Result<Motion> one = ReferenceAt(animation, 1e-4 * kTolerance);
  const Result<Motion> two = ReferenceAt(animation, 1e-5 * kTolerance);
  for (const auto* result : {&motion, &one, &two}) {
    if (result->ok()) continue;
    std::printf("seed %d: %s\n", seed, result->error().ToString().c_str());
    ++tally->failed;
    return;
  }
  const double apart = LargestErrorInDegrees(animation, one.value(), two.value());
  if (!(apart <= kChaos)) {
    ++tally->set_aside;
    std::printf("seed %d set aside: references differ by %g deg\n", seed, apart);
    return;
  }
  Judge(seed, LargestErrorInDegrees(animation, motion.value(), two.value()),
        motion.value().regions[0].error_estimate / kDegree, tally);
}

void Expect(const Tally& tally) {
  std::printf(
      "%d cases, %d failed, %d set aside, %d beyond the tolerance, %d underestimated, worst error "
      "%g deg, worst ratio %g\n",
      tally.cases, tally.failed, tally.set_aside, tally.too_far, tally.underestimated, tally.worst,
      tally.worst_ratio);
  EXPECT_EQ(tally.failed, 0);
  EXPECT_LE(tally.set_aside, MostOf(tally.cases, 0.02));
  EXPECT_LE(tally.too_far, MostOf(tally.cases, 0.001));
  EXPECT_LE(tally.underestimated, MostOf(tally.cases, 0.001));
}

void TryAll(bool has_limits) {
  Tally tally;
  for (const int seed : RandomCases(1, 100)) Try(seed, has_limits, &tally);
  Expect(tally);
}

TEST(ExactRegion, OfFiguresWithoutLimitsKeepsItsToleranceAndKnowsItsError) { TryAll(false); }

TEST(ExactRegion, OfFiguresWithLimitsKeepsItsToleranceAndKnowsItsError) { TryAll(true); }

// Found among ten thousand: outer hinges that whip round past a pole, meet their limits there or
// are let go at it, impacts next to it, contacts and pulls too brief to be seen, friction that
// outruns steps.
TEST(ExactRegion, KeepsItsToleranceAtPolesInBriefContactsAndUnderFriction) {
  Tally tally;
  for (const int seed : {147, 169, 612, 985, 1071, 1170, 1250, 2296, 2414, 2721, 2843, 3111, 3659,
                         3745, 3818, 3837, 4161, 4465, 9018}) {
    Try(seed, true, &tally);
  }
  for (const int seed : {727, 1484, 3407, 4167}) Try(seed, false, &tally);
  Expect(tally);
}

}  // namespace
}  // namespace hazumi::test
