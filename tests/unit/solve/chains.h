#pragma once

#include <cmath>
#include <random>

#include "engine/solve/chain.h"
#include "engine/solve/turn_vector.h"

namespace hazumi::solve {

// An arm of three joints, the first a ball, the second a hinge, the third of two hinges, on a
// carrier that moves; all of it at random, the motion smooth.
inline Chain RandomChain(int frames, unsigned seed, Turns* turns) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&](double size) {
    return Vec3(size * Vec3(number(random), number(random), number(random)));
  };
  Chain chain;
  chain.step = 1.0 / 60.0;
  chain.gravity = {0.0, 0.0, -9.81};
  const Vec3 ball[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  chain.joints = {{vector(0.2), {{ball[0], false}, {ball[1], false}, {ball[2], false}}},
                  {vector(0.3), {{vector(1.0).normalized(), false}}},
                  {vector(0.3), {{Vec3::UnitX(), true}, {Vec3::UnitY(), false}}}};
  std::vector<Mat3> inertias;
  for (size_t k = 0; k < chain.joints.size(); ++k) {
    const Mat3 A = Mat3::NullaryExpr([&] { return 0.1 * number(random); });
    inertias.push_back(A * A.transpose() + 0.01 * Mat3::Identity());
  }
  const Vec3 sway = vector(0.3), turn = vector(0.5);
  std::vector<Vec3> swings, coms;
  for (size_t k = 0; k < chain.joints.size(); ++k) {
    swings.push_back(vector(0.8));
    coms.push_back(vector(0.2));
  }
  for (int t = 0; t < frames; ++t) {
    const double phase = 0.35 * t;
    chain.carrier.push_back({RotationBy(std::sin(phase) * turn), std::cos(phase) * sway});
    std::vector<RigidInertia> bodies;
    std::vector<Mat3> now;
    for (size_t k = 0; k < chain.joints.size(); ++k) {
      bodies.push_back({1.0 + 0.5 * static_cast<double>(k), coms[k], inertias[k]});
      const double angle = std::sin(phase + static_cast<double>(k));
      const VecX by = VecX::Constant(static_cast<Eigen::Index>(chain.joints[k].axes.size()), angle);
      now.push_back(TurnedOn(RotationBy(swings[k]), chain.joints[k], by));
    }
    turns->push_back(now);
    chain.bodies.push_back(bodies);
    chain.is_known.push_back(std::vector<char>(chain.joints.size(), 0));
  }
  return chain;
}

}  // namespace hazumi::solve
