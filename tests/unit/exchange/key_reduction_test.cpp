#include "engine/exchange/import/key_reduction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

// A few sines and a little noise, 1 high or so.
std::vector<double> RandomCurve(Random* random, int num_frames) {
  std::vector<double> values(num_frames, 0.0);
  const double noise = random->Uniform(0.0, 0.01);
  for (int s = 0; s < 4; ++s) {
    const double height = random->Uniform(0.0, 0.5), phase = random->Uniform(0.0, 6.0);
    const double speed = random->Uniform(0.01, 0.2);
    for (int f = 0; f < num_frames; ++f) values[f] += height * std::sin(phase + speed * f);
  }
  for (double& value : values) value += random->Uniform(-noise, noise);
  return values;
}

TEST(KeyReduction, StaysWithinItsToleranceWithFewerKeys) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<double> values = RandomCurve(&random, random.Integer(60, 400));
    const double tolerance = random.Uniform(0.03, 0.2);
    const std::vector<ReducedKey> keys = ReduceKeys(values, tolerance);
    EXPECT_LT(keys.size(), values.size() / 2);
    EXPECT_EQ(keys.front().frame, 0);
    EXPECT_EQ(keys.back().frame, static_cast<int>(values.size()) - 1);
    const std::vector<double> said = ValuesOf(keys);
    ASSERT_EQ(said.size(), values.size());
    for (size_t f = 0; f < values.size(); ++f) EXPECT_LE(std::abs(said[f] - values[f]), tolerance);
    for (const ReducedKey& key : keys) EXPECT_EQ(key.value, values[key.frame]);
  }
}

TEST(KeyReduction, OfAParabolaLeavesItsEnds) {
  std::vector<double> values;
  for (int f = 0; f < 50; ++f) values.push_back(0.02 * f * f - 0.7 * f + 3.0);
  EXPECT_EQ(ReduceKeys(values, 1e-9).size(), 2u);
}

TEST(KeyReduction, TakesClipsOfOneAndTwoFrames) {
  EXPECT_EQ(ValuesOf(ReduceKeys({2.5}, 0.1)), (std::vector<double>{2.5}));
  EXPECT_EQ(ValuesOf(ReduceKeys({2.5, 4.0}, 0.1)), (std::vector<double>{2.5, 4.0}));
}

TEST(KeyReduction, KeepsAStepWhateverItTakes) {
  std::vector<double> values(40, 0.0);
  std::fill(values.begin() + 20, values.end(), 1.0);
  const std::vector<double> said = ValuesOf(ReduceKeys(values, 0.01));
  for (size_t f = 0; f < values.size(); ++f) EXPECT_NEAR(said[f], values[f], 0.01);
}

}  // namespace
}  // namespace hazumi::test
