// Runs the tests of a program as GTest's own main does, but a skipped test does not count as
// passed. A skipped test fails if HAZUMI_DATA is set, since all requirements of tests are then
// available. Skips whose reason begins with "not here: " (a sanitizer, a missing permission) stay
// skips, which CTest shows because of kSkipped. Test programs do not lie beside hazumi-reader
// and name its path.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "engine/child/reader_program.h"

namespace {

constexpr const char* kSkipped = "hazumi test: skipped";  // same text in tests/CMakeLists.txt
constexpr const char* kAllowed = "not here: ";

bool IsPromised() {
  const char* folder = std::getenv("HAZUMI_DATA");
  return folder != nullptr && *folder != '\0';
}

bool IsAllowed(const testing::TestResult& result) {
  for (int i = 0; i < result.total_part_count(); ++i) {
    const testing::TestPartResult& part = result.GetTestPartResult(i);
    if (part.skipped() && std::strstr(part.message(), kAllowed) == nullptr) return false;
  }
  return true;
}

// Returns the number of tests whose skip is not allowed, and prints their names.
int NumWronglySkipped(const testing::UnitTest& all) {
  int num_wrong = 0;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (!test.should_run() || !test.result()->Skipped() || IsAllowed(*test.result())) continue;
      std::printf("hazumi test: %s.%s may not be skipped where HAZUMI_DATA is set\n", suite.name(),
                  test.name());
      ++num_wrong;
    }
  }
  return num_wrong;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  hazumi::SetReaderPath(HAZUMI_BUILT_READER);
  if (const int code = RUN_ALL_TESTS(); code != 0) return code;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  if (IsPromised() && NumWronglySkipped(all) > 0) return 1;
  if (all.skipped_test_count() > 0) std::printf("%s\n", kSkipped);
  return 0;
}
