// Where a pair of features ceases to be the nearest one around.

#include "engine/region/contact/touch_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

using namespace small;  // NOLINT(google-build-using-namespace): operators

struct Scene {
  ContactObstacle box;
  MovingCapsule capsule, other;

  std::optional<TouchPoint> BoxPoint(int pair, bool is_touching) const {
    return TouchPointOf(pair, capsule, box, is_touching);
  }
  std::optional<TouchPoint> CapsulePoint(int pair, bool is_touching) const {
    return TouchPointOf(pair, capsule, other, is_touching);
  }
};

MovingCapsule RandomCapsule(Random* random) {
  return {V3(random->Vector3(0.5)), V3(random->Vector3(0.5)), V3(), V3(), 0.05};
}

Scene RandomScene(uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.box.is_box = true;
  scene.box.R = random.Rotation();
  for (int i = 0; i < 3; ++i) scene.box.half_size[i] = random.Uniform(0.05, 0.3);
  scene.capsule = RandomCapsule(&random);
  scene.other = RandomCapsule(&random);
  return scene;
}

// Within slack of the end it may be either.
void ExpectBeyondWhereNotNearest(const std::optional<TouchPoint>& open,
                                 const std::optional<TouchPoint>& closed) {
  constexpr double kSlack = 1e-8;
  if (closed && std::abs(closed->beyond) < kSlack) return;
  EXPECT_EQ(open.has_value(), closed.has_value() && closed->beyond < 0.0);
}

TEST(TouchPoint, IsBeyondWhereItsPairIsNotTheNearest) {
  int inside = 0, beyond = 0;
  for (int seed = 1; seed <= 2000; ++seed) {
    const Scene scene = RandomScene(seed);
    for (int pair = kPlanePairs; pair < kBoxPairs; ++pair) {
      const auto closed = scene.BoxPoint(pair, true);
      ExpectBeyondWhereNotNearest(scene.BoxPoint(pair, false), closed);
      if (closed) ++(closed->beyond < 0.0 ? inside : beyond);
    }
    for (int pair = 2; pair < kCapsulePairs; ++pair) {
      ExpectBeyondWhereNotNearest(scene.CapsulePoint(pair, false), scene.CapsulePoint(pair, true));
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(beyond, 1000);
}

double NearestOpen(const Scene& scene) {
  double gap = HUGE_VAL;
  for (int pair = 0; pair < kBoxPairs; ++pair) {
    if (const auto point = scene.BoxPoint(pair, false)) gap = std::min(gap, point->gap);
  }
  return gap;
}

// So that what lets go of one pair touches by the next.
TEST(TouchPoint, WhereAPairEndsAnotherIsAsNear) {
  int ends = 0;
  for (int seed = 1; seed <= 2000; ++seed) {
    const Scene scene = RandomScene(seed);
    Random random(seed);
    const V3 way(random.Vector3(0.5));
    for (int pair = kPlanePairs; pair < kBoxPairs; ++pair) {
      const auto moved = [&](double share) {
        Scene there = scene;
        there.capsule.a += share * way;
        there.capsule.b += share * way;
        return there;
      };
      if (!scene.BoxPoint(pair, false) || moved(1.0).BoxPoint(pair, false)) continue;
      double inside = 0.0, outside = 1.0;
      for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (inside + outside);
        (moved(middle).BoxPoint(pair, false) ? inside : outside) = middle;
      }
      const Scene end = moved(outside);
      const auto point = end.BoxPoint(pair, true);
      // What is inside the box is told by its faces.
      if (!point || NearestOpen(end) < -0.049) continue;
      EXPECT_NEAR(point->beyond, 0.0, 1e-8) << seed << ' ' << pair;
      EXPECT_LE(NearestOpen(end), point->gap + 1e-7) << seed << ' ' << pair;
      ++ends;
    }
  }
  EXPECT_GT(ends, 500);
}

}  // namespace
}  // namespace hazumi::test
