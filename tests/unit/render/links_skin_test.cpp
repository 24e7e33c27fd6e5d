#include <gtest/gtest.h>

#include <map>

#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "render/motion/figure_skin.h"
#include "tests/support/stick_figures.h"

namespace hazumi::render {
namespace {

// The skin of a sphere lies on it however the figure is bent.
TEST(LinksSkin, FollowsTheBodies) {
  const Figure figure = test::TwoLinks();
  const Skin skin = SkinOfLinks(figure, 12);
  ASSERT_EQ(skin.meshes.size(), 1u);  // of one colour
  const SkinMesh& mesh = skin.meshes[0];
  EXPECT_EQ(skin.bones, (std::vector<SkinBone>{figure.root_name(), "knee", "foot"}));
  DynamicsWorkspace ws(figure);
  VecX q(2);
  q << 0.7, -0.4;
  ComputePositions(figure, {Mat3::Identity(), Vec3(1, 2, 3)}, q, &ws);
  int num_on_foot = 0;
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const SkinMesh::Bind& bind = mesh.binds[mesh.bind_indices[v][0]];
    if (skin.bones[static_cast<size_t>(bind.bone)].joint != "foot") continue;
    const auto& foot = ws.body(JointIndex(1));
    const Eigen::Vector4d p = bind.inverse_bind * mesh.positions[v].cast<double>().homogeneous();
    const Vec3 p_W = foot.p + foot.R * Vec3(p.head<3>());
    EXPECT_NEAR((p_W - foot.p).norm(), 0.05, 1e-6);
    ++num_on_foot;
  }
  EXPECT_GT(num_on_foot, 20);
}

// Poles are one vertex, and every edge belongs to two triangles: nothing is open.
TEST(LinksSkin, IsWeldedAndClosed) {
  const Skin skin = SkinOfLinks(test::Pogo(), 8);
  const SkinMesh& mesh = skin.meshes[0];
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
  // Of a closed surface like a sphere's: V - E + F = 2 for each of the two.
  const auto faces = static_cast<int>(mesh.triangles.size());
  EXPECT_EQ(static_cast<int>(mesh.positions.size()) - faces / 2, 4);
}

TEST(LinksSkin, HasAMeshForEachColour) {
  FigureSpec spec;
  spec.name = "f";
  spec.root_name = "root";
  LinkSpec link;
  link.name = "body";
  link.to = Vec3(0, 0, 1);
  link.radius = 0.1;
  link.mass = 1.0;
  Look look;
  look.to = link.to;
  look.radius_from = look.radius_to = 0.1;
  look.color = "#ffffff";
  link.looks = {look, look};
  link.looks[1].color = "#000000";
  spec.root_links = {link};
  const Skin skin = SkinOfLinks(BuildFigure(spec).value());
  ASSERT_EQ(skin.meshes.size(), 2u);
  EXPECT_EQ(skin.materials[0].base_color, (std::array<float, 4>{1, 1, 1, 1}));
  EXPECT_EQ(skin.materials[1].base_color, (std::array<float, 4>{0, 0, 0, 1}));
}

}  // namespace
}  // namespace hazumi::render
