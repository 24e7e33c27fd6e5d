#include "engine/analysis/time_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/flight_report.h"

namespace hazumi {
namespace {

TimeScale Judge(double gravity, double frame_time, double stature, bool scale_known) {
  return JudgeTime({{gravity, 0.01 * gravity}}, frame_time, stature, scale_known, 9.81);
}

TEST(TimeScale, IsTrueWhereGravityIs) {
  const TimeScale time = Judge(9.5, 1.0 / 120.0, 1.7, true);
  EXPECT_EQ(time.verdict, TimeVerdict::kTrue);
  EXPECT_EQ(TimeSentence(time), "gravity is right within 4 %: the clip plays at its natural speed");
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
            "this clip plays at 1/4 speed: its frame time is probably 1/120 s, not 1/30 s");
  EXPECT_EQ(TimeSentence(Judge(9.81 * 16.0, 1.0 / 120.0, 1.7, true)),
            "this clip plays at 4 times its speed: its frame time is probably 1/30 s, not 1/120 s");
  EXPECT_EQ(TimeSentence(Judge(9.81 * 0.64, 1.0 / 24.0, 1.7, true)),
            "this clip plays at 0.80 of its speed: its frame time is probably 1/30 s, not 1/24 s");
  EXPECT_EQ(TimeSentence(Judge(9.81 * 0.25, 1.0 / 24.0, 1.7, true)),
            "this clip plays at 1/2 speed: its frame time is about 0.0208 s, not 1/24 s");
}

// A child, or a giant's bones: a guessed unit of length is doubted before the clip's time.
TEST(TimeScale, DoubtsAGuessedUnitOfLengthIfTheFigureStaysOfHumanHeight) {
  const TimeScale child = Judge(15.0, 1.0 / 120.0, 1.7, false);
  EXPECT_EQ(child.verdict, TimeVerdict::kWrongLength);
  EXPECT_NEAR(child.length_factor, 0.654, 1e-9);
  EXPECT_EQ(LengthSentence(child),
            "guessed from the figure's height, 1.70 m; fitted to gravity: lengths times 0.654, "
            "height 1.11 m");
  EXPECT_EQ(TimeSentence(child),
            "gravity comes out as 15 m/s^2 instead of 9.81: lengths are probably 1.53 times too "
            "great (or frames 0.0103 s apart)");
  const TimeScale stated = Judge(15.0, 1.0 / 120.0, 1.7, true);
  EXPECT_EQ(stated.verdict, TimeVerdict::kWrongFrameTime);
  EXPECT_EQ(TimeSentence(stated),
            "this clip plays at 1.24 of its speed: its frame time is probably 1/100 s, not 1/120 s "
            "(or lengths are 1.53 times too great)");
  EXPECT_EQ(Judge(9.81 / 16.0, 1.0 / 30.0, 1.7, false).verdict, TimeVerdict::kWrongFrameTime);
}

TEST(TimeScale, WeighsFlightsByTheirErrors) {
  const TimeScale time =
      JudgeTime({{9.8, 0.05}, {7.0, 3.0}, {9.9, 0.05}}, 1.0 / 60.0, 1.7, true, 9.81);
  EXPECT_NEAR(time.gravity, 9.85, 0.05);
  EXPECT_EQ(time.verdict, TimeVerdict::kTrue);
}

TEST(TimeScale, IsUnknownWithoutFlightsOrGravity) {
  EXPECT_EQ(JudgeTime({}, 1.0 / 30.0, 1.7, false, 9.81).verdict, TimeVerdict::kUnknown);
  EXPECT_EQ(JudgeTime({{1.0, 0.1}}, 1.0 / 30.0, 1.7, true, 0.0).verdict, TimeVerdict::kUnknown);
  EXPECT_EQ(TimeSentence(JudgeTime({}, 1.0 / 30.0, 1.7, true, 9.81)), "");
}

}  // namespace
}  // namespace hazumi
