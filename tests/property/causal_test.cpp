// Causality of motion: a change of an end time does not change any earlier frame.
//
// Random working regions (random figures with drives, forces, contacts, constraints) of 30 frames.
// Their regions, placements, forces and constraints, and the animation, become 1, 5 or 20 frames
// shorter or longer. Angles, rates and the root of all frames before the earlier end must be equal
// bit by bit. A plain ctest runs a few cases; `ctest -C Slow -L slow -R causal -V` runs 500.
// HAZUMI_CASES and HAZUMI_FIRST_CASE as everywhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <tuple>
#include <vector>

#include "engine/bake/bake.h"
#include "tests/property/random_fall.h"
#include "tests/property/random_working_region.h"
#include "tests/support/from_environment.h"

namespace hazumi::test {
namespace {

bool SameBits(const VecX& a, const VecX& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), static_cast<size_t>(a.size()) * sizeof(double)) == 0;
}

bool SameBits(const Pose& a, const Pose& b) {
  return std::memcmp(a.R.data(), b.R.data(), sizeof(double) * 9) == 0 &&
         std::memcmp(a.p.data(), b.p.data(), sizeof(double) * 3) == 0;
}

bool AreSame(const MotionFrame& a, const MotionFrame& b) {
  return SameBits(a.q, b.q) && SameBits(a.X_WR, b.X_WR) && SameBits(a.after.qd, b.after.qd) &&
         SameBits(a.before.qd, b.before.qd) && a.after.root_v == b.after.root_v &&
         a.after.root_w == b.after.root_w && a.contacts.pushes.size() == b.contacts.pushes.size();
}

// Events before a time [s], without what impacts they combine.
std::vector<std::tuple<double, EventKind, std::string>> EventsBefore(double time,
                                                                     const Motion& motion) {
  std::vector<std::tuple<double, EventKind, std::string>> events;
  for (const MotionEvent& event : motion.events) {
    if (event.time < time) events.emplace_back(event.time, event.kind, event.joint);
  }
  return events;
}

// Extends or trims all items that last up to `from` to last up to `to`.
Animation WithEnd(Animation animation, int from, int to) {
  const auto move = [&](int* end) {
    if (*end >= from) *end = to;
  };
  move(&animation.last_frame);
  for (DynamicsRegion& region : animation.regions) move(&region.last_frame);
  for (PlacementSpan& span : animation.placements) move(&span.last_frame);
  for (OuterForce& force : animation.forces) move(&force.last_frame);
  for (Constraint& constraint : animation.constraints) move(&constraint.last_frame);
  return animation;
}

struct Tally {
  int cases = 0, failed = 0, differ = 0;
};

void Compare(int seed, const Animation& animation, int other_end, Tally* tally) {
  const int end = animation.last_frame;
  ++tally->cases;
  const Result<Motion> one = Bake(animation), two = Bake(WithEnd(animation, end, other_end));
  if (!one.ok() || !two.ok()) {  // the shorter one may end before the failure
    ++tally->failed;
    return;
  }
  const int until = std::min(end, other_end) - animation.first_frame;
  for (int i = 0; i < until; ++i) {
    const auto index = static_cast<size_t>(i);
    if (AreSame(one.value().frames[index], two.value().frames[index])) continue;
    ++tally->differ;
    std::printf(
        "seed %d: ends in frame %d or %d, frame %d differs by %.3g rad\n", seed, end, other_end, i,
        (one.value().frames[index].q - two.value().frames[index].q).lpNorm<Eigen::Infinity>());
    return;
  }
  const double time = animation.rate.SecondsAt(animation.first_frame + until - 1);
  if (EventsBefore(time, one.value()) == EventsBefore(time, two.value())) return;
  ++tally->differ;
  std::printf("seed %d: ends in frame %d or %d, events differ\n", seed, end, other_end);
}

template <typename Draw>
void TryAll(int most_cases, Draw&& draw) {
  Tally tally;
  for (const int seed : RandomCases(1, most_cases)) {
    const Animation animation = draw(static_cast<uint64_t>(seed));
    constexpr int kBy[] = {1, 5, 20};
    const int by = kBy[seed % 3], sign = seed % 2 == 0 ? 1 : -1;
    Compare(seed, animation, animation.last_frame + sign * by, &tally);
  }
  std::printf("%d cases, %d differ before the end, %d not compared\n", tally.cases, tally.differ,
              tally.failed);
  EXPECT_EQ(tally.differ, 0);
  EXPECT_LE(tally.failed, tally.cases / 10);
}

TEST(TrimmedEnd, LeavesWorkingRegionsBeforeItAsTheyWere) {
  TryAll(12, [](uint64_t seed) { return RandomWorkingRegion(seed).animation; });
}

TEST(TrimmedEnd, LeavesFallsBeforeItAsTheyWere) {
  TryAll(6, [](uint64_t seed) {
    constexpr Terrain kTerrains[] = {Terrain::kPlane, Terrain::kBoxes, Terrain::kStairs};
    Animation animation = RandomFall(seed, kTerrains[seed % 3]);
    return WithEnd(animation, animation.last_frame, animation.first_frame + 40);
  });
}

}  // namespace
}  // namespace hazumi::test
