#include "tests/unit/passive/random_group.h"

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

std::unique_ptr<RandomGroup> RandomGroup::Of(uint64_t seed, RootCoupling coupling) {
  auto group = std::make_unique<RandomGroup>(RandomGroup{Random(seed), {}, {}, {}, {}});
  Random& random = group->random;
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
    group->driven.angles.push_back(CurveFrom(request.angles[c], rates[c], &random));
  }
  for (DrivenCurve& curve : group->driven.root_position) curve = CurveFrom(0.5, 1.0, &random);
  std::vector<RegionModel> models = CompileRegionModels(figure, request);
  if (models.empty()) return nullptr;
  group->model = std::move(
      models[static_cast<size_t>(random.Integer(0, static_cast<int>(models.size()) - 1))]);
  const RegionLayout layout(group->model, /*balls=*/false);
  group->q.resize(layout.num_hinges());
  group->qd.resize(layout.num_hinges());
  for (int i = 0; i < layout.num_hinges(); ++i) {
    group->q[i] = request.angles[layout.hinges()[i].coordinate];
    group->qd[i] = rates[layout.hinges()[i].coordinate];
  }
  return group;
}

NodeKinematics MovedBy(const RandomGroup& group, const RegionLayout& layout) {
  NodeKinematics kinematics(group.model);
  VecX y(layout.state_size());
  layout.Pack(group.q, group.qd, y.data());
  kinematics.Move(layout, group.driven, 0.0, y.data(), y.data() + layout.num_positions(), 0,
                  kinematics.size());
  small::V3 base;
  if (group.model.coupling == RootCoupling::kPrescribed) {
    const auto& root = group.driven.root_position;
    base = {root[0].At(0.0).dd, root[1].At(0.0).dd, root[2].At(0.0).dd + RandomGroup::kGravity};
  }
  kinematics.SetOwnForces(base);
  return kinematics;
}

RegionDynamics Assembled(const RandomGroup& group) {
  RegionDynamics dynamics(group.model, ForceLaws(), RandomGroup::kGravity);
  dynamics.SetDriven(&group.driven, -0.01, 0.01);
  dynamics.AssembleHinges(0.0, group.q, group.qd);
  return dynamics;
}

}  // namespace hazumi::test
