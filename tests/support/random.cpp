#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace hazumi::test {

double Random::Uniform(double low, double high) {
  return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
}

double Random::LogUniform(double low, double high) {
  return std::exp(Uniform(std::log(low), std::log(high)));
}

int Random::Integer(int low, int high) {
  return low + static_cast<int>(bits_() % static_cast<uint64_t>(high - low + 1));
}

VecX Random::Vector(int size, double bound) {
  VecX x(size);
  for (int i = 0; i < size; ++i) x[i] = Uniform(-bound, bound);
  return x;
}

// Shoemake's map from the unit cube to the unit quaternions.
Mat3 Random::Rotation() {
  const double u = Uniform(0.0, 1.0);
  const double a = 2.0 * std::numbers::pi * Uniform(0.0, 1.0);
  const double b = 2.0 * std::numbers::pi * Uniform(0.0, 1.0);
  const double s = std::sqrt(1.0 - u), t = std::sqrt(u);
  return Eigen::Quaterniond(t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b))
      .normalized()
      .toRotationMatrix();
}

Mat3 Random::Inertia(double mass, double size) {
  Vec3 spread;  // mean squares of the mass along each axis: any positive ones make a real body
  for (double& x : spread) x = std::pow(size * Uniform(0.3, 1.0), 2);
  const Mat3 R = Rotation();
  const Vec3 moments = mass * (Vec3::Constant(spread.sum()) - spread);
  const Mat3 inertia = R * moments.asDiagonal() * R.transpose();
  return 0.5 * (inertia + inertia.transpose());
}

}  // namespace hazumi::test
