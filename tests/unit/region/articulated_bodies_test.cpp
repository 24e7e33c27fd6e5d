// Articulated bodies against the dense equations M x = -b of the same island: what they make the
// bodies do, whatever the layout of the joints is.

#include "engine/region/equations/articulated_bodies.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "engine/matrix/semidefinite.h"
#include "tests/support/compare.h"
#include "tests/unit/region/random_island.h"

namespace hazumi::test {
namespace {

using small::V3;

constexpr double kTreeTolerance = 1e-9;
constexpr uint64_t kSeeds = 100;
constexpr RootCoupling kCouplings[] = {RootCoupling::kPrescribed, RootCoupling::kFlight};

template <typename Check>
void ForEachIsland(Check&& check) {
  for (const RootCoupling coupling : kCouplings) {
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const auto island = RandomIsland::Of(seed, coupling);
      SCOPED_TRACE("seed " + std::to_string(seed) + (coupling == kCouplings[0] ? "" : ", flying"));
      if (island) check(island.get());
    }
  }
}

// Angular accelerations of all dynamic nodes and accelerations of their origins, from the root's.
VecX BodiesAccelerated(const RandomIsland& island, const RegionLayout& layout, const VecX& x) {
  NodeKinematics kinematics = MovedBy(island, layout);
  int first = 0;
  while (!island.model.nodes[first].is_dynamic) ++first;
  kinematics.Accelerate(layout, x.data(), first);
  VecX all(6 * (kinematics.size() - first));
  for (int i = first; i < kinematics.size(); ++i) {
    all.segment<3>(6 * (i - first)) = kinematics.motion()[i].alpha.eigen();
    all.segment<3>(6 * (i - first) + 3) = kinematics.motion()[i].a.eigen();
  }
  return all;
}

VecX SolvedBy(const RandomIsland& island, const RegionLayout& layout) {
  ArticulatedBodies articulated(island.model);
  VecX x(layout.num_dofs());
  articulated.Solve(layout, MovedBy(island, layout).motion(), x.data());
  return x;
}

TEST(ArticulatedBodies, AccelerateChainsOfHingesAsTheDenseEquations) {
  Worst worst("hinges");
  ForEachIsland([&](RandomIsland* island) {
    const IslandEquations dense = Assembled(*island);
    const VecX expected = dense.M.llt().solve(-dense.b);
    const VecX x = SolvedBy(*island, RegionLayout(island->model, /*balls=*/false));
    EXPECT_LE(worst(RelativeDifference(x, expected)), kTreeTolerance);
  });
}

TEST(ArticulatedBodies, AccelerateBodiesOnBallJointsAsTheDenseEquations) {
  Worst worst("balls");
  int balls = 0;
  ForEachIsland([&](RandomIsland* island) {
    const IslandEquations dense = Assembled(*island);
    const RegionLayout hinges(island->model, /*balls=*/false),
        layout(island->model, /*balls=*/true);
    balls += layout.num_positions() - layout.num_dofs();
    const VecX expected = BodiesAccelerated(*island, hinges, dense.M.llt().solve(-dense.b));
    const VecX actual = BodiesAccelerated(*island, layout, SolvedBy(*island, layout));
    EXPECT_LE(worst(RelativeDifference(actual, expected)), kTreeTolerance);
  });
  EXPECT_GT(balls, 50);
}

// What is locked stands in equations of its own, x = 0.
VecX SolveUnlocked(const IslandEquations& dense, const std::vector<char>& locked) {
  MatX M = dense.M;
  VecX right = -dense.b;
  for (Eigen::Index i = 0; i < right.size(); ++i) {
    if (!locked[static_cast<size_t>(i)]) continue;
    M.row(i).setZero();
    M.col(i).setZero();
    M(i, i) = 1.0;
    right[i] = 0.0;
  }
  return M.llt().solve(right);
}

TEST(ArticulatedBodies, LeaveLockedHingesWhereTheyAre) {
  Worst worst("locked");
  int locked_balls = 0;
  ForEachIsland([&](RandomIsland* island) {
    std::vector<char> locked;
    for (double& rate : island->qd) {
      locked.push_back(island->random.Chance(0.3));
      if (locked.back()) rate = 0.0;
    }
    const RegionLayout hinges(island->model, /*balls=*/false);
    RegionLayout layout(island->model, /*balls=*/true);
    const int balls = layout.num_positions() - layout.num_dofs();
    layout.SetLocked(locked, island->q);
    locked_balls += balls - (layout.num_positions() - layout.num_dofs());
    const VecX expected =
        BodiesAccelerated(*island, hinges, SolveUnlocked(Assembled(*island), locked));
    const VecX actual = BodiesAccelerated(*island, layout, SolvedBy(*island, layout));
    EXPECT_LE(worst(RelativeDifference(actual, expected)), kTreeTolerance);
  });
  EXPECT_GT(locked_balls, 20);
}

// A joint with nothing beyond it does not accelerate, and the others do as if it were not there.
TEST(ArticulatedBodies, GiveNothingToADirectionThatMovesNoMass) {
  Worst worst("massless");
  int massless = 0;
  ForEachIsland([&](RandomIsland* island) {
    ModelNode& last = island->model.nodes.back();
    if (last.role != Role::kFree || island->model.num_bodies < 2) return;
    ++massless;
    island->model.mass -= last.body.mass;
    last.body = RigidInertia();
    const IslandEquations dense = Assembled(*island);
    MatX L = dense.M;
    VecX expected = -dense.b;
    FactorSemidefinite(L);
    SolveSemidefinite(L, expected);
    const VecX x = SolvedBy(*island, RegionLayout(island->model, /*balls=*/false));
    EXPECT_TRUE(x.tail(last.num_hinges).isZero(0.0));
    EXPECT_LE(worst((x - expected).norm() / (1.0 + expected.norm())), kTreeTolerance);
  });
  EXPECT_GT(massless, 50);
}

// How the velocity of a point of a node, r from its origin, follows from the hinges' rates, and in
// flight from the root's that answers them.
Eigen::Matrix3Xd PointJacobian(const RandomIsland& island, int node, const V3& r) {
  const RegionLayout layout(island.model, /*balls=*/false);
  const NodeKinematics kinematics = MovedBy(island, layout);
  const auto& motion = kinematics.motion();
  Eigen::Matrix3Xd J = Eigen::Matrix3Xd::Zero(3, layout.num_dofs());
  const auto add = [&](int of, const V3& point, double weight) {
    for (int i = of; i >= 0; i = island.model.nodes[i].parent) {
      const RegionLayout::Node& where = layout.node(i);
      for (int k = 0; k < where.num_dofs; ++k) {
        J.col(where.dof + k) += weight * Cross(motion[i].axis[k], point - motion[i].p).eigen();
      }
    }
  };
  add(node, motion[node].p + r, 1.0);
  if (island.model.coupling != RootCoupling::kFlight) return J;
  for (int i = 0; i < kinematics.size(); ++i) {
    if (motion[i].m == 0.0) continue;
    const V3 com = motion[i].p + (1.0 / motion[i].m) * motion[i].h;
    add(i, com, -motion[i].m / island.model.mass);
  }
  return J;
}

int AnyDynamicNode(RandomIsland* island) {
  const int count = static_cast<int>(island->model.nodes.size());
  int node = island->random.Integer(0, count - 1);
  while (!island->model.nodes[node].is_dynamic) node = island->random.Integer(0, count - 1);
  return node;
}

// x = M^-1 J^T f, and J x + f / m of a flying figure, where the force moves the root too.
TEST(ArticulatedBodies, AnswerAPushAsTheDenseEquations) {
  Worst worst("push");
  ForEachIsland([&](RandomIsland* island) {
    const int node = AnyDynamicNode(island), other = AnyDynamicNode(island);
    const V3 r(island->random.Vector3(0.3)), at(island->random.Vector3(0.3));
    const Vec3 force = island->random.Vector3(50.0);
    const bool flies = island->model.root_answers;
    const VecX x =
        Assembled(*island).M.llt().solve(PointJacobian(*island, node, r).transpose() * force);
    Vec3 expected = PointJacobian(*island, other, at) * x;
    if (flies) expected += force / island->model.mass;
    for (const bool balls : {false, true}) {
      const RegionLayout layout(island->model, balls);
      const NodeKinematics kinematics = MovedBy(*island, layout);
      ArticulatedBodies articulated(island->model);
      VecX pushed(layout.num_dofs());
      articulated.Solve(layout, kinematics.motion(), pushed.data());
      articulated.Push(layout, kinematics.motion(), node, r, V3(force), pushed.data());
      const double size = expected.norm() + x.norm();
      const Vec3 actual = articulated.AccelerationAt(other, at).eigen();
      EXPECT_LE(worst((actual - expected).norm() / size), kTreeTolerance) << "balls " << balls;
      if (balls) continue;
      EXPECT_LE(worst((pushed - x).norm() / size), kTreeTolerance);
    }
  });
}

// How a body turns, by how its points move.
V3 TurnOf(const ArticulatedBodies& bodies, int node) {
  const V3 origin = bodies.AccelerationAt(node, {});
  const auto across = [&](const V3& r) { return bodies.AccelerationAt(node, r) - origin; };
  return {across({0.0, 1.0, 0.0}).z, across({0.0, 0.0, 1.0}).x, across({1.0, 0.0, 0.0}).y};
}

TEST(ArticulatedBodies, AnswerAPushByHalvesAsByAPush) {
  Worst worst("halves");
  ForEachIsland([&](RandomIsland* island) {
    const int node = AnyDynamicNode(island), other = AnyDynamicNode(island);
    const V3 r(island->random.Vector3(0.3)), at(island->random.Vector3(0.3));
    const V3 force(island->random.Vector3(50.0)), along(island->random.Vector3(1.0));
    for (const bool balls : {false, true}) {
      const RegionLayout layout(island->model, balls);
      const NodeKinematics kinematics = MovedBy(*island, layout);
      const auto& motion = kinematics.motion();
      ArticulatedBodies bodies(island->model);
      VecX pushed(layout.num_dofs()), finished(layout.num_dofs());
      bodies.Solve(layout, motion, pushed.data());
      bodies.FactorJoints(layout, motion);
      VecX half = VecX::Zero(bodies.num_root() + layout.num_dofs()), moved = half, turned = half;
      bodies.AddHalf(layout, motion, node, r, force, /*turns=*/false, half.data());
      bodies.AddHalf(layout, motion, other, at, along, /*turns=*/false, moved.data());
      bodies.AddHalf(layout, motion, other, at, along, /*turns=*/true, turned.data());
      bodies.FinishHalf(layout, motion, half.data(), finished.data());
      bodies.Push(layout, motion, node, r, force, pushed.data());
      const V3 a = bodies.AccelerationAt(other, at), alpha = TurnOf(bodies, other);
      const double size = pushed.norm() + half.norm() * (moved.norm() + turned.norm());
      EXPECT_LE(worst((finished - pushed).norm() / size), kTreeTolerance) << "balls " << balls;
      EXPECT_LE(worst(std::abs(moved.dot(half) - Dot(along, a)) / size), kTreeTolerance);
      EXPECT_LE(worst(std::abs(turned.dot(half) - Dot(along, alpha)) / size), kTreeTolerance);
    }
  });
}

TEST(ArticulatedBodies, AnswerATorqueAboutAHingeWithAColumnOfTheInverse) {
  Worst worst("twist");
  ForEachIsland([&](RandomIsland* island) {
    const RegionLayout layout(island->model, /*balls=*/false);
    const NodeKinematics kinematics = MovedBy(*island, layout);
    const MatX inverse =
        Assembled(*island).M.llt().solve(MatX::Identity(layout.num_dofs(), layout.num_dofs()));
    ArticulatedBodies articulated(island->model);
    VecX x(layout.num_dofs());
    articulated.Solve(layout, kinematics.motion(), x.data());
    for (int i = 0; i < layout.num_dofs(); ++i) {
      const FreeHinge& hinge = layout.hinges()[i];
      articulated.Twist(layout, kinematics.motion(), hinge.node, hinge.slot, x.data());
      EXPECT_LE(worst(RelativeDifference(x, inverse.col(i))), kTreeTolerance) << "hinge " << i;
    }
  });
}

// What was pushed or twisted leaves nothing behind.
TEST(ArticulatedBodies, SolveTheSameBitsAfterAPush) {
  ForEachIsland([&](RandomIsland* island) {
    const RegionLayout layout(island->model, /*balls=*/true);
    const NodeKinematics kinematics = MovedBy(*island, layout);
    ArticulatedBodies articulated(island->model);
    VecX first(layout.num_dofs()), x(layout.num_dofs());
    articulated.Solve(layout, kinematics.motion(), first.data());
    articulated.Push(layout, kinematics.motion(), AnyDynamicNode(island), V3(), V3(1.0, 2.0, 3.0),
                     x.data());
    articulated.Solve(layout, kinematics.motion(), x.data());
    EXPECT_EQ(x, first);
  });
}

}  // namespace
}  // namespace hazumi::test
