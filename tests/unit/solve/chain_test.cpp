#include "engine/solve/chain.h"

#include <gtest/gtest.h>

#include "tests/unit/solve/chains.h"

namespace hazumi::solve {
namespace {

VecX TorquesOf(const Chain& chain, const Turns& turns) {
  const ChainPose a = PoseOfChain(chain, 0, turns[0]), x = PoseOfChain(chain, 1, turns[1]),
                  z = PoseOfChain(chain, 2, turns[2]);
  const ChainMoments moments(chain, 1, a, x, z);
  const ChainUnknowns unknowns(chain);
  VecX torques(unknowns.per_frame());
  for (int j = 0; j < chain.num_joints(); ++j) {
    torques.segment(unknowns.first(j), unknowns.size(j)) = moments.Torques(j);
  }
  return torques;
}

// Compares with differences of sixth order. Every second chain hangs on a figure that falls.
TEST(ChainMoments, AreDifferentiatedToNineDigits) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Turns turns;
    Chain chain = RandomChain(3, seed, &turns);
    if (seed % 2 == 0) {
      chain.falling_mass = 20.0;
      chain.fall.assign(3, Vec3(4.0, -2.0, 7.0));
    }
    const ChainUnknowns unknowns(chain);
    const ChainPose a = PoseOfChain(chain, 0, turns[0]), x = PoseOfChain(chain, 1, turns[1]),
                    z = PoseOfChain(chain, 2, turns[2]);
    ChainMoments moments(chain, 1, a, x, z);
    for (int at = -1; at <= 1; ++at) {
      for (int j = 0; j < chain.num_joints(); ++j) {
        const size_t k = static_cast<size_t>(j);
        for (int e = 0; e < unknowns.size(j); ++e) {
          const auto moved = [&](double h) {
            Turns other = turns;
            Mat3& turn = other[static_cast<size_t>(at + 1)][k];
            VecX by = VecX::Zero(unknowns.size(j));
            by[e] = h;
            turn = TurnedOn(turn, chain.joints[k], by);
            return TorquesOf(chain, other);
          };
          constexpr double h = 2e-3;
          const VecX slope = (45.0 * (moved(h) - moved(-h)) - 9.0 * (moved(2 * h) - moved(-2 * h)) +
                              (moved(3 * h) - moved(-3 * h))) /
                             (60.0 * h);
          VecX change(unknowns.per_frame());
          moments.Differentiate(at, j, e, unknowns, change);
          const double size = std::max(1.0, change.norm());
          EXPECT_LT((slope - change).norm(), 1e-9 * size) << seed << " " << at << " " << j;
        }
      }
    }
  }
}

// A still chain gives the moments of its weight.
TEST(ChainMoments, CarryTheWeightOfWhatStandsStill) {
  Turns turns;
  Chain chain = RandomChain(3, 7, &turns);
  for (int t = 0; t < 3; ++t) {
    chain.carrier[static_cast<size_t>(t)] = chain.carrier[0];
    turns[static_cast<size_t>(t)] = turns[0];
  }
  const ChainPose pose = PoseOfChain(chain, 1, turns[1]);
  const ChainMoments moments(chain, 1, pose, pose, pose);
  Vec3 expected = Vec3::Zero();
  for (size_t k = 0; k < chain.joints.size(); ++k) {
    expected +=
        (pose.bodies[k].g - pose.bodies[0].o).cross(Vec3(0.0, 0.0, 9.81 * chain.bodies[1][k].mass));
  }
  EXPECT_LT((moments.moment(0) - expected).norm(), 1e-12);
}

// A limb that asks for no force as the rest of its figure falls does not move that.
TEST(ChainMoments, FallWithTheirFigure) {
  Turns turns;
  Chain chain = RandomChain(3, 5, &turns);
  const ChainPose a = PoseOfChain(chain, 0, turns[0]), x = PoseOfChain(chain, 1, turns[1]),
                  z = PoseOfChain(chain, 2, turns[2]);
  const ChainMoments given(chain, 1, a, x, z);
  Vec3 asked = Vec3::Zero();
  for (size_t k = 0; k < chain.joints.size(); ++k) {
    const double m = chain.bodies[1][k].mass;
    asked += m * (z.bodies[k].g - 2.0 * x.bodies[k].g + a.bodies[k].g) / (chain.step * chain.step);
  }
  chain.falling_mass = 20.0;
  chain.fall.assign(3, asked);
  EXPECT_LT((ChainMoments(chain, 1, a, x, z).moment(0) - given.moment(0)).norm(), 1e-12);
  // A further force moves the figure, as if the carrier gave way.
  chain.fall[1] = asked - Vec3(0.0, 0.0, 8.0);
  const Vec3 more = ChainMoments(chain, 1, a, x, z).moment(0) - given.moment(0);
  Vec3 lever = Vec3::Zero();
  for (size_t k = 0; k < chain.joints.size(); ++k) {
    lever += chain.bodies[1][k].mass * (x.bodies[k].g - x.bodies[0].o);
  }
  EXPECT_LT((more - lever.cross(Vec3(0.0, 0.0, -8.0 / 20.0))).norm(), 1e-12);
}

// Power of the torques is the change of energy where only the joints move.
TEST(ChainMoments, DoTheWorkThatTheEnergyShows) {
  constexpr int kFrames = 600;
  Turns turns;
  Chain chain = RandomChain(kFrames, 11, &turns);
  chain.step = 1.0 / 2000.0;
  std::vector<ChainPose> poses;
  for (int t = 0; t < kFrames; ++t) {
    const double phase = 0.01 * t;
    chain.carrier[static_cast<size_t>(t)] = Pose();
    for (size_t k = 0; k < chain.joints.size(); ++k) {
      const VecX by = VecX::Constant(static_cast<Eigen::Index>(chain.joints[k].axes.size()),
                                     std::sin(phase + static_cast<double>(k)));
      turns[static_cast<size_t>(t)][k] = TurnedOn(Mat3::Identity(), chain.joints[k], by);
    }
    poses.push_back(PoseOfChain(chain, t, turns[static_cast<size_t>(t)]));
  }
  const auto energy = [&](int t) {  // half a step later
    double sum = 0.0;
    for (size_t k = 0; k < chain.joints.size(); ++k) {
      const auto &a = poses[static_cast<size_t>(t)].bodies[k],
                 &b = poses[static_cast<size_t>(t + 1)].bodies[k];
      const RigidInertia& body = chain.bodies[0][k];
      const Vec3 v = (b.g - a.g) / chain.step;
      const Vec3 w = TurnVector(a.W.transpose() * b.W) / chain.step;
      sum += 0.5 * body.mass * v.squaredNorm() + 0.5 * w.dot(body.I_com * w) +
             body.mass * 9.81 * 0.5 * (a.g.z() + b.g.z());
    }
    return sum;
  };
  double work = 0.0, turnover = 0.0;
  for (int t = 1; t + 1 < kFrames; ++t) {
    const size_t at = static_cast<size_t>(t);
    const ChainMoments moments(chain, t, poses[at - 1], poses[at], poses[at + 1]);
    for (size_t k = 0; k < chain.joints.size(); ++k) {
      const Mat3 before = k == 0 ? Mat3(Mat3::Identity()) : poses[at].bodies[k - 1].W;
      const Vec3 turn = 0.5 * TurnVector(turns[at - 1][k].transpose() * turns[at + 1][k]);
      const Vec3 in_world = before * (turns[at][k] * turn);
      work += moments.moment(static_cast<int>(k)).dot(in_world);
      turnover += std::abs(moments.moment(static_cast<int>(k)).dot(in_world));
    }
    EXPECT_NEAR(energy(t) - energy(0), work, 1e-3 * turnover + 1e-5) << t;
  }
}

}  // namespace
}  // namespace hazumi::solve
