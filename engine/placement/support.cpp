// Forces f_i at points r_i with weights w_i that supply a force and moment b:
//   minimize sum |f_i|^2 / (2 w_i)   subject to   sum G_i f_i = b,   G_i = (1; r_i x)
// The solution is f_i = w_i G_i^T y with (sum w_i G_i G_i^T) y = b. The point with the largest
// tensile force is removed and the rest is solved again, until no force pulls. Where the matrix is
// singular, as for collinear points, y is its pseudo-inverse times b.

#include "engine/placement/support.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/spatial/smooth_step.h"

namespace hazumi {

namespace {

constexpr double kNear = 0.02;  // [m]
constexpr double kArm = 0.3;    // length that moments are divided by [m]

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat63 = Eigen::Matrix<double, 6, 3>;

Mat63 MapOf(const Vec3& arm) {
  Mat63 G;
  G.topRows<3>().setIdentity();
  G.bottomRows<3>() << 0.0, -arm.z(), arm.y(), arm.z(), 0.0, -arm.x(), -arm.y(), arm.x(), 0.0;
  G.bottomRows<3>() /= kArm;
  return G;
}

Vec6 PseudoSolve(const Mat6& S, const Vec6& b) {
  constexpr double kNone = 1e-9;
  const Eigen::SelfAdjointEigenSolver<Mat6> eigen(S);
  Vec6 y = eigen.eigenvectors().transpose() * b;
  const double largest = eigen.eigenvalues().maxCoeff();
  for (int i = 0; i < 6; ++i) {
    const double own = eigen.eigenvalues()[i];
    y[i] = own > kNone * largest ? y[i] / own : 0.0;
  }
  return eigen.eigenvectors() * y;
}

}  // namespace

std::vector<SupportPoint> FindSupport(const Figure& figure, const std::vector<SceneObject>& scene,
                                      const DynamicsWorkspace& ws) {
  std::vector<SupportPoint> points;
  for (const Link& link : figure.links()) {
    const BodyScratch& body = ws.body(link.joint);
    const auto add = [&](const Vec3& center) {
      const Vec3 p = body.p + body.R * center;
      for (const SceneObject& object : scene) {
        const Distance distance = SignedDistance({p, p, link.capsule.radius}, object.shape);
        if (distance.value >= kNear) continue;
        const double weight = SmoothStep(1.0 - std::max(0.0, distance.value) / kNear);
        points.push_back({link.joint, center, link.capsule.radius, distance.normal, weight});
      }
    };
    add(link.capsule.a);
    if (link.capsule.b != link.capsule.a) add(link.capsule.b);
  }
  return points;
}

std::vector<Vec3> SupportForces(const std::vector<SupportPoint>& points, const Wrench& needed,
                                const Vec3& about, const DynamicsWorkspace& ws) {
  std::vector<Vec3> forces(points.size(), Vec3::Zero());
  std::vector<char> pushes(points.size(), 1);
  Vec6 b;
  b << needed.force, needed.moment / kArm;
  for (bool any_pulls = !points.empty(); any_pulls;) {
    Mat6 S = Mat6::Zero();
    for (size_t i = 0; i < points.size(); ++i) {
      if (!pushes[i]) continue;
      const Mat63 G = MapOf(points[i].Place(ws) - about);
      S += points[i].weight * G * G.transpose();
    }
    const Vec6 y = PseudoSolve(S, b);
    double worst = 0.0;
    size_t pulls_most = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const Mat63 G = MapOf(points[i].Place(ws) - about);
      forces[i] = pushes[i] ? Vec3(points[i].weight * (G.transpose() * y)) : Vec3::Zero();
      if (forces[i].dot(points[i].normal) >= worst) continue;
      worst = forces[i].dot(points[i].normal);
      pulls_most = i;
    }
    any_pulls = worst < 0.0;
    if (any_pulls) pushes[pulls_most] = 0;
  }
  return forces;
}

std::vector<double> CarriedShares(const Figure& figure, const std::vector<SupportPoint>& points,
                                  const DynamicsWorkspace& ws) {
  const Wrench lift = {Vec3::UnitZ(), Vec3::Zero()};
  const std::vector<Vec3> forces = SupportForces(points, lift, CenterOfMass(figure, ws), ws);
  std::vector<double> shares(static_cast<size_t>(figure.num_joints()), 0.0);
  for (int j = 0; j < figure.num_joints(); ++j) {
    double share = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
      if (IsMovedBy(figure, points[i], JointIndex(j))) share += forces[i].z();
    }
    shares[static_cast<size_t>(j)] = std::clamp(share, 0.0, 1.0);
  }
  return shares;
}

}  // namespace hazumi
