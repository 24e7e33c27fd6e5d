#include <gtest/gtest.h>

#include "engine/base/utf8.h"
#include "engine/project/json/did_you_mean.h"
#include "engine/project/json/json.h"
#include "engine/project/project_files.h"

namespace hazumi {
namespace {

TEST(EditDistance, CountsChangesAndSwaps) {
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
  EXPECT_EQ(EditDistance("r_wirst", "r_wrist"), 1);
  EXPECT_EQ(EditDistance("same", "same"), 0);
}

TEST(Suggestion, NamesTheNearestElseTheChoices) {
  EXPECT_EQ(Suggestion("cubik", {"hold", "cubic"}), "did you mean \"cubic\"?");
  EXPECT_EQ(Suggestion("zzz", {"hold", "cubic"}), "use one of \"hold\", \"cubic\"");
  EXPECT_EQ(Suggestion(std::string(100000, 'x'), {"hold"}), "use one of \"hold\"");
}

TEST(NearestField, AlsoTakesANameWithoutItsUnit) {
  EXPECT_EQ(NearestField("gravity", {"objects", "gravity_m_s2"}), "gravity_m_s2");
  EXPECT_EQ(NearestField("regoins", {"root", "regions"}), "regions");
  EXPECT_EQ(NearestField("grav", {"objects", "gravity_m_s2"}), std::nullopt);
  EXPECT_EQ(NearestField("", {"_s"}), std::nullopt);
}

TEST(ShownName, IsThatOfTheFileWhereNobodyGaveOne) {
  EXPECT_EQ(ShownName("Throw", "a/b.kfa"), "Throw");
  EXPECT_EQ(ShownName("Untitled", "a/b.kfa"), "b");
  EXPECT_EQ(ShownName("", "b.c.kfa"), "b.c");
  EXPECT_EQ(ShownName("Untitled", ""), "Untitled");
}

TEST(Utf8, RefusesOverlongSurrogateAndTooHigh) {
  EXPECT_EQ(FindInvalidUtf8("a\xC3\xA9\xE5\xBC\xBE\xF0\x9F\x98\x80"), std::string::npos);
  for (const char* bad : {"\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                          "\xF0\x80\x80\x80", "\xE5\xBC", "\x80", "\xFE"}) {
    EXPECT_EQ(FindInvalidUtf8(std::string("ab") + bad), 2u);
  }
  EXPECT_EQ(ValidUtf8("a\xFF"
                      "b"),
            "a\xEF\xBF\xBD"
            "b");
}

TEST(Utf8, DecodesEveryLengthAndReplacesWhatIsMalformed) {
  EXPECT_EQ(DecodeUtf8("a\xC3\xA9\xE5\xBC\xBE\xF0\x9F\x98\x80"), U"a\u00e9\u5f3e\U0001f600");
  EXPECT_EQ(DecodeUtf8("\xED\xA0\x80"), U"\ufffd\ufffd\ufffd");
}

TEST(FormatJson, BreaksOnlyWhatDoesNotFit) {
  const Json fits = Json::parse(R"({"a": [1, 2], "b": {}})");
  EXPECT_EQ(FormatJson(fits), "{\"a\": [1, 2], \"b\": {}}\n");
  const std::string word(90, 'x');
  EXPECT_EQ(FormatJson(Json::array({word, 1.0})), "[\"" + word + "\", 1]\n");
  EXPECT_EQ(FormatJson(Json::array({word, 12345678})), "[\n  \"" + word + "\",\n  12345678\n]\n");
}

}  // namespace
}  // namespace hazumi
