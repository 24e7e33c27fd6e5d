// Inverse dynamics of whole figures as in effort, against MuJoCo with its contacts disabled. Random
// states on a root that rotates and accelerates, with known forces at points of any links.

#include "engine/analysis/effort.h"
#include "engine/dynamics/kinematics.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/mujoco_figure.h"
#include "tests/support/random_tree.h"
#include "tests/unit/analysis/baked_effort.h"

namespace hazumi::test {
namespace {

constexpr double kTolerance = 1e-9;

// Figure in random states, with the generalized forces of root and hinges that MuJoCo computes.
class AskedOfMujoco {
 public:
  AskedOfMujoco(Figure figure, double gravity, int states, Random* random) {
    animation_ = Still(std::move(figure));
    animation_.gravity = gravity;
    mujoco_ =
        std::make_unique<MujocoFigure>(*animation_.figure, Vec3(0.0, 0.0, -animation_.gravity));
    for (int i = 0; i < states; ++i) AddState(i, random);
  }

  // Largest relative difference of torques, forces and moments over the states.
  double WorstDifference() const {
    const Effort effort = EffortOf(animation_, motion_);
    double worst = 0.0;
    for (size_t i = 0; i < effort.frames.size(); ++i) {
      const FrameEffort& frame = effort.frames[i];
      VecX own(MujocoFigure::kRootDof + frame.tau.size());
      own << frame.from_nowhere.force, root_axes_[i] * frame.from_nowhere.moment, frame.tau;
      worst = std::max(worst, RelativeDifference(own, asked_[i]));
    }
    return worst;
  }

 private:
  void AddState(int index, Random* random) {
    const Figure& figure = *animation_.figure;
    const MovingRoot root = RandomMovingRoot(random);
    const RootMotion moved = root.Motion();
    MotionFrame frame;
    frame.frame = index;
    frame.q = RandomAngles(figure, random);
    frame.after = {frame.q, random->Vector(figure.num_joints(), 5.0), root.X_WR(), moved.w,
                   moved.v};
    frame.before = frame.after;
    frame.acceleration = {random->Vector(figure.num_joints(), 50.0), moved.alpha, moved.a};
    mujoco_->SetState(MujocoFigure::Join(root.p, root.angle, frame.q),
                      MujocoFigure::Join(root.v, root.rate, frame.after.qd));
    VecX asked = mujoco_->InverseDynamics(
        MujocoFigure::Join(root.a, root.acceleration, frame.acceleration->qdd), nullptr);
    for (int k = random->Integer(0, 5); k > 0; --k) {
      const ContactPush applied = RandomForce(frame, random);
      asked -= mujoco_->PointForce(figure.links()[static_cast<size_t>(applied.link)].joint,
                                   applied.p, applied.force);
      frame.contacts.pushes.push_back(applied);
    }
    root_axes_.push_back(mujoco_->RootAxes());
    asked_.push_back(asked);
    motion_.frames.push_back(frame);
  }

  // Force on a link at a point within half a metre of its joint.
  ContactPush RandomForce(const MotionFrame& frame, Random* random) const {
    const Figure& figure = *animation_.figure;
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, frame.after.X_WR, frame.q, &ws);
    ContactPush applied;
    applied.link = random->Integer(0, static_cast<int>(figure.links().size()) - 1);
    applied.p =
        ws.body(figure.links()[static_cast<size_t>(applied.link)].joint).p + random->Vector3(0.5);
    applied.force = random->Vector3(500.0);
    return applied;
  }

  Animation animation_;
  std::unique_ptr<MujocoFigure> mujoco_;
  Motion motion_;
  std::vector<Mat3> root_axes_;  // one per state
  std::vector<VecX> asked_;      // one per state
};

TEST(Effort, RandomStatesOfHumans_MatchMujoco) {
  constexpr int kStates = 1000;
  Random random(20261124);
  Worst human("effort of the shipped human"), human37("effort of a human of 37 hinges");
  EXPECT_LE(human(AskedOfMujoco(ShippedHuman(), kG, kStates, &random).WorstDifference()),
            kTolerance);
  EXPECT_LE(human37(AskedOfMujoco(Human37(), kG, kStates, &random).WorstDifference()), kTolerance);
}

TEST(Effort, RandomTreesInAnyGravity_MatchMujoco) {
  constexpr int kTrees = 100, kStates = 5;
  Random random(20261127);
  Worst worst("effort of random trees");
  for (int k = 0; k < kTrees; ++k) {
    const double gravity = random.Uniform(0.0, 25.0);
    const AskedOfMujoco asked(Build(RandomTreeSpec(&random)), gravity, kStates, &random);
    EXPECT_LE(worst(asked.WorstDifference()), kTolerance) << "tree " << k;
  }
}

}  // namespace
}  // namespace hazumi::test
