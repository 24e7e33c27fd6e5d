// What Newton's laws say about whole figures, whatever the algorithm.

#include <Eigen/Cholesky>

#include "engine/dynamics/inverse_dynamics.h"
#include "tests/support/compare.h"
#include "tests/support/dense_dynamics.h"
#include "tests/support/figures.h"
#include "tests/support/path.h"

namespace hazumi::test {
namespace {

constexpr uint64_t kSeeds = 40;

// Calls add(body inertia, body scratch) for every body with mass, the root included.
template <typename Add>
void ForEachBody(const Figure& figure, const DynamicsWorkspace& ws, const Add& add) {
  add(figure.root_body(), ws.bodies[0]);
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (!figure.joints()[j].massless) add(figure.body(JointIndex(j)), ws.bodies[j + 1]);
  }
}

Vec3 ComVelocity(const BodyScratch& b) { return b.v + b.w.cross(b.c); }

Vec3 Spin(const RigidInertia& inertia, const BodyScratch& b) {
  return b.R * inertia.I_com * b.R.transpose() * b.w;
}

double KineticEnergy(const Figure& figure, const DynamicsWorkspace& ws) {
  double energy = 0.0;
  ForEachBody(figure, ws, [&](const RigidInertia& inertia, const BodyScratch& b) {
    energy += 0.5 * inertia.mass * ComVelocity(b).squaredNorm() + 0.5 * b.w.dot(Spin(inertia, b));
  });
  return energy;
}

// Linear and angular momentum about the world's origin.
Vec6 Momentum(const Figure& figure, const DynamicsWorkspace& ws) {
  Vec6 momentum = Vec6::Zero();
  ForEachBody(figure, ws, [&](const RigidInertia& inertia, const BodyScratch& b) {
    const Vec3 p = inertia.mass * ComVelocity(b);
    momentum.head<3>() += p;
    momentum.tail<3>() += (b.p + b.c).cross(p) + Spin(inertia, b);
  });
  return momentum;
}

// Inverse dynamics of the path at time 0, without gravity.
DynamicsWorkspace Solved(const Path& path) {
  DynamicsWorkspace ws = path.At(0.0);
  InverseDynamics(path.figure(), path.root().Motion(), path.qd(), path.qdd(), nullptr, &ws);
  return ws;
}

TEST(InverseDynamics, PowerIsTheDerivativeOfKineticEnergy) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Path path(seed);
    const DynamicsWorkspace ws = Solved(path);
    const BodyScratch& root = ws.bodies[0];
    const double power = ws.tau.dot(path.qd()) + root.f.dot(root.v) + root.n.dot(root.w);
    const double derivative =
        Derivative([&](double t) { return KineticEnergy(path.figure(), path.At(t)); });
    const double size = KineticEnergy(path.figure(), ws) + std::abs(power);
    EXPECT_NEAR(power, derivative, 1e-8 * size) << "seed " << seed;
  }
}

TEST(InverseDynamics, ForceOnTheRootIsTheDerivativeOfMomentum) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Path path(seed);
    const BodyScratch root = Solved(path).bodies[0];
    Vec6 wrench;
    wrench << root.f, root.n + root.p.cross(root.f);
    const Vec6 derivative =
        Derivative([&](double t) { return Momentum(path.figure(), path.At(t)); });
    EXPECT_LE(RelativeDifference(derivative, wrench), 1e-8) << "seed " << seed;
  }
}

TEST(InertiaMatrix, GivesTheKineticEnergyOfAFigureOnAStillRoot) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Path path(seed);
    DynamicsWorkspace ws = path.At(0.0);
    ComputeVelocities(path.figure(), Vec3::Zero(), Vec3::Zero(), path.qd(), &ws);
    MatX H;
    InertiaMatrix(path.figure(), &ws, &H);
    const double energy = KineticEnergy(path.figure(), ws);
    EXPECT_NEAR(0.5 * path.qd().dot(H * path.qd()), energy, 1e-12 * energy) << "seed " << seed;
  }
}

TEST(InertiaMatrix, IsSymmetricAndPositiveDefinite) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Path path(seed);
    DynamicsWorkspace ws = path.At(0.0);
    MatX H;
    InertiaMatrix(path.figure(), &ws, &H);
    EXPECT_LE(RelativeDifference(H.transpose(), H), 1e-13) << "seed " << seed;
    EXPECT_EQ(H.llt().info(), Eigen::Success) << "seed " << seed;
  }
}

TEST(UnitAccelerationTorques, GiveTheForceOnTheRoot) {
  const Path path(7);
  DynamicsWorkspace ws = path.At(0.0), full = ws;
  const VecX zero = VecX::Zero(path.qd().size());
  for (int i = 0; i < path.figure().num_joints(); ++i) {
    UnitAccelerationTorques(path.figure(), JointIndex(i), &ws);
    InverseDynamics(path.figure(), RootMotion(), zero, VecX::Unit(zero.size(), i), nullptr, &full);
    EXPECT_LE(RelativeDifference(ws.bodies[0].f, full.bodies[0].f), 1e-12) << "joint " << i;
  }
}

// A hinge without mass of its own, and the same hinge with one too small to matter, which the code
// cannot skip.
FigureSpec WithHingesApart(const FigureSpec& spec, double mass) {
  FigureSpec apart = spec;
  apart.joints.clear();
  for (const JointSpec& joint : spec.joints) {
    for (size_t h = 0; h < joint.hinges.size(); ++h) {
      JointSpec single = joint;
      const bool last = h + 1 == joint.hinges.size();
      single.name = last ? joint.name : joint.name + "-" + std::to_string(h);
      single.hinges = {joint.hinges[h]};
      if (h > 0) {
        single.parent = joint.name + "-" + std::to_string(h - 1);
        single.offset.setZero();
        single.orientation.setIdentity();
      }
      LinkSpec link;
      link.mass = mass;
      if (!last) single.links = {link};
      apart.joints.push_back(single);
    }
  }
  return apart;
}

VecX TorquesAt(const Figure& figure, const Path& path) {
  DynamicsWorkspace ws(figure);
  Random random(99);
  ComputePositions(figure, path.root().X_WR(), RandomAngles(figure, &random), &ws);
  InverseDynamics(figure, path.root().Motion(), path.qd(), path.qdd(), nullptr, &ws);
  return ws.tau;
}

TEST(InverseDynamics, SkippingMasslessBodiesChangesNothing) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Path path(seed);
    Random random(seed);
    const FigureSpec spec = RandomTreeSpec(&random);
    const Figure massless = Build(WithHingesApart(spec, 0.0));
    const Figure nearly = Build(WithHingesApart(spec, 1e-200));
    EXPECT_LE(RelativeDifference(TorquesAt(massless, path), TorquesAt(nearly, path)), 1e-14)
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace hazumi::test
