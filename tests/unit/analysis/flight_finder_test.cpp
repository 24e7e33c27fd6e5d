// Flights of motions made of formulas: when they begin and end, and what gravity they imply.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/flights.h"
#include "tests/unit/analysis/made_motion.h"

namespace hazumi {
namespace {

using test::Jump;

// The one flight of a series that has one.
Flight OnlyFlight(const MotionSeries& series) {
  const std::vector<Flight> flights = FindFlights(series);
  EXPECT_EQ(flights.size(), 1u);
  return flights.empty() ? Flight() : flights[0];
}

TEST(FlightFinder, FindsTakeOffApexAndLandingAtEveryFrameRate) {
  const Jump jump;
  for (const double fps : {24.0, 25.0, 30.0, 60.0, 100.0, 120.0, 240.0}) {
    const Flight flight = OnlyFlight(SeriesOf(jump, fps, fps));
    const double tolerance = 0.5 + 0.01 * fps;  // half a frame, and the 2 cm
    EXPECT_NEAR(flight.take_off, jump.take_off() * fps, tolerance) << fps;
    EXPECT_NEAR(flight.apex, jump.apex() * fps, 0.01 * fps) << fps;
    EXPECT_NEAR(flight.landing, jump.landing() * fps, tolerance) << fps;
    EXPECT_NEAR(flight.parabola.gravity, 9.81, 1e-6) << fps;
    EXPECT_NEAR(flight.horizontal_speed, jump.forward, 1e-6) << fps;
    EXPECT_NEAR(flight.rise, jump.v * jump.v / (2.0 * 9.81), 0.05) << fps;
  }
}

TEST(FlightFinder, FindsThemThroughTheNoiseOfACapture) {
  const Jump jump;
  const Flight flight = OnlyFlight(SeriesOf(jump, 120.0, 120.0, 0.003));
  EXPECT_NEAR(flight.take_off, jump.take_off() * 120.0, 2.0);
  EXPECT_NEAR(flight.apex, jump.apex() * 120.0, 0.5);
  EXPECT_NEAR(flight.landing, jump.landing() * 120.0, 2.0);
  EXPECT_NEAR(flight.parabola.gravity, 9.81, 4.0 * flight.parabola.gravity_error);
  EXPECT_LT(flight.parabola.gravity_error, 0.1);
}

TEST(FlightFinder, FindsAFlightInSlowMotionAndSaysWhichFrameTimeIsRight) {
  const Jump jump;
  const FlightAnalysis analysis = AnalyseFlights(SeriesOf(jump, 120.0, 30.0, 0.001));
  ASSERT_EQ(analysis.flights.size(), 1u);
  EXPECT_NEAR(analysis.flights[0].take_off, jump.take_off() * 120.0, 2.0);
  EXPECT_NEAR(analysis.flights[0].parabola.gravity, 9.81 / 16.0, 0.01);
  EXPECT_EQ(analysis.time.frame_rate, 120);
  EXPECT_TRUE(SpeedRange(analysis.time).Contains(0.25));
  const std::string sentence = TimeSentence(analysis.time);
  EXPECT_NE(sentence.find("this clip plays at 1/4 speed ("), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("probably 1/120 s, not 1/30 s"), std::string::npos) << sentence;
}

TEST(FlightFinder, CountsFramesAsTheClipDoes) {
  const MotionSeries series = SeriesOf(Jump(), 60.0, 60.0);
  const Flight whole = OnlyFlight(series), cut = OnlyFlight(test::Cut(series, 20, 150));
  EXPECT_NEAR(cut.take_off, whole.take_off, 0.01);
  EXPECT_NEAR(cut.apex, whole.apex, 0.01);
  EXPECT_NEAR(cut.landing, whole.landing, 0.01);
}

TEST(FlightFinder, SeesAFlightThatTheClipCutsOff) {
  const Jump jump;
  const MotionSeries series = SeriesOf(jump, 120.0, 120.0);
  const int apex = static_cast<int>(jump.apex() * 120.0);
  const int last = static_cast<int>(series.com.size()) - 1;
  const Flight end = OnlyFlight(test::Cut(series, apex - 8, last));
  EXPECT_TRUE(end.begins_before_clip);
  EXPECT_FALSE(end.ends_after_clip);
  EXPECT_DOUBLE_EQ(end.take_off, apex - 8);
  EXPECT_NEAR(end.parabola.gravity, 9.81, 1e-6);
  const Flight begin = OnlyFlight(test::Cut(series, 0, apex + 8));
  EXPECT_FALSE(begin.begins_before_clip);
  EXPECT_TRUE(begin.ends_after_clip);
  EXPECT_DOUBLE_EQ(begin.landing, apex + 8);
}

TEST(FlightFinder, TakesOffFromABoxWhereTheFootLeavesTheBox) {
  for (const double height : {0.2, 0.4}) {
    Jump jump;
    jump.ground_before = height;
    jump.v = 1.6;
    const Flight flight = OnlyFlight(SeriesOf(jump, 120.0, 120.0));
    EXPECT_NEAR(flight.take_off, jump.take_off() * 120.0, 2.0) << height;
    EXPECT_NEAR(flight.landing, jump.landing() * 120.0, 2.0) << height;
    EXPECT_FALSE(flight.begins_before_clip) << height;
  }
}

// A jump seen backwards is a jump, onto a box.
TEST(FlightFinder, FindsTheJumpOntoABoxAndTheOneDownAgain) {
  Jump down;
  down.ground_before = 0.3;
  down.v = 1.8;
  const MotionSeries second = SeriesOf(down, 120.0, 120.0);
  const MotionSeries both = test::Joined(test::Reversed(second), second);
  const std::vector<Flight> flights = FindFlights(both);
  ASSERT_EQ(flights.size(), 2u);
  const double n = static_cast<double>(second.com.size());
  EXPECT_NEAR(flights[0].take_off, n - 1.0 - down.landing() * 120.0, 2.0);
  EXPECT_NEAR(flights[0].landing, n - 1.0 - down.take_off() * 120.0, 2.0);
  EXPECT_NEAR(flights[1].take_off, n + down.take_off() * 120.0, 2.0);
  EXPECT_NEAR(flights[1].landing, n + down.landing() * 120.0, 2.0);
}

TEST(FlightFinder, FindsNoneInAWalk) {
  for (const double fps : {24.0, 30.0, 120.0}) {
    for (const double slope : {0.0, 0.03, -0.05}) {
      EXPECT_TRUE(FindFlights(test::Walk(fps, 4.0, slope)).empty()) << fps << ' ' << slope;
      EXPECT_TRUE(FindFlights(test::Walk(fps, 4.0, slope, 0.003)).empty()) << fps << ' ' << slope;
    }
  }
}

TEST(FlightFinder, FindsTheShortFlightsOfARun) {
  const std::vector<Flight> flights = FindFlights(test::Run(120.0, 6));
  ASSERT_GE(flights.size(), 5u);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(flights[i].take_off, (0.36 * i + 0.24) * 120.0, 3.0) << i;
    EXPECT_NEAR(flights[i].landing, (0.36 * i + 0.36) * 120.0, 3.0) << i;
    EXPECT_NEAR(flights[i].parabola.gravity, 9.81, 0.2) << i;
  }
}

// A foot that is set down slowly is on the ground where it is slowed down.
TEST(FlightFinder, LandsWhereTheFootTouchesNotTwoCentimetresAbove) {
  Jump jump;
  jump.v = 1.2;  // 2 cm are two frames
  const Flight flight = OnlyFlight(SeriesOf(jump, 120.0, 120.0));
  EXPECT_NEAR(flight.landing, jump.landing() * 120.0, 0.7);
}

TEST(FlightFinder, TakesRisingOnTiptoeForNoFlight) {
  MotionSeries series = SeriesOf(Jump(), 60.0, 60.0);
  for (size_t i = 0; i < series.com.size(); ++i) {
    const double up = 0.035 * std::exp(-std::pow((i / 60.0 - 1.5) / 0.3, 2));
    series.com[i] = Vec3(0.0, 0.0, 0.95 + up);
    for (FootTrack& foot : series.feet) {
      foot.points[0][i] = Vec3(0.0, 0.0, 0.04 + up);
      foot.points[1][i] = Vec3(0.0, 0.0, 0.06 + 3.0 * up);
    }
  }
  EXPECT_TRUE(FindFlights(series).empty());
}

// Lifted by a rope, both feet are off the ground, and nothing falls.
TEST(FlightFinder, TakesALiftForNoFlight) {
  MotionSeries series = SeriesOf(Jump(), 60.0, 60.0);
  for (size_t i = 0; i < series.com.size(); ++i) {
    const double t = i / 60.0 - 1.5;
    const double up = 0.4 / (1.0 + std::pow(t / 0.5, 4));
    series.com[i] = Vec3(0.0, 0.0, 0.95 + up);
    for (FootTrack& foot : series.feet) {
      for (auto& point : foot.points) point[i] = Vec3(0.0, 0.0, 0.04 + up);
    }
  }
  EXPECT_TRUE(FindFlights(series).empty());
}

TEST(FlightFinder, MeasuresHowMuchAngularMomentumChangesInTheAir) {
  MotionSeries series = SeriesOf(Jump(), 120.0, 120.0);
  const double per_frame = 0.01;
  for (size_t i = 0; i < series.com.size(); ++i) {
    series.angular_momentum[i] = Vec3(per_frame * i, 4.0, 0.0);
  }
  const Flight flight = OnlyFlight(series);
  ASSERT_TRUE(flight.angular_momentum.has_value());
  const double frames = flight.duration_frames();
  EXPECT_NEAR(flight.angular_momentum->change.x(), per_frame * frames, 2.0 * per_frame);
  EXPECT_NEAR(flight.angular_momentum->change.y(), 0.0, 1e-9);
  EXPECT_NEAR(flight.angular_momentum->mean.y(), 4.0, 1e-9);
  series.angular_momentum.clear();
  EXPECT_FALSE(OnlyFlight(series).angular_momentum.has_value());
}

TEST(FlightFinder, HasNothingToSayOfMotionsTooShortToHaveAFlight) {
  const MotionSeries series = SeriesOf(Jump(), 30.0, 30.0);
  EXPECT_TRUE(FindFlights(MotionSeries()).empty());
  for (const int last : {0, 1, 3, 6}) {
    EXPECT_TRUE(FindFlights(test::Cut(series, 0, last)).empty()) << last;
  }
  MotionSeries without_feet = series;
  without_feet.feet.clear();
  EXPECT_TRUE(FindFlights(without_feet).empty());
}

}  // namespace
}  // namespace hazumi
