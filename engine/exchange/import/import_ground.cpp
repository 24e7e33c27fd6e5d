#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/exchange/import/figure_parts.h"

namespace hazumi {

namespace {

constexpr double kNear = 0.03;  // [m]
constexpr size_t kLooks = 60;   // at a skin
constexpr size_t kStray = 20;   // one frame in so many may be lower

// Bones that the figure stands on, by kept bone: feet and toes, of animals paws too; without any of
// these all bones.
std::vector<bool> StandingBones(const Skeleton& skeleton) {
  std::vector<bool> stands;
  for (const KeptBone& bone : skeleton.bones) {
    const BodyRole role = bone.place.role;
    const bool is_paw = skeleton.has_four_legs && role == BodyRole::kHand;
    stands.push_back(role == BodyRole::kFoot || role == BodyRole::kToe || is_paw);
  }
  const bool has_any = std::find(stands.begin(), stands.end(), true) != stands.end();
  return has_any ? stands : std::vector<bool>(stands.size(), true);
}

double LowestOf(const std::vector<Pose>& bodies, const std::vector<std::vector<LinkSpec>>& links,
                const std::vector<bool>& stands) {
  double lowest = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < bodies.size(); ++k) {
    if (!stands[k]) continue;
    for (const LinkSpec& link : links[k]) {
      const double from = (bodies[k] * link.from).z(), to = (bodies[k] * link.to).z();
      lowest = std::min({lowest, from - link.radius, to - link.radius});
    }
  }
  return lowest;
}

// Of the vertices, each where the bone that it follows most takes it.
double LowestOf(const std::vector<Pose>& bodies, const Skin& skin,
                const std::vector<bool>& stands) {
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
      const uint16_t bind = mesh.bind_indices[v][most];
      if (!stands[static_cast<size_t>(mesh.binds[bind].bone)]) continue;
      const Eigen::RowVector4d& height = heights[bind];
      const Eigen::Vector4d vertex = mesh.positions[v].cast<double>().homogeneous();
      lowest = std::min(lowest, height.dot(vertex.transpose()));
    }
  }
  return lowest;
}

}  // namespace

double GroundUnder(const Skeleton& skeleton, const FigurePlan& plan, const Skin& skin,
                   const std::vector<std::vector<LinkSpec>>& links) {
  const std::vector<bool> stands = StandingBones(skeleton);
  const size_t num_frames = plan.root_position.size();
  const size_t step = skin.meshes.empty() ? 1 : 1 + num_frames / kLooks;
  std::vector<double> heights;
  for (size_t f = 0; f < num_frames; f += step) {
    const std::vector<Pose> bodies = BodiesOf(plan, static_cast<int>(f));
    double lowest = LowestOf(bodies, skin, stands);
    if (!std::isfinite(lowest)) lowest = LowestOf(bodies, links, stands);  // no skin on its feet
    if (std::isfinite(lowest)) heights.push_back(lowest);
  }
  if (heights.empty()) return 0.0;
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / kStray);
  std::nth_element(heights.begin(), low, heights.end());
  return std::abs(*low) > kNear ? *low : 0.0;
}

}  // namespace hazumi
