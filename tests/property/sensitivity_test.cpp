// Random regions of random figures: are the derivatives of a motion with respect to the rates and
// angles in which it begins those of bakes?
//
// Two joints of a random figure or of the shipped human, with all beyond them or by themselves,
// swing for 5 to 30 frames: friction of all kinds, limits, the root keyed in motion or pinned, in
// half of the regions with torques and springs. D u, u a random direction, is compared with
// Richardson's extrapolation of central differences of four bakes whose tolerance is 2e-10 rad,
//   D u = (4 d(h/2) - d(h)) / 3,   d(h) = (x(+h u) - x(-h u)) / (2 h),   h |D u| <= 1e-3 rad,
// with x the angles and rates on the last frame. Errors are relative to the largest entry of D u, a
// rate of 20 rad/s as large as an angle of 1 rad. Where the four bakes do not hit the same limits
// in the same order there is no derivative to compare with. HAZUMI_CASES and HAZUMI_FIRST_CASE as
// everywhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/bake/bake.h"
#include "engine/bake/sensitivity/region_sensitivity.h"
#include "tests/property/random_drives.h"
#include "tests/property/random_region.h"
#include "tests/support/from_environment.h"

namespace hazumi::test {
namespace {

constexpr double kRateScale = 20.0;   // [1/s]
constexpr double kTolerance = 2e-10;  // of bakes [rad]
constexpr double kMostError = 1e-5;   // relative
constexpr double kChange = 1e-3;      // of the last frame [rad]
constexpr double kLeastSize = 1e-2;   // of derivatives that errors are relative to

Animation RandomSwing(uint64_t seed) {
  Animation animation = RandomRegion(seed, /*has_limits=*/true);
  Random random(seed + 1000000007);
  DynamicsRegion& region = animation.regions[0];
  const bool is_pinned =
      !animation.placements.empty() && animation.placements[0].kind == PlacementKind::kPinned;
  if (!is_pinned) {
    animation.placements.clear();
    region.root = false;
  }
  for (Keys& keys : animation.root_keys) {
    if (is_pinned) keys = {{0, keys[0].value, 0.0, Interpolation::kCubic}};
  }
  if (random.Chance(0.5)) AddRandomDrives(&random, &animation);
  for (Drive& drive : region.drives) drive.feed_forward = false;
  animation.solver.tolerance = kTolerance;
  return animation;
}

// A change of the state in which a region begins, by hinge of its sensitivity.
struct Direction {
  std::vector<Coordinate> hinges;
  VecX angles, rates;
};

Animation Changed(Animation animation, const Direction& direction, double h) {
  for (size_t i = 0; i < direction.hinges.size(); ++i) {
    const Coordinate c = direction.hinges[i];
    if (c >= animation.figure->num_joints()) continue;
    auto& key = animation.joint_keys[static_cast<size_t>(c)][0];
    const auto at = static_cast<Eigen::Index>(i);
    key.value += h * direction.angles[at];
    key.rate = *key.rate + h * direction.rates[at];
  }
  return animation;
}

// Returns whether keys say in which state a hinge begins, and nothing else: springs read them, too.
bool IsFreeToChange(Coordinate hinge, const Animation& animation) {
  if (hinge >= animation.figure->num_joints()) return false;
  for (const Drive& drive : animation.regions[0].drives) {
    const bool is_driven =
        std::binary_search(drive.joints.begin(), drive.joints.end(), JointIndex(hinge));
    if (is_driven && FollowsKeys(drive)) return false;
  }
  return true;
}

struct End {
  VecX x;  // angles, then rates
  std::vector<std::pair<std::string, long>> hits;
};

// State of the last frame; none if the bake fails.
std::optional<End> EndOf(const Animation& animation, const std::vector<Coordinate>& hinges) {
  BakeOptions options;
  options.refine = false;
  const Result<Motion> motion = Bake(animation, options);
  if (!motion.ok()) return std::nullopt;
  const MotionLimit& last = motion.value().frames.back().before;
  const auto n = static_cast<Eigen::Index>(hinges.size());
  End end{VecX::Zero(2 * n), {}};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Coordinate c = hinges[static_cast<size_t>(i)];
    if (c >= animation.figure->num_joints()) continue;
    end.x[i] = last.q[c];
    end.x[n + i] = last.qd[c];
  }
  for (const MotionEvent& event : motion.value().events) {
    if (event.kind == EventKind::kLimit) end.hits.emplace_back(event.joint, event.count);
  }
  return end;
}

double SizeOfChange(const VecX& x) {
  const Eigen::Index n = x.size() / 2;
  return std::max(x.head(n).lpNorm<Eigen::Infinity>(),
                  x.tail(n).lpNorm<Eigen::Infinity>() / kRateScale);
}

// Richardson's extrapolation, by h that is made smaller until its two differences are nearly the
// same and all bakes hit the same limits in the same order.
struct Reference {
  bool is_solved = true, has_one_order = false;
  double curvature = 0.0;  // how far the two are apart, relative
  VecX du;
};
Reference ReferenceFor(const Animation& animation, const Direction& direction, double h,
                       double size) {
  constexpr int kMostTries = 5;
  constexpr double kNearlySame = 3e-5, kSmaller = 0.2;
  Reference reference;
  for (int tries = 0; tries < kMostTries; ++tries, h *= kSmaller) {
    std::array<End, 4> ends;
    const std::array steps = {h, -h, 0.5 * h, -0.5 * h};
    for (size_t i = 0; i < ends.size(); ++i) {
      const std::optional<End> end =
          EndOf(Changed(animation, direction, steps[i]), direction.hinges);
      reference.is_solved &= end.has_value();
      if (!end) return reference;
      ends[i] = *end;
    }
    reference.has_one_order = std::all_of(ends.begin(), ends.end(),
                                          [&](const End& end) { return end.hits == ends[0].hits; });
    const VecX coarse = (ends[0].x - ends[1].x) / (2.0 * h), fine = (ends[2].x - ends[3].x) / h;
    reference.curvature = SizeOfChange(fine - coarse) / size;
    reference.du = (4.0 * fine - coarse) / 3.0;
    if (reference.has_one_order && reference.curvature < kNearlySame) break;
  }
  return reference;
}

struct Tally {
  int cases = 0, refused = 0, unchanged = 0, other_order = 0, one_sided = 0, wrong = 0;
  int hits = 0, releases = 0, with_events = 0;
  std::vector<double> errors;
};

void Compare(int seed, const Animation& animation, bool by_angles, Tally* tally) {
  ++tally->cases;
  const Result<RegionSensitivity> made = DeriveRegion(animation, 0, {animation.last_frame});
  if (!made.ok()) {
    ++tally->refused;
    std::printf("seed %d: %s\n", seed, made.error().ToString().c_str());
    return;
  }
  const RegionSensitivity& sensitivity = made.value();
  const auto n = static_cast<Eigen::Index>(sensitivity.hinges.size());
  Random random(static_cast<uint64_t>(seed));
  Direction direction{sensitivity.hinges, VecX::Zero(n), VecX::Zero(n)};
  (by_angles ? direction.angles : direction.rates) = random.Vector(static_cast<int>(n), 1.0);
  VecX u(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (IsFreeToChange(sensitivity.hinges[static_cast<size_t>(i)], animation)) continue;
    direction.angles[i] = direction.rates[i] = 0.0;
  }
  if (direction.angles.isZero(0.0) && direction.rates.isZero(0.0)) {
    ++tally->unchanged;
    return;
  }
  u << direction.angles, direction.rates;
  const double end = animation.rate.SecondsAt(animation.last_frame);
  for (Eigen::Index c = 0; c < 2 * n; ++c) {
    if (u[c] != 0.0 && sensitivity.one_sided_from[static_cast<size_t>(c)] < end) {
      ++tally->one_sided;
      return;
    }
  }
  VecX du = sensitivity.frames[0].D * u;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (sensitivity.hinges[static_cast<size_t>(i)] < animation.figure->num_joints()) continue;
    du[i] = du[n + i] = 0.0;
  }
  const double size = std::max(SizeOfChange(du), kLeastSize);
  const Reference reference = ReferenceFor(animation, direction, kChange / size, size);
  ASSERT_TRUE(reference.is_solved) << "seed " << seed;
  if (!reference.has_one_order) {
    ++tally->other_order;
    return;
  }
  const double error = SizeOfChange(du - reference.du) / size;
  for (const RegionSensitivity::Event& event : sensitivity.events) {
    ++(event.kind == LimitEvent::kHit ? tally->hits : tally->releases);
  }
  tally->with_events += !sensitivity.events.empty();
  tally->errors.push_back(error);
  if (error <= kMostError) return;
  ++tally->wrong;
  std::printf("seed %d: error %.3g, curvature %.3g, size %.3g, %zu events\n", seed, error,
              reference.curvature, size, sensitivity.events.size());
}

TEST(RegionSensitivity, EqualsDifferencesOfBakes) {
  constexpr double kMostWrong = 0.003, kMostOthers = 0.25;  // shares of all
  Tally tally;
  for (const int seed : RandomCases(1, 500)) {
    const Animation animation = RandomSwing(static_cast<uint64_t>(seed));
    const bool by_angles = animation.regions[0].drives.empty() && seed % 2 == 0;
    Compare(seed, animation, by_angles, &tally);
  }
  std::sort(tally.errors.begin(), tally.errors.end());
  const auto compared = static_cast<int>(tally.errors.size());
  ASSERT_GT(compared, 0);
  std::printf(
      "%d regions: %d compared, %d of them with %d hits and %d releases; error at most %.3g, "
      "median "
      "%.3g, %d above %.0e; not compared: other order of events %d, one-sided %d, refused %d, "
      "nothing to change %d\n",
      tally.cases, compared, tally.with_events, tally.hits, tally.releases, tally.errors.back(),
      tally.errors[tally.errors.size() / 2], tally.wrong, kMostError, tally.other_order,
      tally.one_sided, tally.refused, tally.unchanged);
  // None of the seeds of a plain ctest; of others two in a thousand, most of them with drives.
  EXPECT_LE(tally.wrong, tally.cases == 500 && std::getenv("HAZUMI_FIRST_CASE") == nullptr
                             ? 0
                             : MostOf(tally.cases, kMostWrong));
  EXPECT_LE(tally.cases - compared, MostOf(tally.cases, kMostOthers));
}

}  // namespace
}  // namespace hazumi::test
