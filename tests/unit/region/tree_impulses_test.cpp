// Impulses on several bodies of a tree, all at once and one after the other on a tour, against
// impulses on articulated bodies one at a time.

#include "engine/region/equations/tree_impulses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/compare.h"
#include "tests/unit/region/random_island.h"

namespace hazumi::test {
namespace {

using small::V3;

constexpr double kTreeTolerance = 1e-9;
constexpr uint64_t kSeeds = 60;

struct Pushed {
  explicit Pushed(const RandomIsland& island)
      : layout(island.model, /*balls=*/false),
        kinematics(MovedBy(island, layout)),
        bodies(island.model),
        impulses(island.model),
        x(VecX::Zero(layout.num_dofs())) {
    bodies.Solve(layout, kinematics.motion(), x.data());
    impulses.Begin(layout, kinematics.motion(), bodies);
    impulses.Clear();
  }
  VecX RatesOfImpulse(int node, const V3& r, const V3& f) {
    bodies.Push(layout, kinematics.motion(), node, r, f, x.data());
    return x;
  }
  VecX RatesOfHingeImpulse(const FreeHinge& hinge) {
    bodies.Twist(layout, kinematics.motion(), hinge.node, hinge.slot, x.data());
    return x;
  }

  RegionLayout layout;
  NodeKinematics kinematics;
  ArticulatedBodies bodies;
  TreeImpulses impulses;
  VecX x;
};

template <typename Check>
void ForEachIsland(Check&& check) {
  for (const RootCoupling coupling : {RootCoupling::kPrescribed, RootCoupling::kFlight}) {
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const auto island = RandomIsland::Of(seed, coupling);
      SCOPED_TRACE("seed " + std::to_string(seed));
      if (island) check(island.get());
    }
  }
}

TreeImpulses::Impulse At(const V3& r, const V3& f) { return {Cross(r, f), f}; }

TEST(TreeImpulses, ImpulsesSettledTogether_EqualImpulsesOneByOne) {
  Worst worst("settled");
  ForEachIsland([&](RandomIsland* island) {
    Pushed tree(*island);
    VecX expected = VecX::Zero(tree.layout.num_dofs());
    for (int i = 0; i < static_cast<int>(island->model.nodes.size()); ++i) {
      if (!island->model.nodes[i].is_dynamic) continue;
      const V3 r(island->random.Vector3(0.3)), f(island->random.Vector3(5.0));
      expected += tree.RatesOfImpulse(i, r, f);
      tree.impulses.Add(i, At(r, f));
    }
    for (const FreeHinge& hinge : tree.layout.hinges()) {
      const double twist = island->random.Uniform(-1.0, 1.0);
      expected += twist * tree.RatesOfHingeImpulse(hinge);
      tree.impulses.AddAboutHinge(hinge.node, hinge.slot, twist);
    }
    tree.impulses.Settle();
    EXPECT_LE(worst(RelativeDifference(tree.impulses.Rates(), expected)), kTreeTolerance);
  });
}

// Impulses applied so far.
struct Given {
  std::vector<std::pair<int, TreeImpulses::Impulse>> on_nodes;
  std::vector<std::pair<FreeHinge, double>> about_hinges;
};

TreeImpulses::Motion MotionBy(const Given& given, const RandomIsland& island, int node) {
  Pushed tree(island);
  for (const auto& [at, impulse] : given.on_nodes) tree.impulses.Add(at, impulse);
  for (const auto& [hinge, impulse] : given.about_hinges) {
    tree.impulses.AddAboutHinge(hinge.node, hinge.slot, impulse);
  }
  tree.impulses.Settle();
  return tree.impulses.Of(node);
}

// Applies impulses to hinges before a tour reaches their node and after it leaves the node, and to
// nodes in between.
TEST(TreeImpulses, NodeThatATourReaches_MovesByAllImpulsesSoFar) {
  Worst worst("tour");
  ForEachIsland([&](RandomIsland* island) {
    Pushed tree(*island);
    Given given;
    const auto apply_hinge_impulses = [&](int node) {
      for (const FreeHinge& hinge : tree.layout.hinges()) {
        if (hinge.node != node) continue;
        const double impulse = island->random.Uniform(-1.0, 1.0);
        tree.impulses.PushHinge(node, hinge.slot, impulse);
        given.about_hinges.push_back({hinge, impulse});
      }
    };
    tree.impulses.Settle();
    for (const TreeImpulses::Step& step : tree.impulses.tour()) {
      if (!step.up) apply_hinge_impulses(step.node);
      if (!step.up) tree.impulses.Take(step);
      const auto impulse = At(V3(island->random.Vector3(0.3)), V3(island->random.Vector3(5.0)));
      tree.impulses.Push(step.node, impulse);
      given.on_nodes.push_back({step.node, impulse});
      const TreeImpulses::Motion actual = tree.impulses.Of(step.node);
      const TreeImpulses::Motion expected = MotionBy(given, *island, step.node);
      EXPECT_LE(worst(RelativeDifference(actual.w.eigen(), expected.w.eigen())), kTreeTolerance);
      EXPECT_LE(worst(RelativeDifference(actual.v.eigen(), expected.v.eigen())), kTreeTolerance);
      if (step.up) tree.impulses.Take(step);
      if (step.up) apply_hinge_impulses(step.node);
    }
  });
}

TEST(TreeImpulses, ResponseOfAHinge_IsTheInverseInertia) {
  Worst worst("hinge");
  ForEachIsland([&](RandomIsland* island) {
    Pushed tree(*island);
    for (int i = 0; i < tree.layout.num_dofs(); ++i) {
      const FreeHinge& hinge = tree.layout.hinges()[i];
      const double expected = tree.RatesOfHingeImpulse(hinge)[i];
      const double actual = tree.impulses.ResponseOfHinge(hinge.node, hinge.slot);
      EXPECT_LE(worst(std::abs(actual - expected) / std::abs(expected)), kTreeTolerance);
    }
  });
}

}  // namespace
}  // namespace hazumi::test
