// What help, manual page and completions can rely on: the table of options is whole.

#include "app/cli/option_table.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "app/cli/help_text.h"

namespace hazumi {
namespace {

std::vector<std::string> Words(const char* text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(OptionTable, EveryOptionHasANameOfItsOwnAndSaysWhatItIs) {
  std::set<std::string> names;
  for (const OptionRule& rule : AllOptions()) {
    EXPECT_TRUE(std::string(rule.name).starts_with("--")) << rule.name;
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    ASSERT_TRUE(rule.help) << rule.name;
  }
}

TEST(OptionTable, WhatTakesAValueSaysWhatToDoAboutAWrongOneAndAFlagDoesNot) {
  for (const OptionRule& rule : AllOptions()) {
    EXPECT_EQ(rule.value != nullptr, rule.remedy != nullptr) << rule.name;
    EXPECT_TRUE(rule.value || !(rule.choices || rule.files)) << rule.name;
  }
}

TEST(OptionTable, EveryChoiceThatIsOfferedIsTakenAndOthersAreNot) {
  for (const OptionRule& rule : AllOptions()) {
    if (!rule.choices) continue;
    Options options;
    for (const std::string& choice : Words(rule.choices)) {
      EXPECT_TRUE(rule.read(choice, &options)) << rule.name << " " << choice;
    }
    Options untouched;
    EXPECT_FALSE(rule.read("nonsense", &untouched)) << rule.name;
  }
}

TEST(OptionTable, EveryKindOfFileThatIsOfferedIsTaken) {
  for (const OptionRule& rule : AllOptions()) {
    if (!rule.files || std::string(rule.files).find_first_of("*/") != std::string::npos) continue;
    Options options;
    for (const std::string& suffix : Words(rule.files)) {
      EXPECT_TRUE(rule.read("name." + suffix, &options)) << rule.name << " " << suffix;
    }
  }
}

TEST(OptionTable, TasksAreNamedAsTheyAreSaid) {
  EXPECT_EQ(TaskNames(kRender), "--render");
  EXPECT_EQ(TaskNames(kCheck | kInfo | kFlight), "--check, --info and --flight");
  EXPECT_EQ(TaskNames(kDraw), "--render and --export to .mp4");
  EXPECT_EQ(TaskNames(kWindow), "the editor");
}

TEST(HelpText, NamesEveryOptionOnceWithTheWordForItsValueInEightyColumns) {
  const std::string help = HelpText();
  for (const OptionRule& rule : AllOptions()) {
    const std::string entry =
        std::string("\n  ") + rule.name + (rule.value ? std::string(" ") + rule.value : "");
    const size_t at = help.find(entry);
    ASSERT_NE(at, std::string::npos) << rule.name;
    EXPECT_TRUE(help[at + entry.size()] == ' ' || help[at + entry.size()] == '\n') << rule.name;
    EXPECT_EQ(help.find(entry + " ", at + 1), std::string::npos) << rule.name;
  }
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80u) << line;
    EXPECT_FALSE(line.ends_with(" ")) << line;
  }
}

}  // namespace
}  // namespace hazumi
