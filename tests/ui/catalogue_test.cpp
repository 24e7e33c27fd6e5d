#include "ui/panels/catalogue.h"

#include <gtest/gtest.h>

#include <set>

namespace hazumi::test {
namespace {

using namespace ui;

TEST(Catalogue, SpeaksTheLanguageThatIsChosen) {
  SetLanguage(Language::kJapanese);
  EXPECT_STREQ(Tr("Recover"), "復元");
  EXPECT_STREQ(Tr("no such text"), "no such text");
  SetLanguage(Language::kEnglish);
  EXPECT_STREQ(Tr("Recover"), "Recover");
}

TEST(Catalogue, HasEachTextOnce) {
  std::set<std::string_view> seen;
  for (const std::string_view key : CatalogueKeys()) {
    EXPECT_TRUE(seen.insert(key).second) << key;
  }
}

}  // namespace
}  // namespace hazumi::test
