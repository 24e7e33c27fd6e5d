// JSON that is no project, from the JSON parsing test suite beside the repository.

#include <gtest/gtest.h>

#include "engine/project/project_reader.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

// Calls check(file name, result) for each file whose name begins with `prefix`; returns how many.
template <typename Check>
int ForEachFile(const std::string& prefix, Check check) {
  const std::filesystem::path folder = HAZUMI_SHARED_DIR "/data/json";
  if (!std::filesystem::exists(folder)) return 0;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    check(name, LoadProject(entry.path().string()));
    ++count;
  }
  return count;
}

TEST(ForeignJson, WhatIsNotJsonIsASyntaxErrorWithLineAndColumn) {
  const int count = ForEachFile("n_", [](const std::string& name, const Result<Project>& read) {
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_EQ(read.error().code, ErrorCode::kSyntax) << name << read.error().ToString();
    EXPECT_TRUE(read.error().place.starts_with("line ")) << name << read.error().ToString();
  });
  if (count == 0) GTEST_SKIP() << "skipped: no data";
}

TEST(ForeignJson, WhatIsJsonIsNoProject) {
  const int count = ForEachFile("y_", [](const std::string& name, const Result<Project>& read) {
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_EQ(read.error().code, ErrorCode::kSchema) << name << read.error().ToString();
  });
  if (count == 0) GTEST_SKIP() << "skipped: no data";
}

TEST(ForeignJson, WhatMayBeJsonIsRefusedToo) {
  const int count = ForEachFile("i_", [](const std::string& name, const Result<Project>& read) {
    EXPECT_FALSE(read.ok()) << name;
  });
  if (count == 0) GTEST_SKIP() << "skipped: no data";
}

// A file cut short at any byte is an error, and never a crash.
TEST(ForeignJson, EveryPrefixOfAProjectIsAnError) {
  const std::string text = SampleProject().dump();
  for (size_t size = 0; size < text.size(); size += 7) {
    EXPECT_FALSE(ParseProject(text.substr(0, size), "cut.kfa").ok()) << size;
  }
}

}  // namespace
}  // namespace hazumi::testing
