// Assertions of regions: each family fires where its invariant does not hold.

#include <gtest/gtest.h>

#include <limits>

#include "engine/matrix/semidefinite.h"
#include "engine/region/exact/exact_solver.h"
#include "tests/unit/region/random_island.h"

#ifndef NDEBUG

namespace hazumi::test {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

RegionDynamics DynamicsOf(const RandomIsland& island) {
  RegionDynamics dynamics(island.model, ForceLaws(), RandomIsland::kGravity);
  dynamics.SetDriven(&island.driven, -0.01, 0.01);
  return dynamics;
}

TEST(AssertionsDeathTest, SizesHaveToFit) {
  VecX x = VecX::Zero(2);
  EXPECT_DEATH(SolveSemidefinite(MatX::Identity(3, 3), x), "demand failed.*size");
  const auto island = RandomIsland::Of(1, RootCoupling::kFlight);
  RegionDynamics dynamics = DynamicsOf(*island);
  VecX y(dynamics.state_size());
  const HingeState shorter(dynamics.num_hinges() - 1, 0);
  EXPECT_DEATH(dynamics.Pack(shorter, y.data()), "demand failed.*size");
}

TEST(AssertionsDeathTest, StatesHaveToBeFinite) {
  const auto island = RandomIsland::Of(1, RootCoupling::kFlight);
  RegionDynamics dynamics = DynamicsOf(*island);
  const VecX none = VecX::Constant(island->q.size(), std::numeric_limits<double>::infinity());
  ExactSolver solver(&dynamics, -none, none);
  HingeState state = dynamics.NewState();
  state.qd.setConstant(kNan);
  EXPECT_DEATH(solver.Start(0.0, state), "demand failed.*IsFinite");
}

TEST(AssertionsDeathTest, PlacementsHaveToBeTheLatest) {
  const auto island = RandomIsland::Of(1, RootCoupling::kFlight);
  RegionDynamics dynamics = DynamicsOf(*island);
  const HingeState state(island->q, island->qd), other(island->q, island->qd);
  dynamics.PlaceHinges(0.0, state);
  EXPECT_DEATH(dynamics.PlacedHinges(0.001, state), "demand failed.*placed_at_");
  EXPECT_DEATH(dynamics.PlacedHinges(0.0, other), "demand failed.*placed_at_");
}

TEST(AssertionsDeathTest, MatricesHaveToBeSymmetric) {
  MatX A = MatX::Identity(2, 2);
  A(0, 1) = 0.5;
  EXPECT_DEATH(LeastNorm(A, VecX::Ones(2)), "demand failed.*IsSymmetric");
}

TEST(AssertionsDeathTest, ComplianceHasToBePositive) {
  const MatX A = MatX::Identity(2, 2);
  EXPECT_DEATH(SolveGivingWay(A, /*is_symmetric=*/true, VecX::Ones(2), VecX::Constant(2, -1.0)),
               "demand failed.*IsNonnegative");
}

}  // namespace
}  // namespace hazumi::test

#endif
