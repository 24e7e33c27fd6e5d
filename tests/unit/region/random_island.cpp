#include "tests/unit/region/random_island.h"

#include <utility>

#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

namespace {

Role AnyRole(double free_share, Random* random) {
  if (random->Chance(free_share)) return Role::kFree;
  return random->Chance(0.5) ? Role::kDriven : Role::kConstant;
}

// By Coordinate; the root's three have one role.
std::vector<Role> AnyRoles(int joints, RootCoupling coupling, Random* random) {
  const double free_share = random->Uniform(0.2, 1.0);
  std::vector<Role> roles;
  for (int j = 0; j < joints; ++j) roles.push_back(AnyRole(free_share, random));
  const bool flies = coupling == RootCoupling::kFlight;
  roles.insert(roles.end(), kRootAngles, AnyRole(flies ? 0.5 : 0.0, random));
  return roles;
}

DrivenCurve CurveFrom(double value, double rate, Random* random) {
  DrivenCurve curve;
  curve.degree = 2;
  curve.c[0] = value;
  curve.c[1] = rate;
  curve.c[2] = random->Uniform(-10.0, 10.0);
  return curve;
}

}  // namespace

std::unique_ptr<RandomIsland> RandomIsland::Of(uint64_t seed, RootCoupling coupling) {
  auto island = std::make_unique<RandomIsland>(RandomIsland{Random(seed), {}, {}, {}, {}});
  Random& random = island->random;
  const Figure figure = Build(RandomTreeSpec(&random));
  const int n = figure.num_joints();
  ModelRequest request;
  request.coupling = coupling;
  request.roles = AnyRoles(n, coupling, &random);
  request.angles.resize(n + kRootAngles);
  request.angles << RandomAngles(figure, &random), random.Vector(kRootAngles, 1.0);
  const VecX rates = random.Vector(n + kRootAngles, 3.0);
  if (coupling == RootCoupling::kPinned) request.pin = JointIndex(random.Integer(0, n - 1));
  for (int c = 0; c < n + kRootAngles; ++c) {
    island->driven.angles.push_back(CurveFrom(request.angles[c], rates[c], &random));
  }
  for (DrivenCurve& curve : island->driven.root_position) curve = CurveFrom(0.5, 1.0, &random);
  std::vector<RegionModel> models = CompileRegionModels(figure, request);
  if (models.empty()) return nullptr;
  island->model = std::move(
      models[static_cast<size_t>(random.Integer(0, static_cast<int>(models.size()) - 1))]);
  Random of_drives(seed);
  for (size_t i = 0; i < island->driven.angles.size(); ++i) {  // as many as any island reads
    island->driven.drives.push_back(
        CurveFrom(of_drives.Uniform(-1.0, 1.0), of_drives.Uniform(-1.0, 1.0), &of_drives));
  }
  const RegionLayout layout(island->model, /*balls=*/false);
  island->q.resize(layout.num_hinges());
  island->qd.resize(layout.num_hinges());
  for (int i = 0; i < layout.num_hinges(); ++i) {
    island->q[i] = request.angles[layout.hinges()[i].coordinate];
    island->qd[i] = rates[layout.hinges()[i].coordinate];
  }
  return island;
}

NodeKinematics MovedBy(const RandomIsland& island, const RegionLayout& layout) {
  NodeKinematics kinematics(island.model);
  VecX y(layout.state_size());
  layout.Pack(island.q, island.qd, y.data());
  kinematics.Move(layout, island.driven, 0.0, y.data(), y.data() + layout.num_positions(), 0,
                  kinematics.size());
  small::V3 base;
  if (island.model.coupling == RootCoupling::kPrescribed) {
    const auto& root = island.driven.root_position;
    base = {root[0].At(0.0).dd, root[1].At(0.0).dd, root[2].At(0.0).dd + RandomIsland::kGravity};
  }
  kinematics.SetOwnForces(base);
  return kinematics;
}

IslandEquations Assembled(const RandomIsland& island) {
  RegionDynamics dynamics(island.model, ForceLaws(), RandomIsland::kGravity);
  dynamics.SetDriven(&island.driven, -0.01, 0.01);
  const HingeEquations equations = dynamics.AssembleHinges(0.0, {island.q, island.qd});
  return {equations.M(), equations.b()};
}

}  // namespace hazumi::test
