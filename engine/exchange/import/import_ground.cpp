#include "engine/exchange/import/import_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hazumi {

namespace {

constexpr double kNear = 0.03;  // [m]
constexpr size_t kStray = 20;   // one frame in so many may be lower

double LowestOf(const std::vector<Pose>& bodies, const std::vector<std::vector<LinkSpec>>& links) {
  double lowest = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < bodies.size(); ++k) {
    for (const LinkSpec& link : links[k]) {
      const double from = (bodies[k] * link.from).z(), to = (bodies[k] * link.to).z();
      lowest = std::min({lowest, from - link.radius, to - link.radius});
    }
  }
  return lowest;
}

}  // namespace

double GroundUnder(const FigurePlan& plan, const std::vector<std::vector<LinkSpec>>& links) {
  const size_t num_frames = plan.root_position.size();
  std::vector<double> heights;
  heights.reserve(num_frames);
  for (size_t f = 0; f < num_frames; ++f) {
    heights.push_back(LowestOf(BodiesOf(plan, static_cast<int>(f)), links));
  }
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(num_frames / kStray);
  std::nth_element(heights.begin(), low, heights.end());
  return std::abs(*low) > kNear ? *low : 0.0;
}

}  // namespace hazumi
