#include "render/mesh/linear_blend.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tube.h"

namespace hazumi::render {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr double kLength = 2.0;

std::shared_ptr<Skin> Tube() { return std::make_shared<Skin>(*TubeSkin(kLength, 12, 20)); }

SkinnedFigure FigureOf(std::shared_ptr<const Skin> skin) {
  const auto model = MakeSkinModel(std::move(skin));
  EXPECT_TRUE(model.ok()) << model.error().ToString();
  return RestingTube(model.value(), kLength);
}

std::vector<SkinnedVertex> PosedBy(const SkinnedFigure& figure) {
  std::vector<SkinnedVertex> vertices;
  PoseSkin(figure, &vertices);
  return vertices;
}

Vec3f Position(const SkinnedVertex& v) {
  return Vec3f(v.position[0], v.position[1], v.position[2]);
}
Vec3f Normal(const SkinnedVertex& v) { return Vec3f(v.normal[0], v.normal[1], v.normal[2]); }

Pose Turned(double angle, const Vec3& axis, const Vec3& p) {
  return {AxisRotation<double>(axis, std::sin(angle), std::cos(angle)), p};
}

TEST(LinearBlend, TheBindPoseGivesTheMeshItself) {
  const SkinnedFigure figure = FigureOf(Tube());
  const SkinMesh& mesh = figure.model->skin->meshes[0];
  const std::vector<SkinnedVertex> vertices = PosedBy(figure);
  ASSERT_EQ(vertices.size(), mesh.positions.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_LE((Position(vertices[i]) - mesh.positions[i]).norm(), 1e-6f);
    EXPECT_LE((Normal(vertices[i]) - mesh.normals[i]).norm(), 1e-6f);
  }
}

TEST(LinearBlend, MovesTheWholeLikeARigidBody) {
  SkinnedFigure figure = FigureOf(Tube());
  const Pose X = Turned(1.1, Vec3(1, 2, 3).normalized(), {4, -5, 6});
  for (Pose& X_WB : figure.X_WB) X_WB = X * X_WB;
  const SkinMesh& mesh = figure.model->skin->meshes[0];
  const std::vector<SkinnedVertex> vertices = PosedBy(figure);
  for (size_t i = 0; i < vertices.size(); ++i) {
    const Vec3f expected = (X * Vec3(mesh.positions[i].cast<double>())).cast<float>();
    EXPECT_LE((Position(vertices[i]) - expected).norm(), 3e-6f);
    EXPECT_LE((Normal(vertices[i]) - X.R.cast<float>() * mesh.normals[i]).norm(), 3e-6f);
  }
}

// Bent by a right angle: the lower end stays, the upper end turns about the joint, and a vertex of
// equal weights is the mean of where the two would take it.
TEST(LinearBlend, BendsBetweenTwoBones) {
  SkinnedFigure figure = FigureOf(Tube());
  figure.X_WB[1] = Turned(M_PI / 2, Vec3::UnitX(), {0, 0, 1});
  const SkinMesh& mesh = figure.model->skin->meshes[0];
  const std::vector<SkinnedVertex> vertices = PosedBy(figure);
  int halves = 0;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 v = mesh.positions[i].cast<double>();
    const Vec3 turned = figure.X_WB[1] * Vec3(v - Vec3(0, 0, 1));
    const double upper = mesh.weights[i][1];
    const Vec3f expected = ((1.0 - upper) * v + upper * turned).cast<float>();
    EXPECT_LE((Position(vertices[i]) - expected).norm(), 2e-6f);
    halves += std::abs(upper - 0.5) < 1e-6;
  }
  EXPECT_GT(halves, 0);
}

// A normal stays at right angles to the surface where a bind stretches it unevenly, and outward
// where it mirrors.
TEST(LinearBlend, NormalsStayAtRightAnglesUnderStretchAndMirror) {
  for (const double mirror : {1.0, -1.0}) {
    const auto skin = Tube();
    SkinMesh& mesh = skin->meshes[0];
    for (Vec3f& n : mesh.normals) n = Vec3f(1, 1, 1).normalized();
    const Vec3f along(1, -1, 0), across(1, 1, -2);  // in the surface
    const Eigen::Vector3d stretch(3.0 * mirror, 0.5, 1.0);
    for (SkinMesh::Bind& bind : mesh.binds) {
      bind.inverse_bind = Eigen::Matrix4d::Identity();
      bind.inverse_bind.diagonal().head<3>() = stretch;
    }
    const Vec3f n = Normal(PosedBy(FigureOf(skin))[0]), s = stretch.cast<float>();
    EXPECT_NEAR(n.norm(), 1.0f, 1e-6f);
    EXPECT_NEAR(n.dot(s.cwiseProduct(along)), 0.0f, 1e-5f);
    EXPECT_NEAR(n.dot(s.cwiseProduct(across)), 0.0f, 1e-5f);
    EXPECT_GT(n.dot(s.cwiseProduct(Vec3f(1, 1, 1))), 0.0f);
  }
}

TEST(LinearBlend, TintsByTheBonesWeights) {
  SkinnedFigure figure = FigureOf(Tube());
  figure.tints = {{0, 0, 0, 0}, {1, 0, 0, 0.5f}};
  const std::vector<SkinnedVertex> vertices = PosedBy(figure);
  EXPECT_EQ(vertices.front().tint[3], 0);
  EXPECT_NEAR(vertices.back().tint[0], 127, 1);
  EXPECT_NEAR(vertices.back().tint[3], 127, 1);
  EXPECT_NEAR(vertices[vertices.size() / 2].tint[3], 64, 1);
}

// Such vertices come with real files: nothing of them becomes infinite or flies off.
TEST(LinearBlend, TakesVerticesWithoutWeightsOrNormal) {
  const auto skin = Tube();
  skin->meshes[0].weights[0] = {0, 0, 0, 0};
  skin->meshes[0].weights[1] = {0.25f, 0, 0, 0};
  skin->meshes[0].normals[2].setZero();
  const std::vector<SkinnedVertex> vertices = PosedBy(FigureOf(skin));
  for (int i = 0; i < 2; ++i) {
    EXPECT_LE((Position(vertices[i]) - skin->meshes[0].positions[i]).norm(), 1e-6f);
  }
  EXPECT_EQ(Normal(vertices[2]), Vec3f::Zero());
}

TEST(SkinModel, RefusesWhatWouldReadOutsideAndNamesThePlace) {
  const auto place_of = [](auto&& damage) {
    const auto skin = Tube();
    damage(*skin);
    const auto model = MakeSkinModel(skin);
    return model.ok() ? std::string("accepted") : model.error().place;
  };
  EXPECT_EQ(place_of([](Skin&) {}), "accepted");
  EXPECT_EQ(place_of([](Skin& s) { s.meshes[0].triangles[3][1] = 9999; }),
            "meshes[0].triangles[3]");
  EXPECT_EQ(place_of([](Skin& s) { s.meshes[0].bind_indices[5][3] = 2; }),
            "meshes[0].bind_indices[5]");
  EXPECT_EQ(place_of([](Skin& s) { s.meshes[0].binds[1].bone = 2; }), "meshes[0].binds[1].bone");
  EXPECT_EQ(place_of([](Skin& s) { s.meshes[0].material = 1; }), "meshes[0].material");
  EXPECT_EQ(place_of([](Skin& s) { s.materials[0].texture = -2; }), "materials[0].texture");
  EXPECT_EQ(place_of([](Skin& s) { s.meshes[0].normals.pop_back(); }), "meshes[0].normals");
  EXPECT_EQ(place_of([](Skin& s) { s.meshes[0].positions[7].x() = NAN; }),
            "meshes[0].positions[7]");
}

TEST(SkinModel, SaysWhichTextureItCannotReadAndUsesTheColourAlone) {
  const auto skin = Tube();
  skin->textures[0].encoded.resize(40);
  const auto model = MakeSkinModel(skin);
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model.value()->warnings.size(), 1u);
  EXPECT_EQ(model.value()->warnings[0].place, "textures[0] halves");
  EXPECT_EQ(model.value()->parts[0].texture, -1);
}

}  // namespace
}  // namespace hazumi::render
