#include "tests/unit/project/wrong_projects.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <set>

namespace hazumi::testing {
namespace {

// True if `message` is the check's sentence with its {} filled in.
bool Instantiates(std::string_view message, Check check) {
  std::string_view sentence = TextOf(check).text;
  for (size_t hole; (hole = sentence.find("{}")) != std::string_view::npos;) {
    const size_t at = message.find(sentence.substr(0, hole));
    if (at == std::string_view::npos) return false;
    message.remove_prefix(at + hole);
    sentence.remove_prefix(hole + 2);
  }
  return message.ends_with(sentence);
}

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
