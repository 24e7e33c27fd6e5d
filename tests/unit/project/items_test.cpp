// Properties of every kind of item.

#include "engine/project/items.h"

#include <gtest/gtest.h>

namespace hazumi {
namespace {

TEST(Items, AreInTheirListAlone) {
  const Project empty;
  const auto has_one = [&](auto kind, const auto& items) {
    EXPECT_TRUE(items.empty()) << kind.kList;
    Project project;
    kind.In(project).emplace_back();
    int lists_with_one = 0;
    ForEachItemList([&](auto, const auto& list) { lists_with_one += list.size() == 1; }, project);
    EXPECT_EQ(lists_with_one, 1) << kind.kList;
  };
  ForEachItemList(has_one, empty);
}

// A list that undo does not know would stay as it is.
TEST(Items, ArePartsOfTheProject) {
  const Project empty;
  const auto is_part = [&](auto kind, const auto&) {
    Project project;
    kind.In(project).emplace_back();
    EXPECT_FALSE(PartsOfProject(project) == PartsOfProject(empty)) << kind.kList;
  };
  ForEachItemList(is_part, empty);
}

}  // namespace
}  // namespace hazumi
