// Flights of baked projects: what the bake knows, the analysis must find.

#include <gtest/gtest.h>

#include "engine/analysis/flights.h"
#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"

namespace hazumi {
namespace {

constexpr FrameRate kRate{120, 1};

Animation Example(const std::string& name) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/" + name;
  return CompileAnimation(LoadProject(path).value()).value().animation;
}

Motion BakeAtRate(const Animation& animation) {
  BakeOptions options;
  options.output_rate = kRate;
  return Bake(animation, options).value();
}

double FrameOf(const Motion& motion, EventKind kind) {
  for (const MotionEvent& event : motion.events) {
    if (event.kind == kind) return kRate.FrameAt(event.time);
  }
  ADD_FAILURE() << "no event " << NameOf(kind);
  return 0.0;
}

TEST(BakedFlight, IsWhereTheBakeTakesOffAndLands) {
  const Animation animation = Example("jump.kfa");
  const Motion motion = BakeAtRate(animation);
  const FlightAnalysis analysis =
      AnalyseFlights(SeriesOf(*animation.figure, motion), animation.gravity);
  ASSERT_EQ(analysis.flights.size(), 1u);
  const Flight& flight = analysis.flights[0];
  EXPECT_NEAR(flight.take_off, FrameOf(motion, EventKind::kTakeOff), 2.0);
  EXPECT_NEAR(flight.apex, FrameOf(motion, EventKind::kApex), 0.1);
  EXPECT_NEAR(flight.landing, FrameOf(motion, EventKind::kLanding), 2.0);
  EXPECT_NEAR(flight.parabola.gravity, animation.gravity, 1e-3);
  EXPECT_EQ(analysis.time.verdict, TimeVerdict::kTrue);
}

TEST(BakedFlight, IsNoneInAThrowFromStandingFeet) {
  const Animation animation = Example("throw.kfa");
  const FlightAnalysis analysis =
      AnalyseFlights(SeriesOf(*animation.figure, BakeAtRate(animation)), animation.gravity);
  EXPECT_TRUE(analysis.flights.empty());
  EXPECT_EQ(FlightReport(analysis).at(0),
            "flight     none: a foot is on the ground, or the CoM is on no parabola");
}

TEST(BakedSeries, StandsOnTheBallsAndHeelsOfTheFigure) {
  const Animation animation = Example("throw.kfa");
  const MotionSeries series = SeriesOf(*animation.figure, BakeAtRate(animation));
  ASSERT_EQ(series.feet.size(), 2u);
  EXPECT_EQ(series.feet[0].name, "r_toe");
  EXPECT_EQ(series.feet[1].name, "l_toe");
  EXPECT_NEAR(series.stature, 1.70, 0.1);
  EXPECT_EQ(series.angular_momentum.size(), series.com.size());
}

}  // namespace
}  // namespace hazumi
