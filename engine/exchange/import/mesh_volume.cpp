// The volume that a surface encloses is V = 1/3 ∮ x . n dA (divergence theorem). A bone k has the
// share w_k of the surface, by its weights, and caps over the cuts at its own joint p_k and at
// those of the bones that hang on it. Caps close each cut of a subtree, so that their area vectors
// are those of its surface, A_k = ∮ n dA over all below k:
//   3 V_k = ∮ w_k x . n dA + sum over children c of p_c . A_c - p_k . A_k
// What is added at a cut above is taken away below: the sum over k is that of the whole mesh. Over
// a flat triangle x . n is constant, so that the mean of the weights is exact.

#include <cmath>

#include "engine/exchange/import/figure_parts.h"

namespace hazumi {

namespace {

constexpr double kMostNegative = 0.1;  // of the volume, all negative parts together

struct Surface {
  std::vector<double> moments;  // 3 V_k without caps, by bone
  std::vector<Vec3> areas;      // by bone
};

Vec3 VertexAt(const SkinMesh& mesh, size_t v, const std::vector<Pose>& bodies) {
  Vec3 p = Vec3::Zero();
  for (size_t i = 0; i < 4; ++i) {
    const double weight = mesh.weights[v][i];
    if (weight == 0.0) continue;
    const SkinMesh::Bind& bind = mesh.binds[mesh.bind_indices[v][i]];
    const Eigen::Vector4d at = mesh.positions[v].cast<double>().homogeneous();
    p += weight * (bodies[bind.bone] * Vec3((bind.inverse_bind * at).head<3>()));
  }
  return p;
}

void AddMesh(const SkinMesh& mesh, const std::vector<Pose>& bodies, Surface* surface) {
  std::vector<Vec3> points;
  points.reserve(mesh.positions.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v) points.push_back(VertexAt(mesh, v, bodies));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 area = 0.5 * (points[b] - points[a]).cross(points[c] - points[a]);
    for (const uint32_t v : {a, b, c}) {
      for (size_t i = 0; i < 4; ++i) {
        const auto bone = mesh.binds[mesh.bind_indices[v][i]].bone;
        const double share = mesh.weights[v][i] / 3.0;
        surface->moments[bone] += share * area.dot(points[a]);
        surface->areas[bone] += share * area;
      }
    }
  }
}

void AddCaps(const FigurePlan& plan, const std::vector<Pose>& bodies, Surface* surface) {
  for (size_t k = plan.joints.size(); k-- > 0;) {
    const double cap = bodies[k].p.dot(surface->areas[k]);  // of all below
    surface->moments[k] -= cap;
    const int parent = plan.joints[k].parent;
    if (parent < 0) continue;
    surface->moments[parent] += cap;
    surface->areas[parent] += surface->areas[k];
  }
}

}  // namespace

std::vector<double> MeshVolumes(const Skin& skin, const FigurePlan& plan) {
  const std::vector<Pose> bodies = RestBodies(plan);
  Surface surface{std::vector<double>(bodies.size(), 0.0),
                  std::vector<Vec3>(bodies.size(), Vec3::Zero())};
  for (const SkinMesh& mesh : skin.meshes) AddMesh(mesh, bodies, &surface);
  AddCaps(plan, bodies, &surface);
  double sum = 0.0, negative = 0.0;
  for (const double moment : surface.moments) sum += moment;
  const double sign = sum < 0.0 ? -1.0 : 1.0;  // faces may look inwards
  for (double& moment : surface.moments) {
    moment *= sign / 3.0;
    negative -= std::min(moment, 0.0);
  }
  if (!(negative < kMostNegative * std::abs(sum) / 3.0)) return {};
  return std::move(surface.moments);
}

}  // namespace hazumi
