#include "engine/analysis/foot_contact.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

// Height of a point over where it stands, by frame [m].
std::vector<double> HeightOf(const std::vector<Vec3>& point) {
  std::vector<double> heights;
  heights.reserve(point.size());
  for (const Vec3& p : point) heights.push_back(p.z());
  const double level = Quantile(heights, 0.1);
  for (double& height : heights) height -= level;
  return heights;
}

std::vector<std::vector<double>> HeightsOf(const FootTrack& foot) {
  std::vector<std::vector<double>> heights;
  for (const auto& point : foot.points) heights.push_back(HeightOf(point));
  return heights;
}

// From frame to frame + 1 it slides so far.
void AddSlide(int frame, double step, std::vector<FootSlide>* slides) {
  constexpr int kPause = 2;  // [frames]
  if (slides->empty() || frame - slides->back().last > kPause) slides->push_back({frame, 0, 0.0});
  slides->back().last = frame + 1;
  slides->back().distance += step;
}

FootSkate SkateOf(const FootTrack& foot, double frame_time, double threshold, int first_frame) {
  constexpr double kSliding = 0.1;  // [m/s]
  constexpr double kFirm = 0.6;     // weight from which on it is not a foot that swings low
  const auto heights = HeightsOf(foot);
  FootSkate skate{foot.name};
  for (size_t i = 1; i < foot.points[0].size(); ++i) {
    // The point that carries the foot between these frames: the lowest.
    size_t low = 0;
    const auto height = [&](size_t k) { return 0.5 * (heights[k][i - 1] + heights[k][i]); };
    for (size_t k = 1; k < heights.size(); ++k) low = height(k) < height(low) ? k : low;
    const double h = std::max(height(low), 0.0);
    if (h >= threshold) continue;
    const double weight = 2.0 - std::exp2(h / threshold);
    const double step = weight * (foot.points[low][i] - foot.points[low][i - 1]).head<2>().norm();
    skate.time_low += frame_time;
    skate.distance += step;
    if (step <= kSliding * frame_time) continue;
    ++skate.frames;
    if (weight < kFirm) continue;
    AddSlide(first_frame + static_cast<int>(i) - 1, step, &skate.slides);
  }
  return skate;
}

}  // namespace

std::vector<double> FootClearance(const MotionSeries& series) {
  if (series.feet.empty()) return {};
  std::vector<double> clearance(series.com.size(), 1e300);
  for (const FootTrack& foot : series.feet) {
    for (const auto& heights : HeightsOf(foot)) {
      for (size_t i = 0; i < heights.size(); ++i) clearance[i] = std::min(clearance[i], heights[i]);
    }
  }
  return clearance;
}

std::vector<FootSkate> FootSkates(const MotionSeries& series) {
  const double threshold = 0.025 / 1.7 * series.stature;
  std::vector<FootSkate> skates;
  for (const FootTrack& foot : series.feet) {
    skates.push_back(SkateOf(foot, series.frame_time, threshold, series.first_frame));
  }
  return skates;
}

}  // namespace hazumi
