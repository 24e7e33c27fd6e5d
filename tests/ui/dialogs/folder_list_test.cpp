#include "ui/panels/dialogs/folder_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace hazumi::ui {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> NamesOf(const std::vector<FileEntry>& entries) {
  std::vector<std::string> names;
  for (const FileEntry& entry : entries) names.push_back(entry.name);
  return names;
}

TEST(FolderList, FoldersGoFirstAndNumbersAreCounted) {
  std::vector<FileEntry> entries = {
      {"shot 10.kfa"}, {"Shot 2.kfa"}, {"takes", true}, {"shot 02b.kfa"}, {"投げる.kfa"}};
  SortEntries(FileOrder::kName, &entries);
  EXPECT_EQ(NamesOf(entries), (std::vector<std::string>{"takes", "Shot 2.kfa", "shot 02b.kfa",
                                                        "shot 10.kfa", "投げる.kfa"}));
}

TEST(FolderList, TheNewestGoesFirstIfAsked) {
  std::vector<FileEntry> entries = {{"a.kfa", false, 5}, {"b.kfa", false, 9}, {"old", true, 1}};
  SortEntries(FileOrder::kNewest, &entries);
  EXPECT_EQ(NamesOf(entries), (std::vector<std::string>{"old", "b.kfa", "a.kfa"}));
}

TEST(FolderList, ShowsProjectsAndFoldersUnlessAllIsAsked) {
  const FolderFilter projects = {.wanted = IsProject};
  const FolderFilter all = {.wanted = IsProject, .all_files = true};
  EXPECT_TRUE(IsShown({"a.KFA"}, projects));
  EXPECT_TRUE(IsShown({"folder", true}, projects));
  EXPECT_FALSE(IsShown({"a.txt"}, projects));
  EXPECT_TRUE(IsShown({"a.txt"}, all));
  EXPECT_FALSE(IsShown({".hidden.kfa"}, all));
}

TEST(FolderList, ShowsFoldersAloneWhereNoFileIsWanted) {
  EXPECT_TRUE(IsShown({"folder", true}, {}));
  EXPECT_FALSE(IsShown({"a.kfa"}, {}));
  EXPECT_FALSE(IsShown({"a.kfa"}, {.all_files = true}));
}

TEST(FolderList, TypedNamesBecomePaths) {
  EXPECT_EQ(PathOf("/a/b", "c.kfa", "/home/x"), "/a/b/c.kfa");
  EXPECT_EQ(PathOf("/a/b", "../c.kfa", "/home/x"), "/a/c.kfa");
  EXPECT_EQ(PathOf("/a/b", "/c.kfa", "/home/x"), "/c.kfa");
  EXPECT_EQ(PathOf("/a/b", "~/c.kfa", "/home/x"), "/home/x/c.kfa");
  EXPECT_EQ(PathOf("/a/b", "~", "/home/x"), "/home/x");
  EXPECT_EQ(PathOf("/a", "投げる/", "/home/x"), "/a/投げる");
  EXPECT_EQ(ParentOf("/a/b"), "/a");
  EXPECT_EQ(ParentOf("/a"), "/");
  EXPECT_EQ(ParentOf("/"), "/");
}

TEST(FolderList, TheSuffixIsAddedOnce) {
  EXPECT_EQ(WithProjectSuffix("throw"), "throw.kfa");
  EXPECT_EQ(WithProjectSuffix("throw.KFA"), "throw.KFA");
  EXPECT_EQ(WithProjectSuffix("throw.v2"), "throw.v2.kfa");
}

TEST(FolderList, TypingFindsTheFirstThatBeginsSo) {
  const std::vector<FileEntry> entries = {{"jump.kfa"}, {"Throw.kfa"}};
  EXPECT_EQ(FirstBeginningWith(entries, "th"), 1);
  EXPECT_EQ(FirstBeginningWith(entries, "x"), -1);
  EXPECT_EQ(FirstBeginningWith(entries, ""), -1);
}

TEST(FolderList, TheInstalledExamplesAreAPlace) {
  const fs::path prefix = fs::path(testing::TempDir()) / "hazumi_shelves";
  fs::remove_all(prefix);
  const std::string examples = ExamplesBeside((prefix / "bin" / "hazumi").string());
  const auto has_them = [&] {
    const std::vector<Shelf> shelves = Shelves("/", {}, examples);
    return std::any_of(shelves.begin(), shelves.end(), [&](const Shelf& shelf) {
      return shelf.label == "Examples" && shelf.path == examples;
    });
  };
  EXPECT_FALSE(has_them());
  fs::create_directories(prefix / "share" / "hazumi" / "examples");
  EXPECT_TRUE(has_them());
  fs::remove_all(prefix);
}

TEST(FolderList, AFolderIsListedAndOneThatIsNotThereIsAnError) {
  const fs::path folder = fs::path(testing::TempDir()) / "hazumi_folder_list";
  fs::remove_all(folder);
  fs::create_directories(folder / "sub");
  std::ofstream(folder / "投げる.kfa") << "x";
  std::ofstream(folder / "notes.txt") << "x";
  const auto listed = ListFolder(folder.string(), {.wanted = IsProject});
  ASSERT_TRUE(listed.ok());
  EXPECT_EQ(NamesOf(listed.value()), (std::vector<std::string>{"sub", "投げる.kfa"}));
  EXPECT_GT(listed.value()[1].changed, 1'500'000'000);
  const auto missing = ListFolder((folder / "none").string(), {});
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::kNoInput);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace hazumi::ui
