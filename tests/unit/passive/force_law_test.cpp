// Forces of a law act as virtual power says, and their power is the energy that comes in.

#include "engine/passive/forces/force_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/passive/exact_solver.h"
#include "engine/passive/forces/hinge_moment.h"
#include "tests/unit/passive/random_group.h"

namespace hazumi::test {
namespace {

using small::V3;

// A force at a point of a link, a torque on it, and one about its first hinge alone, if it has one
// that is free and no part of a ball.
struct Push {
  int node;
  V3 r, force, torque;
  double hinge_torque;
};

class PushLaw : public ForceLaw {
 public:
  explicit PushLaw(const Push& push) : push_(push) {}
  std::string_view name() const override { return "push"; }
  void AddForces(const RegionState& state, NodeKinematics* kinematics) const override {
    kinematics->AddForce(push_.node, push_.r, push_.force);
    kinematics->AddTorque(push_.node, push_.torque);
    const RegionLayout::Node& node = state.layout.node(push_.node);
    if (node.kind != RegionLayout::NodeKind::kHinges || node.num_dofs == 0) return;
    const double torques[3] = {push_.hinge_torque, 0.0, 0.0};
    const NodeMotion& own = kinematics->motion()[push_.node];
    kinematics->AddJointMoment(push_.node, MomentOfHinges(own, node.num_dofs, torques));
  }

 private:
  Push push_;
};

Push AnyPush(const RandomGroup& group, Random* random) {
  const auto any = [random] { return V3(Vec3(random->Vector(3, 20.0))); };
  const auto& nodes = group.model.nodes;
  int node = static_cast<int>(nodes.size()) - 1;
  const auto goes_on = [&] { return nodes[node].body.is_massless() || random->Chance(0.5); };
  while (node > 0 && nodes[node - 1].is_dynamic && goes_on()) --node;
  return {node, any(), any(), any(), random->Uniform(-5.0, 5.0)};
}

bool IsAtOrBeyond(const RegionModel& model, int node, int inner) {
  while (node > inner) node = model.nodes[node].parent;
  return node == inner;
}

// By hinge: the power of the push for a unit rate of it, what the root answers included.
VecX VirtualPower(const RandomGroup& group, const Push& push) {
  const RegionLayout layout(group.model, /*balls=*/false);
  const NodeKinematics kinematics = MovedBy(group, layout);
  const auto& motion = kinematics.motion();
  const RegionModel& model = group.model;
  const Vec3 F = push.force.eigen(), M = push.torque.eigen();
  const Vec3 P = (motion[push.node].p + push.r).eigen();
  VecX power = VecX::Zero(layout.num_hinges());
  for (int i = 0; i < kinematics.size(); ++i) {
    const Vec3 p = motion[i].p.eigen();
    for (int k = 0; k < layout.node(i).num_dofs; ++k) {
      const Vec3 axis = motion[i].axis[k].eigen();
      double& own = power[layout.node(i).dof + k];
      if (IsAtOrBeyond(model, push.node, i)) own += axis.dot(M + (P - p).cross(F));
      if (i == push.node && k == 0) own += push.hinge_torque;
      if (!model.root_answers) continue;
      Vec3 root = Vec3::Zero();  // how fast it moves, so that the pin or the CoM stays
      if (model.coupling == RootCoupling::kPinned) {
        const NodeMotion& pin = motion[model.pin_node];
        const Vec3 p_pin = (pin.p + pin.R * V3(model.p_pin)).eigen();
        if (IsAtOrBeyond(model, model.pin_node, i)) root = -axis.cross(p_pin - p);
      } else {
        for (int b = 0; b < kinematics.size(); ++b) {
          if (!IsAtOrBeyond(model, b, i)) continue;
          const Vec3 moved = motion[b].m * (motion[b].p.eigen() - p) + motion[b].h.eigen();
          root -= axis.cross(moved) / model.mass;
        }
      }
      own += root.dot(F);
    }
  }
  return power;
}

template <typename Action>
void ForEachGroup(Action&& action) {
  int groups = 0;
  for (const RootCoupling coupling :
       {RootCoupling::kPrescribed, RootCoupling::kPinned, RootCoupling::kFlight}) {
    for (uint64_t seed = 1; seed <= 40; ++seed) {
      const auto group = RandomGroup::Of(seed, coupling);
      if (!group || group->model.pin_node >= static_cast<int>(group->model.nodes.size())) continue;
      ++groups;
      action(*group, "seed " + std::to_string(seed));
    }
  }
  EXPECT_GE(groups, 60);
}

ForceLaws With(const Push& push) { return {std::make_shared<PushLaw>(push)}; }

TEST(ForceLaw, ActsByVirtualPower) {
  ForEachGroup([](const RandomGroup& group, const std::string& what) {
    Random random(3);
    const Push push = AnyPush(group, &random);
    RegionDynamics plain(group.model, {}, RandomGroup::kGravity);
    RegionDynamics pushed(group.model, With(push), RandomGroup::kGravity);
    for (RegionDynamics* dynamics : {&plain, &pushed}) {
      dynamics->SetDriven(&group.driven, -0.01, 0.01);
      dynamics->AssembleHinges(0.0, group.q, group.qd);
    }
    const VecX forces = plain.b() - pushed.b(), expected = VirtualPower(group, push);
    EXPECT_LE((forces - expected).norm(), 1e-10 * (1.0 + plain.b().norm() + expected.norm()))
        << what;
  });
}

// Both ways of solving.
TEST(ForceLaw, AcceleratesAsTheDenseEquationsSay) {
  ForEachGroup([](const RandomGroup& group, const std::string& what) {
    Random random(4);
    RegionDynamics dynamics(group.model, With(AnyPush(group, &random)), RandomGroup::kGravity);
    dynamics.SetDriven(&group.driven, -0.01, 0.01);
    const RegionLayout& layout = dynamics.layout();
    if (layout.num_positions() != layout.num_dofs()) return;  // balls have no angles to compare
    VecX y(layout.state_size()), dy(y.size());
    layout.Pack(group.q, group.qd, y.data());
    dynamics.Derivative(0.0, y.data(), dy.data());
    dynamics.AssembleHinges(0.0, group.q, group.qd);
    const VecX expected = dynamics.M().llt().solve(-dynamics.b());
    EXPECT_LE((dy.tail(layout.num_dofs()) - expected).norm(), 1e-8 * (1.0 + expected.norm()))
        << what;
  });
}

// By Gauss's formula over one step of the solver.
TEST(ForceLaw, ItsPowerIsTheEnergyThatComesIn) {
  constexpr double kNode[2] = {0.3399810435848563, 0.8611363115940526};
  constexpr double kWeight[2] = {0.6521451548625461, 0.3478548451374538};
  ForEachGroup([&](const RandomGroup& group, const std::string& what) {
    Random random(5);
    RegionDynamics dynamics(group.model, With(AnyPush(group, &random)), RandomGroup::kGravity);
    dynamics.SetDriven(&group.driven, 0.0, 0.01);
    const VecX none = VecX::Constant(group.q.size(), std::numeric_limits<double>::infinity());
    ExactSolver solver(&dynamics, -none, none);
    solver.SetTolerance(1e-10);
    solver.Start(0.0, group.q, group.qd);
    if (solver.Advance(0.002)) return;  // a direction that moves no mass
    const double end = solver.time(), half = 0.5 * end;
    const EnergyFlow first = solver.Energy(0.0), last = solver.Energy(end);
    ASSERT_EQ(first.laws.size(), 1u);
    EXPECT_EQ(first.laws[0].name, "push");
    double work = 0.0, size = std::abs(last.kinetic) + std::abs(last.potential);
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i < 2; ++i) {
        const EnergyFlow flow = solver.Energy(half + side * kNode[i] * half);
        work += half * kWeight[i] * (flow.laws[0].power + flow.keyed);
        size += half * (std::abs(flow.laws[0].power) + std::abs(flow.keyed));
      }
    }
    const double change = last.kinetic + last.potential - first.kinetic - first.potential;
    EXPECT_NEAR(work, change, 1e-7 * size) << what;
  });
}

}  // namespace
}  // namespace hazumi::test
