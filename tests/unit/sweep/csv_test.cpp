#include <gtest/gtest.h>

#include "engine/sweep/table_text.h"
#include "tests/support/random.h"

namespace hazumi {
namespace {

using Line = std::vector<std::string>;

TEST(Csv, QuotesWhatWouldBeTakenForSomethingElse) {
  EXPECT_EQ(CsvLine({"1", "", "a b"}), "1,,a b\n");
  EXPECT_EQ(CsvLine({"[1,0]", "say \"x\"", "two\nlines", "\r"}),
            "\"[1,0]\",\"say \"\"x\"\"\",\"two\nlines\",\"\r\"\n");
}

TEST(Csv, ReadsLinesHoweverTheyEnd) {
  const std::vector<Line> lines = {{"a", "b"}, {"", "2"}, {"x"}};
  EXPECT_EQ(ReadCsv("a,b\n,2\nx\n"), lines);
  EXPECT_EQ(ReadCsv("a,b\r\n,2\r\nx"), lines);
  EXPECT_EQ(ReadCsv(""), std::vector<Line>());
  EXPECT_EQ(ReadCsv("\"a\"\"b\",\"\"\r\n"), (std::vector<Line>{{"a\"b", ""}}));
  EXPECT_EQ(ReadCsv("\"never ends, \n"), (std::vector<Line>{{"never ends, \n"}}));
}

TEST(Csv, ComesBackAsItWasWhateverItHolds) {
  test::Random random(3);
  static constexpr char kLetters[] = {'a', ',', '"', '\n', '\r', ' ', '1', '\t'};
  for (int round = 0; round < 500; ++round) {
    std::vector<Line> lines;
    std::string text;
    for (int i = random.Integer(1, 4); i > 0; --i) {
      Line& line = lines.emplace_back(static_cast<size_t>(random.Integer(1, 4)));
      for (std::string& field : line) {
        for (int k = random.Integer(0, 5); k > 0; --k) field += kLetters[random.Integer(0, 7)];
      }
      text += CsvLine(line);
    }
    EXPECT_EQ(ReadCsv(text), lines) << "round " << round << ": " << text;
  }
}

}  // namespace
}  // namespace hazumi
