#include "ui/panels/text/catalogue.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "ui/edit/operator.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/commands/first_steps.h"
#include "ui/panels/commands/menus.h"
#include "ui/panels/dialogs/file_purpose.h"
#include "ui/panels/dialogs/manual.h"
#include "ui/panels/forms/offers.h"
#include "ui/panels/forms/texts.h"

namespace hazumi::ui {
namespace {

std::set<std::string> Keys() {
  std::set<std::string> keys;
  for (const std::string_view key : CatalogueKeys()) keys.emplace(key);
  return keys;
}

void ExpectHas(const char* text, const std::string& where) {
  static const std::set<std::string> keys = Keys();
  EXPECT_TRUE(keys.contains(text)) << where << ": {\"" << text << "\", \"\"},";
}

// What a literal in a source file says.
std::string Unescaped(const std::string& literal) {
  std::string text;
  for (size_t i = 0; i < literal.size(); ++i) {
    if (literal[i] == '\\' && i + 1 < literal.size()) {
      ++i;
      text += literal[i] == 'n' ? '\n' : literal[i];
    } else {
      text += literal[i];
    }
  }
  return text;
}

// The texts of all Tr("..." "...") in a source file.
std::vector<std::string> TextsIn(const std::string& source) {
  static const std::regex call(R"re(\bTr\(\s*("(?:[^"\\]|\\.)*"(?:\s*"(?:[^"\\]|\\.)*")*)\s*\))re");
  static const std::regex part(R"re("((?:[^"\\]|\\.)*)")re");
  std::vector<std::string> texts;
  for (std::sregex_iterator it(source.begin(), source.end(), call), end; it != end; ++it) {
    const std::string literals = (*it)[1];
    std::string text;
    for (std::sregex_iterator p(literals.begin(), literals.end(), part); p != end; ++p) {
      text += Unescaped((*p)[1]);
    }
    texts.push_back(text);
  }
  return texts;
}

// Returns the number of texts in the sources below a folder.
int ExpectHasTextsOf(const char* folder) {
  int num_texts = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".cpp" && extension != ".h") continue;
    std::ostringstream source;
    source << std::ifstream(entry.path()).rdbuf();
    for (const std::string& text : TextsIn(source.str())) {
      ExpectHas(text.c_str(), entry.path().filename().string());
      ++num_texts;
    }
  }
  return num_texts;
}

TEST(Catalogue, HasEveryTextOfTheSources) {
  EXPECT_GT(ExpectHasTextsOf(HAZUMI_SOURCE_DIR "/ui"), 60);
  EXPECT_GT(ExpectHasTextsOf(HAZUMI_SOURCE_DIR "/engine/analysis"), 20);
}

void ExpectHasAll(const char* id, const char* label, const char* help,
                  const std::vector<edit::ParameterInfo>& parameters) {
  static const edit::Session session;
  ExpectHas(label, id);
  ExpectHas(help, id);
  for (const edit::ParameterInfo& info : parameters) {
    ExpectHas(LabelOf(info).c_str(), id);
    ExpectHas(info.help, id);
    if (info.offer.words[0] == '\0') continue;
    for (const FormOption& option : OptionsOf(info, session)) {
      ExpectHas(option.label.c_str(), id);
    }
  }
}

TEST(Catalogue, HasEveryOperatorAndAction) {
  for (const edit::Operator& op : edit::AllOperators()) {
    ExpectHasAll(op.id, op.label, op.help, op.parameters);
  }
  for (const Action& action : AllActions()) {
    ExpectHasAll(action.id, action.label, action.help, action.parameters);
  }
}

TEST(Catalogue, HasTheTextsOfTheFileDialog) {
  for (const FilePurpose* purpose : AllFilePurposes()) {
    for (const char* text :
         {purpose->title, purpose->nothing, purpose->button, purpose->button_help}) {
      ExpectHas(text, purpose->title);
    }
    if (*purpose->advice) ExpectHas(purpose->advice, purpose->title);
  }
}

TEST(Catalogue, HasTheTextsOfForms) {
  for (const std::string& text : AllFormTexts()) ExpectHas(text.c_str(), "forms");
}

// Of transactions that are called otherwise than their operator.
TEST(Catalogue, HasEveryUndoLabel) {
  static const std::regex call(
      R"re((?:Edit|Change|KeyPose|Commit|Put)\(\s*(?:session, (?:p, )?)?"([^"]*)")re");
  int num_labels = 0;
  const std::filesystem::path folder = HAZUMI_SOURCE_DIR "/ui/edit";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    std::ostringstream stream;
    stream << std::ifstream(entry.path()).rdbuf();
    const std::string source = stream.str();
    for (std::sregex_iterator it(source.begin(), source.end(), call), end; it != end; ++it) {
      ExpectHas((*it)[1].str().c_str(), entry.path().filename().string());
      ++num_labels;
    }
  }
  EXPECT_GT(num_labels, 40);
}

void ExpectHasEntries(const std::vector<MenuEntry>& entries) {
  for (const MenuEntry& entry : entries) {
    if (entry.label) ExpectHas(entry.label, "menu");
    ExpectHasEntries(entry.entries);
  }
}

TEST(Catalogue, HasMenusManualAndFirstSteps) {
  ExpectHasEntries(AllMenus());
  for (const ManualPart& part : ManualParts()) {
    ExpectHas(part.title, "manual");
    for (const char* paragraph : part.paragraphs) ExpectHas(paragraph, "manual");
  }
  for (int i = 0; i < kNumFirstSteps; ++i) {
    ExpectHas(TextOfStep(i).title, "first steps");
    ExpectHas(TextOfStep(i).how, "first steps");
  }
}

TEST(Catalogue, HasNoTextTwiceAndNoneWithoutATranslation) {
  std::set<std::string_view> seen;
  SetLanguage(Language::kJapanese);
  for (const std::string_view key : CatalogueKeys()) {
    EXPECT_TRUE(seen.insert(key).second) << key;
    EXPECT_NE(std::string(Tr(std::string(key).c_str())), "") << key;
  }
  SetLanguage(Language::kEnglish);
}

}  // namespace
}  // namespace hazumi::ui
