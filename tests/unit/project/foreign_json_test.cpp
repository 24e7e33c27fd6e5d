// JSON that is no project, from the JSON parsing test suite beside the repository.

#include <gtest/gtest.h>

#include "engine/project/project_reader.h"
#include "tests/support/data_folder.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

// Calls check(file name, result) for each file whose name begins with `prefix`.
template <typename Check>
void ForEachFile(const std::string& prefix, Check check) {
  HAZUMI_NEED_DATA("json");
  int count = 0;
  for (const std::filesystem::path& path : test::DataFiles("json")) {
    const std::string name = path.filename().string();
    if (!name.starts_with(prefix)) continue;
    check(name, LoadProject(path.string()));
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(ForeignJson, WhatIsNotJsonIsASyntaxErrorWithLineAndColumn) {
  ForEachFile("n_", [](const std::string& name, const Result<Project>& read) {
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_EQ(read.error().code, ErrorCode::kSyntax) << name << read.error().ToString();
    EXPECT_TRUE(read.error().place.starts_with("line ")) << name << read.error().ToString();
  });
}

TEST(ForeignJson, WhatIsJsonIsNoProject) {
  ForEachFile("y_", [](const std::string& name, const Result<Project>& read) {
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_EQ(read.error().code, ErrorCode::kSchema) << name << read.error().ToString();
  });
}

TEST(ForeignJson, WhatMayBeJsonIsRefusedToo) {
  ForEachFile("i_", [](const std::string& name, const Result<Project>& read) {
    EXPECT_FALSE(read.ok()) << name;
  });
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
