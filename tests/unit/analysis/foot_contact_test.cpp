#include "engine/analysis/foot_contact.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hazumi {
namespace {

// A foot that stands for a second and then moves for one at `v` [m/s] at `height` over the ground.
MotionSeries Slide(double v, double height) {
  MotionSeries series;
  series.frame_time = 0.01;
  series.feet = {{"foot", {{}}}};
  for (int i = 0; i <= 200; ++i) {
    const double moved = std::max(i - 100, 0) * 0.01;
    series.com.push_back(Vec3(0.0, 0.0, 1.0));
    series.feet[0].points[0].push_back(Vec3(v * moved, 0.0, i > 100 ? 0.05 + height : 0.05));
  }
  return series;
}

TEST(FootSkate, IsTheWayThatAFootOnTheGroundSlides) {
  const FootSkate skate = FootSkates(Slide(0.3, 0.0)).at(0);
  EXPECT_NEAR(skate.distance, 0.3, 1e-9);
  EXPECT_EQ(skate.frames, 100);
  EXPECT_NEAR(skate.time_low, 2.0, 1e-9);
}

TEST(FootSkate, SaysInWhichFramesOneSlideIs) {
  MotionSeries series = Slide(0.3, 0.0);
  series.first_frame = 7;
  std::vector<Vec3>& points = series.feet[0].points[0];
  for (size_t i = 150; i < points.size(); ++i) points[i].x() -= i > 160 ? 0.03 : 0.003 * (i - 150);
  const FootSkate skate = FootSkates(series).at(0);  // from 150 to 160 it stands
  ASSERT_EQ(skate.slides.size(), 2u);
  EXPECT_EQ(skate.slides[0].first, 107);
  EXPECT_EQ(skate.slides[0].last, 157);
  EXPECT_NEAR(skate.slides[0].distance, 0.15, 1e-9);
  EXPECT_EQ(skate.slides[1].first, 167);
  EXPECT_EQ(skate.slides[1].last, 207);
}

TEST(FootSkate, CountsLessTheHigherTheFootAndNothingAboveTheThreshold) {
  // 2 - 2^(h/H) at half of H; the one frame that rises is lower.
  const double weight = 2.0 - std::sqrt(2.0);
  EXPECT_NEAR(FootSkates(Slide(0.3, 0.0125)).at(0).distance, 0.3 * weight, 0.002);
  EXPECT_NEAR(FootSkates(Slide(0.3, 0.03)).at(0).distance, 0.0, 0.002);
}

TEST(FootSkate, OfAFootThatStandsIsNothing) {
  const FootSkate skate = FootSkates(Slide(0.0, 0.0)).at(0);
  EXPECT_EQ(skate.distance, 0.0);
  EXPECT_EQ(skate.frames, 0);
}

TEST(FootClearance, IsThatOfTheLowerFoot) {
  MotionSeries series = Slide(0.0, 0.3);
  series.feet.push_back(Slide(0.0, 0.1).feet[0]);
  const std::vector<double> clearance = FootClearance(series);
  EXPECT_NEAR(clearance[50], 0.0, 1e-12);
  EXPECT_NEAR(clearance[150], 0.1, 1e-12);
}

}  // namespace
}  // namespace hazumi
