#include "tests/unit/project/wrong_projects.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <set>

namespace hazumi::testing {
namespace {

TEST(WrongProjects, EachGetsItsMessage) {
  for (const WrongProject& wrong : WrongProjects()) {
    const std::string said = wrong.say();
    EXPECT_EQ(said, wrong.expected);
    if (wrong.check == Check::kNumChecks) continue;
    EXPECT_TRUE(Instantiates(said, wrong.check)) << said << "\n" << TextOf(wrong.check).text;
  }
}

TEST(WrongProjects, EveryCheckHasOne) {
  std::set<Check> reached;
  for (const WrongProject& wrong : WrongProjects()) reached.insert(wrong.check);
  for (int i = 0; i < static_cast<int>(Check::kNumChecks); ++i) {
    EXPECT_TRUE(reached.contains(static_cast<Check>(i))) << TextOf(static_cast<Check>(i)).text;
  }
}

}  // namespace
}  // namespace hazumi::testing
