#include <gtest/gtest.h>

#include <algorithm>

#include "engine/exchange/import/import_names.h"
#include "engine/exchange/import/import_project.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/unit/exchange/made_characters.h"

namespace hazumi::test {
namespace {

TEST(FigureNames, AreSuchThatAProjectHoldsThem) {
  ImportReport report;
  const std::vector<std::string> names =
      FigureNames({"A", "B", "B_x", "C_y", "C", "D+", "D", "", "A", "e\x01"}, &report);
  const std::vector<std::string> expected = {"A", "B",   "B_x_2", "C_y", "C_2",
                                             "D", "D_2", "bone",  "A_2", "e_"};
  EXPECT_EQ(names, expected);
  EXPECT_EQ(report.warnings.size(), 7u);
}

TEST(FigureNames, OfACharacterMakeAFigure) {
  Character character = Hand();
  const char* const odd[] = {"A", "B", "B_x", "B_x_x", "C+", "C", "\xff", "C_y_2", "root"};
  for (size_t b = 0; b < character.bones.size(); ++b) character.bones[b].name = odd[b];
  const Project project = ImportWell(character).project;
  const Result<Project> read = ParseProject(WriteProject(project), "odd.kfa");
  ASSERT_TRUE(read.ok()) << read.error().ToString();
  BakeWell(read.value());
}

TEST(ImportReport, SaysTheSameOnceAndTheRestAsANumber) {
  std::vector<Warning> warnings;
  for (const char* bone : {"a", "b", "c", "d", "e"}) warnings.push_back({bone, "is odd"});
  for (int i = 0; i < 12; ++i) warnings.push_back({"f", std::to_string(i)});
  const std::vector<Warning> few = Shortened(warnings, 10);
  ASSERT_EQ(few.size(), 11u);
  EXPECT_EQ(few[0].place, "a, b, c and 2 more");
  EXPECT_EQ(few[10].message, "and 3 more; --all-warnings says them");
  EXPECT_EQ(Shortened(warnings, 0).size(), warnings.size());
}

}  // namespace
}  // namespace hazumi::test
