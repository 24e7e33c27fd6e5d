// What a test does without the data beside the repository.

#include "tests/support/data_folder.h"

#include <gtest/gtest-spi.h>

#include <cstdlib>
#include <fstream>
#include <optional>

#include "tests/support/temporary_folder.h"

namespace hazumi::test {
namespace {

// HAZUMI_DATA, as it was before when this ends.
class DataVariable {
 public:
  DataVariable() {
    if (const char* value = std::getenv("HAZUMI_DATA")) before_ = value;
  }
  ~DataVariable() { Set(before_); }
  void Set(const std::optional<std::string>& value) {
    value ? setenv("HAZUMI_DATA", value->c_str(), 1) : unsetenv("HAZUMI_DATA");
  }

 private:
  std::optional<std::string> before_;
};

class DataFolder : public testing::Test {
 protected:
  DataFolder() {
    std::filesystem::create_directory(folder_ / "empty");
    std::ofstream(folder_ / "clip.bvh") << "HIERARCHY";
  }
  TemporaryFolder folder_;
  DataVariable variable_;
};

bool g_was_reached = false;

void Need(const char* name) {
  HAZUMI_NEED_DATA(name);
  g_was_reached = true;
}

testing::TestPartResult OnlyResultOf(const char* name) {
  testing::TestPartResultArray results;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    Need(name);
  }
  EXPECT_EQ(results.size(), 1);
  return results.GetTestPartResult(0);
}

TEST_F(DataFolder, WhereItIsNamedAMissingFileFails) {
  variable_.Set(folder_.path());
  for (const char* name : {"none.bvh", "nowhere", "empty"}) {
    const testing::TestPartResult result = OnlyResultOf(name);
    EXPECT_TRUE(result.fatally_failed()) << name;
    EXPECT_NE(std::string(result.message()).find(folder_ / name), std::string::npos);
  }
}

TEST_F(DataFolder, WhereItIsNotNamedAMissingFileSkipsAndSaysSo) {
  variable_.Set(std::nullopt);
  const testing::TestPartResult result = OnlyResultOf("no such file");
  EXPECT_TRUE(result.skipped());
  EXPECT_NE(std::string(result.message()).find("no such file is not there"), std::string::npos);
  EXPECT_NE(std::string(result.message()).find("HAZUMI_DATA"), std::string::npos);
}

TEST_F(DataFolder, WhatIsThereIsUsed) {
  variable_.Set(folder_.path());
  g_was_reached = false;
  Need("clip.bvh");
  EXPECT_TRUE(g_was_reached);
  ASSERT_EQ(DataFiles("").size(), 1u);
  EXPECT_EQ(DataFiles("")[0].filename(), "clip.bvh");
}

}  // namespace
}  // namespace hazumi::test
