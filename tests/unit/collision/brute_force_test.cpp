// The main test: every answer against the searches of brute_force.h, 10,000 scenes an obstacle
// (in a release build).

#include "tests/unit/collision/brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "engine/collision/distance.h"
#include "tests/unit/collision/random_shapes.h"

namespace hazumi::test {
namespace {

constexpr uint64_t kSeed = 20260101;
constexpr int kScenes = 10000;
constexpr double kBruteTolerance = 1e-9;

// The largest of the errors it was shown, and how many.
class Worst {
 public:
  explicit Worst(const char* name) : name_(name) {}
  void Add(double error) {
    EXPECT_LE(error, kBruteTolerance) << name_;
    ++count_;
    if (!(error <= worst_)) worst_ = error;
  }
  void Print() const { std::printf("  %-44s %6d cases, worst %.1e m\n", name_, count_, worst_); }

 private:
  const char* name_;
  double worst_ = 0.0;
  int count_ = 0;
};

std::string Label(int index) {
  return "seed " + std::to_string(kSeed) + ", scene " + std::to_string(index) + " (" +
         kFamilyNames[index % kFamilies] + ")";
}

double SearchPoint(const Vec3& point, const Obstacle& obstacle) {
  return SearchSignedDistance({point, point, 0.0}, obstacle);
}

struct DistanceErrors {
  Worst apart{"distance apart"}, depth{"depth"}, unit{"|normal| - 1"};
  Worst leave{"gap left after moving by -value * normal"}, touching{"distance when touching"};
  Worst on_capsule{"point_on_capsule to the capsule's surface"};
  Worst on_obstacle{"point_on_capsule - value * normal to obstacle"};

  void Check(const Scene& scene) {
    const Distance d = SignedDistance(scene.capsule, scene.obstacle);
    const double error = d.value - SearchSignedDistance(scene.capsule, scene.obstacle);
    (d.value >= 0.0 ? apart : depth).Add(std::abs(error));
    unit.Add(std::abs(d.normal.norm() - 1.0));
    const Vec3 out = -d.value * d.normal;
    leave.Add(std::abs(SearchSignedDistance(Moved(scene.capsule, out), scene.obstacle)));
    touching.Add(std::abs(SignedDistance(Moved(scene.capsule, out), scene.obstacle).value));
    on_capsule.Add(std::abs(SearchPoint(d.point_on_capsule, scene.capsule)));
    on_obstacle.Add(std::abs(SearchPoint(d.point_on_capsule + out, scene.obstacle)));
  }
  void Print() const {
    for (const Worst* worst : {&apart, &depth, &unit, &leave, &touching, &on_capsule, &on_obstacle})
      worst->Print();
  }
};

struct SweepErrors {
  Worst gap{"gap at first touch"}, path{"path to first touch, unless grazing"};
  Worst missed{"overlap of a path said to be free"}, invented{"gap of a path said to touch"};
  Worst late{"overlap before first touch"};
  int at_start = 0, grazing = 0;

  void Check(const Scene& scene) {
    const auto s = FirstTouch(scene.capsule, scene.translation, scene.obstacle);
    const auto searched = SearchFirstTouch(scene.capsule, scene.translation, scene.obstacle);
    if (!s) {
      EXPECT_FALSE(searched.s.has_value());
      return missed.Add(std::max(0.0, -searched.least_gap));
    }
    invented.Add(std::max(0.0, searched.least_gap));
    if (*s == 0.0) {
      ++at_start;
      return gap.Add(std::max(0.0, SearchGap(scene.capsule, scene.obstacle)));
    }
    CheckTouch(scene, *s, searched.s.value_or(*s));
  }

  void CheckTouch(const Scene& scene, double s, double searched_s) {
    const Vec3& path_W = scene.translation;
    const auto at = [&](double x) { return Moved(scene.capsule, x * path_W); };
    gap.Add(std::abs(SearchGap(at(s), scene.obstacle)));
    late.Add(std::max(0.0, -SearchGap(at(0.5 * (s + searched_s)), scene.obstacle)));
    const double length = path_W.norm();
    const double way = std::min(1e-6, s * length);
    const double approach = SearchGap(at(s - way / length), scene.obstacle) / way;
    if (approach < 0.05) ++grazing;
    if (approach >= 0.05) path.Add(std::abs(s - searched_s) * length);
  }

  void Print() const {
    for (const Worst* worst : {&gap, &path, &missed, &invented, &late}) worst->Print();
    std::printf("  %d touched at the start, %d grazed\n", at_start, grazing);
  }
};

// The scene as RandomScene() makes it.
Scene AsMade(const Scene& scene, int) { return scene; }

// The same with the capsule half-way along its path, so that most paths begin outside.
Scene HalfWay(const Scene& scene, int) {
  return {Moved(scene.capsule, -0.5 * scene.translation), scene.obstacle, scene.translation};
}

// A path that comes nearest, at its middle, to a gap of -1e-6, -2e-9, 0, 2e-9 or 1e-6 m.
Scene Grazing(const Scene& scene, int index) {
  constexpr double kGaps[] = {-1e-6, -2e-9, 0.0, 2e-9, 1e-6};
  const Distance d = SignedDistance(scene.capsule, scene.obstacle);
  const Vec3& n = d.normal;
  const Vec3 path_W = scene.translation - n.dot(scene.translation) * n;
  const Vec3 middle = (kGaps[index % 5] - d.value) * n;
  return {Moved(scene.capsule, middle - 0.5 * path_W), scene.obstacle, path_W};
}

template <typename Errors>
void CheckScenes(ObstacleKind kind, Scene (*change)(const Scene&, int)) {
  Errors errors;
  for (int index = 0; index < kScenes; ++index) {
    SCOPED_TRACE(Label(index));
    errors.Check(change(RandomScene(kind, kSeed, index), index));
  }
  errors.Print();
}

using Kind = ObstacleKind;

TEST(SignedDistance, AgreesWithSearchForPlanes) {
  CheckScenes<DistanceErrors>(Kind::kPlane, AsMade);
}
TEST(SignedDistance, AgreesWithSearchAndHullForBoxes) {
  CheckScenes<DistanceErrors>(Kind::kBox, AsMade);
}
TEST(SignedDistance, AgreesWithSearchForCapsules) {
  CheckScenes<DistanceErrors>(Kind::kCapsule, AsMade);
}
TEST(FirstTouch, AgreesWithSearchForPlanes) { CheckScenes<SweepErrors>(Kind::kPlane, HalfWay); }
TEST(FirstTouch, AgreesWithSearchForBoxes) { CheckScenes<SweepErrors>(Kind::kBox, HalfWay); }
TEST(FirstTouch, AgreesWithSearchForCapsules) { CheckScenes<SweepErrors>(Kind::kCapsule, HalfWay); }
TEST(FirstTouch, AgreesWithSearchOnPathsGrazingPlanes) {
  CheckScenes<SweepErrors>(Kind::kPlane, Grazing);
}
TEST(FirstTouch, AgreesWithSearchOnPathsGrazingBoxes) {
  CheckScenes<SweepErrors>(Kind::kBox, Grazing);
}
TEST(FirstTouch, AgreesWithSearchOnPathsGrazingCapsules) {
  CheckScenes<SweepErrors>(Kind::kCapsule, Grazing);
}

// The path ends in a scene that touches exactly, as far as rounding allows.
TEST(FirstTouch, FindsATouchAtTheVeryEndOfThePath) {
  for (const Kind kind : {Kind::kPlane, Kind::kBox, Kind::kCapsule})
    for (int index = 0; index < std::min(kScenes, 1000); ++index) {
      SCOPED_TRACE(Label(index));
      const Scene scene = RandomScene(kind, kSeed, index);
      const Distance d = SignedDistance(scene.capsule, scene.obstacle);
      if (d.value < 1e-6) continue;
      const auto s = FirstTouch(scene.capsule, -d.value * d.normal, scene.obstacle);
      ASSERT_TRUE(s.has_value());
      EXPECT_NEAR((*s - 1.0) * d.value, 0.0, kBruteTolerance);
    }
}

}  // namespace
}  // namespace hazumi::test
