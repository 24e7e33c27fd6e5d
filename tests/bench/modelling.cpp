// What the evaluations of a bake cost, from the whole figure to what the scene needs.

#include <Eigen/Cholesky>
#include <cstdio>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/bake/bake.h"
#include "engine/matrix/semidefinite.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/region/forces/force_spec.h"
#include "engine/region/region_dynamics.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/tables.h"
#include "tests/support/animations.h"
#include "tests/support/free_figure.h"

namespace hazumi::bench {

namespace {

Animation Example(const std::string& name) {
  const std::string path = std::string(HAZUMI_SOURCE_DIR) + "/assets/examples/" + name + ".kfa";
  return CompileAnimation(LoadProject(path).value()).value().animation;
}

// The jump, with arms that swing freely while it flies.
Animation JumpWithFreeArms() {
  Animation animation = Example("jump");
  DynamicsRegion& arms =
      test::AddRegion(&animation, "arms", 7, 17, {"l_shoulder", "r_shoulder"}, 0.8);
  arms.method = Method::kExact;
  return animation;
}

// An animation in the middle of what its region does.
struct Scene {
  Animation animation;
  Motion motion;
  MotionFrame frame;

  Scene(Animation of, int number)
      : animation(std::move(of)), motion(Bake(animation).value()), frame(motion.frames[number]) {}
  const Figure& figure() const { return *animation.figure; }
  const DynamicsRegion& region() const { return animation.regions[0]; }
  RootCoupling coupling() const {
    return frame.pinned ? RootCoupling::kPinned : RootCoupling::kFlight;
  }
  JointIndex pin() const {
    return frame.pinned ? figure().group(*frame.pinned).first : JointIndex();
  }
};

// Evaluations of the equations of motion of all groups, one for each level.
struct Level {
  const char* name;
  std::function<void()> evaluate;
  LeastTime time;
};

// Everything that moves outside the region moves along a cubic.
DrivenMotion DrivenBy(const Scene& scene) {
  const int n = scene.figure().num_joints();
  DrivenMotion driven;
  driven.angles.resize(n + kRootAngles);
  const auto curve = [](double value, double rate) {
    DrivenCurve cubic;
    cubic.degree = rate == 0.0 ? 0 : 3;
    cubic.c[0] = value;
    cubic.c[1] = rate;
    cubic.c[2] = cubic.c[3] = -rate;
    return cubic;
  };
  for (int j = 0; j < n; ++j) {
    driven.angles[j] = curve(scene.frame.q[j], scene.frame.after.qd[j]);
  }
  const Vec3 w = scene.frame.after.root_w;
  for (int i = 0; i < kRootAngles; ++i) driven.angles[n + i] = curve(0.0, w.norm());
  return driven;
}

ModelRequest RequestFor(const Scene& scene, const DrivenMotion& driven) {
  ModelRequest request;
  request.coupling = scene.coupling();
  request.pin = scene.pin();
  request.angles = VecX::Zero(static_cast<Eigen::Index>(driven.angles.size()));
  for (size_t c = 0; c < driven.angles.size(); ++c) {
    request.angles[static_cast<Eigen::Index>(c)] = driven.angles[c].c[0];
    request.roles.push_back(driven.angles[c].degree > 0 ? Role::kDriven : Role::kConstant);
  }
  for (const JointIndex j : scene.region().joints) request.roles[j.value()] = Role::kFree;
  return request;
}

// One group and a state of it.
struct Group {
  RegionDynamics dynamics;
  VecX q, qd, state, derivative;

  Group(const RegionModel& model, const Scene& scene, const DrivenMotion& driven)
      : dynamics(model, FrictionAlone(VecX::Constant(model.num_free, 1.0)),
                 scene.animation.gravity),
        q(model.num_free),
        qd(model.num_free),
        state(dynamics.layout().state_size()),
        derivative(state.size()) {
    for (int i = 0; i < model.num_free; ++i) {
      const Coordinate c = dynamics.hinges()[i].coordinate;
      q[i] = scene.frame.q[c];
      qd[i] = scene.frame.after.qd[c];
    }
    dynamics.layout().Pack(q, qd, state.data());
    dynamics.SetDriven(&driven, 0.0, 0.1);
  }

  void Evaluate() { dynamics.Derivative(0.05, state.data(), derivative.data()); }
  void EvaluateDense() {
    const HingeEquations equations = dynamics.AssembleHinges(0.05, {q, qd});
    MatX L = equations.M();
    FactorSemidefinite(L);
    derivative.tail(q.size()) = -equations.b();
    SolveSemidefinite(L, derivative.tail(q.size()));
  }
};

using Groups = std::deque<Group>;

Groups MakeGroups(const Scene& scene, const DrivenMotion& driven, bool fits_outside) {
  Groups groups;
  for (RegionModel& model : CompileRegionModels(scene.figure(), RequestFor(scene, driven))) {
    for (ModelNode& node : model.nodes) node.is_dynamic |= !fits_outside;
    groups.emplace_back(model, scene, driven);
  }
  return groups;
}

std::function<void()> WholeFigure(const Scene& scene) {
  const auto free = std::make_shared<test::FreeFigure>(scene.figure(), Vec3::Zero());
  const auto qdd = std::make_shared<VecX>(scene.frame.q);
  return [=, &scene, tau = VecX(VecX::Zero(scene.frame.q.size()))] {
    free->Accelerate(scene.frame.q, scene.frame.after.qd, tau, qdd.get());
  };
}

std::function<void()> WholeFigureWithPrescribedJoints(const Scene& scene) {
  const auto system = std::make_shared<RegionSystem>(scene.figure(), scene.region().joints);
  const auto ws = std::make_shared<DynamicsWorkspace>(scene.figure());
  PassiveState state{scene.frame.X_WR, RootMotion(), scene.frame.q, scene.frame.after.qd,
                     VecX::Zero(scene.frame.q.size())};
  return [=, &scene] {
    system->Evaluate(state, scene.coupling(), scene.pin(), scene.animation.gravity, ws.get());
    KeepAlive(VecX(system->M().ldlt().solve(-system->b())));
  };
}

template <typename Evaluate>
std::function<void()> AllOf(Groups* groups, Evaluate evaluate) {
  return [=] {
    for (Group& group : *groups) (group.*evaluate)();
  };
}

void PrintScene(const char* name, const Scene& scene, int rounds) {
  const DrivenMotion driven = DrivenBy(scene);
  Groups apart = MakeGroups(scene, driven, false), fitted = MakeGroups(scene, driven, true);
  std::vector<Level> levels;
  levels.push_back({"whole figure, as the paper", WholeFigureWithPrescribedJoints(scene), {}});
  levels.push_back({"whole figure free", WholeFigure(scene), {}});
  levels.push_back({"groups apart, dense", AllOf(&apart, &Group::EvaluateDense), {}});
  levels.push_back({"groups apart, articulated", AllOf(&apart, &Group::Evaluate), {}});
  levels.push_back({"outside as a fitted motion", AllOf(&fitted, &Group::Evaluate), {}});
  for (int round = 0; round < rounds; ++round) {
    for (Level& level : levels) level.time.Round(0.01, [&](long) { level.evaluate(); });
  }
  const double evaluations = scene.motion.regions[0].evaluations / double(apart.size());
  for (const Level& level : levels) {
    std::printf("%s,\"%s\",%.4g\n", name, level.name, level.time.microseconds() * evaluations);
  }
}

}  // namespace

void PrintModelling(int rounds) {
  std::printf("case,level,microseconds\n");
  PrintScene("throw", Scene(Example("throw"), 10), rounds);
  PrintScene("jump with free arms", Scene(JumpWithFreeArms(), 12), rounds);
}

}  // namespace hazumi::bench
