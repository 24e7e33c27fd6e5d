// The skin of the shipped human, on the shipped figure.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/project/project_figure.h"
#include "render/mesh/linear_blend.h"
#include "render/motion/figure_skin.h"

namespace hazumi::render {
namespace {

constexpr double kHipHeight = 0.9024;  // of the standing figure [m]
constexpr double kDensity = 1000.0;    // of a body, about that of water [kg/m^3]

Figure Human() {
  const Result<FigureSpec> spec = LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json");
  EXPECT_TRUE(spec.ok()) << spec.error().ToString();
  Result<Figure> figure = BuildFigure(spec.value());
  EXPECT_TRUE(figure.ok());
  return std::move(figure).value();
}

struct Hinge {
  JointIndex joint;
  double angle;  // one of its limits [rad]
  std::string name;
};

class HumanSkin : public ::testing::Test {
 protected:
  HumanSkin() : figure_(Human()), ws_(figure_) {
    const auto model = MakeSkinModel(MeshesOf(ShippedSkin::kHuman));
    EXPECT_TRUE(model.ok()) << model.error().ToString();
    const Result<FigureSkin> skin = PutOn(figure_, model.value());
    EXPECT_TRUE(skin.ok()) << skin.error().ToString();
    skin_ = skin.value();
  }

  const std::vector<SkinMesh>& meshes() const { return skin_.model->skin->meshes; }
  const SkinMesh& body() const { return meshes()[0]; }

  // Of all meshes, one after the other, of the standing figure with these angles.
  std::vector<SkinnedVertex> Posed(const VecX& q) {
    const Pose X_WR = {Mat3::Identity(), {0.0, 0.0, kHipHeight}};
    ComputePositions(figure_, X_WR, q, &ws_);
    std::vector<SkinnedVertex> vertices;
    PoseSkin({skin_.model, skin_.PosesIn(figure_, q, ws_), {}, 1.0f}, &vertices);
    return vertices;
  }
  std::vector<SkinnedVertex> Standing() { return Posed(VecX::Zero(figure_.num_joints())); }
  std::vector<SkinnedVertex> At(const Hinge& hinge) {
    VecX q = VecX::Zero(figure_.num_joints());
    q[hinge.joint.value()] = hinge.angle;
    return Posed(q);
  }

  std::vector<Hinge> Limits() const {
    std::vector<Hinge> limits;
    for (int j = 0; j < figure_.num_joints(); ++j) {
      const Joint& joint = figure_.joint(JointIndex(j));
      limits.push_back({JointIndex(j), joint.lower, joint.name + " at its lower limit"});
      limits.push_back({JointIndex(j), joint.upper, joint.name + " at its upper limit"});
    }
    return limits;
  }

  Figure figure_;
  DynamicsWorkspace ws_;
  FigureSkin skin_;
};

Vec3 PlaceOf(const SkinnedVertex& v) { return {v.position[0], v.position[1], v.position[2]}; }

double VolumeOf(const SkinMesh& mesh, const std::vector<SkinnedVertex>& vertices) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume +=
        PlaceOf(vertices[t[0]]).cross(PlaceOf(vertices[t[1]])).dot(PlaceOf(vertices[t[2]])) / 6.0;
  }
  return volume;
}

double LowestOf(const std::vector<SkinnedVertex>& vertices) {
  double lowest = 1e9;
  for (const SkinnedVertex& v : vertices) lowest = std::min<double>(lowest, v.position[2]);
  return lowest;
}

// Where two charts of the picture meet, two vertices are in one place.
TEST_F(HumanSkin, IsClosedAndWoundOneWay) {
  for (const SkinMesh& mesh : meshes()) {
    std::map<std::array<float, 3>, int> numbers;
    const auto number = [&](std::uint32_t v) {
      const Eigen::Vector3f& p = mesh.positions[v];
      return numbers.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(numbers.size()))
          .first->second;
    };
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : mesh.triangles) {
      for (size_t k = 0; k < 3; ++k) ++edges[{number(t[k]), number(t[(k + 1) % 3])}];
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1) << mesh.name;
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1u) << mesh.name;
    }
  }
}

TEST_F(HumanSkin, WeightsAddUpToOne) {
  for (const SkinMesh& mesh : meshes()) {
    for (const auto& w : mesh.weights) ASSERT_NEAR(w[0] + w[1] + w[2] + w[3], 1.0f, 1e-5f);
  }
}

// Vertices in one place have the same weights: nothing comes apart at a border of the picture.
TEST_F(HumanSkin, HoldsTogetherWhereItsPictureIsCut) {
  std::map<std::array<float, 3>, std::array<float, 4>> weights;
  for (size_t i = 0; i < body().positions.size(); ++i) {
    const Eigen::Vector3f& p = body().positions[i];
    const auto [entry, is_new] = weights.try_emplace({p.x(), p.y(), p.z()}, body().weights[i]);
    ASSERT_EQ(entry->second, body().weights[i]);
  }
}

TEST_F(HumanSkin, HasTheVolumeOfItsMass) {
  const double wanted = figure_.total_mass() / kDensity;
  EXPECT_NEAR(VolumeOf(body(), Standing()), wanted, 0.05 * wanted);
}

TEST_F(HumanSkin, StandsOnTheFloorAsItsCapsulesDo) {
  EXPECT_NEAR(LowestOf(Standing()), 0.0, 1e-3);
  for (const char* name : {"l_toe", "r_toe"}) {  // bent up, the ball of the foot stays down
    const JointIndex toe = *figure_.FindJoint(name);
    EXPECT_NEAR(LowestOf(At({toe, figure_.joint(toe).upper, name})), 0.0, 2e-3);
  }
}

// From one limit to the other, the flesh neither vanishes nor swells.
TEST_F(HumanSkin, KeepsItsVolumeAtEveryLimit) {
  const double standing = VolumeOf(body(), Standing());
  for (const Hinge& hinge : Limits()) {
    EXPECT_NEAR(VolumeOf(body(), At(hinge)), standing, 0.05 * standing) << hinge.name;
  }
}

// Of the whole surface, how much lies the wrong way around: its facets look against the normals
// that are lit. Where skin folds between two limbs, some of it does.
double TurnedInside(const SkinMesh& mesh, const std::vector<SkinnedVertex>& vertices) {
  double turned = 0.0, all = 0.0;
  for (const auto& t : mesh.triangles) {
    Vec3 lit = Vec3::Zero();
    for (const std::uint32_t v : t) {
      lit += Vec3(vertices[v].normal[0], vertices[v].normal[1], vertices[v].normal[2]);
    }
    const Vec3 a = PlaceOf(vertices[t[0]]);
    const Vec3 facet = (PlaceOf(vertices[t[1]]) - a).cross(PlaceOf(vertices[t[2]]) - a);
    all += facet.norm();
    if (facet.dot(lit) < 0.0) turned += facet.norm();
  }
  return turned / all;
}

TEST_F(HumanSkin, IsNotTurnedInsideOutAtAnyLimit) {
  for (const Hinge& hinge : Limits()) {
    EXPECT_LT(TurnedInside(body(), At(hinge)), 0.01) << hinge.name;
  }
}

// How much longer the longest of the edges is than in the pose that the skin was made in; short
// ones, of fingers and face, are measured as if they were 1 cm long.
double MostStretch(const SkinMesh& mesh, const std::vector<SkinnedVertex>& vertices) {
  double most = 0.0;
  for (const auto& t : mesh.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const double made = (mesh.positions[a] - mesh.positions[b]).cast<double>().norm();
      const double now = (PlaceOf(vertices[a]) - PlaceOf(vertices[b])).norm();
      most = std::max(most, now / std::max(made, 0.01));
    }
  }
  return most;
}

TEST_F(HumanSkin, IsNowhereStretchedToMoreThanFiveTimesAtAnyLimit) {
  for (const Hinge& hinge : Limits()) {
    EXPECT_LT(MostStretch(body(), At(hinge)), 5.0) << hinge.name;
  }
}

// What touches things is the capsules: the skin is to be where they are.
TEST_F(HumanSkin, StaysNearItsCapsules) {
  const std::vector<SkinnedVertex> vertices = Standing();
  double sum = 0.0, most = 0.0;
  for (size_t i = 0; i < body().positions.size(); ++i) {
    const Vec3 p = PlaceOf(vertices[i]);
    double nearest = 1e9;
    for (const Link& link : figure_.links()) {
      const BodyScratch& bone = link.joint.is_valid() ? ws_.body(link.joint) : ws_.bodies[0];
      const Vec3 a = bone.p + bone.R * link.capsule.a, b = bone.p + bone.R * link.capsule.b;
      const double along =
          std::clamp((p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-12), 0.0, 1.0);
      nearest = std::min(nearest, (p - a - along * (b - a)).norm() - link.capsule.radius);
    }
    sum += std::abs(nearest);
    most = std::max(most, std::abs(nearest));
  }
  EXPECT_LT(sum / static_cast<double>(body().positions.size()), 0.015);
  EXPECT_LT(most, 0.07);
}

}  // namespace
}  // namespace hazumi::render
