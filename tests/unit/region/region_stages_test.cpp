// Stages of the equations of motion of a region.

#include <gtest/gtest.h>

#include <type_traits>

#include "engine/region/forces/force_spec.h"
#include "tests/unit/region/random_island.h"

namespace hazumi::test {
namespace {

// Each stage takes the result of the one before, which only that returns.
static_assert(!std::is_constructible_v<LoadedState, const RegionState&, NodeKinematics*>);
static_assert(!std::is_invocable_v<decltype(&EquationsOfMotion::Assemble), EquationsOfMotion*,
                                   const RegionState&>);
static_assert(!std::is_constructible_v<AssembledEquations, EquationsOfMotion*, EquationsMethod,
                                       const RegionState&>);
static_assert(!std::is_invocable_v<decltype(&RowSystem::Respond), RowSystem*, const RowMatrices&,
                                   const AssembledEquations&>);

// An island with friction whose last node is drawn to a point of the world.
RegionDynamics Drawn(const RandomIsland& island) {
  ConstraintSpec constraint;
  constraint.a.node = static_cast<int>(island.model.nodes.size()) - 1;
  constraint.b.node = ConstraintSeat::kWorld;
  constraint.b.p = Vec3(0.4, 0.1, 0.3);
  constraint.closing_rate = 5.0;
  RegionDynamics dynamics(island.model, FrictionAlone(VecX::Constant(island.q.size(), 2.0)),
                          RandomIsland::kGravity, {constraint});
  dynamics.SetDriven(&island.driven, -0.01, 0.01);
  dynamics.mode().anchor.p = Vec3(0.3, -0.2, 1.1);
  return dynamics;
}

TEST(RegionDynamics, DerivativeIsAFunctionOfModeTimeAndState) {
  int islands = 0;
  for (const RootCoupling coupling :
       {RootCoupling::kPrescribed, RootCoupling::kPinned, RootCoupling::kFlight}) {
    for (uint64_t seed = 1; seed <= 40; ++seed) {
      const auto island = RandomIsland::Of(seed, coupling);
      if (!island) continue;
      ++islands;
      RegionDynamics dynamics = Drawn(*island), other = Drawn(*island);
      const auto state = [&](double share) {
        HingeState all = dynamics.NewState();
        all.q = share * island->q;
        all.qd = share * island->qd;
        all.outer.anchor.p = Vec3(0.1, 0.2, share);
        return all;
      };
      const auto packed = [&](const HingeState& of) {
        VecX y(dynamics.state_size());
        dynamics.Pack(of, y.data());
        return y;
      };
      const VecX y = packed(state(1.0)), elsewhere = packed(state(0.7));
      VecX dy(y.size()), again(y.size()), unused(y.size());
      dynamics.Derivative(0.001, y.data(), dy.data());
      dynamics.Derivative(-0.002, elsewhere.data(), unused.data());
      dynamics.AssembleHinges(0.0, state(0.5));
      dynamics.PlaceHinges(0.0, state(0.6));
      dynamics.Derivative(0.001, y.data(), again.data());
      EXPECT_EQ(dy, again) << "seed " << seed;
      other.Derivative(0.001, y.data(), again.data());
      EXPECT_EQ(dy, again) << "seed " << seed;
    }
  }
  EXPECT_GE(islands, 60);
}

}  // namespace
}  // namespace hazumi::test
