// Effort without contacts against MuJoCo's inverse dynamics: humans in random states on a root that
// turns and accelerates.

#include "engine/analysis/effort.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_reader.h"
#include "tests/support/animations.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/mujoco_figure.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {
namespace {

void ExpectMujocosEffort(Figure of, const char* claim) {
  constexpr int kStates = 1000;
  const Animation animation = Still(std::move(of));
  const Figure& figure = *animation.figure;
  const int n = figure.num_joints();
  MujocoFigure mujoco(figure, Vec3(0, 0, -animation.gravity));
  Random random(20261124);
  Motion motion;
  std::vector<VecX> torques;
  for (int i = 0; i < kStates; ++i) {
    const MovingRoot root = RandomMovingRoot(&random);
    const RootMotion moved = root.Motion();
    MotionFrame frame;
    frame.frame = i;
    frame.q = RandomAngles(figure, &random);
    frame.after = {frame.q, random.Vector(n, 5.0), root.X_WR(), moved.w, moved.v};
    frame.before = frame.after;
    frame.acceleration = {random.Vector(n, 50.0), moved.alpha, moved.a};
    mujoco.SetState(MujocoFigure::Join(root.p, root.angle, frame.q),
                    MujocoFigure::Join(root.v, root.rate, frame.after.qd));
    torques.push_back(mujoco.InverseDynamics(
        MujocoFigure::Join(root.a, root.acceleration, frame.acceleration->qdd), nullptr));
    motion.frames.push_back(frame);
  }
  const Effort effort = EffortOf(animation, motion);
  Worst worst(claim);
  for (int i = 0; i < kStates; ++i) {
    const FrameEffort& frame = effort.frames[static_cast<size_t>(i)];
    const VecX& other = torques[static_cast<size_t>(i)];
    EXPECT_LE(worst((frame.tau - other.tail(n)).lpNorm<Eigen::Infinity>()), 1e-6) << i;
    EXPECT_LE((frame.from_nowhere.force - other.head<3>()).norm(), 1e-6) << i;
    EXPECT_TRUE(frame.contacts.empty());
  }
}

TEST(Effort, OfRandomStatesIsThatOfMujoco) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/figures/human.json";
  ExpectMujocosEffort(BuildFigure(LoadFigure(path).value()).value(),
                      "effort of the shipped human [N m]");
  ExpectMujocosEffort(Human37(), "effort of a human of 37 hinges [N m]");
}

}  // namespace
}  // namespace hazumi::test
