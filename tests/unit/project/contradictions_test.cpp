// What must hold between regions, placements and holds: what is found, and how long that takes.

#include <gtest/gtest.h>

#include <atomic>
#include <ctime>
#include <set>

#include "engine/project/checks/animation_checks.h"
#include "engine/project/compile.h"
#include "tests/support/random.h"
#include "tests/support/scaled_projects.h"
#include "tests/unit/project/pairwise_checks.h"
#include "tests/unit/project/wrong_projects.h"

namespace hazumi::testing {
namespace {

using test::Random;

// Spans of a few frames among 40.
template <typename Item>
void PlaceInTime(Random* random, int longest, Item* item) {
  item->first_frame = random->Integer(0, 39);
  item->last_frame = std::min(40, item->first_frame + random->Integer(1, longest));
}

GroupIndex AnyGroup(const Figure& figure, Random* random) {
  return GroupIndex(random->Integer(0, static_cast<int>(figure.groups().size()) - 1));
}

DynamicsRegion AnyRegion(const Figure& figure, Random* random) {
  DynamicsRegion region;
  PlaceInTime(random, 6, &region);
  const JointGroup& group = figure.group(AnyGroup(figure, random));
  for (int j = group.first.value(); j <= group.last().value(); ++j) region.joints.emplace_back(j);
  region.root = random->Integer(0, 9) == 0;
  region.method = random->Integer(0, 29) == 0 ? Method::kPaper : Method::kExact;
  return region;
}

PlacementSpan AnyPlacement(const Figure& figure, Random* random) {
  PlacementSpan span;
  PlaceInTime(random, 5, &span);
  span.kind = random->Integer(0, 3) == 0 ? PlacementKind::kGravity : PlacementKind::kPinned;
  span.pin = AnyGroup(figure, random);
  if (span.kind == PlacementKind::kGravity) span.landing_pin = AnyGroup(figure, random);
  return span;
}

IkHold AnyHold(const Figure& figure, Random* random) {
  IkHold hold;
  PlaceInTime(random, 6, &hold);
  hold.joint = AnyGroup(figure, random);
  if (random->Integer(0, 2) == 0) hold.reach = HoldReach::kBody;
  return hold;
}

Animation AnyAnimation(std::shared_ptr<const Figure> figure, Random* random) {
  Animation animation;
  animation.figure = std::move(figure);
  animation.last_frame = 40;
  animation.solver.method = Method::kExact;
  const auto add = [&](int most, auto make, auto* list) {
    for (int i = random->Integer(0, most); i > 0; --i) {
      list->push_back(make(*animation.figure, random));
    }
  };
  add(4, AnyRegion, &animation.regions);
  add(3, AnyPlacement, &animation.placements);
  add(4, AnyHold, &animation.holds);
  return animation;
}

TEST(Contradictions, AreThoseThatComparingAllPairsFinds) {
  const test::ScaledProject human = test::MakeScaled("frames", 2);
  const auto figure = CompileAnimation(human.project).value().animation.figure;
  std::map<Check, int> found;
  int sound = 0;
  for (uint64_t seed = 1; seed <= 20000; ++seed) {
    Random random(seed);
    const Animation animation = AnyAnimation(figure, &random);
    const auto expected = FirstContradiction(animation);
    FirstError errors;
    CheckAnimation(animation, nullptr, &errors);
    ASSERT_EQ(expected.has_value(), !errors.ok()) << "seed " << seed;
    if (!expected) {
      ++sound;
      continue;
    }
    ++found[expected->check];
    ASSERT_EQ(errors.error()->place, expected->place) << "seed " << seed;
    ASSERT_TRUE(Instantiates(errors.error()->message, expected->check))
        << "seed " << seed << ": " << errors.error()->message;
  }
  EXPECT_GT(sound, 1000);
  for (int check = static_cast<int>(Check::kRegionsOverlap);
       check <= static_cast<int>(Check::kRootInHold); ++check) {
    if (Check(check) == Check::kRegionAllFixed) continue;
    EXPECT_GE(found[Check(check)], 10) << TextOf(Check(check)).text;
  }
}

// Thirty thousand of each took 27 s and more when each was compared with each. Processor time of
// any build.
TEST(Compile, ChecksThirtyThousandOfAKindInSeconds) {
  for (const char* kind : {"placements", "regions", "holds"}) {
    const test::ScaledProject scaled = test::MakeScaled(kind, 30000);
    const std::clock_t start = std::clock();
    EXPECT_TRUE(CompileAnimation(scaled.project).ok()) << kind;
    EXPECT_LE(double(std::clock() - start) / CLOCKS_PER_SEC, 4.0) << kind;
  }
}

TEST(Compile, EndsWhereItIsCancelled) {
  const test::ScaledProject scaled = test::MakeScaled("placements", 1000);
  const std::atomic<bool> cancel = true;
  const Result<Compiled> compiled = CompileAnimation(scaled.project, &cancel);
  ASSERT_FALSE(compiled.ok());
  EXPECT_EQ(compiled.error().code, ErrorCode::kInterrupted);
}

}  // namespace
}  // namespace hazumi::testing
