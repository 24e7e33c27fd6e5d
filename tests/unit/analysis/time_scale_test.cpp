#include "engine/analysis/time_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/flights.h"

namespace hazumi {
namespace {

TimeScale Judge(double gravity, double frame_time, double stature, bool scale_known) {
  return JudgeTime({{gravity, 0.01 * gravity, {}}}, frame_time, stature, scale_known, 9.81);
}

TEST(TimeScale, IsTrueWhereGravityIs) {
  const TimeScale time = Judge(9.5, 1.0 / 120.0, 1.7, true);
  EXPECT_EQ(time.verdict, TimeVerdict::kTrue);
  EXPECT_EQ(TimeSentence(time), "gravity is right within 8 %: the clip plays at its natural speed");
}

TEST(TimeScale, NamesTheCommonFrameTimeThatGravityCallsFor) {
  for (const int stated : {24, 30, 60, 120, 240}) {
    for (const int rate : {24, 25, 30, 60, 100, 120, 240}) {
      const double ratio = static_cast<double>(stated) / rate;  // of true to stated frame time
      const TimeScale time = Judge(9.81 * ratio * ratio, 1.0 / stated, 1.7, true);
      EXPECT_EQ(time.frame_rate, rate) << stated;
      EXPECT_NEAR(time.speed, ratio, 1e-12);
      EXPECT_EQ(time.verdict == TimeVerdict::kTrue, std::abs(ratio * ratio - 1.0) < 0.1);
    }
  }
}

TEST(TimeScale, SaysHowFastTheClipPlays) {
  EXPECT_EQ(TimeSentence(Judge(9.81 / 16.0, 1.0 / 30.0, 1.7, true)),
            "this clip plays at 1/4 speed (0.244 to 0.256): its frame time is probably 1/120 s, "
            "not 1/30 s");
  EXPECT_EQ(
      TimeSentence(Judge(9.81 * 16.0, 1.0 / 120.0, 1.7, true)),
      "this clip plays at 4 times its speed (3.91 to 4.09): its frame time is probably 1/30 s, not "
      "1/120 s");
  EXPECT_EQ(
      TimeSentence(Judge(9.81 * 0.64, 1.0 / 24.0, 1.7, true)),
      "this clip plays at 0.80 of its speed (0.782 to 0.818): its frame time is probably 1/30 s, "
      "not 1/24 s");
  EXPECT_EQ(TimeSentence(Judge(9.81 * 0.25, 1.0 / 24.0, 1.7, true)),
            "this clip plays at 1/2 speed (0.489 to 0.511): its frame time is about 0.0208 s, not "
            "1/24 s");
}

// A child, or a giant's bones: a guessed unit of length is doubted before the clip's time.
TEST(TimeScale, DoubtsAGuessedUnitOfLengthIfTheFigureStaysOfHumanHeight) {
  const TimeScale child = Judge(15.0, 1.0 / 120.0, 1.7, false);
  EXPECT_EQ(child.verdict, TimeVerdict::kWrongLength);
  EXPECT_NEAR(child.length_factor, 0.654, 1e-9);
  EXPECT_EQ(
      LengthSentence(child),
      "guessed from the figure's height, 1.70 m; fitted to gravity: lengths times 0.654 (0.626 "
      "to 0.685), "
      "height 1.11 m");
  EXPECT_EQ(TimeSentence(child),
            "gravity comes out as 15 m/s^2 instead of 9.81: lengths are probably 1.53 times too "
            "great (1.46 to 1.6), or frames 0.0103 s apart");
  const TimeScale stated = Judge(15.0, 1.0 / 120.0, 1.7, true);
  EXPECT_EQ(stated.verdict, TimeVerdict::kWrongFrameTime);
  EXPECT_EQ(
      TimeSentence(stated),
      "this clip plays at 1.24 of its speed (1.21 to 1.26): its frame time is probably 1/100 s, "
      "not 1/120 s, or lengths are 1.53 times too great (1.46 to 1.6)");
  EXPECT_EQ(Judge(9.81 / 16.0, 1.0 / 30.0, 1.7, false).verdict, TimeVerdict::kWrongFrameTime);
}

// An arc of a tenth of a second, or of a few millimetres.
TEST(TimeScale, GivesNoVerdictThatItsIntervalDoesNotBear) {
  for (const bool scale_known : {false, true}) {
    const TimeScale time = JudgeTime({{13.0, 3.0, {}}}, 1.0 / 120.0, 1.7, scale_known, 9.81);
    EXPECT_EQ(time.verdict, TimeVerdict::kUnknown);
    EXPECT_TRUE(time.gravity_range.Contains(9.81));
    EXPECT_EQ(TimeSentence(time),
              "no verdict: flights this short or low leave gravity between 6.98 and 19 m/s^2");
    EXPECT_EQ(LengthSentence(time), "");
  }
  // Nor that it is right.
  EXPECT_EQ(JudgeTime({{9.8, 2.0, {}}}, 1.0 / 120.0, 1.7, true, 9.81).verdict,
            TimeVerdict::kUnknown);
}

TEST(TimeScale, StatesTheIntervalOfEachFactor) {
  const TimeScale time = Judge(9.81 / 4.0, 1.0 / 30.0, 1.7, true);
  EXPECT_NEAR(time.gravity_range.low, 0.25 * 9.81 * (1.0 - 2.0 * std::hypot(0.01, 0.02)), 1e-9);
  EXPECT_NEAR(SpeedRange(time).high, std::sqrt(time.gravity_range.high / 9.81), 1e-12);
  EXPECT_NEAR(FrameTimeRange(time).low, SpeedRange(time).low / 30.0, 1e-12);
  EXPECT_NEAR(LengthFactorRange(time).low, 9.81 / time.gravity_range.high, 1e-12);
  const TimeScale open = JudgeTime({{1.0, 2.0, {}}}, 1.0 / 30.0, 1.7, true, 9.81);
  EXPECT_TRUE(std::isinf(LengthFactorRange(open).high));
  EXPECT_EQ(SpeedRange(open).low, 0.0);
}

// Masses err alike in all flights, noise in each for itself; flights that contradict each other
// make the interval wider.
TEST(TimeScale, OfManyFlightsIsNarrowerByWhatIsIndependentAlone) {
  const std::vector<GravityEstimate> by_noise(16, {9.8, 0.4, {}}), by_mass(16, {9.8, 0.0, {0.4}});
  EXPECT_NEAR(MeanGravity(by_noise).error, 0.1, 1e-9);
  EXPECT_NEAR(MeanGravity(by_mass).by_mass[0], 0.4, 1e-9);
  const auto width = [](const Range& range) { return range.high - range.low; };
  EXPECT_GT(width(MeanGravity({{8.0, 0.2, {}}, {11.0, 0.2, {}}}).Interval()),
            3.0 * width(MeanGravity({{9.5, 0.2, {}}, {9.5, 0.2, {}}}).Interval()));
}

TEST(TimeScale, WeighsFlightsByTheirErrors) {
  const TimeScale time =
      JudgeTime({{9.8, 0.05, {}}, {7.0, 3.0, {}}, {9.9, 0.05, {}}}, 1.0 / 60.0, 1.7, true, 9.81);
  EXPECT_NEAR(time.gravity, 9.85, 0.05);
  EXPECT_EQ(time.verdict, TimeVerdict::kTrue);
}

TEST(TimeScale, IsUnknownWithoutFlightsOrGravity) {
  EXPECT_EQ(JudgeTime({}, 1.0 / 30.0, 1.7, false, 9.81).verdict, TimeVerdict::kUnknown);
  EXPECT_EQ(JudgeTime({{1.0, 0.1, {}}}, 1.0 / 30.0, 1.7, true, 0.0).verdict, TimeVerdict::kUnknown);
  EXPECT_EQ(TimeSentence(JudgeTime({}, 1.0 / 30.0, 1.7, true, 9.81)), "");
}

}  // namespace
}  // namespace hazumi
