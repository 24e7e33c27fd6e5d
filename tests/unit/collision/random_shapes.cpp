#include "tests/unit/collision/random_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hazumi::test {
namespace {

enum Family { kGeneral, kGrid, kSphere, kParallel, kNearlyParallel, kCentred, kThin, kLimb };

class SceneMaker {
 public:
  SceneMaker(uint64_t seed, int index)
      : random_(seed + static_cast<uint64_t>(index)),
        family_(static_cast<Family>(index % kFamilies)),
        path_(index / kFamilies % 5),
        scale_(std::pow(10.0, Uniform(-3.0, 2.0))) {}

  Scene Make(ObstacleKind kind) {
    X_WO_ = {RandomRotation(), Uniform(0.0, 1.0) * Offset(100.0)};
    if (family_ == kGrid) X_WO_ = {Mat3::Identity(), OnGrid(X_WO_.p)};
    Scene scene;
    scene.obstacle = MakeObstacle(kind);
    scene.capsule = MakeCapsule();
    scene.translation = MakePath(0.5 * (scene.capsule.a + scene.capsule.b));
    return scene;
  }

 private:
  double Uniform(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random_);
  }
  Vec3 Offset(double size) {
    return {Uniform(-size, size), Uniform(-size, size), Uniform(-size, size)};
  }
  Mat3 RandomRotation() {
    std::normal_distribution<double> normal;
    const Eigen::Vector4d q(normal(random_), normal(random_), normal(random_), normal(random_));
    return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
  }
  // Of the scene's scale, down to a hundredth of it, within 1 mm and 100 m.
  double Size() {
    const double size = scale_ * std::pow(10.0, Uniform(-2.0, 0.0));
    return std::clamp(family_ == kGrid ? std::ceil(4.0 * size / scale_) * Step() : size, 1e-3, 1e2);
  }
  double Step() const { return std::exp2(std::round(std::log2(scale_))) / 4.0; }
  Vec3 OnGrid(const Vec3& x) const { return (x / Step()).array().round() * Step(); }

  Obstacle MakeObstacle(ObstacleKind kind) {
    if (kind == ObstacleKind::kPlane) {
      const Vec3 n = X_WO_.R.col(2);
      return Plane{n, n.dot(X_WO_.p)};
    }
    if (kind == ObstacleKind::kBox) return Box{X_WO_, Vec3(Size(), Size(), Size())};
    const Vec3 half = Size() * X_WO_.R.col(2);
    return Capsule{X_WO_.p - half, X_WO_.p + half, Size()};
  }

  Vec3 CapsuleAxis() {
    if (family_ == kSphere) return Vec3::Zero();
    const int i = std::uniform_int_distribution<int>(0, 2)(random_);
    const Vec3 along = X_WO_.R.col(family_ == kGrid ? i : i == 0 ? 0 : 2) * Size();
    if (family_ == kGrid || family_ == kParallel) return along;
    const Vec3 across = Offset(1.0);
    if (family_ != kNearlyParallel) return across.normalized() * Size();
    return along + along.norm() * std::pow(10.0, Uniform(-13.0, -3.0)) * across;
  }

  Capsule MakeCapsule() {
    const double big = scale_;
    if (family_ == kLimb) scale_ = std::max(1e-3, 0.01 * scale_);
    const Vec3 axis = CapsuleAxis();
    Vec3 centre = X_WO_.p + X_WO_.R * Offset(1.2 * big);
    if (Uniform(0.0, 1.0) < 0.3) centre = X_WO_.p + Offset(0.2 * big);
    if (family_ == kCentred) centre = X_WO_.p;
    if (family_ == kGrid) centre = OnGrid(centre);
    const double radius = family_ == kThin ? 0.0 : Size();
    scale_ = big;
    return {centre - 0.5 * axis, centre + 0.5 * axis, radius};
  }

  Vec3 MakePath(const Vec3& from) {
    const Vec3 towards = X_WO_.p + Offset(0.5 * scale_) - from;
    if (path_ == 0) return Uniform(0.5, 1.5) * towards;
    if (path_ == 1) return Uniform(3.0, 30.0) * towards;
    const int axis = std::uniform_int_distribution<int>(0, 2)(random_);
    if (path_ == 2) return Uniform(-3.0, 3.0) * scale_ * X_WO_.R.col(axis);
    if (path_ == 3) return Offset(3.0 * scale_);
    return Vec3::Zero();
  }

  std::mt19937_64 random_;
  Family family_;
  int path_;
  double scale_;
  Pose X_WO_;
};

}  // namespace

Scene RandomScene(ObstacleKind kind, uint64_t seed, int index) {
  return SceneMaker(seed, index).Make(kind);
}

}  // namespace hazumi::test
