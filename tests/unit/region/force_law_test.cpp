// Forces of a law act as virtual power says, and their power is the energy that comes in.

#include "engine/region/forces/force_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/region/exact/exact_solver.h"
#include "engine/region/forces/force_spec.h"
#include "engine/region/forces/hinge_moment.h"
#include "tests/unit/region/random_island.h"

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
  PushLaw(const Push& push, bool is_outer) : push_(push), is_outer_(is_outer) {}
  std::string_view name() const override { return "push"; }
  bool is_outer() const override { return is_outer_; }
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
  bool is_outer_;
};

// Every body is slowed down by kRate for each kilogram, against air that moves with kWind.
class DragLaw : public ForceLaw {
 public:
  static constexpr double kRate = 3.0;  // [1/s]
  static inline const Vec3 kWind = Vec3(1.5, -0.5, 0.25);

  std::string_view name() const override { return "drag"; }
  bool is_outer() const override { return true; }
  void AddForces(const RegionState& state, NodeKinematics* kinematics) const override {
    for (int i = 0; i < kinematics->size(); ++i) {
      const NodeMotion& own = kinematics->motion()[i];
      if (!state.model.nodes[i].is_dynamic || own.m == 0.0) continue;
      const V3 com = (1.0 / own.m) * own.h;
      kinematics->AddForce(i, com, -(kRate * own.m) * (state.VelocityAt(i, com) - V3(kWind)));
    }
  }
};

Push AnyPush(const RandomIsland& island, Random* random) {
  const auto any = [random] { return V3(Vec3(random->Vector(3, 20.0))); };
  const auto& nodes = island.model.nodes;
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
VecX VirtualPower(const RandomIsland& island, const Push& push) {
  const RegionLayout layout(island.model, /*balls=*/false);
  const NodeKinematics kinematics = MovedBy(island, layout);
  const auto& motion = kinematics.motion();
  const RegionModel& model = island.model;
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
void ForEachLawsIsland(Action&& action) {
  int islands = 0;
  for (const RootCoupling coupling :
       {RootCoupling::kPrescribed, RootCoupling::kPinned, RootCoupling::kFlight}) {
    for (uint64_t seed = 1; seed <= 40; ++seed) {
      const auto island = RandomIsland::Of(seed, coupling);
      if (!island || island->model.pin_node >= static_cast<int>(island->model.nodes.size()))
        continue;
      ++islands;
      action(*island, "seed " + std::to_string(seed));
    }
  }
  EXPECT_GE(islands, 60);
}

ForceLaws With(const Push& push, bool is_outer = false) {
  return {std::make_shared<PushLaw>(push, is_outer)};
}

// Some hinges are driven; a joint of three is as a whole.
ForceLaws AnyTorques(const RandomIsland& island, Random* random) {
  TorqueSpec spec{std::vector<char>(island.q.size(), 0)};
  for (char& is_driven : spec.is_driven) is_driven = random->Chance(0.7);
  return MakeLaws({spec});
}

ForceLaws AnySprings(const RandomIsland& island, Random* random) {
  SpringSpec spec{std::vector<Spring>(island.q.size())};
  const Vec3 moments(0.3, 0.2, 0.4);
  const RegionLayout layout(island.model, /*balls=*/false);
  for (int i = 0; i < layout.num_hinges(); ++i) {
    if (layout.hinges()[i].node == 0) continue;  // the root has no muscles
    Spring& spring = spec.springs[i];
    spring.rate = random->Uniform(1.0, 20.0);
    spring.damping_ratio = random->Uniform(0.0, 1.5);
    spring.most = random->Uniform(1.0, 50.0);
    spring.most_forward = Vec3(3.0, 20.0, 10.0);
    spring.share = 1.0;
    spring.inertia = random->Uniform(0.1, 1.0);
    spring.of_ball = moments.asDiagonal();
  }
  return MakeLaws({spec});
}

// Cylinders and surfaces on all bodies, in wind.
ForceLaws Windy(const RandomIsland& island, Random* random) {
  WindSpec wind{random->Vector(3, 5.0), 1.225, {}, {}};
  for (size_t i = 0; i < island.model.nodes.size(); ++i) {
    if (!island.model.nodes[i].is_dynamic || island.model.nodes[i].body.is_massless()) continue;
    wind.cylinders.push_back({static_cast<int>(i), random->Vector(3, 0.3), random->Vector(3, 0.3),
                              random->Uniform(0.02, 0.2)});
    const Vec3 normal = random->Vector3(1.0);
    wind.surfaces.push_back({static_cast<int>(i),
                             {random->Uniform(0.01, 0.1),
                              normal.normalized(),
                              random->Vector3(0.3),
                              i % 2 == 0 ? LinkSurface::Kind::kWing : LinkSurface::Kind::kPlate,
                              {},
                              {}}});
  }
  return MakeLaws({wind});
}

ForceLaws Attracted(const RandomIsland& island, Random* random) {
  const Push at = AnyPush(island, random);
  return MakeLaws({AttractionSpec{at.node, random->Vector(3, 0.2), random->Vector(3, 0.5),
                                  random->Uniform(1.0, 20.0), random->Uniform(0.2, 2.0)}});
}

// Each law by itself. A new one is to be added here.
std::vector<ForceLaws> EachLaw(const RandomIsland& island, Random* random) {
  return {With(AnyPush(island, random)), With(AnyPush(island, random), /*is_outer=*/true),
          {std::make_shared<DragLaw>()}, FrictionAlone(VecX::Constant(island.q.size(), 2.0)),
          AnyTorques(island, random),    AnySprings(island, random),
          Windy(island, random),         Attracted(island, random)};
}

// Where the pin or the CoM is, and how fast it moves.
const PointMotion kAnchor = {Vec3(0.3, -0.2, 1.1), Vec3(-1.0, 2.0, 3.0)};
PointMotion AnchorOf(const RandomIsland& island) {
  if (island.model.coupling == RootCoupling::kFlight) return kAnchor;
  return {kAnchor.p, Vec3::Zero()};
}

// A law on its way: a solver of an island, one step on. Empty where a direction moves no mass.
struct Solved {
  Solved(const RandomIsland& island, ForceLaws laws)
      : dynamics(island.model, std::move(laws), RandomIsland::kGravity), solver([&] {
          dynamics.SetDriven(&island.driven, 0.0, 0.01);
          const VecX none =
              VecX::Constant(island.q.size(), std::numeric_limits<double>::infinity());
          return ExactSolver(&dynamics, -none, none);
        }()) {
    solver.SetTolerance(1e-10);
    solver.Start(0.0, {island.q, island.qd, {AnchorOf(island), {}}});
    is_solved = !solver.Advance(0.002);
  }

  RegionDynamics dynamics;
  ExactSolver solver;
  bool is_solved = false;
};

TEST(ForceLaw, ActsByVirtualPower) {
  ForEachLawsIsland([](const RandomIsland& island, const std::string& what) {
    Random random(3);
    const Push push = AnyPush(island, &random);
    RegionDynamics plain(island.model, {}, RandomIsland::kGravity);
    RegionDynamics pushed(island.model, With(push), RandomIsland::kGravity);
    const auto b_of = [&](RegionDynamics* dynamics) {
      dynamics->SetDriven(&island.driven, -0.01, 0.01);
      return dynamics->AssembleHinges(0.0, {island.q, island.qd}).b();
    };
    const VecX b = b_of(&plain), expected = VirtualPower(island, push);
    EXPECT_LE((b - b_of(&pushed) - expected).norm(), 1e-10 * (1.0 + b.norm() + expected.norm()))
        << what;
  });
}

// Both ways of solving.
TEST(ForceLaw, AcceleratesAsTheDenseEquationsSay) {
  ForEachLawsIsland([](const RandomIsland& island, const std::string& what) {
    Random random(4);
    RegionDynamics dynamics(island.model, With(AnyPush(island, &random)), RandomIsland::kGravity);
    dynamics.SetDriven(&island.driven, -0.01, 0.01);
    const RegionLayout& layout = dynamics.layout();
    if (layout.num_positions() != layout.num_dofs()) return;  // balls have no angles to compare
    VecX y(layout.state_size()), dy(y.size());
    layout.Pack(island.q, island.qd, y.data());
    dynamics.Derivative(0.0, y.data(), dy.data());
    const HingeEquations equations = dynamics.AssembleHinges(0.0, {island.q, island.qd});
    const VecX expected = equations.M().llt().solve(-equations.b());
    EXPECT_LE((dy.tail(layout.num_dofs()) - expected).norm(), 1e-8 * (1.0 + expected.norm()))
        << what;
  });
}

// Angles whose ball joints are this far from a pole [rad].
VecX NextToPoles(const RandomIsland& island, const RegionLayout& layout, double distance) {
  VecX q = island.q;
  for (int i = 0; i < static_cast<int>(island.model.nodes.size()); ++i) {
    const HingeTriple* triple = layout.triple(i);
    if (!triple || layout.node(i).num_dofs < 3) continue;
    double& middle = q[layout.node(i).first_hinge + 1];
    const double way = triple->FromPole(middle) - distance;
    middle += triple->FromPole(middle + way) < triple->FromPole(middle - way) ? way : -way;
  }
  return q;
}

// Torques of limits in time-stepping mode, unlike those of drives, act in full next to a pole.
TEST(ForceLaw, TorquesOfTimeSteppingActInFullNextToAPole) {
  int balls = 0;
  ForEachLawsIsland([&](const RandomIsland& island, const std::string& what) {
    Random random(6);
    RegionDynamics dynamics(island.model, {}, RandomIsland::kGravity);
    dynamics.SetDriven(&island.driven, -0.01, 0.01);
    const RegionLayout& layout = dynamics.layout();
    balls += layout.num_positions() != layout.num_dofs();
    const VecX q = NextToPoles(island, layout, 0.01), torques = random.Vector(q.size(), 20.0);
    const HingeState state(q, island.qd);
    const VecX free = dynamics.AssembleHinges(0.0, state).b();
    dynamics.mode().constant.AddTorques(torques, dynamics.PlacedHinges(0.0, state));
    const VecX b = dynamics.AssembleHinges(0.0, state).b();
    EXPECT_LE((free - b - torques).norm(), 1e-6 * (1.0 + free.norm())) << what;
  });
  EXPECT_GE(balls, 10);
}

// By Gauss's formula over one step of the solver.
void ExpectPowerIsEnergy(const RandomIsland& island, const ForceLaws& laws,
                         const std::string& what) {
  constexpr double kNode[2] = {0.3399810435848563, 0.8611363115940526};
  constexpr double kWeight[2] = {0.6521451548625461, 0.3478548451374538};
  Solved solved(island, laws);
  if (!solved.is_solved) return;
  ExactSolver& solver = solved.solver;
  const double end = solver.time(), half = 0.5 * end;
  const EnergyFlow first = solver.Energy(0.0), last = solver.Energy(end);
  ASSERT_EQ(first.laws.size(), 1u);
  EXPECT_EQ(first.laws[0].name, laws[0]->name());
  double work = 0.0, size = std::abs(last.kinetic) + std::abs(last.potential);
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 2; ++i) {
      const EnergyFlow flow = solver.Energy(half + side * kNode[i] * half);
      work += half * kWeight[i] * (flow.laws[0].power + flow.keyed);
      size += half * (std::abs(flow.laws[0].power) + std::abs(flow.keyed));
    }
  }
  const double change = last.kinetic + last.potential - first.kinetic - first.potential;
  EXPECT_NEAR(work, change, 1e-7 * size) << what << ", " << laws[0]->name();
}

TEST(ForceLaw, ItsPowerIsTheEnergyThatComesIn) {
  ForEachLawsIsland([&](const RandomIsland& island, const std::string& what) {
    Random random(5);
    for (const ForceLaws& laws : EachLaw(island, &random)) ExpectPowerIsEnergy(island, laws, what);
  });
}

// Tells where a point of each node is that it is asked about.
class Witness : public ForceLaw {
 public:
  static inline const V3 kPoint = V3(0.1, -0.2, 0.3);  // in the node's frame
  struct Seen {
    std::vector<Vec3> p, v;
  };

  explicit Witness(Seen* seen) : seen_(seen) {}
  std::string_view name() const override { return "witness"; }
  bool is_outer() const override { return true; }
  void AddForces(const RegionState& state, NodeKinematics*) const override {
    *seen_ = {};
    for (int i = 0; i < state.kinematics.size(); ++i) {
      const V3 r = state.kinematics.motion()[i].R * kPoint;
      seen_->p.push_back(state.PositionAt(i, r).eigen());
      seen_->v.push_back(state.VelocityAt(i, r).eigen());
    }
  }

 private:
  Seen* seen_;
};

// Their velocities are how their places change, on moving bases, pins and in flight.
TEST(ForceLaw, IsToldWherePointsAreAndHowTheyMove) {
  ForEachLawsIsland([&](const RandomIsland& island, const std::string& what) {
    Witness::Seen seen;
    Solved solved(island, {std::make_shared<Witness>(&seen)});
    if (!solved.is_solved) return;
    const double middle = 0.5 * solved.solver.time(), h = 1e-3 * middle;
    const auto at = [&](double t) {
      solved.solver.Energy(t);
      return seen;
    };
    const Witness::Seen before = at(middle - h), now = at(middle), after = at(middle + h);
    for (size_t i = 0; i < now.v.size(); ++i) {
      const Vec3 moved = (after.p[i] - before.p[i]) / (2.0 * h);
      EXPECT_LE((moved - now.v[i]).norm(), 1e-5 * (1.0 + now.v[i].norm())) << what << " " << i;
    }
  });
}

// A figure whose every part is slowed down alike falls as one body would:
//   v = u + (v_0 - u) e^(-c t),   u = wind - g / c.
TEST(ForceLaw, FromOutsidePushesAFigureOffItsParabola) {
  int figures = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const auto island = RandomIsland::Of(seed, RootCoupling::kFlight);
    if (!island) continue;
    Solved solved(*island, {std::make_shared<DragLaw>()});
    ExactSolver& solver = solved.solver;
    while (solved.is_solved && solver.time() < 0.2) solved.is_solved = !solver.Advance(0.2);
    if (!solved.is_solved) continue;
    ++figures;
    const double c = DragLaw::kRate, left = std::exp(-c * 0.2);
    const Vec3 u = DragLaw::kWind - RandomIsland::kGravity / c * Vec3::UnitZ();
    HingeState state;
    solver.Sample(0.2, &state);
    const PointMotion& fall = state.outer.anchor;
    EXPECT_LE((fall.v - u - (kAnchor.v - u) * left).norm(), 1e-8) << seed;
    EXPECT_LE((fall.p - kAnchor.p - 0.2 * u - (kAnchor.v - u) * (1.0 - left) / c).norm(), 1e-8)
        << seed;
  }
  EXPECT_GE(figures, 20);
}

}  // namespace
}  // namespace hazumi::test
