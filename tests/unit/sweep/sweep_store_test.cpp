#include "engine/sweep/sweep_store.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/project/json/text_file.h"
#include "tests/support/temporary_folder.h"

namespace hazumi {
namespace {

using test::TemporaryFolder;

constexpr const char* kIdentity =
    R"({"program": "Hazumi 1", "sweep": {}, "project": {"name": "a"}, "figure": {}})";
constexpr const char* kOther =
    R"({"program": "Hazumi 2", "sweep": {}, "project": {"name": "b"}, "figure": {}})";

SweepStore Opened(const TemporaryFolder& folder, long cells) {
  return SweepStore::Open(folder / "out", cells, kIdentity).value();
}

TEST(SweepStore, SharesAllCellsOutAmongBlocks) {
  const TemporaryFolder folder;
  for (const long cells : {1L, 19L, 20L, 21L, 999L, 20000L, 20001L, 1000000L}) {
    const SweepStore store = Opened(folder, cells);
    long next = 0;
    for (long block = 0; block < store.blocks(); ++block) {
      EXPECT_EQ(store.FirstCell(block), next);
      EXPECT_GT(store.EndCell(block), next);
      next = store.EndCell(block);
    }
    EXPECT_EQ(next, cells);
    EXPECT_LE(store.blocks(), 1000) << cells;
  }
}

TEST(SweepStore, KeepsBlocksAndMergesThemInOrder) {
  const TemporaryFolder folder;
  const SweepStore store = Opened(folder, 45);
  ASSERT_EQ(store.blocks(), 3);
  EXPECT_FALSE(store.HasBlock(0));
  EXPECT_EQ(store.Merge("cell\n").error().code, ErrorCode::kNoInput);
  for (const long block : {2L, 0L, 1L}) {
    ASSERT_TRUE(store.WriteBlock(block, "rows " + std::to_string(block) + "\n").ok());
    EXPECT_TRUE(store.HasBlock(block));
  }
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(store.Merge("cell\n").ok());
    EXPECT_EQ(ReadTextFile(store.CsvPath()).value(), "cell\nrows 0\nrows 1\nrows 2\n");
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "out/rows/000020.csv"));
  EXPECT_EQ(store.PicturePath(7, ".png"), folder / "out/pictures/000007.png");
}

TEST(SweepStore, GoesOnInAFolderOfTheSameSweep) {
  const TemporaryFolder folder;
  ASSERT_TRUE(Opened(folder, 30).WriteBlock(1, "rows\n").ok());
  const SweepStore again = Opened(folder, 30);
  EXPECT_FALSE(again.HasBlock(0));
  EXPECT_TRUE(again.HasBlock(1));
}

TEST(SweepStore, RefusesAFolderOfAnotherSweepAndLeavesIt) {
  const TemporaryFolder folder;
  (void)Opened(folder, 30);
  const auto other = SweepStore::Open(folder / "out", 30, kOther);
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(other.error().code, ErrorCode::kSemantics);
  EXPECT_EQ(other.error().ToString(),
            folder / "out" +
                ": holds another sweep: its plan.json differs in the project and the program "
                "(there: Hazumi 1); name another folder, or remove this one");
  EXPECT_EQ(ReadTextFile(folder / "out/plan.json").value(), kIdentity);
}

TEST(SweepStore, SaysWhatCannotBeMade) {
  const TemporaryFolder folder;
  ASSERT_TRUE(SweepStore::Open(folder / "out", 1, "x").ok());
  const auto inside = SweepStore::Open(folder / "out/plan.json", 1, "x");
  ASSERT_FALSE(inside.ok());
  EXPECT_EQ(inside.error().code, ErrorCode::kCannotWrite);
  EXPECT_EQ(inside.error().file, folder / "out/plan.json");
}

}  // namespace
}  // namespace hazumi
