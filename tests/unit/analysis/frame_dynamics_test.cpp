// What a motion asks of its figure in four frames at once, beside the recursion in world axes,
// which is tested against another program: figures at random and figures that chance does not make.

#include "engine/analysis/frame_dynamics.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "engine/dynamics/inverse_dynamics.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/unit/analysis/lane_frames.h"

namespace hazumi::test {
namespace {

// A figure in four states on a moving root.
struct FourFrames {
  FourFrames(const Figure& figure, uint64_t seed) : random(seed) {
    animation.figure = std::make_shared<const Figure>(figure);
    stances = RandomStances(figure, 4, &random);
    for (size_t i = 0; i < 4; ++i) {
      qd[i] = random.Vector(figure.num_joints(), 5.0);
      qdd[i] = random.Vector(figure.num_joints(), 50.0);
      root[i] = RandomMovingRoot(&random).Motion();
    }
  }

  Animation animation;
  Random random;
  std::vector<Stance> stances;
  VecX qd[4], qdd[4];
  RootMotion root[4];
};

struct Answer {
  VecX tau;
  Wrench needed;
};

// `pushes`, if any: of each end link, at its joint's origin.
std::vector<Answer> ByLanes(const FourFrames& of, const EffortKernels& kernels,
                            const EndForces* pushes) {
  const Figure& figure = *of.animation.figure;
  const PlacedFrames placed = PlaceAll(figure, of.stances, kernels);
  FrameDynamics dynamics(of.animation, placed, kernels);
  for (size_t i = 0; i < 4; ++i) {
    dynamics.Set(i, {},
                 {&of.stances[i].X_WR, of.stances[i].q.data(), of.qd[i].data(), of.qdd[i].data(),
                  of.root[i]});
  }
  dynamics.Demand(0);
  const std::vector<JointIndex> ends = EndJoints(figure);
  for (size_t i = 0; pushes != nullptr && i < 4; ++i) {
    for (size_t e = 0; e < ends.size(); ++e) {
      const auto column = static_cast<long>(e);
      dynamics.Push(i, ends[e], placed[i].p(ends[e]),
                    {pushes->Kf.col(column), pushes->Kn.col(column)});
    }
  }
  dynamics.FindTorques();
  std::vector<Answer> answers;
  for (size_t i = 0; i < 4; ++i) answers.push_back({dynamics.torques(i), dynamics.needed(i)});
  return answers;
}

Answer ByRecursion(const FourFrames& of, size_t frame, const EndForces* pushes) {
  const Figure& figure = *of.animation.figure;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, of.stances[frame].X_WR, of.stances[frame].q, &ws);
  RootMotion root = of.root[frame];
  root.a.z() += of.animation.gravity;
  InverseDynamics(figure, root, of.qd[frame], of.qdd[frame], pushes, &ws);
  return {ws.tau, {ws.bodies[0].f, ws.bodies[0].n}};
}

// By every instruction set, with the same bits.
void ExpectLanesAgree(const FourFrames& of, const std::string& what,
                      const EndForces* pushes = nullptr) {
  const std::vector<Answer> first = ByLanes(of, AllKernels()[0], pushes);
  for (const EffortKernels& kernels : AllKernels()) {
    const std::vector<Answer> found = ByLanes(of, kernels, pushes);
    for (size_t i = 0; i < 4; ++i) {
      const Answer expected = ByRecursion(of, i, pushes);
      EXPECT_LE(RelativeDifference(found[i].tau, expected.tau), 1e-12) << what;
      EXPECT_LE(RelativeDifference(found[i].needed.force, expected.needed.force), 1e-12) << what;
      EXPECT_LE(RelativeDifference(found[i].needed.moment, expected.needed.moment), 1e-12) << what;
      EXPECT_EQ(found[i].tau, first[i].tau) << what;
      EXPECT_EQ(found[i].needed.moment, first[i].needed.moment) << what;
    }
  }
}

TEST(FrameDynamics, AreThoseOfTheRecursion) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Figure figure = seed == 1 ? Human37() : Build(RandomTreeSpec(&random));
    const EndForces pushes = RandomEndForces(figure, &random);
    const FourFrames frames(figure, seed);
    ExpectLanesAgree(frames, "seed " + std::to_string(seed));
    ExpectLanesAgree(frames, "pushed, seed " + std::to_string(seed), &pushes);
  }
}

// A joint with hinges about these axes, somewhere on its parent, and a link on it.
JointSpec JointAbout(const std::string& name, const std::string& parent,
                     const std::vector<Vec3>& axes, Random* random) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.offset = random->Vector3(0.3);
  for (size_t h = 0; h < axes.size(); ++h) {
    joint.hinges.push_back({std::string(1, static_cast<char>('a' + h)), axes[h], -3.0, 3.0});
  }
  LinkSpec link;
  link.to = Vec3(0.1, 0.2, -0.3) + random->Vector3(0.1);
  link.radius = 0.05;
  link.mass = 1.0 + random->Uniform(0.0, 1.0);
  joint.links = {link};
  return joint;
}

FigureSpec EmptySpec() {
  FigureSpec spec;
  spec.name = "test";
  spec.root_name = "root";
  return spec;
}

TEST(FrameDynamics, TakesHingesAtAnyAngleToEachOther) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    FigureSpec spec = EmptySpec();
    spec.joints = {JointAbout("skew", "root", {x, (y + 0.3 * x), (z + 0.5 * y)}, &random),
                   JointAbout("euler", "skew", {z, x, z}, &random),
                   JointAbout("two", "euler", {random.Vector3(1.0), random.Vector3(1.0)}, &random),
                   JointAbout("left_handed", "euler", {y, x, z}, &random),
                   JointAbout("backwards", "left_handed", {-z, -x}, &random)};
    ExpectLanesAgree(FourFrames(Build(spec), seed), "seed " + std::to_string(seed));
  }
}

TEST(FrameDynamics, TakesFiguresOfEveryShape) {
  for (const int arms : {1, 2, 3, 4, 5, 9}) {
    for (const int joints : {1, 2, 5}) {
      Random random(arms * 10 + joints);
      FigureSpec spec = EmptySpec();
      for (int a = 0; a < arms; ++a) {
        std::string parent = "root";
        for (int j = 0; j < joints; ++j) {
          const Mat3 axes = random.Rotation();
          std::vector<Vec3> hinges = {axes.col(0), axes.col(1), axes.col(2)};
          hinges.resize(1 + (a + j) % 3);
          const std::string name = std::to_string(a) + "-" + std::to_string(j);
          spec.joints.push_back(JointAbout(name, parent, hinges, &random));
          // Every second arm branches off the one before.
          parent = a % 2 == 1 && j == 0 ? std::to_string(a - 1) + "-0" : name;
        }
      }
      ExpectLanesAgree(FourFrames(Build(spec), arms),
                       std::to_string(arms) + " x " + std::to_string(joints));
    }
  }
}

TEST(FrameDynamics, TakesALoadBetweenTheHingesOfAJoint) {
  const RigidInertia load{2.0, Vec3(0.1, 0.2, 0.3), 0.1 * Mat3::Identity()};
  for (const int joint : {0, 1, 2, 9, 10, 30, 36}) {
    ExpectLanesAgree(FourFrames(Human37().WithLoad(JointIndex(joint), load), 5),
                     std::to_string(joint));
  }
}

TEST(FrameDynamics, TakesLargeAngles) {
  FourFrames frames(Human37(), 8);
  frames.stances[0].q[3] += 2e5;
  frames.stances[1].q[20] -= 1e9;
  frames.stances[3].q[36] += 1e4;
  ExpectLanesAgree(frames, "large angles");
}

TEST(FrameDynamics, TakesAFigureWithoutJoints) {
  FigureSpec spec = EmptySpec();
  spec.root_links = JointAbout("", "", {}, std::make_unique<Random>(1).get()).links;
  ExpectLanesAgree(FourFrames(Build(spec), 1), "no joints");
}

// Hinges about y and z in turn, 0.1 m apart.
FigureSpec Chain(int joints) {
  FigureSpec spec = EmptySpec();
  Random random(1);
  for (int i = 0; i < joints; ++i) {
    JointSpec joint =
        JointAbout("j" + std::to_string(i), i == 0 ? "root" : "j" + std::to_string(i - 1),
                   {i % 2 == 0 ? Vec3::UnitY() : Vec3::UnitZ()}, &random);
    joint.offset = Vec3(0.1, 0.0, 0.0);
    spec.joints.push_back(joint);
  }
  return spec;
}

TEST(FrameDynamics, OfChainsAreThoseOfTheRecursion) {
  for (const int joints : {1, 10, 100, 1000}) {
    FourFrames frames(Build(Chain(joints)), static_cast<uint64_t>(joints));
    for (size_t i = 0; i < 4; ++i) {
      frames.stances[i].q *= 0.1;
      frames.qd[i] *= 0.1;
    }
    ExpectLanesAgree(frames, std::to_string(joints));
  }
}

}  // namespace
}  // namespace hazumi::test
