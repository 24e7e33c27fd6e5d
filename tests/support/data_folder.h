#pragma once

// Captures and characters that are no part of the repository: in the folder that the environment
// variable HAZUMI_DATA names, or else in ../shared/data beside the repository.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hazumi::test {

// Path of a file or folder of the data, whether it is there or not.
std::string DataPath(const std::string& name);

// The regular files in such a folder and below, sorted; none where there is no folder.
std::vector<std::filesystem::path> DataFiles(const std::string& folder);

// Nothing if the file is there, or the folder with a file in it. Else what is missing.
std::string MissingData(const std::string& name);

// HAZUMI_DATA is set: whatever is missing is an error.
bool DataIsPromised();

// NOLINTBEGIN(cppcoreguidelines-macro-usage): only the body of a test can leave the test
// In the body of a test or in SetUp(), before a file or folder of the data is used: without it the
// test fails where HAZUMI_DATA is set, and is skipped elsewhere; both say what is missing.
#define HAZUMI_NEED_DATA(name)                                                         \
  if (const std::string missing = hazumi::test::MissingData(name); !missing.empty()) { \
    if (hazumi::test::DataIsPromised()) GTEST_FAIL() << missing;                       \
    GTEST_SKIP() << missing;                                                           \
  }                                                                                    \
  static_assert(true)
// NOLINTEND(cppcoreguidelines-macro-usage)

}  // namespace hazumi::test
