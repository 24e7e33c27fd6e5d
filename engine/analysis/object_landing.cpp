// The parabola through two neighbouring frames of a flight, a time T apart:
//   p(t) = p0 + v0 t + g t^2 / 2
// v0 is that of the frames before, (p0 - p-1) / T + g T / 2, since the last frame may lie where
// keys have put the object; of the first frames in the air it is (p1 - p0) / T - g T / 2. The gap
// to the scene is sampled on it and its first zero halved down to rounding.

#include "engine/analysis/object_landing.h"

#include <algorithm>

#include "engine/collision/distance.h"

namespace hazumi {

namespace {

constexpr int kSamples = 16;            // of the gap, between two frames
constexpr int kHalvings = 50;           // of the time between two samples
constexpr double kStill = 1e-9;         // moves less than this are none [m]
constexpr double kTouchingGap = 1e-12;  // so near is touching: as exact as the gap is [m]

struct Gap {
  double value = 0.0;  // [m]
  const SceneObject* obstacle = nullptr;
};

Gap GapAt(const Animation& animation, const Vec3& p, double radius) {
  Gap least;
  for (const SceneObject& obstacle : animation.scene) {
    const double value = SignedDistance(Capsule{p, p, radius}, obstacle.shape).value;
    if (!least.obstacle || value < least.value) least = {value, &obstacle};
  }
  return least;
}

struct FlightPath {
  Vec3 p0, v0, g;
  Vec3 At(double t) const { return p0 + t * v0 + (0.5 * t * t) * g; }
};

// From 0 to T.
std::optional<ObjectLanding> FirstTouchOn(const FlightPath& path, double T, double radius,
                                          const Animation& animation) {
  double clear = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    double touching = T * i / kSamples;
    if (GapAt(animation, path.At(touching), radius).value > kTouchingGap) {
      clear = touching;
      continue;
    }
    // As it is let go it may touch, and leave.
    if (i == 0) continue;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (clear + touching);
      (GapAt(animation, path.At(middle), radius).value > kTouchingGap ? clear : touching) = middle;
    }
    const Vec3 position = path.At(touching);
    return ObjectLanding{position, touching, GapAt(animation, position, radius).obstacle->name};
  }
  return std::nullopt;
}

}  // namespace

std::optional<ObjectLanding> LandingOf(const Animation& animation, const Motion& motion,
                                       size_t object) {
  if (animation.scene.empty()) return std::nullopt;
  const double T = motion.rate.seconds_per_frame();
  const double radius = InnerRadius(animation.held_objects[object]);
  const Vec3 g = -animation.gravity * Vec3::UnitZ();
  const auto pose = [&](size_t i) -> const ObjectPose& { return motion.frames[i].objects[object]; };
  bool was_held = false;
  int flown = 0;  // frames since it was let go
  for (size_t i = 1; i < motion.frames.size(); ++i) {
    was_held = was_held || pose(i - 1).is_held();
    // The way from the hand's last frame to the one in which it lets go is still the hand's.
    if (!was_held || pose(i - 1).is_held() || pose(i).is_held()) {
      flown = 0;
      continue;
    }
    const Vec3 p0 = pose(i - 1).X_WO.p, step = pose(i).X_WO.p - p0;
    if (step.norm() < kStill) continue;
    const Vec3 v0 = flown > 0 ? Vec3((p0 - pose(i - 2).X_WO.p) / T + 0.5 * T * g)
                              : Vec3(step / T - 0.5 * T * g);
    ++flown;
    auto landing = FirstTouchOn({p0, v0, g}, T, radius, animation);
    if (!landing) continue;
    landing->time += motion.rate.SecondsAt(motion.frames[i - 1].frame);
    return landing;
  }
  return std::nullopt;
}

double InnerRadius(const HeldObject& object) {
  if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) return sphere->radius;
  return std::get<BoxShape>(object.shape).half_size.minCoeff();
}

}  // namespace hazumi
