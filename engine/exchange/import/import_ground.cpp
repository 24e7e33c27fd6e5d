#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/exchange/import/figure_parts.h"

namespace hazumi {

namespace {

constexpr double kNear = 0.03;  // [m]
constexpr size_t kLooks = 60;   // at a skin
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

// Of the vertices, each where the bone that it follows most takes it.
double LowestOf(const std::vector<Pose>& bodies, const Skin& skin) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const SkinMesh& mesh : skin.meshes) {
    std::vector<Eigen::RowVector4d> heights;  // of a vertex that follows a bind
    for (const SkinMesh::Bind& bind : mesh.binds) {
      Eigen::RowVector4d row = bodies[bind.bone].R.row(2) * bind.inverse_bind.topRows<3>();
      row[3] += bodies[bind.bone].p.z();
      heights.push_back(row);
    }
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const auto& weights = mesh.weights[v];
      const auto most = std::max_element(weights.begin(), weights.end()) - weights.begin();
      const Eigen::RowVector4d& height = heights[mesh.bind_indices[v][most]];
      const Eigen::Vector4d vertex = mesh.positions[v].cast<double>().homogeneous();
      lowest = std::min(lowest, height.dot(vertex.transpose()));
    }
  }
  return lowest;
}

}  // namespace

double GroundUnder(const FigurePlan& plan, const Skin& skin,
                   const std::vector<std::vector<LinkSpec>>& links) {
  const size_t num_frames = plan.root_position.size();
  const size_t step = skin.meshes.empty() ? 1 : 1 + num_frames / kLooks;
  std::vector<double> heights;
  for (size_t f = 0; f < num_frames; f += step) {
    const std::vector<Pose> bodies = BodiesOf(plan, static_cast<int>(f));
    const double lowest = skin.meshes.empty() ? LowestOf(bodies, links) : LowestOf(bodies, skin);
    if (std::isfinite(lowest)) heights.push_back(lowest);
  }
  if (heights.empty()) return 0.0;
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / kStray);
  std::nth_element(heights.begin(), low, heights.end());
  return std::abs(*low) > kNear ? *low : 0.0;
}

}  // namespace hazumi
